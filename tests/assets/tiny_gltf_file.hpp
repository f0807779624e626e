// Small glTF binaries, put together by tests.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstring>
#include <string>
#include <vector>

namespace deixis::tests {

/// Collects binary data with its views and accessors; glb() adds the rest of the JSON. Little-endian machines
/// only, as the tests' are.
class TinyGltf {
  public:
    /// Index of a new accessor over values of one component type; `more` is added to its JSON.
    template <typename T>
    int add(const std::vector<T>& values, const char* type, int component_type, std::size_t width,
            const std::string& more = {}) {
        const int view = addView(values);
        return addAccessor(fmt::format(R"("bufferView":{},"componentType":{},"count":{},"type":"{}"{})", view,
                                       component_type, values.size() / width, type, more));
    }

    template <typename T>
    int addView(const std::vector<T>& values, const std::string& more = {}) {
        const std::size_t offset = bin_.size();
        bin_.resize(offset + values.size() * sizeof(T));
        std::memcpy(bin_.data() + offset, values.data(), values.size() * sizeof(T));
        views_.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", offset,
                                     values.size() * sizeof(T), more));
        bin_.resize((bin_.size() + 3) / 4 * 4);
        return static_cast<int>(views_.size()) - 1;
    }

    int addAccessor(const std::string& members) {
        accessors_.push_back("{" + members + "}");
        return static_cast<int>(accessors_.size()) - 1;
    }

    int times(const std::vector<float>& values) {
        return add(values, "SCALAR", 5126, 1,
                   fmt::format(R"(,"min":[{}],"max":[{}])", values.front(), values.back()));
    }
    int vectors(const std::vector<float>& values) { return add(values, "VEC3", 5126, 3); }
    int quaternions(const std::vector<float>& values) { return add(values, "VEC4", 5126, 4); }

    /// An animation of one channel.
    void animate(int node, const char* path, int input, int output, const char* interpolation = "LINEAR") {
        channels_.push_back(fmt::format(R"({{"sampler":{},"target":{{"node":{},"path":"{}"}}}})",
                                        samplers_.size(), node, path));
        samplers_.push_back(
            fmt::format(R"({{"input":{},"output":{},"interpolation":"{}"}})", input, output, interpolation));
    }

    /// `rest`: further members of the JSON, such as "nodes":[...].
    [[nodiscard]] std::string json(const std::string& rest) const {
        std::string out = R"({"asset":{"version":"2.0"})";
        if (!bin_.empty()) out += fmt::format(R"(,"buffers":[{{"byteLength":{}}}])", bin_.size());
        if (!views_.empty()) out += fmt::format(R"(,"bufferViews":[{}])", fmt::join(views_, ","));
        if (!accessors_.empty()) out += fmt::format(R"(,"accessors":[{}])", fmt::join(accessors_, ","));
        if (!channels_.empty())
            out += fmt::format(R"(,"animations":[{{"name":"move","samplers":[{}],"channels":[{}]}}])",
                               fmt::join(samplers_, ","), fmt::join(channels_, ","));
        return out + "," + rest + "}";
    }

    [[nodiscard]] std::string glb(const std::string& rest) const {
        std::string text = json(rest);
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string out = "glTF";
        word(out, 2);
        word(out, 12 + 8 + text.size() + 8 + bin_.size());
        word(out, text.size());
        out += "JSON" + text;
        word(out, bin_.size());
        out += std::string("BIN\0", 4);
        return out + std::string(bin_.begin(), bin_.end());
    }

  private:
    static void word(std::string& out, std::size_t value) {
        for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(value >> shift & 0xFF);
    }

    std::vector<char> bin_;
    std::vector<std::string> views_, accessors_, samplers_, channels_;
};

}  // namespace deixis::tests
