#include "gltf_accessor.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace deixis::assets {

namespace {

/// Where an accessor's elements lie: checked to be inside their buffer.
struct Layout {
    const unsigned char* first = nullptr;
    std::size_t count = 0, stride = 0, width = 0;
    int component_type = 0;
    bool normalised = false;
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

Result<Layout> layoutOf(const tinygltf::Model& model, int index, const std::string& file,
                        const std::string& name) {
    const auto bad = [&](std::string message) {
        return fail(file + ": " + name, std::move(message), "Export the file anew");
    };
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size())
        return bad(fmt::format("accessor {} does not exist; the file has {}", index, model.accessors.size()));
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    if (accessor.sparse.isSparse) return bad("sparse accessors are not supported");
    if (accessor.bufferView < 0 || static_cast<std::size_t>(accessor.bufferView) >= model.bufferViews.size())
        return bad(fmt::format("buffer view {} does not exist", accessor.bufferView));
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size())
        return bad(fmt::format("buffer {} does not exist", view.buffer));
    const auto& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;

    Layout layout;
    layout.component_type = accessor.componentType;
    layout.normalised = accessor.normalized;
    layout.count = accessor.count;
    layout.width = elementWidth(accessor.type);
    const std::size_t element = layout.width * componentSize(accessor.componentType);
    if (element == 0)
        return bad(fmt::format("unknown element type {} of component type {}", accessor.type,
                               accessor.componentType));
    layout.stride = view.byteStride == 0 ? element : view.byteStride;
    if (layout.stride < element || layout.stride > 252)
        return bad(fmt::format("stride {} does not fit elements of {} bytes", layout.stride, element));
    // Each bound alone first, so that no sum can overflow.
    const std::size_t size = data.size();
    const bool view_fits = view.byteOffset <= size && view.byteLength <= size - view.byteOffset;
    if (!view_fits || accessor.byteOffset > view.byteLength)
        return bad(fmt::format("its bytes lie outside the buffer of {} bytes", size));
    const std::size_t room = view.byteLength - accessor.byteOffset;
    const bool elements_fit =
        layout.count > 0 && room >= element && layout.count - 1 <= (room - element) / layout.stride;
    if (!elements_fit)
        return bad(
            fmt::format("{} elements do not fit in the {} bytes of their buffer view", layout.count, room));
    layout.first = data.data() + view.byteOffset + accessor.byteOffset;
    return layout;
}

float fraction(double value, double greatest, bool normalised) {
    return static_cast<float>(normalised ? std::max(value / greatest, -1.0) : value);
}

}  // namespace

Result<GltfRows> readGltfRows(const tinygltf::Model& model, int accessor, const std::string& file,
                              const std::string& name) {
    const auto layout = layoutOf(model, accessor, file, name);
    if (!layout) return tl::unexpected(layout.error());
    GltfRows rows;
    rows.width = layout->width;
    rows.values.reserve(layout->count * layout->width);
    const std::size_t size = componentSize(layout->component_type);
    for (std::size_t i = 0; i < layout->count; ++i)
        for (std::size_t c = 0; c < layout->width; ++c) {
            const unsigned char* from = layout->first + i * layout->stride + c * size;
            float value = 0.0F;
            switch (layout->component_type) {
                case TINYGLTF_COMPONENT_TYPE_FLOAT:
                    value = component<float>(from);
                    break;
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                    value = fraction(*from, 255.0, layout->normalised);
                    break;
                case TINYGLTF_COMPONENT_TYPE_BYTE:
                    value = fraction(component<std::int8_t>(from), 127.0, layout->normalised);
                    break;
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                    value = fraction(component<std::uint16_t>(from), 65535.0, layout->normalised);
                    break;
                case TINYGLTF_COMPONENT_TYPE_SHORT:
                    value = fraction(component<std::int16_t>(from), 32767.0, layout->normalised);
                    break;
                default:
                    value = fraction(component<std::uint32_t>(from), 4294967295.0, layout->normalised);
            }
            if (!std::isfinite(value))
                return fail(file + ": " + name,
                            fmt::format("element {} is {}, expected a finite number", i, value),
                            "Export the file anew");
            rows.values.push_back(value);
        }
    return rows;
}

Result<GltfIntegers> readGltfIntegers(const tinygltf::Model& model, int accessor, const std::string& file,
                                      const std::string& name) {
    const auto layout = layoutOf(model, accessor, file, name);
    if (!layout) return tl::unexpected(layout.error());
    GltfIntegers integers;
    integers.width = layout->width;
    integers.values.reserve(layout->count * layout->width);
    const std::size_t size = componentSize(layout->component_type);
    for (std::size_t i = 0; i < layout->count; ++i)
        for (std::size_t c = 0; c < layout->width; ++c) {
            const unsigned char* from = layout->first + i * layout->stride + c * size;
            switch (layout->component_type) {
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                    integers.values.push_back(*from);
                    break;
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                    integers.values.push_back(component<std::uint16_t>(from));
                    break;
                case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                    integers.values.push_back(component<std::uint32_t>(from));
                    break;
                default:
                    return fail(
                        file + ": " + name,
                        fmt::format("component type {} is not an unsigned integer", layout->component_type),
                        "Export the file anew");
            }
        }
    return integers;
}

}  // namespace deixis::assets
