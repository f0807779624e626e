#include "assets/gltf/gltf_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "gltf_container.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr std::size_t max_elements = 10'000'000;

template <typename T>
T component(const char* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

double number(const char* from, int component_type, bool normalised) {
    const auto fraction = [&](double value, double max) {
        return normalised ? std::max(value / max, -1.0) : value;
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

std::string Values::place(int accessor, const std::string& what) const {
    return fmt::format("{}: /accessors/{} ({})", document_.file, accessor, what);
}

std::vector<double> Values::numbers(int accessor, const std::string& what) const {
    return decode(document_.accessors[static_cast<std::size_t>(accessor)], place(accessor, what));
}

const std::vector<double>& Values::read(int accessor, const std::string& what) {
    const auto found = read_.find(accessor);
    return found != read_.end() ? found->second : read_[accessor] = numbers(accessor, what);
}

std::vector<std::uint32_t> Values::integers(int accessor, const std::string& what) const {
    Accessor plain = document_.accessors[static_cast<std::size_t>(accessor)];
    if (const int type = plain.component_type; type != 5121 && type != 5123 && type != 5125)
        reject(place(accessor, what), fmt::format("component type {} is not an unsigned integer", type));
    plain.normalised = false;
    const std::vector<double> values = decode(plain, place(accessor, what));
    return {values.begin(), values.end()};
}

std::string Values::image(std::size_t index) const {
    const Image& image = document_.images[index];
    const std::string place = fmt::format("{}: /images/{}", document_.file, index);
    return std::string(image.view >= 0 ? view(image.view, place) : outside(image.outside, 0, place + "/uri"));
}

std::vector<Values::Neighbour> Values::neighbours() const {
    std::vector<Neighbour> files;
    const auto add = [&](const Outside& from, std::size_t min_bytes, const char* list, std::size_t index) {
        if (from.file.empty()) return;
        const std::string place = fmt::format("{}: /{}/{}/uri", document_.file, list, index);
        files.push_back(
            {folder_.value_or(std::filesystem::path()) / from.file, outside(from, min_bytes, place)});
    };
    for (std::size_t i = 0; i < document_.buffers.size(); ++i)
        add(document_.buffers[i].outside, document_.buffers[i].length, "buffers", i);
    for (std::size_t i = 0; i < document_.images.size(); ++i)
        add(document_.images[i].outside, 0, "images", i);
    return files;
}

std::string_view Values::outside(const Outside& from, std::size_t min_bytes, const std::string& place) const {
    const auto found = outside_.find(place);
    if (found != outside_.end()) return found->second;
    if (!from.data_uri.empty()) return outside_[place] = decodeDataUri(from.data_uri, place);
    if (from.file.empty()) return {};
    if (!folder_) reject(place, "names a file, but there is no folder to read it from");
    return outside_[place] = readNeighbour(from.file, *folder_, min_bytes, place);
}

std::string_view Values::buffer(int index, const std::string& where) const {
    const Buffer& buffer = document_.buffers[static_cast<std::size_t>(index)];
    if (!buffer.outside.data_uri.empty() || !buffer.outside.file.empty())
        return outside(buffer.outside, buffer.length,
                       fmt::format("{}: /buffers/{}/uri", document_.file, index))
            .substr(0, buffer.length);
    if (index != 0 || !document_.has_bin)
        reject(where, fmt::format("is in buffer {}, which has no data", index));
    return document_.bin.substr(0, buffer.length);
}

std::string_view Values::view(int index, const std::string& where) const {
    const BufferView& view = document_.views[static_cast<std::size_t>(index)];
    const std::string_view data = buffer(view.buffer, where);
    // Each bound alone first, so that no sum can overflow.
    if (view.offset > data.size() || view.length > data.size() - view.offset)
        reject(where, fmt::format("buffer view {} (bytes {} to {}) leaves its buffer of {} bytes", index,
                                  view.offset, view.offset + view.length, data.size()));
    return data.substr(view.offset, view.length);
}

std::string_view Values::bytes(int view_index, std::size_t offset, std::size_t count, std::size_t element,
                               std::size_t stride, const std::string& where) const {
    const std::string_view data = view(view_index, where);
    if (stride < element || stride > 4096)
        reject(where, fmt::format("stride {} does not fit elements of {} bytes", stride, element));
    if (offset > data.size() || data.size() - offset < element ||
        count - 1 > (data.size() - offset - element) / stride)
        reject(where, fmt::format("{} elements from byte {} exceed buffer view {} of {} bytes", count, offset,
                                  view_index, data.size()));
    return data.substr(offset, (count - 1) * stride + element);
}

std::vector<double> Values::decode(const Accessor& accessor, const std::string& where) const {
    const std::size_t width = elementWidth(accessor.type);
    const std::size_t size = componentSize(accessor.component_type);
    // The columns of smaller matrices may be padded, which nothing that is read here needs.
    if (width == 0 || accessor.type == "MAT2" || accessor.type == "MAT3")
        reject(where,
               fmt::format("found type \"{}\", expected SCALAR, VEC2, VEC3, VEC4 or MAT4", accessor.type));
    if (size == 0)
        reject(where, fmt::format("found component type {}, expected 5120, 5121, 5122, 5123, 5125 or 5126",
                                  accessor.component_type));
    if (accessor.count == 0 || accessor.count > max_elements)
        reject(where, fmt::format("found {} elements, expected 1 to {}", accessor.count, max_elements));
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
        reject(where, fmt::format("element {} is {}, expected a finite number",
                                  static_cast<std::size_t>(odd - values.begin()) / width, *odd));
    return values;
}

/// The replaced elements (section 3.6.2.3): they rise.
std::vector<std::size_t> Values::sparseIndices(const Accessor& accessor, const std::string& where) const {
    const Sparse& sparse = *accessor.sparse;
    const int type = sparse.index_type;
    if (type != 5121 && type != 5123 && type != 5125)
        reject(where,
               fmt::format("found sparse indices of component type {}, expected 5121, 5123 or 5125", type));
    if (sparse.count == 0 || sparse.count > accessor.count)
        reject(where, fmt::format("replaces {} of {} elements", sparse.count, accessor.count));
    const std::size_t size = componentSize(type);
    const auto data = bytes(sparse.index_view, sparse.index_offset, sparse.count, size, size, where);
    std::vector<std::size_t> indices;
    std::size_t min = 0;
    for (std::size_t i = 0; i < sparse.count; ++i) {
        const auto index = static_cast<std::size_t>(number(data.data() + i * size, type, false));
        if (index < min || index >= accessor.count)
            reject(where, fmt::format("sparse index {} is {}, expected {} to {}", i, index, min,
                                      accessor.count - 1));
        min = index + 1;
        indices.push_back(index);
    }
    return indices;
}

void Values::replaceSparse(const Accessor& accessor, const std::string& where,
                           std::vector<double>& values) const {
    const std::vector<std::size_t> indices = sparseIndices(accessor, where);
    const std::size_t width = elementWidth(accessor.type);
    const std::size_t size = componentSize(accessor.component_type);
    const auto replaced = bytes(accessor.sparse->value_view, accessor.sparse->value_offset, indices.size(),
                                size * width, size * width, where);
    for (std::size_t i = 0; i < indices.size(); ++i)
        for (std::size_t c = 0; c < width; ++c)
            values[indices[i] * width + c] = number(replaced.data() + (i * width + c) * size,
                                                    accessor.component_type, accessor.normalised);
}

}  // namespace deixis::assets::gltf
