#include "assets/gltf/gltf_accessor.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "gltf_sparse.hpp"

namespace deixis::assets {

namespace {

constexpr std::size_t most_numbers = 100'000'000;

/// Where an accessor's elements lie: checked to be inside their buffers.
struct Layout {
    const unsigned char* first = nullptr;  ///< none: all zero, but for what is replaced
    std::size_t count = 0, stride = 0, width = 0;
    int component_type = 0;
    bool normalised = false;
    std::vector<std::size_t> replaced;  ///< elements of a sparse accessor (glTF 2.0, section 3.6.2.3)
    const unsigned char* replacements = nullptr;  ///< one for each of them, close together
};

std::size_t componentSize(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

std::size_t elementWidth(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;
    }
}

template <typename T>
T component(const unsigned char* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

/// Finds the bytes of one accessor's elements.
class LayoutReader {
    [[nodiscard]] auto bad(std::string message) const {
        return fail(where_, std::move(message), "Export the file anew");
    }

  public:
    LayoutReader(const tinygltf::Model& model, const std::string& file, const std::string& name)
        : model_(model), where_(file + ": " + name) {}

    Result<Layout> run(int index) {
        if (index < 0 || static_cast<std::size_t>(index) >= model_.accessors.size())
            return bad(
                fmt::format("accessor {} does not exist; the file has {}", index, model_.accessors.size()));
        const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
        Layout layout;
        layout.component_type = accessor.componentType;
        layout.normalised = accessor.normalized;
        layout.count = accessor.count;
        layout.width = elementWidth(accessor.type);
        const std::size_t element = layout.width * componentSize(accessor.componentType);
        if (element == 0)
            return bad(fmt::format("unknown element type {} of component type {}", accessor.type,
                                   accessor.componentType));
        if (layout.count == 0 || layout.count > most_numbers / layout.width)
            return bad(
                fmt::format("{} elements, expected 1 to {}", layout.count, most_numbers / layout.width));
        const bool sparse = accessor.sparse.isSparse;
        if (!sparse || accessor.bufferView != -1) {
            const auto first =
                elements(accessor.bufferView, accessor.byteOffset, layout.count, element, layout.stride);
            if (!first) return tl::unexpected(first.error());
            layout.first = *first;
        }
        if (sparse)
            if (auto done = readSparse(accessor, element, layout); !done) return tl::unexpected(done.error());
        return layout;
    }

  private:
    /// The first of `count` elements in a view; fills their stride.
    Result<const unsigned char*> elements(int view_index, std::size_t offset, std::size_t count,
                                          std::size_t element, std::size_t& stride) const {
        if (view_index < 0 || static_cast<std::size_t>(view_index) >= model_.bufferViews.size())
            return bad(fmt::format("buffer view {} does not exist", view_index));
        const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
        if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model_.buffers.size())
            return bad(fmt::format("buffer {} does not exist", view.buffer));
        const auto& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
        stride = view.byteStride == 0 ? element : view.byteStride;
        if (stride < element || stride > 252)
            return bad(fmt::format("stride {} does not fit elements of {} bytes", stride, element));
        // Each bound alone first, so that no sum can overflow.
        const std::size_t size = data.size();
        const bool view_fits = view.byteOffset <= size && view.byteLength <= size - view.byteOffset;
        if (!view_fits || offset > view.byteLength)
            return bad(fmt::format("its bytes lie outside the buffer of {} bytes", size));
        const std::size_t room = view.byteLength - offset;
        if (room < element || count - 1 > (room - element) / stride)
            return bad(
                fmt::format("{} elements do not fit in the {} bytes of their buffer view", count, room));
        return data.data() + view.byteOffset + offset;
    }

    /// The same of elements that stand close together; tinygltf has whole numbers of either sign here.
    Result<const unsigned char*> closeElements(int view_index, std::int64_t offset, std::size_t count,
                                               std::size_t element) const {
        if (offset < 0) return bad(fmt::format("found {} as a byte offset, expected 0 or more", offset));
        std::size_t stride = 0;
        auto first = elements(view_index, static_cast<std::size_t>(offset), count, element, stride);
        if (first && stride != element)
            return bad("a buffer view of a sparse accessor has a stride, expected none");
        return first;
    }

    Result<void> readSparse(const tinygltf::Accessor& accessor, std::size_t element, Layout& layout) const {
        const auto& sparse = accessor.sparse;
        const auto given = static_cast<std::int64_t>(sparse.count);
        const auto count = static_cast<std::size_t>(std::max<std::int64_t>(given, 0));
        const int index_type = sparse.indices.componentType;
        if (const auto problem = gltf::sparseProblem(count, index_type, layout.count)) return bad(*problem);
        const auto indices =
            closeElements(sparse.indices.bufferView, static_cast<std::int64_t>(sparse.indices.byteOffset),
                          count, componentSize(index_type));
        if (!indices) return tl::unexpected(indices.error());
        const auto values = closeElements(
            sparse.values.bufferView, static_cast<std::int64_t>(sparse.values.byteOffset), count, element);
        if (!values) return tl::unexpected(values.error());
        auto replaced =
            gltf::sparseIndices(reinterpret_cast<const char*>(*indices), count, index_type, layout.count);
        if (!replaced) return bad(replaced.error());
        layout.replaced = std::move(*replaced);
        layout.replacements = *values;
        return {};
    }

    const tinygltf::Model& model_;
    std::string where_;
};

float fraction(double value, double greatest, bool normalised) {
    return static_cast<float>(normalised ? std::max(value / greatest, -1.0) : value);
}

float rowNumber(const unsigned char* from, int component_type, bool normalised) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return component<float>(from);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return fraction(*from, 255.0, normalised);
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return fraction(component<std::int8_t>(from), 127.0, normalised);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return fraction(component<std::uint16_t>(from), 65535.0, normalised);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return fraction(component<std::int16_t>(from), 32767.0, normalised);
        default:
            return fraction(component<std::uint32_t>(from), 4294967295.0, normalised);
    }
}

