// Writing binary glTF (.glb): the one writer, for clips and for the figures that the tools make.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace deixis::assets {

using GltfJson = nlohmann::ordered_json;  ///< keys stay in the order in which they are set

/// Collects numbers, and the views and accessors by which the JSON finds them. The same bytes from every
/// compiler.
class GlbWriter {
  public:
    /// Index of the new accessor over `count` elements of a type such as "VEC3". `target`: 34962 of vertices,
    /// 34963 of indices, 0 of others.
    std::size_t add(const std::vector<float>& values, std::size_t count, std::string_view type,
                    int target = 0);
    std::size_t add(const std::vector<std::uint8_t>& values, std::size_t count, std::string_view type,
                    int target = 0);
    std::size_t add(const std::vector<std::uint16_t>& values, std::size_t count, std::string_view type,
                    int target = 0);
    std::size_t add(const std::vector<std::uint32_t>& values, std::size_t count, std::string_view type,
                    int target = 0);
    /// Index of a new view of bytes, such as a picture's.
    std::size_t addBytes(std::string_view bytes);
    /// The smallest and the largest of each of an accessor's components, as arrays.
    void setBounds(std::size_t accessor, GltfJson min, GltfJson max);

    /// The file: `root` with accessors, views and buffer added. Throws std::invalid_argument if it would
    /// hold 4 GiB or more.
    [[nodiscard]] std::string file(GltfJson root) const;

  private:
    template <typename T>
    std::size_t add(const std::vector<T>& values, int component_type, std::size_t count,
                    std::string_view type, int target);

    std::string bytes_;
    GltfJson views_ = GltfJson::array(), accessors_ = GltfJson::array();
};

}  // namespace deixis::assets
