#include "materials.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>  // for its decoder of pictures alone

#include <algorithm>
#include <cmath>

namespace deixis::assets {

namespace {

constexpr int widest_texture = 8192;

TextureWrap wrapOf(std::size_t gl_mode) {
    if (gl_mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return TextureWrap::clamp;
    return gl_mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? TextureWrap::mirror : TextureWrap::repeat;
}

/// The size that a PNG's first chunk states, before anything is unpacked.
bool tooLargePng(std::string_view bytes) {
    if (bytes.size() < 24 || !bytes.starts_with("\x89P")) return false;
    const auto number = [&](std::size_t at) {
        unsigned value = 0;
        for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
        return value;
    };
    return number(16) > widest_texture || number(20) > widest_texture;
}

}  // namespace

glm::vec2 MaterialLook::placed(const glm::vec2& uv) const {
    if (material == nullptr) return uv;
    const auto& [offset, scale, angle] =
        std::tie(material->uv_offset, material->uv_scale, material->uv_rotation_rad);
    if (angle == 0.0 && scale == glm::dvec2(1.0) && offset == glm::dvec2(0.0)) return uv;
    const glm::dvec2 scaled = scale * glm::dvec2(uv);
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return glm::vec2(offset + glm::dvec2(c * scaled.x - s * scaled.y, s * scaled.x + c * scaled.y));
}

MaterialLook MaterialReader::look(int material) {
    if (const auto known = looks_.find(material); known != looks_.end()) return known->second;
    MaterialLook made;
    if (material >= 0)
        made = read(doc_.materials[static_cast<std::size_t>(material)], material);
    else
        made.part = partFor({});
    return looks_[material] = made;
}

MaterialLook MaterialReader::read(const gltf::Material& material, int index) {
    MaterialLook look;
    look.material = &material;
    const auto& factor = material.colour;
    look.factor = glm::vec3(glm::dvec3(factor[0], factor[1], factor[2]));
    AvatarPart part;
    part.double_sided = material.double_sided;
    if (material.alpha_mode == "MASK") part.alpha_cutoff = static_cast<float>(material.alpha_cutoff);
    if (material.alpha_mode == "BLEND") {
        part.alpha_cutoff = 0.5F;
        remarks_.push_back(
            fmt::format("{} is translucent: drawn only where it covers more than half",
                        material.name.empty() ? fmt::format("material {}", index) : material.name));
    }
    if (part.alpha_cutoff > 0.0F) part.alpha_cutoff /= static_cast<float>(std::max(factor[3], 1e-6));
    if (material.texture >= 0) {
        part.texture = texture(material.texture);
        look.uv_set = material.uv_set;
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

int MaterialReader::texture(int index) {
    const gltf::Texture& source = doc_.textures[static_cast<std::size_t>(index)];
    const auto key = std::tuple(source.image, source.sampler);
    if (const auto known = texture_of_.find(key); known != texture_of_.end()) return known->second;
    AvatarTexture made = decoded(source.image);
    if (source.sampler >= 0) {
        const gltf::TextureSampler& sampler = doc_.texture_samplers[static_cast<std::size_t>(source.sampler)];
        made.wrap_u = wrapOf(sampler.wrap_u);
        made.wrap_v = wrapOf(sampler.wrap_v);
        made.nearest = sampler.mag_filter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    textures_.push_back(std::move(made));
    const int place = static_cast<int>(textures_.size()) - 1;
    texture_of_.emplace(key, place);
    return place;
}

AvatarTexture MaterialReader::decoded(int index) {
    const auto bad = [&](const std::string& what) {
        gltf::reject(doc_.file, what, "Export with PNG or JPEG textures");
    };
    if (index < 0) bad("a texture has no image");
    const gltf::Image& kept = doc_.images[static_cast<std::size_t>(index)];
    const std::string name = "the texture \"" +
                             (!kept.name.empty()           ? kept.name
                              : !kept.outside.file.empty() ? kept.outside.file
                                                           : fmt::format("image {}", index)) +
                             "\" ";
    const std::string bytes = values_.image(static_cast<std::size_t>(index));
    const std::string too_large = fmt::format("{}is wider or higher than {} pixels", name, widest_texture);
    if (bytes.empty()) bad(name + "has no bytes");
    if (tooLargePng(bytes)) bad(too_large);
    tinygltf::Image image;
    std::string problem, warning;
    const bool loaded = tinygltf::LoadImageData(&image, index, &problem, &warning, 0, 0,
                                                reinterpret_cast<const unsigned char*>(bytes.data()),
                                                static_cast<int>(bytes.size()), nullptr);
    if (!loaded || image.component != 4 || image.width <= 0 || image.height <= 0)
        bad(name + "is not a readable PNG or JPEG picture");
    if (image.width > widest_texture || image.height > widest_texture) bad(too_large);
    AvatarTexture texture;
    texture.width = image.width;
    texture.height = image.height;
    const std::size_t size =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4;
    if (image.bits == 16) {  // the high byte of each
        texture.rgba.resize(size);
        for (std::size_t i = 0; i < size; ++i) texture.rgba[i] = image.image[2 * i + 1];
    } else {
        texture.rgba.assign(image.image.begin(), image.image.begin() + static_cast<std::ptrdiff_t>(size));
    }
    return texture;
}

}  // namespace deixis::assets