/// All numbers in a row, each read from its bytes by `number`; sparse ones put in place.
template <typename T, typename Number>
std::vector<T> allNumbers(const Layout& layout, Number number) {
    std::vector<T> values(layout.count * layout.width, T{});
    const std::size_t size = componentSize(layout.component_type);
    const auto put = [&](std::size_t element, const unsigned char* from) {
        for (std::size_t c = 0; c < layout.width; ++c)
            values[element * layout.width + c] = number(from + c * size);
    };
    if (layout.first != nullptr)
        for (std::size_t i = 0; i < layout.count; ++i) put(i, layout.first + i * layout.stride);
    for (std::size_t i = 0; i < layout.replaced.size(); ++i)
        put(layout.replaced[i], layout.replacements + i * layout.width * size);
    return values;
}

}  // namespace

Result<GltfRows> readGltfRows(const tinygltf::Model& model, int accessor, const std::string& file,
                              const std::string& name) {
    const auto layout = LayoutReader(model, file, name).run(accessor);
    if (!layout) return tl::unexpected(layout.error());
    GltfRows rows;
    rows.width = layout->width;
    rows.values = allNumbers<float>(*layout, [&](const unsigned char* from) {
        return rowNumber(from, layout->component_type, layout->normalised);
    });
    const auto odd =
        std::find_if(rows.values.begin(), rows.values.end(), [](float v) { return !std::isfinite(v); });
    if (odd != rows.values.end())
        return fail(file + ": " + name,
                    fmt::format("element {} is {}, expected a finite number",
                                static_cast<std::size_t>(odd - rows.values.begin()) / rows.width, *odd),
                    "Export the file anew");
    return rows;
}

Result<GltfIntegers> readGltfIntegers(const tinygltf::Model& model, int accessor, const std::string& file,
                                      const std::string& name) {
    const auto layout = LayoutReader(model, file, name).run(accessor);
    if (!layout) return tl::unexpected(layout.error());
    GltfIntegers integers;
    integers.width = layout->width;
    const auto read = [&](auto number) { integers.values = allNumbers<std::uint32_t>(*layout, number); };
    switch (layout->component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            read([](const unsigned char* from) { return std::uint32_t{*from}; });
            return integers;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            read([](const unsigned char* from) { return std::uint32_t{component<std::uint16_t>(from)}; });
            return integers;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            read([](const unsigned char* from) { return component<std::uint32_t>(from); });
            return integers;
        default:
            return fail(file + ": " + name,
                        fmt::format("component type {} is not an unsigned integer", layout->component_type),
                        "Export the file anew");
    }
}

}  // namespace deixis::assets
