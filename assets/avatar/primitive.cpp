#include "primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace deixis::assets {

namespace {

constexpr int mode_triangles = 4, mode_strip = 5, mode_fan = 6;

/// Rows of numbers; row i starts at values[i * width].
struct Rows {
    std::vector<double> values;
    std::size_t width = 0;
    [[nodiscard]] std::size_t size() const { return values.size() / width; }
    [[nodiscard]] float at(std::size_t row, std::size_t column) const {
        return static_cast<float>(values[row * width + column]);
    }
    [[nodiscard]] glm::vec3 vec3(std::size_t row) const { return {at(row, 0), at(row, 1), at(row, 2)}; }
};

class PrimitiveReader {
  public:
    PrimitiveReader(const gltf::Document& document, const gltf::Values& values,
                    const gltf::Primitive& primitive)
        : doc_(document), values_(values), primitive_(primitive) {}

    PrimitiveData run(const PrimitiveWants& wants) {
        const Rows positions = rows("POSITION", 3, 0);
        count_ = positions.size();
        for (std::size_t v = 0; v < count_; ++v) data_.positions.push_back(positions.vec3(v));
        readTriangles();
        readNormals();
        if (has("COLOR_0")) {
            const Rows colours = rows("COLOR_0", 3, count_, 4);
            for (std::size_t v = 0; v < count_; ++v) data_.colours.push_back(colours.vec3(v));
        }
        if (const std::string name = fmt::format("TEXCOORD_{}", wants.uv_set);
            wants.uv_set >= 0 && has(name)) {
            const Rows uvs = rows(name, 2, count_);
            for (std::size_t v = 0; v < count_; ++v) data_.uvs.emplace_back(uvs.at(v, 0), uvs.at(v, 1));
        }
        if (wants.skin_joints) readInfluences(*wants.skin_joints);
        return std::move(data_);
    }

  private:
    [[noreturn]] void bad(std::string message) const { gltf::reject(doc_.file, std::move(message)); }
    [[nodiscard]] bool has(const std::string& name) const { return primitive_.attributes.count(name) > 0; }

    [[nodiscard]] int attribute(const std::string& name) const {
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end()) bad("the mesh has no " + name);
        return found->second;
    }

    /// An attribute with one row of an expected width for each vertex.
    [[nodiscard]] Rows rows(const std::string& name, std::size_t width, std::size_t count,
                            std::size_t also_width = 0) const {
        const int accessor = attribute(name);
        const Rows read{values_.numbers(accessor, name), doc_.accessorWidth(accessor)};
        if (read.width != width && (also_width == 0 || read.width != also_width))
            bad(fmt::format("{} has {} numbers per vertex, expected {}", name, read.width, width));
        if (count != 0 && read.size() != count)
            bad(fmt::format("{} has {} rows, expected {}", name, read.size(), count));
        return read;
    }

    void readTriangles() {
        std::vector<std::uint32_t> indices;
        if (primitive_.indices < 0) {
            indices.resize(count_);
            std::iota(indices.begin(), indices.end(), 0U);
        } else {
            if (doc_.accessorWidth(primitive_.indices) != 1) bad("indices are not single numbers");
            indices = values_.integers(primitive_.indices, "indices");
        }
        for (const std::uint32_t index : indices)
            if (index >= count_)
                bad(fmt::format("index {} is out of range; there are {} vertices", index, count_));
        const bool strip = primitive_.mode == mode_strip;
        const bool fan = primitive_.mode == mode_fan;
        if (!strip && !fan) {
            if (indices.size() % 3 != 0)
                bad(fmt::format("{} indices are not a whole number of triangles", indices.size()));
            data_.triangles = std::move(indices);
            return;
        }
        // glTF 2.0, 3.7.2.1: every second triangle of a strip runs the other way round.
        for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
            const std::uint32_t a = indices[fan ? 0 : i];
            const std::uint32_t b = indices[strip && i % 2 == 1 ? i + 2 : i + 1];
            const std::uint32_t c = indices[strip && i % 2 == 1 ? i + 1 : i + 2];
            if (a != b && b != c && c != a) data_.triangles.insert(data_.triangles.end(), {a, b, c});
        }
    }

    void readNormals() {
        if (has("NORMAL")) {
            const Rows normals = rows("NORMAL", 3, count_);
            for (std::size_t v = 0; v < count_; ++v) data_.normals.push_back(normals.vec3(v));
            return;
        }
        data_.normals.assign(count_, glm::vec3(0.0F));
        for (std::size_t t = 0; t + 2 < data_.triangles.size(); t += 3) {
            const glm::vec3& p = data_.positions[data_.triangles[t]];
            const glm::vec3 cross = glm::cross(data_.positions[data_.triangles[t + 1]] - p,
                                               data_.positions[data_.triangles[t + 2]] - p);
            for (std::size_t i = 0; i < 3; ++i) data_.normals[data_.triangles[t + i]] += cross;
        }
    }

    void readInfluences(std::size_t skin_joints) {
        data_.influences.resize(count_);
        for (int set = 0; set == 0 || has(fmt::format("JOINTS_{}", set)); ++set)
            addInfluences(set, skin_joints);
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
                bad(fmt::format("the weights of vertex {} sum to {}, expected 1", v, sum));
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
    }

    void addInfluences(int set, std::size_t skin_joints) {
        const std::string joints_name = fmt::format("JOINTS_{}", set);
        const Rows weights = rows(fmt::format("WEIGHTS_{}", set), 4, count_);
        const auto joints = values_.integers(attribute(joints_name), joints_name);
        if (doc_.accessorWidth(attribute(joints_name)) != 4 || joints.size() != 4 * count_)
            bad(fmt::format("{} has {} numbers, expected 4 for each of {} vertices", joints_name,
                            joints.size(), count_));
        for (std::size_t i = 0; i < 4 * count_; ++i) {
            const float weight = weights.at(i / 4, i % 4);
            const std::uint32_t joint = joints[i];
            if (weight < 0.0F) bad(fmt::format("vertex {} has the negative weight {}", i / 4, weight));
            if (joint >= skin_joints)
                bad(fmt::format("vertex {} names joint {}; the skin has {}", i / 4, joint, skin_joints));
            if (weight > 0.0F) data_.influences[i / 4].emplace_back(joint, weight);
        }
    }

    const gltf::Document& doc_;
    const gltf::Values& values_;
    const gltf::Primitive& primitive_;
    std::size_t count_ = 0;
    PrimitiveData data_;
};

}  // namespace

std::optional<PrimitiveData> readPrimitive(const gltf::Document& document, const gltf::Values& values,
                                           const gltf::Primitive& primitive, const PrimitiveWants& wants) {
    if (primitive.mode < mode_triangles || primitive.mode > mode_fan) return std::nullopt;
    return PrimitiveReader(document, values, primitive).run(wants);
}

}  // namespace deixis::assets
