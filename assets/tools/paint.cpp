#include "paint.hpp"

#include <glm/geometric.hpp>
#include <map>
#include <optional>

#include "split.hpp"

namespace deixis::avatar_maker {

namespace {

class Cutter {
  public:
    explicit Cutter(Mesh mesh) : mesh_(std::move(mesh)) {
        for (const Vec3& p : mesh_.positions) label_.emplace_back(figureMaterial(p));
    }

    PaintedMesh run() {
        moveNearVerticesOntoBorders();
        PaintedMesh out;
        for (const Triangle& t : mesh_.triangles) cut(t, out);
        out.mesh.positions = std::move(mesh_.positions);
        return out;
    }

  private:
    /// Where along the edge the material changes.
    [[nodiscard]] double border(const Vec3& a, const Vec3& b) const {
        const Material first = figureMaterial(a);
        double low = 0.0, high = 1.0;
        for (int step = 0; step < 14; ++step) {
            const double middle = 0.5 * (low + high);
            (figureMaterial(glm::mix(a, b, middle)) == first ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    /// A vertex close to a border moves onto it and belongs to neither side, which saves slivers.
    void moveNearVerticesOntoBorders() {
        constexpr double near = 0.3;
        const std::vector<Vec3> before = mesh_.positions;
        const std::vector<std::optional<Material>> label = label_;
        std::vector<double> nearest(before.size(), near);
        for (const Triangle& t : mesh_.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = t[i];
                const std::uint32_t b = t[(i + 1) % 3];
                if (label[a] == label[b]) continue;
                const double s = border(before[a], before[b]);
                const std::uint32_t v = s < 0.5 ? a : b;
                const double distance = std::min(s, 1.0 - s);
                if (distance >= nearest[v]) continue;
                nearest[v] = distance;
                mesh_.positions[v] = ontoSurface(glm::mix(before[a], before[b], s));
                label_[v].reset();
            }
    }

    std::uint32_t splitVertex(std::uint32_t a, std::uint32_t b) {
        const std::array<std::uint32_t, 2> key{std::min(a, b), std::max(a, b)};
        const auto [at, is_new] = split_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (is_new) {
            const Vec3 from = mesh_.positions[key[0]];
            const Vec3 to = mesh_.positions[key[1]];
            mesh_.positions.push_back(ontoSurface(glm::mix(from, to, border(from, to))));
            label_.emplace_back();
        }
        return at->second;
    }

    void emit(const Triangle& t, PaintedMesh& out) const {
        std::optional<Material> material;
        for (const std::uint32_t v : t)
            if (label_[v]) material = label_[v];
        if (!material)
            material =
                figureMaterial((mesh_.positions[t[0]] + mesh_.positions[t[1]] + mesh_.positions[t[2]]) / 3.0);
        out.mesh.triangles.push_back(t);
        out.materials.push_back(*material);
    }

    void cut(const Triangle& t, PaintedMesh& out) {
        std::array<std::optional<std::uint32_t>, 3> split;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i];
            const std::uint32_t b = t[(i + 1) % 3];
            if (label_[a] && label_[b] && label_[a] != label_[b]) split[i] = splitVertex(a, b);
        }
        splitTriangle(t, split, [&](const Triangle& part) { emit(part, out); });
    }

    Mesh mesh_;
    std::vector<std::optional<Material>> label_;  // none for a vertex on a border
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> split_;
};

}  // namespace

PaintedMesh paint(Mesh mesh) {
    return Cutter(std::move(mesh)).run();
}

}  // namespace deixis::avatar_maker
