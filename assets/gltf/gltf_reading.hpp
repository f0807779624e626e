// The parts of a document that are read in files of their own.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "assets/gltf/gltf_document.hpp"
#include "gltf_json.hpp"

namespace deixis::assets::gltf {

/// The "uri" of a buffer or an image, where it has one: its path is judged, and nothing opened.
[[nodiscard]] Outside readOutside(const Cursor& in, const std::string& file);

/// Exactly `size` finite numbers.
template <std::size_t size>
[[nodiscard]] std::array<double, size> readNumbers(const Cursor& in) {
    if (in.size() != size) in.expected(("an array of " + std::to_string(size) + " numbers").c_str());
    std::array<double, size> numbers{};
    for (std::size_t i = 0; i < size; ++i) numbers[i] = in.at(i).number();
    return numbers;
}

/// Scenes, meshes, materials, textures and images; nodes, views and accessors are there already.
void readFigure(const Cursor& root, Document& document);

/// The humanoid of VRM 0.x, VRM 1.0 or a VRM animation, where the file has one. Unknown bones and such are
/// told in `remarks`.
[[nodiscard]] std::optional<Humanoid> readHumanoid(const Cursor& root, std::size_t node_count,
                                                   std::vector<std::string>& remarks);

}  // namespace deixis::assets::gltf
