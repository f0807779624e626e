// What a simulated participant takes from watching the avatar move.
#pragma once

#include <array>
#include <vector>

#include "motion/pointing/rays.hpp"
#include "studies/observers/observer.hpp"

namespace deixis::studies {

/// What was seen of one gesture.
struct SeenGesture {
    motion::Side hand = motion::Side::right;
    ArmLines lines{};             ///< where it pointed, mean over the hold
    ArmLines at_first{};          ///< when the hold began
    ArmLines at_last{};           ///< and when it ended
    double hold_middle_s = 0.0;   ///< on the clock of the frames
    double peak_over_mean = 1.0;  ///< speed of the fingertip during the raise
    double participation_deg =
        0.0;  ///< turn of the head and of the trunk, from before the raise to the hold, summed
    double hold_speed_m_s = 0.0;  ///< mean speed of the fingertip in the hold
};

/// Watches the avatar from the first frame given after `forget` and finds the gesture in what it saw.
class GestureObserver {
  public:
    /// Throws std::invalid_argument where the avatar lacks the joints of head, trunk or an arm.
    GestureObserver(const motion::Skeleton& avatar, const Reading& reading);

    void forget();
    void see(const std::vector<Pose>& stage_from_joint, double time_s);
    [[nodiscard]] SeenGesture gesture() const;

  private:
    struct ObservedFrame {
        double time_s = 0.0;
        std::array<Vec3, 2> tip{};  ///< by side
        std::array<ArmLines, 2> lines{};
        Quat head{1.0, 0.0, 0.0, 0.0};
        Quat trunk{1.0, 0.0, 0.0, 0.0};
    };
    struct Span {
        std::size_t first = 0;
        std::size_t last = 0;  ///< included
    };

    [[nodiscard]] static Span holdOf(const std::vector<Vec3>& tip, const std::vector<double>& speed);

    const motion::Skeleton& avatar_;
    motion::HumanoidMap map_;
    int trunk_ = 0;  ///< the joint that the trunk turns with
    Reading reading_;
    std::vector<ObservedFrame> seen_;
};

}  // namespace deixis::studies
