#include "studies/simulated_participant.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>

#include "core/random.hpp"
#include "panel_layout.hpp"
#include "simulated_observer.hpp"

namespace deixis::studies {

namespace {

constexpr double look_away_s = 0.3;   ///< after an answer: until then it does not watch the avatar
constexpr double aim_s = 0.25;        ///< it aims so long before it presses
constexpr double look_s = 0.5;        ///< it looks at what it means so long before it presses
constexpr double head_turn_s = 0.15;  ///< time constant of its head
const Vec3 hand_in_viewer{0.2, 1.15, -0.35};
const Vec3 hanging_hand_in_viewer{0.25, 0.75, -0.05};

/// What the frame asks of whoever sees it.
enum class Situation : unsigned char { watching, page, rating, choosing };

bool isNumber(const PanelButton& button) {
    return !button.label.empty() &&
           std::all_of(button.label.begin(), button.label.end(), [](char c) { return c >= '0' && c <= '9'; });
}

Situation situationOf(const PresentedFrame& frame) {
    if (!frame.balls.empty() && std::any_of(frame.balls.begin(), frame.balls.end(), [](const BallView& ball) {
            return ball.look == BallLook::chosen;
        }))
        return Situation::watching;
    if (!frame.balls.empty() && frame.balls.front().look != BallLook::waiting) return Situation::choosing;
    if (frame.panel) {
        for (const PanelButton& button : frame.panel->buttons)
            if (button.enabled) return isNumber(button) ? Situation::rating : Situation::page;
    }
    return Situation::watching;
}

double share(double value, double none, double all) {
    return std::clamp((value - none) / (all - none), 0.0, 1.0);
}

motion::PointingRay rayKind(const std::string& name) {
    const auto kind = motion::pointingRayFromName(name);
    if (!kind) throw std::invalid_argument(kind.error().text());
    return *kind;
}

Vec3 buttonCentre(const Panel& panel, const PanelButton& button) {
    return transformPoint(panel.stage_from_panel, {button.box.x + button.box.width / 2.0,
                                                   button.box.y + button.box.height / 2.0, 0.0});
}

/// The ray's direction turned by two angles about axes across it.
Vec3 disturbed(const Vec3& direction, double a_rad, double b_rad) {
    const Vec3 helper = std::abs(direction.y) < 0.9 ? up : Vec3(1.0, 0.0, 0.0);
    const Vec3 right = glm::normalize(glm::cross(direction, helper));
    const Vec3 above = glm::cross(right, direction);
    return glm::normalize(direction + std::tan(a_rad) * right + std::tan(b_rad) * above);
}

Quat lookRotation(const Vec3& forward) {
    const double yaw = std::atan2(-forward.x, -forward.z);
    const double pitch = std::asin(std::clamp(forward.y, -1.0, 1.0));
    return yawRotation(yaw) * Quat(std::cos(pitch / 2.0), std::sin(pitch / 2.0), 0.0, 0.0);
}

/// True where the ray meets this ball before the others and any panel.
bool meetsFirst(const PresentedFrame& frame, const Ray& ray, std::size_t place) {
    const double own = distanceToSphere(ray, frame.balls[place].centre, frame.balls[place].radius_m);
    if (own < 0.0) return false;
    for (std::size_t i = 0; i < frame.balls.size(); ++i) {
        if (i == place) continue;
        const double other = distanceToSphere(ray, frame.balls[i].centre, frame.balls[i].radius_m);
        if (other >= 0.0 && other <= own) return false;
    }
    const auto panel = frame.panel ? meetPanel(*frame.panel, ray) : std::nullopt;
    return !panel || panel->distance_m > own;
}

/// A ray from the hand to a ball that nothing else stops: where another ball hides its centre, past its edge
/// or from a hand held elsewhere.
Ray aimAtBall(const PresentedFrame& frame, std::size_t place) {
    const BallView& ball = frame.balls[place];
    Ray straight{};
    bool first = true;
    for (const double aside_m : {0.0, 0.25, -0.65, 0.5, -0.9}) {
        for (const double raised_m : {0.0, 0.35, -0.4}) {
            const Vec3 hand =
                transformPoint(frame.stage_from_viewer, hand_in_viewer + Vec3(aside_m, raised_m, 0.0));
            const Vec3 direction = glm::normalize(ball.centre - hand);
            if (first) straight = {hand, direction};
            first = false;
            const Vec3 right = glm::normalize(glm::cross(direction, up));
            const Vec3 above = glm::cross(right, direction);
            const double edge_m = 0.8 * ball.radius_m;
            for (const Vec3& offset :
                 {Vec3(0.0), right * edge_m, right * -edge_m, above * edge_m, above * -edge_m}) {
                const Ray ray{hand, glm::normalize(ball.centre + offset - hand)};
                if (meetsFirst(frame, ray, place)) return ray;
            }
        }
    }
    return straight;
}

}  // namespace

struct SimulatedParticipant::State {
    State(const SimulatedParameters& given, const motion::Skeleton& avatar, std::uint64_t seed)
        : parameters(given),
          observer(avatar, rayKind(given.pointing_ray)),
          head(motion::mapByVrmNames(avatar)[motion::Bone::head]),
          choices(seed, "choices"),
          ratings(seed, "ratings"),
          reactions(seed, "reactions") {
        Random person(seed, "person");
        noise_rad = radiansFromDegrees(parameters.pointing_noise_deg) *
                    std::max(0.2, 1.0 + parameters.pointing_noise_between * person.normal());
        bias = parameters.rating_bias_between * person.normal();
    }

