// A figure as a glTF 2.0 binary, for the tools that make figures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assets/gltf/glb_writer.hpp"
#include "core/pose.hpp"

namespace deixis::assets {

struct FigureJoint {
    std::string name;
    int parent = -1;          ///< smaller than the joint's own index
    Vec3 in_parent{0.0};      ///< metres; no joint is turned at rest
    Vec3 position{0.0};       ///< in the figure
    std::optional<Vec3> tip;  ///< in the joint, where the chain ends
};

/// Rows of 3 numbers for each vertex, 4 of weights and joints.
struct FigureVertices {
    std::vector<float> positions, normals, weights;
    std::vector<float> colours;  ///< none: white
    std::vector<std::uint8_t> joints;
};

/// One node per joint and per tip ("NAME_end"), one skin, one mesh "body" of one primitive. `material`: as
/// glTF has it. The same figure gives the same bytes.
[[nodiscard]] std::string figureGlb(const std::string& generator, const std::vector<FigureJoint>& joints,
                                    const FigureVertices& vertices, const std::vector<std::uint32_t>& indices,
                                    const GltfJson& material);

}  // namespace deixis::assets
