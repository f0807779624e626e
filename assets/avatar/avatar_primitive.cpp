#include "avatar_primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "assets/gltf/gltf_accessor.hpp"

namespace deixis::assets {

namespace {

class PrimitiveReader {
  public:
    PrimitiveReader(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                    const std::string& file)
        : model_(model), primitive_(primitive), file_(file) {}

    Result<PrimitiveData> run(const PrimitiveWants& wants) {
        const auto positions = rows("POSITION", 3, 0);
        if (!positions) return tl::unexpected(positions.error());
        count_ = positions->size();
        for (std::size_t v = 0; v < count_; ++v) data_.positions.push_back(vec3(*positions, v));
        if (auto done = readTriangles(); !done) return tl::unexpected(done.error());
        if (auto done = readNormals(); !done) return tl::unexpected(done.error());
        if (has("COLOR_0")) {
            const auto colours = rows("COLOR_0", 3, count_, 4);
            if (!colours) return tl::unexpected(colours.error());
            for (std::size_t v = 0; v < count_; ++v) data_.colours.push_back(vec3(*colours, v));
        }
        if (const std::string name = fmt::format("TEXCOORD_{}", wants.uv_set);
            wants.uv_set >= 0 && has(name)) {
            const auto uvs = rows(name, 2, count_);
            if (!uvs) return tl::unexpected(uvs.error());
            for (std::size_t v = 0; v < count_; ++v)
                data_.uvs.emplace_back(uvs->values[v * 2], uvs->values[v * 2 + 1]);
        }
        if (wants.skin_joints)
            if (auto done = readInfluences(*wants.skin_joints); !done) return tl::unexpected(done.error());
        return std::move(data_);
    }

  private:
    [[nodiscard]] auto bad(std::string message) const {
        return fail(file_, std::move(message), "Export the file anew");
    }
    [[nodiscard]] bool has(const std::string& name) const { return primitive_.attributes.count(name) > 0; }

    static glm::vec3 vec3(const GltfRows& rows, std::size_t v) {
        const float* p = &rows.values[v * rows.width];
        return {p[0], p[1], p[2]};
    }

    /// An attribute with one row of an expected width for each vertex.
    [[nodiscard]] Result<GltfRows> rows(const std::string& name, std::size_t width, std::size_t count,
                                        std::size_t also_width = 0) const {
        if (!has(name)) return bad("the mesh has no " + name);
        auto read = readGltfRows(model_, primitive_.attributes.at(name), file_, name);
        if (!read) return read;
        if (read->width != width && (also_width == 0 || read->width != also_width))
            return bad(fmt::format("{} has {} numbers a vertex, expected {}", name, read->width, width));
        if (count != 0 && read->size() != count)
            return bad(fmt::format("{} has {} rows, expected {}", name, read->size(), count));
        return read;
    }

    Result<void> readTriangles() {
        std::vector<std::uint32_t> indices;
        if (primitive_.indices < 0) {
            indices.resize(count_);
            std::iota(indices.begin(), indices.end(), 0U);
        } else {
            auto read = readGltfIntegers(model_, primitive_.indices, file_, "indices");
            if (!read) return tl::unexpected(read.error());
            if (read->width != 1) return bad("indices are not single numbers");
            indices = std::move(read->values);
        }
        for (const std::uint32_t index : indices)
            if (index >= count_)
                return bad(fmt::format("index {} is out of range; there are {} vertices", index, count_));
        const bool strip = primitive_.mode == TINYGLTF_MODE_TRIANGLE_STRIP;
        const bool fan = primitive_.mode == TINYGLTF_MODE_TRIANGLE_FAN;
        if (!strip && !fan) {
            if (indices.size() % 3 != 0)
                return bad(fmt::format("{} indices are no whole number of triangles", indices.size()));
            data_.triangles = std::move(indices);
            return {};
        }
        // glTF 2.0, 3.7.2.1: every second triangle of a strip runs the other way round.
        for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
            const std::uint32_t a = indices[fan ? 0 : i];
            const std::uint32_t b = indices[strip && i % 2 == 1 ? i + 2 : i + 1];
            const std::uint32_t c = indices[strip && i % 2 == 1 ? i + 1 : i + 2];
            if (a != b && b != c && c != a) data_.triangles.insert(data_.triangles.end(), {a, b, c});
        }
        return {};
    }

