#include "studies/observers/observer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "core/normal_probability.hpp"
#include "studies/observers/observer_cues.hpp"

namespace deixis::studies {

namespace {

constexpr std::string_view two_cue_name = "two-cue";
constexpr std::string_view arm_finger_name = "arm-finger";
constexpr motion::PointingRay arm_finger_ray = motion::PointingRay::elbow_fingertip;

/// Without noise the nearest line alone decides: so narrow that no other says anything.
constexpr double min_noise_rad = 1e-5;

Vec3 raisedDirection(const Vec3& direction, double by_rad) {
    const double across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    if (by_rad == 0.0 || across <= 0.0) return direction;
    const double elevation = std::clamp(std::atan2(direction.y, across) + by_rad, -0.5 * pi, 0.5 * pi);
    const double flat = std::cos(elevation) / across;
    return {flat * direction.x, std::sin(elevation), flat * direction.z};
}

double oneLineChance(const Ray& line, const std::vector<Vec3>& balls, std::size_t ball, double noise_rad) {
    // The disturbed line is direction + x right + y above with x and y the tangents of two normal angles. The
    // ball nearest in angle has the largest cosine with it: against each other ball a half-plane in x and y.
    const AcrossRay across = acrossRay(line.direction);
    const Vec3 to_ball = glm::normalize(balls[ball] - line.origin);
    struct HalfPlane {
        double constant, x, y;  // constant + x tan(a) + y tan(b) >= 0
    };
    std::vector<HalfPlane> nearer;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        if (i == ball) continue;
        const Vec3 than = to_ball - glm::normalize(balls[i] - line.origin);
        nearer.push_back(
            {glm::dot(than, line.direction), glm::dot(than, across.right), glm::dot(than, across.above)});
    }
    constexpr double step = 0.1;
    constexpr int steps = 50;
    double sum = 0.0;
    double weights = 0.0;
    for (int k = -steps; k <= steps; ++k) {
        const double z = step * k;
        const double a_rad = noise_rad * z;
        if (std::abs(a_rad) >= 0.5 * pi) continue;
        const double weight = std::exp(-0.5 * z * z);
        weights += weight;
        double low_rad = -0.5 * pi;
        double high_rad = 0.5 * pi;
        for (const HalfPlane& plane : nearer) {
            const double rest = plane.constant + plane.x * std::tan(a_rad);
            if (plane.y > 0.0)
                low_rad = std::max(low_rad, std::atan(-rest / plane.y));
            else if (plane.y < 0.0)
                high_rad = std::min(high_rad, std::atan(-rest / plane.y));
            else if (rest < 0.0)
                high_rad = low_rad;
        }
        if (high_rad > low_rad)
            sum += weight * (normalBelow(high_rad / noise_rad) - normalBelow(low_rad / noise_rad));
    }
    return sum / weights;
}

}  // namespace

Result<Reading> readingFromName(std::string_view name) {
    if (name == two_cue_name) return Reading{};
    if (name == arm_finger_name) return Reading{arm_finger_ray};
    const auto line = motion::pointingRayFromName(name);
    if (line) return Reading{*line};
    std::string hint = "Expected " + std::string(two_cue_name) + ", " + std::string(arm_finger_name);
    for (const motion::PointingRay ray : motion::all_pointing_rays)
        hint += ", " + std::string(motion::pointingRayName(ray));
    return fail("", line.error().message, std::move(hint));
}

std::string_view readingName(const Reading& reading) {
    if (reading.twoCue()) return two_cue_name;
    return *reading.line == arm_finger_ray ? arm_finger_name : motion::pointingRayName(*reading.line);
}

ArmLines armLines(const motion::Skeleton& skeleton, const motion::HumanoidMap& map,
                  const std::vector<Pose>& world, motion::Side side, const Reading& reading) {
    const auto line = [&](motion::PointingRay kind) {
        return motion::pointingRay(skeleton, map, world, side, kind);
    };
    ArmLines out{line(motion::PointingRay::eye_fingertip), line(arm_finger_ray), {}};
    out.line = reading.twoCue() ? out.eye_line : line(*reading.line);
    return out;
}

ArmLines meanOf(std::span<const ArmLines> frames) {
    ArmLines out;
    for (Ray ArmLines::*const line : {&ArmLines::eye_line, &ArmLines::arm_line, &ArmLines::line}) {
        Ray sum{Vec3(0.0), Vec3(0.0)};
        for (const ArmLines& frame : frames) {
            sum.origin += (frame.*line).origin;
            sum.direction += (frame.*line).direction;
        }
        out.*line = {sum.origin / static_cast<double>(frames.size()), glm::normalize(sum.direction)};
    }
    return out;
}

