#include "simulated_choice.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "motion/pointing.hpp"

namespace deixis::studies {

namespace {

/// The ray's direction turned by two angles about axes across it.
Vec3 disturbed(const Vec3& direction, double a_rad, double b_rad) {
    const AcrossRay across = acrossRay(direction);
    return glm::normalize(direction + std::tan(a_rad) * across.right + std::tan(b_rad) * across.above);
}

}  // namespace

AcrossRay acrossRay(const Vec3& direction) {
    const Vec3 helper = std::abs(direction.y) < 0.9 ? up : Vec3(1.0, 0.0, 0.0);
    const Vec3 right = glm::normalize(glm::cross(direction, helper));
    return {right, glm::cross(right, direction)};
}

BallChooser::BallChooser(double noise_rad, double lapse_rate, std::uint64_t seed)
    : noise_rad_(noise_rad), lapse_rate_(lapse_rate), choices_(seed, "choices") {}

BallChoice BallChooser::choose(const SeenGesture& seen, const std::vector<BallView>& balls) {
    const bool lapse = choices_.uniform() < lapse_rate_;
    const std::size_t random_place = choices_.below(balls.size());
    const double a_rad = noise_rad_ * choices_.normal();
    const double b_rad = noise_rad_ * choices_.normal();
    if (lapse) return {random_place, 0.0};
    const Ray ray{seen.ray.origin, disturbed(seen.ray.direction, a_rad, b_rad)};
    double nearest = std::numeric_limits<double>::infinity();
    double next = std::numeric_limits<double>::infinity();
    std::size_t place = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double angle = motion::angularError(ray, balls[i].centre);
        if (angle < nearest) {
            next = nearest;
            nearest = angle;
            place = i;
        } else if (angle < next) {
            next = angle;
        }
    }
    return {place, next - nearest};
}

}  // namespace deixis::studies