    Result<void> readNormals() {
        if (has("NORMAL")) {
            const auto normals = rows("NORMAL", 3, count_);
            if (!normals) return tl::unexpected(normals.error());
            for (std::size_t v = 0; v < count_; ++v) data_.normals.push_back(vec3(*normals, v));
            return {};
        }
        data_.normals.assign(count_, glm::vec3(0.0F));
        for (std::size_t t = 0; t + 2 < data_.triangles.size(); t += 3) {
            const glm::vec3& p = data_.positions[data_.triangles[t]];
            const glm::vec3 cross = glm::cross(data_.positions[data_.triangles[t + 1]] - p,
                                               data_.positions[data_.triangles[t + 2]] - p);
            for (std::size_t i = 0; i < 3; ++i) data_.normals[data_.triangles[t + i]] += cross;
        }
        return {};
    }

    Result<void> readInfluences(std::size_t skin_joints) {
        data_.influences.resize(count_);
        for (int set = 0; set == 0 || has(fmt::format("JOINTS_{}", set)); ++set)
            if (auto done = addInfluences(set, skin_joints); !done) return done;
        for (std::size_t v = 0; v < count_; ++v) {
            auto& influences = data_.influences[v];
            float sum = 0.0F;
            for (const auto& [joint, weight] : influences) sum += weight;
            if (!(sum > 1e-6F)) {
                influences = {{0U, 1.0F}};
                data_.unweighted = true;
                continue;
            }
            if (!(std::abs(sum - 1.0F) < 0.02F))
                return bad(fmt::format("the weights of vertex {} sum to {}, expected 1", v, sum));
            std::stable_sort(influences.begin(), influences.end(),
                             [](const auto& a, const auto& b) { return a.second > b.second; });
            if (influences.size() > 4) {
                data_.more_than_four = true;
                influences.resize(4);
                sum = 0.0F;
                for (const auto& [joint, weight] : influences) sum += weight;
            }
            for (auto& [joint, weight] : influences) weight /= sum;
        }
        return {};
    }

    Result<void> addInfluences(int set, std::size_t skin_joints) {
        const std::string joints_name = fmt::format("JOINTS_{}", set);
        const auto weights = rows(fmt::format("WEIGHTS_{}", set), 4, count_);
        if (!weights) return tl::unexpected(weights.error());
        if (!has(joints_name)) return bad("the mesh has no " + joints_name);
        const auto joints =
            readGltfIntegers(model_, primitive_.attributes.at(joints_name), file_, joints_name);
        if (!joints) return tl::unexpected(joints.error());
        if (joints->width != 4 || joints->values.size() != 4 * count_)
            return bad(fmt::format("{} has {} numbers, expected 4 for each of {} vertices", joints_name,
                                   joints->values.size(), count_));
        for (std::size_t i = 0; i < 4 * count_; ++i) {
            const float weight = weights->values[i];
            const std::uint32_t joint = joints->values[i];
            if (weight < 0.0F) return bad(fmt::format("vertex {} has the negative weight {}", i / 4, weight));
            if (joint >= skin_joints)
                return bad(
                    fmt::format("vertex {} names joint {}; the skin has {}", i / 4, joint, skin_joints));
            if (weight > 0.0F) data_.influences[i / 4].emplace_back(joint, weight);
        }
        return {};
    }

    const tinygltf::Model& model_;
    const tinygltf::Primitive& primitive_;
    const std::string& file_;
    std::size_t count_ = 0;
    PrimitiveData data_;
};

}  // namespace

Result<std::optional<PrimitiveData>> readPrimitive(const tinygltf::Model& model,
                                                   const tinygltf::Primitive& primitive,
                                                   const PrimitiveWants& wants, const std::string& file) {
    if (primitive.mode != -1 && primitive.mode != TINYGLTF_MODE_TRIANGLES &&
        primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP && primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN)
        return std::nullopt;
    auto data = PrimitiveReader(model, primitive, file).run(wants);
    if (!data) return tl::unexpected(data.error());
    return std::move(*data);
}

}  // namespace deixis::assets
