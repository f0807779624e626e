// MakeHuman's base mesh, and a rig of MPFB fitted to it.
//
// Formats: the mesh is Wavefront OBJ in decimetres, y up, facing +z, whose groups are the body ("body"),
// helpers that carry clothes, and cubes that stand where joints are ("joint-..."). A rig file of MPFB 2 tells
// for the head and tail of each bone how to find it on the mesh ("strategy"): CUBE is the middle of the cube
// named, MEAN that of the vertices listed. A weights file lists for each bone [vertex, weight] pairs.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::humanoid_maker {

struct BaseMesh {
    std::vector<Vec3> vertices;                                        ///< metres, y up, soles on y = 0
    std::vector<std::array<std::uint32_t, 3>> body;                    ///< triangles of the group "body"
    std::map<std::string, std::vector<std::uint32_t>> group_vertices;  ///< of the other groups
};
[[nodiscard]] Result<BaseMesh> readBaseMesh(const std::filesystem::path& obj);

struct RigBone {
    std::string name;
    int parent = -1;  ///< smaller than the bone's own index
    Vec3 head{0.0}, tail{0.0};
};
[[nodiscard]] Result<std::vector<RigBone>> readRig(const std::filesystem::path& json, const BaseMesh& mesh);

struct VertexWeights {
    std::array<std::uint8_t, 4> bones{};
    std::array<float, 4> weights{};  ///< heaviest first; their sum is exactly 1
};
/// Of every vertex of the mesh, the four heaviest. Vertices of the body must have some.
[[nodiscard]] Result<std::vector<VertexWeights>> readWeights(const std::filesystem::path& json,
                                                             const BaseMesh& mesh,
                                                             const std::vector<RigBone>& bones);

}  // namespace deixis::humanoid_maker
