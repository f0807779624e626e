#include "physics/figure/de_leva.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace deixis::physics {

namespace {

/// Percent, as in the table.
struct Row {
    double mass, centre, front, side, length;
};
struct Rows {
    Row women, men;
};

constexpr std::array<Rows, 10> table{{
    {{6.68, 48.41, 27.1, 29.5, 26.1}, {6.94, 50.02, 30.3, 31.5, 26.1}},
    {{15.45, 50.50, 46.6, 31.4, 44.9}, {15.96, 50.66, 50.5, 32.0, 46.5}},
    {{14.65, 45.12, 43.3, 35.4, 41.5}, {16.33, 45.02, 48.2, 38.3, 46.8}},
    {{12.47, 49.20, 43.3, 40.2, 44.4}, {11.17, 61.15, 61.5, 55.1, 58.7}},
    {{2.55, 57.54, 27.8, 26.0, 14.8}, {2.71, 57.72, 28.5, 26.9, 15.8}},
    {{1.38, 45.59, 26.1, 25.7, 9.4}, {1.62, 45.74, 27.6, 26.5, 12.1}},
    {{0.56, 74.74, 53.1, 45.4, 33.5}, {0.61, 79.00, 62.8, 51.3, 40.1}},
    {{14.78, 36.12, 36.9, 36.4, 16.2}, {14.16, 40.95, 32.9, 32.9, 14.9}},
    {{4.81, 43.52, 26.7, 26.3, 9.2}, {4.33, 43.95, 25.1, 24.6, 10.2}},
    {{1.29, 40.14, 29.9, 27.9, 13.9}, {1.37, 44.15, 25.7, 24.5, 12.4}},
}};

double mean(double women, double men) {
    return 0.5 * (women + men) / 100.0;
}

}  // namespace

PartParameters partParameters(BodyPart part) {
    const auto& [women, men] = table.at(static_cast<std::size_t>(part));
    return {mean(women.mass, men.mass),
            mean(women.centre, men.centre),
            {mean(women.front, men.front), mean(women.side, men.side), mean(women.length, men.length)}};
}

double bodyMass(double stature_m) {
    constexpr double kg_per_m2 = 0.5 * (61.9 / (1.735 * 1.735) + 73.0 / (1.741 * 1.741));
    return kg_per_m2 * stature_m * stature_m;
}

MassProperties massOf(BodyPart part, double body_mass_kg, const Vec3& first_end, const Vec3& other_end,
                      const Vec3& front) {
    const PartParameters parameters = partParameters(part);
    MassProperties out;
    out.mass_kg = parameters.mass_share * body_mass_kg;
    out.centre_m = first_end + parameters.centre_share * (other_end - first_end);
    const double length_m = glm::length(other_end - first_end);
    const Vec3 lengthwise = (other_end - first_end) / length_m;
    // A foot points ahead itself: what is up for it stands for its front.
    const Vec3 ahead = std::abs(glm::dot(lengthwise, front)) < 0.9 ? front : up;
    const Vec3 front_axis = glm::normalize(ahead - glm::dot(ahead, lengthwise) * lengthwise);
    const std::array<Vec3, 3> axes{front_axis, glm::cross(lengthwise, front_axis), lengthwise};
    for (int i = 0; i < 3; ++i) {
        const double radius_m = parameters.radii_of_gyration[i] * length_m;
        const Vec3& axis = axes.at(static_cast<std::size_t>(i));
        out.inertia_kg_m2 += out.mass_kg * radius_m * radius_m * glm::outerProduct(axis, axis);
    }
    return out;
}

MassProperties together(const MassProperties& a, const MassProperties& b) {
    MassProperties out;
    out.mass_kg = a.mass_kg + b.mass_kg;
    out.centre_m = (a.mass_kg * a.centre_m + b.mass_kg * b.centre_m) / out.mass_kg;
    for (const MassProperties* part : {&a, &b}) {
        const Vec3 away = part->centre_m - out.centre_m;
        out.inertia_kg_m2 += part->inertia_kg_m2 + part->mass_kg * (glm::dot(away, away) * glm::dmat3(1.0) -
                                                                    glm::outerProduct(away, away));
    }
    return out;
}

}  // namespace deixis::physics
