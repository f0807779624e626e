// The content of a glTF 2.0 file as plain data: the one reader of glTF, for clips and for figures. Section
// numbers are those of the glTF 2.0 specification (Khronos 2021).
//
// The reader is our own, since tinygltf ignores values of a wrong type, does not say where in the file an
// error is, and opens the files that it names while it parses, before their paths can be checked.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/gltf/gltf_rejection.hpp"
#include "core/pose.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::assets::gltf {

/// Where bytes stand that are not in the binary chunk: both empty, or one of them.
struct Outside {
    std::string data_uri;
    std::string file;  ///< path below the glTF file's folder
};

struct Buffer {
    Outside outside;  ///< neither: the binary chunk
    std::size_t length = 0;
};

struct BufferView {
    int buffer = 0;
    std::size_t offset = 0, length = 0;
    std::size_t stride = 0;  ///< 0: elements stand close together
};

/// Replaced elements of an accessor (section 3.6.2.3).
struct Sparse {
    std::size_t count = 0;
    int index_view = 0, index_type = 0, value_view = 0;
    std::size_t index_offset = 0, value_offset = 0;
};

struct Accessor {
    int view = -1;  ///< -1: all zero, but for what `sparse` replaces
    std::size_t offset = 0, count = 0;
    int component_type = 0;  ///< 5120..5126; other values are rejected when it is read
    std::string type;        ///< "SCALAR", "VEC3", ...
    bool normalised = false, has_bounds = false;
    std::optional<Sparse> sparse;
};

[[nodiscard]] std::size_t componentSize(int component_type);      ///< bytes; 0 for an unknown type
[[nodiscard]] std::size_t elementWidth(const std::string& type);  ///< numbers; 0 for an unknown type
[[nodiscard]] std::size_t elementSize(const Accessor& accessor);  ///< bytes, with the padding of matrices

struct Node {
    std::string name;
    int parent = -1;
    std::vector<int> children;
    Vec3 translation{0.0}, scale{1.0};
    Quat rotation{1.0, 0.0, 0.0, 0.0};  ///< of unit length; of figures as the file has it
    /// Of figures alone, instead of the three: a clip's must be made of them, and is taken apart.
    std::optional<glm::dmat4> matrix;
    int mesh = -1, skin = -1;
};

struct Skin {
    std::vector<int> joints;  ///< nodes, as listed
    int inverse_bind = -1;    ///< accessor
};

enum class Interpolation : unsigned char { step, linear, cubic_spline };
enum class Path : unsigned char { translation, rotation, scale };

struct Sampler {
    int input = 0, output = 0;
    Interpolation interpolation = Interpolation::linear;
};

struct Channel {
    int sampler = 0, node = 0;
    Path path = Path::translation;
};

struct Animation {
    std::string name;
    std::vector<Sampler> samplers;
    std::vector<Channel> channels;  ///< those that move nodes, each target once
    bool has_others = false;        ///< morph weights and what extensions animate
};

/// The humanoid bones that VRM's extensions name.
struct Humanoid {
    std::string source;                               ///< the extension, such as "VRMC_vrm"
    std::vector<std::pair<motion::Bone, int>> nodes;  ///< in the bones' order
    std::vector<int> other_nodes;  ///< of a VRM animation: they carry expressions and gaze, no body
    bool faces_minus_z = false;    ///< as VRM 0.x models do
};

struct Primitive {
    std::map<std::string, int> attributes;  ///< accessors
    int indices = -1, material = -1;
    int mode = 4;  ///< section 3.7.2.1; 4: triangles
};

struct Mesh {
    std::string name;
    std::vector<Primitive> primitives;
};

/// As far as its colour goes; with KHR_texture_transform: uv' = offset + rotation * (scale * uv).
struct Material {
    std::string name;
    std::array<double, 4> colour{1.0, 1.0, 1.0, 1.0};  ///< the base colour factor, linear
    int texture = -1, uv_set = 0;
    glm::dvec2 uv_offset{0.0}, uv_scale{1.0};
    double uv_rotation_rad = 0.0;
    std::string alpha_mode = "OPAQUE";
    double alpha_cutoff = 0.5;
    bool double_sided = false;
};

struct Texture {
    int image = -1, sampler = -1;
};

/// How a texture is sampled, in OpenGL's numbers; 0 where the file does not say.
struct TextureSampler {
    std::size_t wrap_u = 0, wrap_v = 0, mag_filter = 0;
};

struct Image {
    std::string name;
    Outside outside;
    int view = -1;
};

/// What is wanted of a file beside its nodes, skins and humanoid.
enum class Content : unsigned char {
    clip,   ///< animations
    figure  ///< scenes, meshes, materials and pictures
};

struct Document {
    std::string file;      ///< for errors
    std::string_view bin;  ///< the binary chunk; a part of the bytes that were read
    bool has_bin = false;
    std::vector<Buffer> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<Node> nodes;  ///< a forest: no rings, one parent at most
    std::vector<Skin> skins;
    std::vector<Animation> animations;
    std::vector<std::vector<int>> scenes;  ///< their top nodes
    int scene = 0;                         ///< the one that is shown
    std::vector<Mesh> meshes;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<TextureSampler> texture_samplers;
    std::vector<Image> images;
    std::optional<Humanoid> humanoid;
    std::vector<std::string> remarks;  ///< where the file breaks the specification and yet can be read

    [[nodiscard]] std::size_t accessorWidth(int accessor) const {
        return elementWidth(accessors[static_cast<std::size_t>(accessor)].type);
    }
};

/// Reads text (.gltf) or a binary (.glb, .vrm, .vrma); throws Refusal. `bytes` must outlive the document.
[[nodiscard]] Document readDocument(std::string_view bytes, const std::string& file, Content content);

}  // namespace deixis::assets::gltf
