#include "assets/gltf/glb_writer.hpp"

#include <cstring>
#include <stdexcept>

namespace deixis::assets {

namespace {

void append(std::string& out, std::uint32_t value, std::size_t size = 4) {
    for (std::size_t i = 0; i < size; ++i) out += static_cast<char>(value >> (8 * i) & 0xFFU);
}

void pad(std::string& out, char filler) {
    out.resize((out.size() + 3) / 4 * 4, filler);
}

}  // namespace

template <typename T>
std::size_t GlbWriter::add(const std::vector<T>& values, int component_type, std::size_t count,
                           std::string_view type, int target) {
    const std::size_t offset = bytes_.size();
    for (const T value : values) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof value);
        append(bytes_, bits, sizeof value);
    }
    views_.push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes_.size() - offset}});
    if (target != 0) views_.back()["target"] = target;
    pad(bytes_, '\0');
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", component_type},
                          {"count", count},
                          {"type", type}});
    return accessors_.size() - 1;
}

std::size_t GlbWriter::add(const std::vector<float>& values, std::size_t count, std::string_view type,
                           int target) {
    return add(values, 5126, count, type, target);
}

std::size_t GlbWriter::add(const std::vector<std::uint8_t>& values, std::size_t count, std::string_view type,
                           int target) {
    return add(values, 5121, count, type, target);
}

std::size_t GlbWriter::add(const std::vector<std::uint16_t>& values, std::size_t count, std::string_view type,
                           int target) {
    return add(values, 5123, count, type, target);
}

std::size_t GlbWriter::add(const std::vector<std::uint32_t>& values, std::size_t count, std::string_view type,
                           int target) {
    return add(values, 5125, count, type, target);
}

std::size_t GlbWriter::addBytes(std::string_view bytes) {
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
    bytes_ += bytes;
    pad(bytes_, '\0');
    return views_.size() - 1;
}

void GlbWriter::setBounds(std::size_t accessor, GltfJson min, GltfJson max) {
    accessors_[accessor]["min"] = std::move(min);
    accessors_[accessor]["max"] = std::move(max);
}

std::string GlbWriter::file(GltfJson root) const {
    root["accessors"] = accessors_;
    root["bufferViews"] = views_;
    root["buffers"] = GltfJson::array({{{"byteLength", bytes_.size()}}});
    std::string json = root.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    pad(json, ' ');
    if (json.size() + bytes_.size() >= 0xFFFFFF00U)
        throw std::invalid_argument("a binary glTF holds less than 4 GiB");
    const auto size = [](const std::string& chunk) { return static_cast<std::uint32_t>(chunk.size()); };
    std::string out = "glTF";
    append(out, 2);
    append(out, 12 + 8 + size(json) + 8 + size(bytes_));
    append(out, size(json));
    out += "JSON" + json;
    append(out, size(bytes_));
    return out + std::string("BIN\0", 4) + bytes_;
}

}  // namespace deixis::assets
