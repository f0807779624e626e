#include "surface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <unordered_map>

#include "figure.hpp"
#include "shapes.hpp"

namespace deixis::avatar_maker {

namespace {

// The grid is uniform in its own space and bent so that its cells shrink along the arms towards the hands and
// up the neck towards the head; what is extracted from it is closed wherever the cells differ in size.
constexpr double cell = 0.008;
constexpr double hand_scale = 0.27, head_scale = 0.30;

struct Ramp {
    double start, length, scale;
    [[nodiscard]] double scaleAt(double u) const {
        return 1.0 - (1.0 - scale) * smoothStep(start, start + length, u);
    }
    /// The integral of scaleAt.
    [[nodiscard]] double position(double u) const {
        const double t = std::clamp((u - start) / length, 0.0, 1.0);
        const double ramp = t * t * t - 0.5 * t * t * t * t;
        return u - (1.0 - scale) * length * (ramp + std::max((u - start) / length - 1.0, 0.0));
    }
};
constexpr Ramp arm_ramp{0.50, 0.28, hand_scale};
constexpr Ramp head_ramp{1.45, 0.10, head_scale};
constexpr double arm_height = 1.388, arm_depth = -0.014, head_depth = 0.0;

Vec3 bend(const Vec3& u) {
    if (std::abs(u.x) > 0.45) {
        const double scale = arm_ramp.scaleAt(std::abs(u.x));
        return {std::copysign(arm_ramp.position(std::abs(u.x)), u.x), arm_height + scale * (u.y - arm_height),
                arm_depth + scale * (u.z - arm_depth)};
    }
    const double scale = head_ramp.scaleAt(u.y);
    return {scale * u.x, head_ramp.position(u.y), head_depth + scale * (u.z - head_depth)};
}

using Key = std::array<int, 3>;
struct KeyHash {
    std::size_t operator()(const Key& k) const {
        return static_cast<std::size_t>(k[0]) * 73856093U ^ static_cast<std::size_t>(k[1]) * 19349663U ^
               static_cast<std::size_t>(k[2]) * 83492791U;
    }
};

// The grid covers [-1.8, 1.8] x [-0.04, 2.3] x [-0.5, 0.5] in its own space.
Vec3 cornerPlace(const Key& k) {
    return bend(Vec3(k[0] + 0.5, k[1] - 5.3, k[2] + 0.5) * cell);
}

class Grid {
  public:
    double value(const Key& k) {
        const auto [at, is_new] = values_.try_emplace(k, 0.0);
        if (is_new) {
            at->second = figureDistance(cornerPlace(k));
            if (at->second == 0.0) at->second = 1e-9;
        }
        return at->second;
    }

    /// Cells that the surface may pass through, found by halving blocks that it surely misses away.
    std::vector<Key> cellsNearSurface() {
        std::vector<Key> cells;
        for (int x = -240; x < 240; x += 16)
            for (int y = 0; y < 336; y += 16)
                for (int z = -64; z < 64; z += 16) collect({x, y, z}, 16, cells);
        std::sort(cells.begin(), cells.end());
        return cells;
    }

  private:
    void collect(const Key& min, int size, std::vector<Key>& cells) {
        if (size == 1) {
            cells.push_back(min);
            return;
        }
        const int half = size / 2;
        const Key middle{min[0] + half, min[1] + half, min[2] + half};
        double reach = 0.0;  // from the middle to the farthest corner
        for (int corner = 0; corner < 8; ++corner) {
            const Key k{min[0] + (corner & 1) * size, min[1] + (corner >> 1 & 1) * size,
                        min[2] + (corner >> 2) * size};
            reach = std::max(reach, glm::length(cornerPlace(k) - cornerPlace(middle)));
        }
        // The field may grow faster than the distance does, by less than 1.8.
        if (std::abs(value(middle)) > 1.8 * reach) return;
        for (int child = 0; child < 8; ++child)
            collect(
                {min[0] + (child & 1) * half, min[1] + (child >> 1 & 1) * half, min[2] + (child >> 2) * half},
                half, cells);
    }

