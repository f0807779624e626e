#include "base_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "core/files.hpp"

namespace deixis::humanoid_maker {

namespace {

using nlohmann::json;

constexpr double metres_in_unit = 0.1;

Result<json> readJson(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    json parsed = json::parse(*bytes, nullptr, false);
    if (!parsed.is_object()) return fail(path.string(), "not a JSON object, expected a file of MPFB");
    return parsed;
}

Vec3 middleOf(const BaseMesh& mesh, const std::vector<std::uint32_t>& vertices) {
    Vec3 sum(0.0);
    for (const std::uint32_t v : vertices) sum += mesh.vertices[v];
    return sum / static_cast<double>(vertices.size());
}

/// Where a bone's head or tail lies.
std::optional<Vec3> boneEnd(const json& end, const BaseMesh& mesh) {
    const std::string strategy = end.value("strategy", "");
    if (strategy == "CUBE") {
        const auto cube = mesh.group_vertices.find(end.value("cube_name", ""));
        if (cube == mesh.group_vertices.end()) return std::nullopt;
        return middleOf(mesh, cube->second);
    }
    if (strategy != "MEAN" || !end.contains("vertex_indices")) return std::nullopt;
    std::vector<std::uint32_t> vertices;
    for (const json& index : end["vertex_indices"]) {
        if (!index.is_number_unsigned() || index.get<std::size_t>() >= mesh.vertices.size())
            return std::nullopt;
        vertices.push_back(index.get<std::uint32_t>());
    }
    if (vertices.empty()) return std::nullopt;
    return middleOf(mesh, vertices);
}

/// The number before the first slash of "12/7".
std::optional<std::uint32_t> vertexOf(const std::string& corner, std::size_t count) {
    std::size_t number = 0;
    for (const char c : corner.substr(0, corner.find('/'))) {
        if (c < '0' || c > '9' || number > count) return std::nullopt;
        number = number * 10 + static_cast<std::size_t>(c - '0');
    }
    if (number == 0 || number > count) return std::nullopt;
    return static_cast<std::uint32_t>(number - 1);
}

VertexWeights heaviest(std::vector<std::pair<double, std::uint8_t>> found) {
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    if (found.size() > 4) found.resize(4);
    double sum = 0.0;
    for (const auto& [weight, bone] : found) sum += weight;
    // Multiples of 1/4096, so that they sum to 1 without rounding.
    constexpr int whole = 4096;
    VertexWeights out;
    int left = whole;
    for (std::size_t i = found.size(); i-- > 0;) {
        const int share = i == 0 ? left : static_cast<int>(std::lround(found[i].first / sum * whole));
        left -= share;
        out.weights[i] = static_cast<float>(share) / whole;
        out.bones[i] = share > 0 ? found[i].second : std::uint8_t{0};
    }
    return out;
}

}  // namespace

Result<BaseMesh> readBaseMesh(const std::filesystem::path& obj) {
    const auto bytes = readFile(obj);
    if (!bytes) return tl::unexpected(bytes.error());
    BaseMesh mesh;
    std::map<std::string, std::set<std::uint32_t>> groups;
    std::string group;
    std::istringstream lines(*bytes);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const auto bad = [&](const char* what) {
            return fail(fmt::format("{}:{}", obj.string(), number), what);
        };
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 p(0.0);
            if (!(words >> p.x >> p.y >> p.z)) return bad("found a vertex without 3 numbers");
            mesh.vertices.push_back(metres_in_unit * p);
        } else if (kind == "g") {
            words >> group;
        } else if (kind == "f") {
            std::vector<std::uint32_t> face;
            for (std::string corner; words >> corner;) {
                const auto vertex = vertexOf(corner, mesh.vertices.size());
                if (!vertex) return bad("found a face with a vertex that does not exist");
                face.push_back(*vertex);
            }
            if (face.size() < 3) return bad("found a face of fewer than 3 vertices");
            if (group != "body") {
                groups[group].insert(face.begin(), face.end());
                continue;
            }
            for (std::size_t i = 2; i < face.size(); ++i)
                mesh.body.push_back({face[0], face[i - 1], face[i]});
        }
    }
    if (mesh.body.empty()) return fail(obj.string(), "has no group \"body\", expected MakeHuman's base mesh");
    for (auto& [name, vertices] : groups) mesh.group_vertices[name].assign(vertices.begin(), vertices.end());
    double floor = mesh.vertices[mesh.body.front()[0]].y;
    for (const auto& triangle : mesh.body)
        for (const std::uint32_t v : triangle) floor = std::min(floor, mesh.vertices[v].y);
    for (Vec3& p : mesh.vertices) p.y -= floor;
    return mesh;
}

Result<std::vector<RigBone>> readRig(const std::filesystem::path& path, const BaseMesh& mesh) {
    const auto file = readJson(path);
    if (!file) return tl::unexpected(file.error());
    const json bones = file->value("bones", json::object());
    if (!bones.is_object() || bones.empty() || bones.size() > 255)
        return fail(path.string(), fmt::format("has {} bones, expected 1 to 255", bones.size()));
    std::vector<RigBone> out;
    std::map<std::string, int> index;
    // Parents first: each round takes the bones whose parents are there.
    for (std::size_t before = 1; out.size() < bones.size() && before != out.size();) {
        before = out.size();
        for (const auto& [name, bone] : bones.items()) {
            const std::string parent = bone.value("parent", "");
            if (index.count(name) > 0 || (!parent.empty() && index.count(parent) == 0)) continue;
            const auto head = boneEnd(bone.value("head", json::object()), mesh);
            const auto tail = boneEnd(bone.value("tail", json::object()), mesh);
            if (!head || !tail)
                return fail(path.string(),
                            fmt::format("the ends of the bone {} are not found on the mesh", name),
                            "Ends with the strategies CUBE and MEAN are read");
            index[name] = static_cast<int>(out.size());
            out.push_back({name, parent.empty() ? -1 : index[parent], *head, *tail});
        }
        if (out.size() == before)
            return fail(path.string(),
                        fmt::format("{} bones are attached to no other", bones.size() - out.size()));
    }
    return out;
}

Result<std::vector<VertexWeights>> readWeights(const std::filesystem::path& path, const BaseMesh& mesh,
                                               const std::vector<RigBone>& bones) {
    const auto file = readJson(path);
    if (!file) return tl::unexpected(file.error());
    std::vector<std::vector<std::pair<double, std::uint8_t>>> found(mesh.vertices.size());
    const json lists = file->value("weights", json::object());
    for (std::size_t b = 0; b < bones.size(); ++b) {
        if (!lists.contains(bones[b].name)) continue;
        for (const json& pair : lists[bones[b].name]) {
            const bool sound = pair.is_array() && pair.size() == 2 && pair[0].is_number_unsigned() &&
                               pair[1].is_number() && pair[0].get<std::size_t>() < found.size();
            if (!sound)
                return fail(path.string(),
                            fmt::format("a weight of {} is not [vertex, weight]", bones[b].name));
            if (const double weight = pair[1].get<double>(); weight > 0.0)
                found[pair[0].get<std::size_t>()].emplace_back(weight, static_cast<std::uint8_t>(b));
        }
    }
    for (const auto& triangle : mesh.body)
        for (const std::uint32_t v : triangle)
            if (found[v].empty())
                return fail(path.string(), fmt::format("vertex {} of the body has no weight", v));
    std::vector<VertexWeights> out;
    out.reserve(found.size());
    for (auto& weights : found) out.push_back(heaviest(std::move(weights)));
    return out;
}

}  // namespace deixis::humanoid_maker
