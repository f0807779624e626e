// Edge collapse by quadric error.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <queue>
#include <tuple>

#include "shapes.hpp"
#include "surface.hpp"

namespace deixis::avatar_maker {

namespace {

/// The sum of squared distances from planes, as a quadratic form: p'Ap + 2b'p + c, with the planes' weight.
struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    Vec3 b{0.0};
    double c = 0, weight = 0;

    void addPlane(const Vec3& n, double offset, double w) {
        xx += w * n.x * n.x;
        xy += w * n.x * n.y;
        xz += w * n.x * n.z;
        yy += w * n.y * n.y;
        yz += w * n.y * n.z;
        zz += w * n.z * n.z;
        b += w * offset * n;
        c += w * offset * offset;
        weight += w;
    }
    void add(const Quadric& q) {
        xx += q.xx;
        xy += q.xy;
        xz += q.xz;
        yy += q.yy;
        yz += q.yz;
        zz += q.zz;
        b += q.b;
        c += q.c;
        weight += q.weight;
    }
    [[nodiscard]] double at(const Vec3& p) const {
        const Vec3 ap(xx * p.x + xy * p.y + xz * p.z, xy * p.x + yy * p.y + yz * p.z,
                      xz * p.x + yz * p.y + zz * p.z);
        return std::max(glm::dot(p, ap) + 2.0 * glm::dot(b, p) + c, 0.0) / weight;
    }
};

/// How much detail matters at a place: the face and the hands are looked at.
double importance(const Vec3& p) {
    const double hand = smoothStep(0.68, 0.74, std::abs(p.x));
    const double head = smoothStep(1.47, 1.53, p.y) * (p.z > 0.03 ? 1.0 : 0.5);
    const double collar = p.y > 1.42 && p.y < 1.49 && std::abs(p.x) < 0.09 ? 1.0 : 0.0;
    return 1.0 + 14.0 * hand + 18.0 * std::max(head, 0.4 * collar);
}

/// Edges no longer than this, so that limbs keep rings to bend at.
double longestEdge(const Vec3& p) {
    return 0.034 - 0.022 * smoothStep(0.66, 0.74, std::abs(p.x)) - 0.016 * smoothStep(1.44, 1.52, p.y);
}

class Simplifier {
  public:
    explicit Simplifier(Mesh& mesh) : mesh_(mesh) {
        const std::size_t n = mesh.positions.size();
        quadrics_.resize(n);
        around_.resize(n);
        stamp_.assign(n, 0);
        alive_.assign(mesh.triangles.size(), true);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Vec3 cross = crossOf(mesh.triangles[t]);
            const double length = glm::length(cross);
            for (const std::uint32_t v : mesh.triangles[t]) {
                around_[v].push_back(t);
                if (length < 1e-14) continue;
                const Vec3 normal = cross / length;
                quadrics_[v].addPlane(normal, -glm::dot(normal, mesh.positions[v]), 0.5 * length);
            }
        }
        for (std::uint32_t v = 0; v < n; ++v)
            for (const std::uint32_t w : neighbours(v))
                if (v < w) propose(v, w);
    }

    void run(std::size_t target) {
        std::size_t count = mesh_.triangles.size();
        while (count > target && !queue_.empty()) {
            const Candidate best = queue_.top();
            queue_.pop();
            if (best.stamp != stamp_[best.a] + stamp_[best.b] || around_[best.a].empty() ||
                around_[best.b].empty())
                continue;
            if (collapse(best)) count -= 2;
        }
        compact();
    }

  private:
    struct Candidate {
        double cost;
        std::uint32_t a, b;
        std::uint32_t stamp;
        Vec3 place;
        bool operator<(const Candidate& other) const {  // the queue's top is the largest
            return std::tie(other.cost, other.a, other.b) < std::tie(cost, a, b);
        }
    };