    std::unordered_map<Key, double, KeyHash> values_;
};

// Cube corners are numbered x + 2y + 4z. Edge e runs along axis e/4.
struct CubeEdge {
    int from, to;
};
CubeEdge cubeEdge(int e) {
    const int axis = e / 4;
    const int b = 1 << (axis + 1) % 3;
    const int c = 1 << (axis + 2) % 3;
    const int from = (e & 1 ? b : 0) + (e & 2 ? c : 0);
    return {from, from + (1 << axis)};
}
int edgeBetween(int a, int b) {
    for (int e = 0; e < 12; ++e) {
        const auto [from, to] = cubeEdge(e);
        if ((from == a && to == b) || (from == b && to == a)) return e;
    }
    return -1;
}

/// The surface's sheets in one cell: sheet_of[e] groups the edges that it crosses. On a face with four
/// crossings the inside corners are kept apart, which both cells at the face decide alike.
std::array<int, 12> sheetsOf(const std::array<bool, 8>& inside) {
    std::array<int, 12> group;
    for (int e = 0; e < 12; ++e) group[static_cast<std::size_t>(e)] = e;
    const auto find = [&](int e) {
        while (group[static_cast<std::size_t>(e)] != e) e = group[static_cast<std::size_t>(e)];
        return e;
    };
    const auto join = [&](int a, int b) {
        const int first = std::min(find(a), find(b));
        const int second = std::max(find(a), find(b));
        group[static_cast<std::size_t>(second)] = first;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const int b = 1 << (axis + 1) % 3;
            const int c = 1 << (axis + 2) % 3;
            const int base = side << axis;
            const std::array<int, 4> ring{base, base + b, base + b + c, base + c};
            std::vector<int> crossed;
            for (std::size_t i = 0; i < 4; ++i)
                if (inside[static_cast<std::size_t>(ring[i])] !=
                    inside[static_cast<std::size_t>(ring[(i + 1) % 4])])
                    crossed.push_back(edgeBetween(ring[i], ring[(i + 1) % 4]));
            if (crossed.size() == 2) join(crossed[0], crossed[1]);
            if (crossed.size() == 4) {
                // crossed[i] runs from ring[i] to ring[i + 1]; pair the two edges at each inside corner.
                if (inside[static_cast<std::size_t>(ring[0])]) {
                    join(crossed[3], crossed[0]);
                    join(crossed[1], crossed[2]);
                } else {
                    join(crossed[0], crossed[1]);
                    join(crossed[2], crossed[3]);
                }
            }
        }
    std::array<int, 12> sheet_of;
    for (int e = 0; e < 12; ++e) sheet_of[static_cast<std::size_t>(e)] = find(e);
    return sheet_of;
}

Key corner(const Key& min, int index) {
    return {min[0] + (index & 1), min[1] + (index >> 1 & 1), min[2] + (index >> 2)};
}

/// Evens the mesh out along the surface.
void relax(Mesh& mesh, int rounds) {
    std::vector<Vec3> sum(mesh.positions.size());
    std::vector<int> count(mesh.positions.size());
    for (int round = 0; round < rounds; ++round) {
        std::fill(sum.begin(), sum.end(), Vec3(0.0));
        std::fill(count.begin(), count.end(), 0);
        for (const Triangle& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                sum[t[i]] += mesh.positions[t[(i + 1) % 3]];
                ++count[t[i]];
            }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            const Vec3 p = mesh.positions[i];
            const Vec3 normal = surfaceNormal(p);
            const Vec3 step = sum[i] / static_cast<double>(count[i]) - p;
            mesh.positions[i] = ontoSurface(p + 0.5 * (step - normal * glm::dot(step, normal)));
        }
    }
}

}  // namespace

Vec3 fieldNormal(const std::function<double(const Vec3&)>& field, const Vec3& p) {
    constexpr double e = 0.0004;
    Vec3 gradient(0.0);  // from the corners of a tetrahedron
    for (const Vec3& corner : {Vec3(1, -1, -1), Vec3(-1, -1, 1), Vec3(-1, 1, -1), Vec3(1, 1, 1)})
        gradient += corner * field(p + e * corner);
    const double length = glm::length(gradient);
    return length < 1e-12 ? Vec3(0, 1, 0) : gradient / length;
}

Vec3 surfaceNormal(const Vec3& p) {
    return fieldNormal(figureDistance, p);
}

