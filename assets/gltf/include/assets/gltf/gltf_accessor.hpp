// Typed reading of glTF accessors, with every index and range checked.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace tinygltf {
class Model;
}

namespace deixis::assets {

/// Rows of numbers; row i starts at values[i * width].
struct GltfRows {
    std::vector<float> values;
    std::size_t width = 0;
    [[nodiscard]] std::size_t size() const { return width == 0 ? 0 : values.size() / width; }
};

/// Elements of any component type as floats; integers of normalised accessors become fractions (glTF 2.0,
/// section 3.6.2.2), sparse ones put in place (section 3.6.2.3; without a buffer view the others are 0).
/// `name` stands for the accessor in errors, such as "POSITION". Values are finite.
[[nodiscard]] Result<GltfRows> readGltfRows(const tinygltf::Model& model, int accessor,
                                            const std::string& file, const std::string& name);

/// Elements of an integer accessor, in rows as above.
struct GltfIntegers {
    std::vector<std::uint32_t> values;
    std::size_t width = 0;
};
[[nodiscard]] Result<GltfIntegers> readGltfIntegers(const tinygltf::Model& model, int accessor,
                                                    const std::string& file, const std::string& name);

}  // namespace deixis::assets