    [[nodiscard]] Vec3 crossOf(const Triangle& t) const {
        const Vec3& p = mesh_.positions[t[0]];
        return glm::cross(mesh_.positions[t[1]] - p, mesh_.positions[t[2]] - p);
    }

    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
        std::vector<std::uint32_t> found;
        for (const std::uint32_t t : around_[v])
            for (const std::uint32_t w : mesh_.triangles[t])
                if (w != v) found.push_back(w);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    void propose(std::uint32_t a, std::uint32_t b) {
        if (b < a) std::swap(a, b);
        const Vec3& pa = mesh_.positions[a];
        const Vec3& pb = mesh_.positions[b];
        Quadric q = quadrics_[a];
        q.add(quadrics_[b]);
        Vec3 place = 0.5 * (pa + pb);
        double error = q.at(place);
        for (const Vec3& other : {pa, pb})
            if (const double e = q.at(other); e < error) {
                error = e;
                place = other;
            }
        const double length = glm::length(pa - pb);
        const double limit = longestEdge(place);
        // Short edges first where the surface is flat, so that triangles stay well shaped.
        double cost = importance(place) * (error + 3e-5 * length * length);
        if (length > limit) cost += 1.0;
        queue_.push({cost, a, b, stamp_[a] + stamp_[b], place});
    }

    /// A collapse keeps the mesh closed if the edge's ends share two neighbours and no more, and turns no
    /// triangle over.
    [[nodiscard]] bool allowed(const Candidate& c) const {
        const auto of_a = neighbours(c.a);
        const auto of_b = neighbours(c.b);
        std::vector<std::uint32_t> shared;
        std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(shared));
        if (shared.size() != 2) return false;
        for (const std::uint32_t s : shared)
            if (around_[s].size() <= 3) return false;
        for (const std::uint32_t end : {c.a, c.b})
            for (const std::uint32_t t : around_[end]) {
                const Triangle& triangle = mesh_.triangles[t];
                const auto has = [&](std::uint32_t v) {
                    return std::find(triangle.begin(), triangle.end(), v) != triangle.end();
                };
                if (has(c.a) && has(c.b)) continue;
                std::array<Vec3, 3> p;
                for (std::size_t i = 0; i < 3; ++i)
                    p[i] = triangle[i] == end ? c.place : mesh_.positions[triangle[i]];
                const Vec3 before = crossOf(triangle);
                const Vec3 after = glm::cross(p[1] - p[0], p[2] - p[0]);
                if (glm::dot(before, after) < 0.5 * glm::length(before) * glm::length(after)) return false;
                const double longest =
                    std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
                if (glm::length(after) < 0.12 * longest * longest) return false;  // a sliver
            }
        return true;
    }

    bool collapse(const Candidate& c) {
        if (c.cost >= 1.0 || !allowed(c)) return false;
        mesh_.positions[c.a] = c.place;
        quadrics_[c.a].add(quadrics_[c.b]);
        std::vector<std::uint32_t> kept;
        for (const std::uint32_t t : around_[c.a]) {
            const Triangle& triangle = mesh_.triangles[t];
            if (std::find(triangle.begin(), triangle.end(), c.b) == triangle.end()) {
                kept.push_back(t);
                continue;
            }
            alive_[t] = false;
            for (const std::uint32_t v : triangle)
                if (v != c.a && v != c.b) std::erase(around_[v], t);
        }
        for (const std::uint32_t t : around_[c.b]) {
            if (!alive_[t]) continue;
            std::replace(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), c.b, c.a);
            kept.push_back(t);
        }
        around_[c.a] = kept;
        around_[c.b].clear();
        ++stamp_[c.a];
        for (const std::uint32_t w : neighbours(c.a)) propose(c.a, w);
        return true;
    }

    void compact() {
        std::vector<std::uint32_t> new_index(mesh_.positions.size(), 0);
        std::vector<Vec3> positions;
        for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
            if (around_[v].empty()) continue;
            new_index[v] = static_cast<std::uint32_t>(positions.size());
            positions.push_back(mesh_.positions[v]);
        }
        std::vector<Triangle> triangles;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
            if (alive_[t]) {
                const Triangle& old = mesh_.triangles[t];
                triangles.push_back({new_index[old[0]], new_index[old[1]], new_index[old[2]]});
            }
        mesh_.positions = std::move(positions);
        mesh_.triangles = std::move(triangles);
    }

    Mesh& mesh_;
    std::vector<Quadric> quadrics_;
    std::vector<std::vector<std::uint32_t>> around_;  // triangles at each vertex
    std::vector<std::uint32_t> stamp_;
    std::vector<bool> alive_;
    std::priority_queue<Candidate> queue_;
};

}  // namespace

void simplify(Mesh& mesh, std::size_t triangle_target) {
    Simplifier(mesh).run(triangle_target);
    for (Vec3& p : mesh.positions) p = ontoSurface(p);
}

}  // namespace deixis::avatar_maker