ArmLines raised(const ArmLines& lines, double by_rad) {
    ArmLines out = lines;
    for (Ray* line : {&out.eye_line, &out.arm_line, &out.line})
        line->direction = raisedDirection(line->direction, by_rad);
    return out;
}

Cues cuesOf(const SeenArm& arm, const std::vector<Vec3>& balls) {
    const Vec3 gaze = glm::normalize(arm.lines.eye_line.origin - arm.observer_eye);
    Cues out;
    out.along = std::clamp(glm::dot(gaze, arm.lines.arm_line.direction), 0.0, 1.0);
    for (const Vec3& ball : balls)
        out.missed.push_back({motion::angularError(arm.lines.eye_line, ball),
                              motion::angularError(arm.lines.arm_line, ball),
                              motion::angularError({arm.observer_eye, gaze}, ball)});
    return out;
}

std::array<double, 3> cueWeights(const ObserverModel& model, double along) {
    const double visual = model.visual_weight * along;
    const double eye_line = (1.0 - visual) * model.eye_line_share;
    return {eye_line, 1.0 - visual - eye_line, visual};
}

std::array<double, 3> cueWeights(const ObserverModel& model, const SeenArm& arm) {
    return cueWeights(model, cuesOf(arm, {}).along);
}

std::vector<double> logEvidence(const ObserverModel& model, const Cues& cues) {
    const auto weights = cueWeights(model, cues.along);
    std::array<double, 3> log_weights{};
    for (std::size_t cue = 0; cue < weights.size(); ++cue)
        log_weights[cue] =
            weights[cue] > 0.0 ? std::log(weights[cue]) : -std::numeric_limits<double>::infinity();
    const double noise_rad = std::max(model.noise_rad, min_noise_rad);
    std::vector<double> out;
    out.reserve(cues.missed.size());
    for (const auto& missed : cues.missed) {
        std::array<double, 3> voice{};
        for (std::size_t cue = 0; cue < voice.size(); ++cue) {
            const double z = missed[cue] / noise_rad;
            voice[cue] = log_weights[cue] - 0.5 * z * z;
        }
        const double loudest = *std::max_element(voice.begin(), voice.end());
        double sum = 0.0;
        for (const double one : voice) sum += std::exp(one - loudest);
        out.push_back(loudest + std::log(sum));
    }
    return out;
}

double cueChance(const std::vector<double>& evidence, std::size_t ball) {
    double sum = 0.0;
    for (const double voice : evidence) sum += std::exp(voice - evidence[ball]);  // infinite at worst
    return 1.0 / sum;
}

double cueChance(const ObserverModel& model, const Cues& cues, std::size_t ball) {
    return cueChance(logEvidence(model, cues), ball);
}

std::vector<double> cueMisses(const ObserverModel& model, const std::vector<double>& evidence) {
    const double noise_rad = std::max(model.noise_rad, min_noise_rad);
    std::vector<double> out;
    for (const double voice : evidence) out.push_back(noise_rad * std::sqrt(std::max(0.0, -2.0 * voice)));
    return out;
}

std::vector<double> misses(const ObserverModel& model, const SeenArm& arm, const std::vector<Vec3>& balls) {
    if (model.reading.twoCue()) return cueMisses(model, logEvidence(model, cuesOf(arm, balls)));
    std::vector<double> out;
    for (const Vec3& ball : balls) out.push_back(motion::angularError(arm.lines.line, ball));
    return out;
}

double ballChance(const ObserverModel& model, const SeenArm& arm, const std::vector<Vec3>& balls,
                  std::size_t ball) {
    return model.reading.twoCue() ? cueChance(model, cuesOf(arm, balls), ball)
                                  : oneLineChance(arm.lines.line, balls, ball, model.noise_rad);
}

double choiceChance(const ObserverModel& model, const SeenArm& arm, const std::vector<Vec3>& balls,
                    std::size_t ball) {
    return (1.0 - model.lapse_rate) * ballChance(model, arm, balls, ball) +
           model.lapse_rate / static_cast<double>(balls.size());
}

AcrossRay acrossRay(const Vec3& direction) {
    const Vec3 helper = std::abs(direction.y) < 0.9 ? up : Vec3(1.0, 0.0, 0.0);
    const Vec3 right = glm::normalize(glm::cross(direction, helper));
    return {right, glm::cross(right, direction)};
}

}  // namespace deixis::studies
