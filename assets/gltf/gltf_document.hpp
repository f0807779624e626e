// What a glTF 2.0 file says of its nodes, skins and animations, as plain data. Section numbers are those of
// the glTF 2.0 specification (Khronos 2021).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/pose.hpp"
#include "gltf_json.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::assets::gltf {

struct Buffer {
    std::optional<std::string> uri;  ///< none: the binary chunk
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
    int component_type = 0;  ///< 5120..5126; other values are refused when it is read
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
    Quat rotation{1.0, 0.0, 0.0, 0.0};
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
    std::string source;  ///< the extension, such as "VRMC_vrm"
    std::vector<std::pair<motion::Bone, int>> nodes;
    std::vector<int> other_nodes;  ///< of a VRM animation: they carry expressions and gaze, no body
    bool faces_minus_z = false;    ///< as VRM 0.x models do
};

struct Document {
    std::string file;      ///< for errors
    std::string_view bin;  ///< the binary chunk; a part of the bytes that were read
    bool has_bin = false;
    std::vector<Buffer> buffers;
    std::vector<BufferView> views;
    std::vector<Accessor> accessors;
    std::vector<Node> nodes;              ///< a forest: no rings, one parent at most
    std::vector<std::vector<int>> skins;  ///< the nodes that are their joints
    std::vector<Animation> animations;
    std::optional<Humanoid> humanoid;
    std::vector<std::string> remarks;  ///< where the file breaks the specification and yet can be read
};

/// Reads text (.gltf) or a binary (.glb, .vrm, .vrma); throws Refusal. `bytes` must outlive the document.
[[nodiscard]] Document readDocument(std::string_view bytes, const std::string& file);

/// The humanoid of VRM 0.x, VRM 1.0 or a VRM animation, where the file has one; throws Refusal. Unknown bones
/// and such are told in `remarks`.
[[nodiscard]] std::optional<Humanoid> readHumanoid(const Cursor& root, std::size_t node_count,
                                                   std::vector<std::string>& remarks);

}  // namespace deixis::assets::gltf
