#include "gltf_sparse.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>

namespace deixis::assets::gltf {

namespace {

template <typename Index>
std::size_t indexAt(const char* bytes, std::size_t i) {
    Index index;
    std::memcpy(&index, bytes + i * sizeof index, sizeof index);
    return index;
}

}  // namespace

std::optional<std::string> sparseProblem(std::size_t count, int index_type, std::size_t elements) {
    if (index_type != 5121 && index_type != 5123 && index_type != 5125)
        return fmt::format("found sparse indices of component type {}, expected 5121, 5123 or 5125",
                           index_type);
    if (count == 0 || count > elements) return fmt::format("replaces {} of {} elements", count, elements);
    return std::nullopt;
}

tl::expected<std::vector<std::size_t>, std::string> sparseIndices(const char* bytes, std::size_t count,
                                                                  int index_type, std::size_t elements) {
    std::vector<std::size_t> indices;
    indices.reserve(count);
    std::size_t least = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t index = index_type == 5121   ? indexAt<std::uint8_t>(bytes, i)
                                  : index_type == 5123 ? indexAt<std::uint16_t>(bytes, i)
                                                       : indexAt<std::uint32_t>(bytes, i);
        if (index < least || index >= elements)
            return tl::unexpected(
                fmt::format("sparse index {} is {}, expected {} to {}", i, index, least, elements - 1));
        least = index + 1;
        indices.push_back(index);
    }
    return indices;
}

}  // namespace deixis::assets::gltf
