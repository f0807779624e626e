// Signed distances of the rounded bodies that the avatar is blended from. Metres; negative inside. They are
// exact enough for blending: zero on the surface, and close to the distance near it. No function of libm but
// the square root is used, so that every compiler makes the same avatar.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <vector>

#include "core/pose.hpp"

namespace deixis::avatar_maker {

[[nodiscard]] inline double smoothStep(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Union that rounds the crease over about `k` metres.
[[nodiscard]] inline double blend(double a, double b, double k) {
    const double h = std::max(k - std::abs(a - b), 0.0) / k;
    return std::min(a, b) - h * h * k * 0.25;
}
/// What of `a` lies outside `b`, with a rounded edge.
[[nodiscard]] inline double carve(double a, double b, double k) {
    return -blend(-a, b, k);
}
/// What lies in both, with a rounded edge.
[[nodiscard]] inline double common(double a, double b, double k) {
    return -blend(-a, -b, k);
}

[[nodiscard]] inline double ellipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii) {
    const Vec3 q = (p - centre) / radii;
    const double k0 = glm::length(q);
    const double k1 = glm::length(q / radii);
    return k1 < 1e-9 ? -std::min({radii.x, radii.y, radii.z}) : k0 * (k0 - 1.0) / k1;
}

/// An ellipsoid leaning by (sine, cosine) about the x axis: positive leans its top backwards.
[[nodiscard]] inline double leaningEllipsoid(const Vec3& p, const Vec3& centre, const Vec3& radii,
                                             double sine) {
    const double cosine = std::sqrt(1.0 - sine * sine);
    const Vec3 d = p - centre;
    return ellipsoid({d.x, cosine * d.y - sine * d.z, sine * d.y + cosine * d.z}, Vec3(0.0), radii);
}

[[nodiscard]] inline double roundCone(const Vec3& p, const Vec3& a, const Vec3& b, double radius_a,
                                      double radius_b) {
    const Vec3 ab = b - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - a - t * ab) - (radius_a + (radius_b - radius_a) * t);
}

/// A ring about `axis` (unit length).
[[nodiscard]] inline double torus(const Vec3& p, const Vec3& centre, const Vec3& axis, double ring_radius,
                                  double tube_radius) {
    const Vec3 d = p - centre;
    const double along = glm::dot(d, axis);
    const double out = glm::length(d - along * axis) - ring_radius;
    return std::sqrt(along * along + out * out) - tube_radius;
}

/// One cross-section of a loft: centre, and half widths towards +-u and towards +v and -v.
struct Section {
    double t;
    double u, v;
    double half_u, plus_v, minus_v;
};

/// A body of smoothly varying sections along one coordinate axis. Sections are ellipses (squareness 0) to
/// rounded rectangles (1). Ends are cut flat and rounded by `end_rounding`.
class Loft {
  public:
    /// `along` is the axis of t (0 x, 1 y, 2 z); u and v are the axes given.
    Loft(int along, int u, int v, double squareness, double end_rounding, std::vector<Section> sections)
        : along_(along),
          u_(u),
          v_(v),
          squareness_(squareness),
          end_rounding_(end_rounding),
          sections_(std::move(sections)) {}

    [[nodiscard]] double operator()(const Vec3& p) const {
        const double first = sections_.front().t;
        const double last = sections_.back().t;
        const Section s = at(std::clamp(p[along_], first, last));
        const double du = p[u_] - s.u;
        const double dv = p[v_] - s.v;
        const double a = du / s.half_u;
        const double b = dv / (dv > 0.0 ? s.plus_v : s.minus_v);
        const double cross = 2.0 * (1.0 - squareness_) * a * a * b * b;
        const double q = std::sqrt(std::sqrt(a * a * a * a + b * b * b * b + cross));
        const double min = std::min({s.half_u, s.plus_v, s.minus_v});
        const double side = q < 1e-6 ? -min : std::max(-min, std::sqrt(du * du + dv * dv) * (1.0 - 1.0 / q));
        const double end = std::max(first - p[along_], p[along_] - last);
        return common(side, end, end_rounding_);
    }

  private:
    [[nodiscard]] Section at(double t) const {
        std::size_t i = 1;
        while (i + 1 < sections_.size() && sections_[i].t < t) ++i;
        const auto value = [&](double Section::*member) {
            const Section& a = sections_[i - 1];
            const Section& b = sections_[i];
            const double step = b.t - a.t;
            const double slope = (b.*member - a.*member) / step;
            const auto tangent = [&](std::size_t j) {
                if (j == 0 || j + 1 == sections_.size()) return slope;
                const Section& before = sections_[j - 1];
                const Section& after = sections_[j + 1];
                return (after.*member - before.*member) / (after.t - before.t);
            };
            const double s = (t - a.t) / step;
            const double s2 = s * s;
            const double s3 = s2 * s;
            return (2 * s3 - 3 * s2 + 1) * a.*member + (s3 - 2 * s2 + s) * step * tangent(i - 1) +
                   (3 * s2 - 2 * s3) * b.*member + (s3 - s2) * step * tangent(i);
        };
        return {t,
                value(&Section::u),
                value(&Section::v),
                value(&Section::half_u),
                value(&Section::plus_v),
                value(&Section::minus_v)};
    }

    int along_, u_, v_;
    double squareness_, end_rounding_;
    std::vector<Section> sections_;
};

}  // namespace deixis::avatar_maker
