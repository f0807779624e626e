// Materials, textures, and files beside a .gltf.
#include <doctest/doctest.h>

#include <filesystem>

#include "assets/avatar/avatar.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "gltf_rig.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::tests;
namespace fs = std::filesystem;

namespace {

// 2 x 2 pixels: red, green; blue, white with alpha 0. Written with Python's zlib.
constexpr auto png_base64 =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAYAAABytg0kAAAAE0lEQVR42mP4z8DwHwyBNAgwAABIyQj4xTT9BQAAAABJRU5ErkJggg="
    "=";

std::string unbase64(const std::string& text) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        const auto value = letters.find(c);
        if (value == std::string_view::npos) break;
        bits = bits << 6U | static_cast<unsigned>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            out.push_back(static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU));
        }
    }
    return out;
}

fs::path folder() {
    const fs::path path = deixis::tests::buildDir() / "avatar_materials_test";
    fs::create_directories(path);
    return path;
}

Result<assets::Avatar> loadMaterials(const std::string& bytes, const std::string& name = "figure.glb") {
    REQUIRE(writeFile(folder() / name, bytes).has_value());
    return assets::loadAvatar(folder() / name);
}

void checkMaterialError(const Result<assets::Avatar>& result, const std::string& words) {
    REQUIRE_FALSE(result.has_value());
    INFO(result.error().text());
    CHECK(result.error().text().find(words) != std::string::npos);
    CHECK(result.error().where.find("figure") != std::string::npos);
}

/// A plain figure whose mesh has the texture coordinate (0.25, 0.5) everywhere, the colour (0.5, 1, 1), and
/// the material given.
GlbText figure(const std::string& material, const std::string& image) {
    const RigOptions options;
    const Rig rig = makeRig(options);
    GlbText file;
    addNodes(file, rig, options);
    std::vector<float> uvs, colours;
    for (std::size_t v = 0; v < rig.vertices.size(); ++v) {
        uvs.insert(uvs.end(), {0.25F, 0.5F});
        colours.insert(colours.end(), {0.5F, 1.0F, 1.0F});
    }
    const int uv = file.accessor(uvs, 5126, "VEC2", rig.vertices.size());
    const int colour = file.accessor(colours, 5126, "VEC3", rig.vertices.size());
    addMesh(file, rig, options, R"(,"material":0)");
    std::string& mesh = file.meshes.front();
    mesh.insert(mesh.find(R"("POSITION")"), fmt::format(R"("TEXCOORD_0":{},"COLOR_0":{},)", uv, colour));
    file.more = fmt::format(R"(,"materials":[{}],"textures":[{{"source":0,"sampler":0}}],)"
                            R"("samplers":[{{"wrapS":33071,"wrapT":33648,"magFilter":9728}}],"images":[{}])",
                            material, image);
    return file;
}

const std::string data_image = fmt::format(R"({{"uri":"data:image/png;base64,{}"}})", png_base64);
const std::string textured = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";

}  // namespace

