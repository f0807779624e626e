#include "gltf_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "gltf_container.hpp"
#include "gltf_sparse.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr std::size_t most_elements = 10'000'000;

template <typename T>
T component(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

double number(const char* from, int component_type, bool normalised) {
    const auto fraction = [&](double value, double greatest) {
        return normalised ? std::max(value / greatest, -1.0) : value;
    };
    switch (component_type) {
        case 5120:
            return fraction(component<std::int8_t>(from), 127.0);
        case 5121:
            return fraction(component<std::uint8_t>(from), 255.0);
        case 5122:
            return fraction(component<std::int16_t>(from), 32767.0);
        case 5123:
            return fraction(component<std::uint16_t>(from), 65535.0);
        case 5125:
            return component<std::uint32_t>(from);
        default:
            return static_cast<double>(component<float>(from));
    }
}

}  // namespace

const std::vector<double>& Values::read(int accessor, const std::string& what) {
    const auto found = read_.find(accessor);
    if (found != read_.end()) return found->second;
    const std::string where = fmt::format("{}: /accessors/{} ({})", document_.file, accessor, what);
    return read_[accessor] = decode(document_.accessors[static_cast<std::size_t>(accessor)], where);
}

std::string_view Values::buffer(int index, const std::string& where) {
    const Buffer& buffer = document_.buffers[static_cast<std::size_t>(index)];
    if (!buffer.uri) {
        if (index != 0 || !document_.has_bin)
            refuse(where, fmt::format("lies in buffer {}, which has no data", index));
        return document_.bin.substr(0, buffer.length);
    }
    const auto found = buffers_.find(index);
    if (found != buffers_.end()) return std::string_view(found->second).substr(0, buffer.length);
    const std::string place = fmt::format("{}: /buffers/{}/uri", document_.file, index);
    auto data = decodeDataUri(*buffer.uri, place);
    if (!data) {
        if (!folder_) refuse(place, "names a file, and there is no folder to read it from");
        data = readNeighbour(*buffer.uri, *folder_, buffer.length, place);
    }
    return std::string_view(buffers_[index] = std::move(*data)).substr(0, buffer.length);
}

std::string_view Values::bytes(int view_index, std::size_t offset, std::size_t count, std::size_t element,
                               std::size_t stride, const std::string& where) {
    const BufferView& view = document_.views[static_cast<std::size_t>(view_index)];
    const std::string_view data = buffer(view.buffer, where);
    // Each bound alone first, so that no sum can overflow.
    if (view.offset > data.size() || view.length > data.size() - view.offset)
        refuse(where, fmt::format("buffer view {} (bytes {} to {}) leaves its buffer of {} bytes", view_index,
                                  view.offset, view.offset + view.length, data.size()));
    if (stride < element || stride > 4096)
        refuse(where, fmt::format("stride {} does not fit elements of {} bytes", stride, element));
    if (offset > view.length || view.length - offset < element ||
        count - 1 > (view.length - offset - element) / stride)
        refuse(where, fmt::format("{} elements from byte {} on leave buffer view {} of {} bytes", count,
                                  offset, view_index, view.length));
    return data.substr(view.offset + offset, (count - 1) * stride + element);
}

std::vector<double> Values::decode(const Accessor& accessor, const std::string& where) {
    const std::size_t width = elementWidth(accessor.type);
    const std::size_t size = componentSize(accessor.component_type);
    if (width == 0 || accessor.type.substr(0, 3) == "MAT")
        refuse(where, fmt::format("found type \"{}\", expected SCALAR, VEC2, VEC3 or VEC4", accessor.type));
    if (size == 0)
        refuse(where, fmt::format("found component type {}, expected 5120, 5121, 5122, 5123, 5125 or 5126",
                                  accessor.component_type));
    if (accessor.count == 0 || accessor.count > most_elements)
        refuse(where, fmt::format("found {} elements, expected 1 to {}", accessor.count, most_elements));
    std::vector<double> values(accessor.count * width, 0.0);
    if (accessor.view >= 0) {
        const std::size_t given = document_.views[static_cast<std::size_t>(accessor.view)].stride;
        const std::size_t stride = given == 0 ? size * width : given;
        const auto data = bytes(accessor.view, accessor.offset, accessor.count, size * width, stride, where);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = number(data.data() + i / width * stride + i % width * size, accessor.component_type,
                               accessor.normalised);
    }
    if (accessor.sparse) replaceSparse(accessor, where, values);
    const auto odd = std::find_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); });
    if (odd != values.end())
        refuse(where, fmt::format("element {} is {}, expected a finite number",
                                  static_cast<std::size_t>(odd - values.begin()) / width, *odd));
    return values;
}

void Values::replaceSparse(const Accessor& accessor, const std::string& where, std::vector<double>& values) {
    const Sparse& sparse = *accessor.sparse;
    if (const auto problem = sparseProblem(sparse.count, sparse.index_type, accessor.count))
        refuse(where, *problem);
    const std::size_t index_size = componentSize(sparse.index_type);
    const std::size_t width = elementWidth(accessor.type);
    const std::size_t size = componentSize(accessor.component_type);
    const auto index_bytes =
        bytes(sparse.index_view, sparse.index_offset, sparse.count, index_size, index_size, where);
    const auto replaced =
        bytes(sparse.value_view, sparse.value_offset, sparse.count, size * width, size * width, where);
    const auto indices = sparseIndices(index_bytes.data(), sparse.count, sparse.index_type, accessor.count);
    if (!indices) refuse(where, indices.error());
    for (std::size_t i = 0; i < sparse.count; ++i)
        for (std::size_t c = 0; c < width; ++c)
            values[(*indices)[i] * width + c] = number(replaced.data() + (i * width + c) * size,
                                                       accessor.component_type, accessor.normalised);
}

}  // namespace deixis::assets::gltf
