#include "simulated_choice.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "motion/pointing/rays.hpp"
#include "studies/observers/observer_cues.hpp"

namespace deixis::studies {

namespace {

/// The line's direction turned by two angles about axes across it.
Vec3 disturbed(const Vec3& direction, double a_rad, double b_rad) {
    const AcrossRay across = acrossRay(direction);
    return glm::normalize(direction + std::tan(a_rad) * across.right + std::tan(b_rad) * across.above);
}

}  // namespace

BallChooser::BallChooser(const ObserverModel& model, std::uint64_t seed)
    : model_(model), choices_(seed, "choices") {}

BallChoice BallChooser::choose(const SeenArm& arm, const std::vector<BallView>& balls) {
    const bool lapse = choices_.uniform() < model_.lapse_rate;
    const std::size_t random_place = choices_.below(balls.size());
    std::vector<Vec3> centres;
    centres.reserve(balls.size());
    for (const BallView& ball : balls) centres.push_back(ball.centre);
    const BallChoice read =
        model_.reading.twoCue() ? byTwoCues(arm, centres) : byOneLine(arm.lines.line, centres);
    return lapse ? BallChoice{random_place, 0.0} : read;
}

BallChoice BallChooser::byTwoCues(const SeenArm& arm, const std::vector<Vec3>& balls) {
    const std::vector<double> evidence = logEvidence(model_, cuesOf(arm, balls));
    double left = choices_.uniform();
    std::size_t place = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double chance = cueChance(evidence, i);
        if (chance <= 0.0) continue;
        place = i;  // the last that is possible takes what rounding leaves
        left -= chance;
        if (left < 0.0) break;
    }
    const std::vector<double> missed = cueMisses(model_, evidence);
    double margin_rad = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < balls.size(); ++i)
        if (i != place) margin_rad = std::min(margin_rad, missed[i] - missed[place]);
    return {place, std::max(0.0, margin_rad)};
}

BallChoice BallChooser::byOneLine(const Ray& line, const std::vector<Vec3>& balls) {
    const double a_rad = model_.noise_rad * choices_.normal();
    const double b_rad = model_.noise_rad * choices_.normal();
    const auto best = motion::chosenBall({line.origin, disturbed(line.direction, a_rad, b_rad)}, balls);
    return {best->ball, best->margin_rad.value_or(std::numeric_limits<double>::infinity())};
}

}  // namespace deixis::studies