Vec3 ontoSurface(const Vec3& p) {
    Vec3 q = p;
    for (int step = 0; step < 3; ++step) {
        const double d = figureDistance(q);
        if (std::abs(d) < 5e-6) break;
        q -= surfaceNormal(q) * std::clamp(d, -0.003, 0.003);
    }
    return q;
}

Mesh extractSurface() {
    Grid grid;
    Mesh mesh;
    std::map<Key, std::array<int, 12>> vertex_of;  // per cell and edge; -1 where there is none
    for (const Key& min : grid.cellsNearSurface()) {
        std::array<bool, 8> inside;
        for (int c = 0; c < 8; ++c) inside[static_cast<std::size_t>(c)] = grid.value(corner(min, c)) < 0.0;
        if (std::all_of(inside.begin(), inside.end(), [&](bool i) { return i == inside[0]; })) continue;
        const auto sheet_of = sheetsOf(inside);
        std::array<Vec3, 12> sum{};
        std::array<int, 12> count{};
        for (int e = 0; e < 12; ++e) {
            const auto [from, to] = cubeEdge(e);
            if (inside[static_cast<std::size_t>(from)] == inside[static_cast<std::size_t>(to)]) continue;
            const double a = grid.value(corner(min, from));
            const double b = grid.value(corner(min, to));
            const auto sheet = static_cast<std::size_t>(sheet_of[static_cast<std::size_t>(e)]);
            sum[sheet] += glm::mix(cornerPlace(corner(min, from)), cornerPlace(corner(min, to)), a / (a - b));
            ++count[sheet];
        }
        std::array<int, 12> vertices;
        vertices.fill(-1);
        for (std::size_t sheet = 0; sheet < 12; ++sheet) {
            if (count[sheet] == 0) continue;
            vertices[sheet] = static_cast<int>(mesh.positions.size());
            mesh.positions.push_back(sum[sheet] / static_cast<double>(count[sheet]));
        }
        auto& of_edge = vertex_of[min];
        for (std::size_t e = 0; e < 12; ++e) of_edge[e] = vertices[static_cast<std::size_t>(sheet_of[e])];
    }
    // One quadrilateral across each crossed grid edge, from the four cells around it.
    for (const auto& [min, unused] : vertex_of)
        for (int axis = 0; axis < 3; ++axis) {
            const Key end{min[0] + (axis == 0), min[1] + (axis == 1), min[2] + (axis == 2)};
            const bool starts_inside = grid.value(min) < 0.0;
            if (starts_inside == (grid.value(end) < 0.0)) continue;
            const auto b = static_cast<std::size_t>((axis + 1) % 3);
            const auto c = static_cast<std::size_t>((axis + 2) % 3);
            std::array<std::uint32_t, 4> quad;
            // Seen along the axis, counter-clockwise: cells at (-b,-c), (0,-c), (0,0), (-b,0).
            const std::array<std::array<int, 2>, 4> around{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
            for (std::size_t i = 0; i < 4; ++i) {
                Key at = min;
                at[b] -= around[i][0];
                at[c] -= around[i][1];
                const int e = axis * 4 + around[i][0] + 2 * around[i][1];
                quad[i] = static_cast<std::uint32_t>(vertex_of.at(at)[static_cast<std::size_t>(e)]);
            }
            if (!starts_inside) std::swap(quad[1], quad[3]);
            const auto length = [&](std::size_t i, std::size_t j) {
                return glm::length(mesh.positions[quad[i]] - mesh.positions[quad[j]]);
            };
            if (length(0, 2) <= length(1, 3)) {
                mesh.triangles.push_back({quad[0], quad[1], quad[2]});
                mesh.triangles.push_back({quad[0], quad[2], quad[3]});
            } else {
                mesh.triangles.push_back({quad[0], quad[1], quad[3]});
                mesh.triangles.push_back({quad[1], quad[2], quad[3]});
            }
        }
    for (Vec3& p : mesh.positions) p = ontoSurface(p);
    relax(mesh, 3);
    return mesh;
}

bool isClosed(const std::vector<Triangle>& triangles) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const Triangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) edges.push_back({t[i], t[(i + 1) % 3]});
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i] == edges[i - 1]) return false;
        const std::array<std::uint32_t, 2> back{edges[i][1], edges[i][0]};
        if (!std::binary_search(edges.begin(), edges.end(), back)) return false;
    }
    return true;
}

}  // namespace deixis::avatar_maker