TEST_SUITE("assets/avatar_materials") {
    TEST_CASE("A base colour texture is decoded; factor and vertex colours multiply") {
        const auto avatar =
            loadMaterials(figure(R"({"alphaMode":"MASK","alphaCutoff":0.3,"doubleSided":true,)"
                                 R"("pbrMetallicRoughness":{"baseColorFactor":[0.4,0.5,0.6,0.5],)"
                                 R"("baseColorTexture":{"index":0}}})",
                                 data_image)
                              .glb());
        REQUIRE_MESSAGE(avatar.has_value(), (avatar ? std::string() : avatar.error().text()));
        REQUIRE(avatar->textures.size() == 1);
        const assets::AvatarTexture& texture = avatar->textures[0];
        CHECK(texture.width == 2);
        CHECK(texture.height == 2);
        CHECK(texture.rgba ==
              std::vector<std::uint8_t>{255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0});
        CHECK(texture.wrap_u == assets::TextureWrap::clamp);
        CHECK(texture.wrap_v == assets::TextureWrap::mirror);
        CHECK(texture.nearest);
        REQUIRE(avatar->parts.size() == 1);
        const assets::AvatarPart& part = avatar->parts[0];
        CHECK(part.texture == 0);
        CHECK(part.first_index == 0);
        CHECK(part.index_count == avatar->indices.size());
        CHECK(part.alpha_cutoff == doctest::Approx(0.6));  // the factor halves every texel's alpha
        CHECK(part.double_sided);
        CHECK(avatar->vertices[0].colour.r == doctest::Approx(0.2));
        CHECK(avatar->vertices[0].colour.b == doctest::Approx(0.6));
        CHECK(avatar->vertices[0].uv == glm::vec2(0.25F, 0.5F));
    }

    TEST_CASE("KHR_texture_transform moves the texture coordinates: scaled, turned, shifted") {
        const auto avatar = loadMaterials(
            figure(
                R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":)"
                R"({"KHR_texture_transform":{"offset":[0.1,0.2],"scale":[2,0.5],"rotation":1.5707963267948966}}}}})",
                data_image)
                .glb());
        REQUIRE(avatar.has_value());
        // (0.25, 0.5) -> (0.5, 0.25) -> a quarter turn (-0.25, 0.5) -> (-0.15, 0.7)
        CHECK(avatar->vertices[0].uv.x == doctest::Approx(-0.15));
        CHECK(avatar->vertices[0].uv.y == doctest::Approx(0.7));
    }

    TEST_CASE("A translucent material is drawn with holes, with a remark; an opaque one has none") {
        auto avatar = loadMaterials(
            figure(
                R"({"name":"veil","alphaMode":"BLEND","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})",
                data_image)
                .glb());
        REQUIRE(avatar.has_value());
        CHECK(avatar->parts[0].alpha_cutoff == 0.5F);
        REQUIRE(avatar->remarks.size() == 1);
        CHECK(avatar->remarks[0].find("veil") != std::string::npos);
        avatar = loadMaterials(figure(textured, data_image).glb());
        REQUIRE(avatar.has_value());
        CHECK(avatar->parts[0].alpha_cutoff == 0.0F);
        CHECK(avatar->remarks.empty());
    }

    TEST_CASE("Pictures that are none are named, and only those that are shown are opened") {
        checkMaterialError(
            loadMaterials(figure(textured, R"({"name":"face","uri":"data:image/png;base64,AAAA"})").glb()),
            "\"face\" is not a readable PNG or JPEG");
        checkMaterialError(
            loadMaterials(
                figure(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":4}}})", data_image).glb()),
            "texture 4");
        const auto unused =
            loadMaterials(figure(R"({"name":"plain"})", R"({"uri":"data:image/png;base64,AAAA"})").glb());
        CHECK(unused.has_value());
    }

    TEST_CASE("A .gltf is read with its files, escaped names too; their bytes count in the hash") {
        const GlbText file = figure(textured, R"({"uri":"my%20face.png"})");
        REQUIRE(writeFile(folder() / "figure data.bin", file.bytes()).has_value());
        REQUIRE(writeFile(folder() / "my face.png", unbase64(png_base64)).has_value());
        const std::string text = file.json("figure%20data.bin");
        const auto avatar = loadMaterials(text, "figure.gltf");
        REQUIRE_MESSAGE(avatar.has_value(), (avatar ? std::string() : avatar.error().text()));
        CHECK(avatar->textures.size() == 1);
        CHECK(avatar->content_hash.size() == 64);
        CHECK(avatar->content_hash != sha256Hex(text));
        std::string changed = unbase64(png_base64);
        changed += '\0';  // behind the picture's end
        REQUIRE(writeFile(folder() / "my face.png", changed).has_value());
        const auto other = loadMaterials(text, "figure.gltf");
        REQUIRE(other.has_value());
        CHECK(other->content_hash != avatar->content_hash);
    }

    TEST_CASE("Names that leave the folder, or lead to no file, are rejected before anything is opened") {
        const GlbText file = figure(textured, data_image);
        REQUIRE(writeFile(folder().parent_path() / "outside.bin", file.bytes()).has_value());
        checkMaterialError(loadMaterials(file.json("../outside.bin"), "figure.gltf"), "leaves the folder");
        checkMaterialError(loadMaterials(file.json("%2e%2e/outside.bin"), "figure.gltf"),
                           "leaves the folder");
        checkMaterialError(loadMaterials(file.json("a/../../outside.bin"), "figure.gltf"),
                           "leaves the folder");
        checkMaterialError(loadMaterials(file.json("/etc/passwd"), "figure.gltf"), "\"/etc/passwd\"");
        checkMaterialError(loadMaterials(file.json("http://example.org/a.bin"), "figure.gltf"),
                           "http://example.org/a.bin");
        checkMaterialError(loadMaterials(file.json("file:///etc/passwd"), "figure.gltf"),
                           "file:///etc/passwd");
        checkMaterialError(loadMaterials(file.json("lost.bin"), "figure.gltf"), "which does not exist");
        std::error_code code;
        fs::remove(folder() / "link.bin", code);
        fs::create_symlink(folder().parent_path() / "outside.bin", folder() / "link.bin", code);
        if (!code)
            checkMaterialError(loadMaterials(file.json("link.bin"), "figure.gltf"),
                               "link that leaves the folder");
    }

    TEST_CASE(
        "An extension that must be known and is not is named; those that change nothing are let through") {
        GlbText file = figure(textured, data_image);
        const std::string before = file.more;
        file.more +=
            R"(,"extensionsUsed":["KHR_draco_mesh_compression"],"extensionsRequired":["KHR_draco_mesh_compression"])";
        checkMaterialError(loadMaterials(file.glb()), "KHR_draco_mesh_compression");
        file.more =
            before +
            R"(,"extensionsUsed":["KHR_materials_unlit"],"extensionsRequired":["KHR_materials_unlit"])";
        CHECK(loadMaterials(file.glb()).has_value());
    }
}