    SimulatedParameters parameters;
    GestureObserver observer;
    int head;
    Random choices, ratings, reactions;  // apart, so that no answer depends on how many others were drawn
    double noise_rad = 0.0;
    double bias = 0.0;

    Situation situation = Situation::watching;
    double situation_since_s = 0.0;
    std::optional<Ray> aim;  ///< decided: at what it will press,
    Vec3 meant{0.0};         ///< which lies here
    double press_at_s = 0.0;
    bool aimed = false;  ///< the ray has been held out in an earlier frame
    Pose stage_from_viewer{};
    std::string place;
    Vec3 look{0.0, 0.0, -1.0};
    double seen_s = 0.0;

    double reactionTime() {
        const double mean = parameters.reaction_mean_s;
        const double variation = parameters.reaction_sd_s / mean;
        const double variance = std::log1p(variation * variation);
        return std::exp(std::log(mean) - variance / 2.0 + std::sqrt(variance) * reactions.normal());
    }

    void see(const PresentedFrame& frame, double time_s) {
        stage_from_viewer = frame.stage_from_viewer;
        const Situation now = situationOf(frame);
        if (now != situation) {
            situation = now;
            situation_since_s = time_s;
            aim.reset();
            if (now == Situation::watching) observer.forget();
            if (now != Situation::watching) decide(frame, now, time_s);
        } else if (now == Situation::page && !aim) {
            decide(frame, now, time_s);
        }
        if (now == Situation::watching && time_s - situation_since_s >= look_away_s)
            observer.see(frame.avatar_joints, time_s);
        lookAround(frame, time_s);
    }

    void decide(const PresentedFrame& frame, Situation asked, double time_s) {
        aimed = false;
        press_at_s = time_s + reactionTime();
        switch (asked) {
            case Situation::choosing: {
                const std::size_t chosen = chosenPlace(frame);
                aim = aimAtBall(frame, chosen);
                meant = frame.balls[chosen].centre;
                break;
            }
            case Situation::rating:
                decideOnButton(frame, [wanted = rating(frame)](const PanelButton& button) {
                    return button.label == std::to_string(wanted);
                });
                break;
            case Situation::page:
                decideOnButton(frame, [](const PanelButton& button) { return button.enabled; });
                break;
            case Situation::watching:
                break;
        }
    }

    template <typename Wanted>
    void decideOnButton(const PresentedFrame& frame, const Wanted& wanted) {
        const Vec3 hand = transformPoint(frame.stage_from_viewer, hand_in_viewer);
        const auto& buttons = frame.panel->buttons;
        const auto found = std::find_if(buttons.begin(), buttons.end(), wanted);
        aim.reset();
        if (found == buttons.end()) return;
        meant = buttonCentre(*frame.panel, *found);
        aim = Ray{hand, glm::normalize(meant - hand)};
    }

    std::size_t chosenPlace(const PresentedFrame& frame) {
        const bool lapse = choices.uniform() < parameters.lapse_rate;
        const std::size_t random_place = choices.below(frame.balls.size());
        const double a_rad = noise_rad * choices.normal();
        const double b_rad = noise_rad * choices.normal();
        if (lapse) return random_place;
        Ray ray = observer.gesture().ray;
        ray.direction = disturbed(ray.direction, a_rad, b_rad);
        std::size_t best = 0;
        for (std::size_t i = 1; i < frame.balls.size(); ++i)
            if (motion::angularError(ray, frame.balls[i].centre) <
                motion::angularError(ray, frame.balls[best].centre))
                best = i;
        return best;
    }

