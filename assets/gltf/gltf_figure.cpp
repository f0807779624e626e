// What a figure needs beside its nodes and skins: scenes, meshes, materials and pictures.
#include "gltf_reading.hpp"

namespace deixis::assets::gltf {

namespace {

Primitive readPrimitive(const Cursor& in, const Cursor& root, const Document& document) {
    Primitive primitive;
    const Cursor attributes = in.at("attributes");
    for (const std::string& name : attributes.keys())
        primitive.attributes[name] = attributes.at(name.c_str()).index(document.accessors.size(), "accessor");
    primitive.indices = in.index("indices", document.accessors.size(), "accessor");
    primitive.material = in.index("material", root.count("materials"), "material");
    primitive.mode = in.has("mode") ? in.at("mode").index(7, "mode") : 4;
    return primitive;
}

Material readMaterial(const Cursor& in, const Cursor& root) {
    Material material;
    material.name = in.text("name", "");
    material.alpha_mode = in.text("alphaMode", "OPAQUE");
    if (in.has("alphaCutoff")) material.alpha_cutoff = in.at("alphaCutoff").number();
    material.double_sided = in.has("doubleSided") && in.at("doubleSided").flag();
    if (!in.has("pbrMetallicRoughness")) return material;
    const Cursor pbr = in.at("pbrMetallicRoughness");
    if (pbr.has("baseColorFactor")) material.colour = readNumbers<4>(pbr.at("baseColorFactor"));
    if (!pbr.has("baseColorTexture")) return material;
    const Cursor texture = pbr.at("baseColorTexture");
    constexpr std::size_t max_uv_sets = 1000;
    material.texture = texture.at("index").index(root.count("textures"), "texture");
    if (texture.has("texCoord")) material.uv_set = texture.at("texCoord").index(max_uv_sets, "set");
    if (!texture.has("extensions") || !texture.at("extensions").has("KHR_texture_transform")) return material;
    const Cursor transform = texture.at("extensions").at("KHR_texture_transform");
    if (transform.has("offset")) {
        const auto offset = readNumbers<2>(transform.at("offset"));
        material.uv_offset = {offset[0], offset[1]};
    }
    if (transform.has("scale")) {
        const auto scale = readNumbers<2>(transform.at("scale"));
        material.uv_scale = {scale[0], scale[1]};
    }
    if (transform.has("rotation")) material.uv_rotation_rad = transform.at("rotation").number();
    if (transform.has("texCoord")) material.uv_set = transform.at("texCoord").index(max_uv_sets, "set");
    return material;
}

}  // namespace

void readFigure(const Cursor& root, Document& document) {
    for (const Cursor& in : root.elements("scenes")) {
        document.scenes.emplace_back();
        for (const Cursor& node : in.elements("nodes"))
            document.scenes.back().push_back(node.index(document.nodes.size(), "node"));
    }
    if (root.has("scene")) document.scene = root.index("scene", document.scenes.size(), "scene");
    for (const Cursor& in : root.elements("meshes")) {
        Mesh mesh{in.text("name", ""), {}};
        static_cast<void>(in.at("primitives"));
        for (const Cursor& primitive : in.elements("primitives"))
            mesh.primitives.push_back(readPrimitive(primitive, root, document));
        document.meshes.push_back(std::move(mesh));
    }
    for (const Cursor& in : root.elements("materials")) document.materials.push_back(readMaterial(in, root));
    for (const Cursor& in : root.elements("textures"))
        document.textures.push_back({in.index("source", root.count("images"), "image"),
                                     in.index("sampler", root.count("samplers"), "sampler")});
    for (const Cursor& in : root.elements("samplers"))
        document.texture_samplers.push_back(
            {in.whole("wrapS", 0), in.whole("wrapT", 0), in.whole("magFilter", 0)});
    for (const Cursor& in : root.elements("images"))
        document.images.push_back({in.text("name", ""), readOutside(in, document.file),
                                   in.index("bufferView", document.views.size(), "buffer view")});
}

}  // namespace deixis::assets::gltf
