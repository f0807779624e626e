#include "split.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace deixis::avatar_maker {

void splitTriangle(const Triangle& t, const std::array<std::optional<std::uint32_t>, 3>& split,
                   const std::function<void(const Triangle&)>& emit) {
    const auto count = std::count_if(split.begin(), split.end(), [](const auto& s) { return s.has_value(); });
    if (count == 0) return emit(t);
    if (count == 3) {
        for (std::size_t i = 0; i < 3; ++i) emit({t[i], *split[i], *split[(i + 2) % 3]});
        return emit({*split[0], *split[1], *split[2]});
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i];
        const std::uint32_t b = t[(i + 1) % 3];
        const std::uint32_t c = t[(i + 2) % 3];
        if (count == 1 && split[i]) {
            emit({a, *split[i], c});
            return emit({*split[i], b, c});
        }
        if (count == 2 && split[i] && split[(i + 2) % 3]) {  // a is cut off
            const std::uint32_t s = *split[i];
            const std::uint32_t r = *split[(i + 2) % 3];
            emit({a, s, r});
            emit({s, b, c});
            return emit({s, c, r});
        }
    }
}

void refine(Mesh& mesh, const std::function<double(const Vec3&)>& longest) {
    for (int round = 0; round < 4; ++round) {
        std::map<std::array<std::uint32_t, 2>, std::uint32_t> middle_of;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) -> std::optional<std::uint32_t> {
            const std::array<std::uint32_t, 2> key{std::min(a, b), std::max(a, b)};
            if (const auto found = middle_of.find(key); found != middle_of.end()) return found->second;
            const Vec3 from = mesh.positions[key[0]];
            const Vec3 to = mesh.positions[key[1]];
            const Vec3 p = 0.5 * (from + to);
            if (glm::length(to - from) <= longest(p)) return std::nullopt;
            const auto index = static_cast<std::uint32_t>(mesh.positions.size());
            mesh.positions.push_back(ontoSurface(p));
            middle_of.emplace(key, index);
            return index;
        };
        std::vector<Triangle> finer;
        for (const Triangle& t : mesh.triangles)
            splitTriangle(t, {middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])},
                          [&](const Triangle& part) { finer.push_back(part); });
        mesh.triangles = std::move(finer);
    }
}

}  // namespace deixis::avatar_maker