    int rating(const PresentedFrame& frame) {
        const auto steps = static_cast<int>(
            std::count_if(frame.panel->buttons.begin(), frame.panel->buttons.end(), isNumber));
        const SeenGesture seen = observer.gesture();
        const double profile =
            share(seen.peak_over_mean, parameters.profile_abrupt, parameters.profile_smooth);
        const double participation = 1.0 - std::exp(-seen.participation_deg / parameters.participation_deg);
        const double steadiness =
            share(seen.hold_speed_m_s, parameters.unsteady_speed_m_s, parameters.steady_speed_m_s);
        const double of_five = parameters.rating_base + parameters.rating_profile_weight * profile +
                               parameters.rating_participation_weight * participation +
                               parameters.rating_steadiness_weight * steadiness;
        const double value = 1.0 + (of_five - 1.0) * (steps - 1) / 4.0 + bias +
                             parameters.rating_noise_within * ratings.normal();
        return std::clamp(static_cast<int>(std::floor(value + 0.5)), 1, steps);
    }

    /// Eyes on what it is about to press, on the panel, or between the avatar and the balls.
    void lookAround(const PresentedFrame& frame, double time_s) {
        const Vec3 eyes = frame.stage_from_viewer.position + Vec3(0.0, parameters.eye_height_m, 0.0);
        const Vec3 ahead = frame.stage_from_viewer.orientation * Vec3(0.0, 0.0, -1.0);
        const Vec3 avatar =
            frame.avatar_joints[static_cast<std::size_t>(head)].position - Vec3(0.0, 0.25, 0.0);
        Vec3 goal = glm::normalize(avatar - eyes);
        if (aim && time_s >= press_at_s - look_s) {
            goal = meant - eyes;
        } else if (!frame.balls.empty()) {
            Vec3 middle(0.0);
            for (const BallView& ball : frame.balls)
                middle += ball.centre / static_cast<double>(frame.balls.size());
            // Beside the avatar, the balls; its arm is then in view anyway.
            const double avatar_share = glm::dot(goal, ahead) > 0.7 ? 0.5 : 0.1;
            goal = avatar_share * goal + (1.0 - avatar_share) * glm::normalize(middle - eyes);
        } else if (frame.panel && situation == Situation::page) {
            goal = transformPoint(frame.panel->stage_from_panel,
                                  {frame.panel->width_m / 2.0, frame.panel->height_m / 2.0, 0.0}) -
                   eyes;
        }
        const bool moved = place != frame.viewer_place;
        if (moved) place = frame.viewer_place;
        const double turned = moved ? 1.0 : 1.0 - std::exp(-(time_s - seen_s) / head_turn_s);
        const Vec3 next = look + turned * (glm::normalize(goal) - look);
        look = glm::length(next) > 1e-6 ? glm::normalize(next) : glm::normalize(goal);
        seen_s = time_s;
    }

    InputFrame act(double time_s) {
        InputFrame input;
        input.time_s = time_s;
        input.utc_s = time_s;
        input.stage_from_head = {stage_from_viewer.position + Vec3(0.0, parameters.eye_height_m, 0.0),
                                 lookRotation(look)};
        if (!aim || time_s < press_at_s - aim_s) {
            input.pointer = Ray{transformPoint(stage_from_viewer, hanging_hand_in_viewer), -up};
            return input;
        }
        input.pointer = aim;
        if (aimed && time_s >= press_at_s) {
            input.select = true;
            // Should the press not take, it tries again; a page may also be followed by another.
            press_at_s = time_s + reactionTime();
            aimed = false;
            if (situation == Situation::page) aim.reset();
        } else {
            aimed = true;
        }
        return input;
    }
};

SimulatedParticipant::SimulatedParticipant(const SimulatedParameters& parameters,
                                           const motion::Skeleton& avatar, std::uint64_t seed)
    : state_(std::make_unique<State>(parameters, avatar, seed)) {}

SimulatedParticipant::~SimulatedParticipant() = default;
SimulatedParticipant::SimulatedParticipant(SimulatedParticipant&&) noexcept = default;

void SimulatedParticipant::see(const PresentedFrame& frame, double time_s) {
    state_->see(frame, time_s);
}

InputFrame SimulatedParticipant::act(double time_s) {
    return state_->act(time_s);
}

}  // namespace deixis::studies
