#include "avatar_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace deixis::assets {

namespace {

constexpr int widest_texture = 8192;

TextureWrap wrapOf(int gl_mode) {
    if (gl_mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp;
    return gl_mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirror : TextureWrap::repeat;
}

/// The size that a PNG's first chunk states, before anything is unpacked.
bool tooLargePng(const std::vector<unsigned char>& bytes) {
    if (bytes.size() < 24 || bytes[0] != 0x89 || bytes[1] != 'P') return false;
    const auto number = [&](std::size_t at) {
        return static_cast<unsigned>(bytes[at]) << 24U | static_cast<unsigned>(bytes[at + 1]) << 16U |
               static_cast<unsigned>(bytes[at + 2]) << 8U | static_cast<unsigned>(bytes[at + 3]);
    };
    return number(16) > widest_texture || number(20) > widest_texture;
}

double numberOr(const tinygltf::Value& object, const char* key, double otherwise) {
    return object.Has(key) && object.Get(key).IsNumber() ? object.Get(key).GetNumberAsDouble() : otherwise;
}

glm::dvec2 pairOr(const tinygltf::Value& object, const char* key, double otherwise) {
    if (!object.Has(key) || !object.Get(key).IsArray() || object.Get(key).ArrayLen() != 2)
        return glm::dvec2(otherwise);
    const tinygltf::Value& pair = object.Get(key);
    if (!pair.Get(0).IsNumber() || !pair.Get(1).IsNumber()) return glm::dvec2(otherwise);
    return {pair.Get(0).GetNumberAsDouble(), pair.Get(1).GetNumberAsDouble()};
}

}  // namespace

glm::vec2 MaterialLook::placed(const glm::vec2& uv) const {
    if (uv_rotation_rad == 0.0 && uv_scale == glm::dvec2(1.0) && uv_offset == glm::dvec2(0.0)) return uv;
    const glm::dvec2 scaled = uv_scale * glm::dvec2(uv);
    const double c = std::cos(uv_rotation_rad);
    const double s = std::sin(uv_rotation_rad);
    return glm::vec2(uv_offset + glm::dvec2(c * scaled.x - s * scaled.y, s * scaled.x + c * scaled.y));
}

Result<MaterialLook> MaterialReader::look(int material) {
    if (const auto known = looks_.find(material); known != looks_.end()) return known->second;
    Result<MaterialLook> made = MaterialLook{};
    if (material >= 0) {
        if (static_cast<std::size_t>(material) >= model_.materials.size())
            return fail(file_, fmt::format("material {} does not exist", material), "Export the file anew");
        made = read(model_.materials[static_cast<std::size_t>(material)], material);
    } else {
        made->part = partFor({});
    }
    if (made) looks_.emplace(material, *made);
    return made;
}

Result<MaterialLook> MaterialReader::read(const tinygltf::Material& material, int index) {
    const std::string name = material.name.empty() ? fmt::format("material {}", index) : material.name;
    const auto& pbr = material.pbrMetallicRoughness;
    MaterialLook look;
    const auto& factor = pbr.baseColorFactor;
    if (std::any_of(factor.begin(), factor.end(), [](double f) { return !std::isfinite(f); }))
        return fail(file_, fmt::format("the colour of {} is no number", name), "Export the file anew");
    if (factor.size() >= 3) look.factor = glm::vec3(glm::dvec3(factor[0], factor[1], factor[2]));
    AvatarPart part;
    part.double_sided = material.doubleSided;
    if (material.alphaMode == "MASK") part.alpha_cutoff = static_cast<float>(material.alphaCutoff);
    if (material.alphaMode == "BLEND") {
        part.alpha_cutoff = 0.5F;
        remarks_.push_back(
            fmt::format("{} is translucent: drawn where it covers more than half, else not", name));
    }
    if (part.alpha_cutoff > 0.0F && factor.size() == 4)
        part.alpha_cutoff /= static_cast<float>(std::max(factor[3], 1e-6));
    if (pbr.baseColorTexture.index >= 0) {
        const auto made = texture(pbr.baseColorTexture.index);
        if (!made) return tl::unexpected(made.error());
        part.texture = *made;
        look.uv_set = pbr.baseColorTexture.texCoord;
        const auto& extensions = pbr.baseColorTexture.extensions;
        const auto transform = extensions.find("KHR_texture_transform");
        if (transform != extensions.end() && transform->second.IsObject()) {
            const tinygltf::Value& values = transform->second;
            look.uv_offset = pairOr(values, "offset", 0.0);
            look.uv_scale = pairOr(values, "scale", 1.0);
            look.uv_rotation_rad = numberOr(values, "rotation", 0.0);
            look.uv_set = static_cast<int>(numberOr(values, "texCoord", look.uv_set));
        }
    }
    // Without a texture there is nothing that could have holes.
    if (part.texture < 0 && part.alpha_cutoff <= 1.0F) part.alpha_cutoff = 0.0F;
    look.part = partFor(part);
    return look;
}

std::size_t MaterialReader::partFor(const AvatarPart& part) {
    const auto same = std::find_if(parts_.begin(), parts_.end(), [&](const AvatarPart& known) {
        return known.texture == part.texture && known.alpha_cutoff == part.alpha_cutoff &&
               known.double_sided == part.double_sided;
    });
    if (same == parts_.end()) {
        parts_.push_back(part);
        return parts_.size() - 1;
    }
    return static_cast<std::size_t>(same - parts_.begin());
}

Result<int> MaterialReader::texture(int index) {
    if (static_cast<std::size_t>(index) >= model_.textures.size())
        return fail(file_, fmt::format("texture {} does not exist", index), "Export the file anew");
    const tinygltf::Texture& source = model_.textures[static_cast<std::size_t>(index)];
    const auto key = std::tuple(source.source, source.sampler);
    if (const auto known = texture_of_.find(key); known != texture_of_.end()) return known->second;
    auto made = decoded(source.source);
    if (!made) return tl::unexpected(made.error());
    if (source.sampler >= 0 && static_cast<std::size_t>(source.sampler) < model_.samplers.size()) {
        const tinygltf::Sampler& sampler = model_.samplers[static_cast<std::size_t>(source.sampler)];
        made->wrap_u = wrapOf(sampler.wrapS);
        made->wrap_v = wrapOf(sampler.wrapT);
        made->nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    textures_.push_back(std::move(*made));
    const int place = static_cast<int>(textures_.size()) - 1;
    texture_of_.emplace(key, place);
    return place;
}

Result<AvatarTexture> MaterialReader::decoded(int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= model_.images.size())
        return fail(file_, fmt::format("image {} of a texture does not exist", index),
                    "Export with PNG or JPEG textures");
    const tinygltf::Image& kept = model_.images[static_cast<std::size_t>(index)];
    const std::string name = !kept.name.empty()  ? kept.name
                             : !kept.uri.empty() ? kept.uri
                                                 : fmt::format("image {}", index);
    const auto bad = [&](const std::string& what) {
        return fail(file_, fmt::format("the texture \"{}\" {}", name, what),
                    "Export with PNG or JPEG textures");
    };
    if (kept.image.empty()) return bad("holds no bytes");
    if (tooLargePng(kept.image)) return bad(fmt::format("is wider or higher than {} pixels", widest_texture));
    tinygltf::Image image;
    std::string problem, warning;
    const bool loaded = tinygltf::LoadImageData(&image, index, &problem, &warning, 0, 0, kept.image.data(),
                                                static_cast<int>(kept.image.size()), nullptr);
    if (!loaded || image.component != 4 || image.width <= 0 || image.height <= 0)
        return bad("is no readable PNG or JPEG picture");
    if (image.width > widest_texture || image.height > widest_texture)
        return bad(fmt::format("is wider or higher than {} pixels", widest_texture));
    AvatarTexture texture;
    texture.width = image.width;
    texture.height = image.height;
    const std::size_t bytes =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    if (image.bits == 16) {  // the high byte of each
        texture.rgba.resize(bytes);
        for (std::size_t i = 0; i < bytes; ++i) texture.rgba[i] = image.image[2 * i + 1];
    } else {
        texture.rgba.assign(image.image.begin(), image.image.begin() + static_cast<std::ptrdiff_t>(bytes));
    }
    return texture;
}

}  // namespace deixis::assets
