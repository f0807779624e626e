// Where a simulated participant's hand points and its eyes look.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "studies/station/station.hpp"

namespace deixis::studies {

/// A point of a board, in the stage's frame.
[[nodiscard]] Vec3 pointOnPanel(const Panel& panel, double x_m, double y_m);

/// The hand hangs down.
[[nodiscard]] Ray restingRay(const Pose& stage_from_viewer);

/// From the hand to a ball, such that nothing else stops the ray: where another ball hides its centre, past
/// its edge or from a hand held elsewhere.
[[nodiscard]] Ray aimAtBall(const PresentedFrame& frame, std::size_t place);

/// From the hand to a point of the board, such that no ball stops the ray.
[[nodiscard]] Ray aimAtBoard(const PresentedFrame& frame, const Vec3& point);

/// What the hand is about to do: it hangs, comes up in time, aims, presses, and where something is to be
/// dragged keeps select down until the ray has moved on.
class SimulatedHand {
  public:
    /// `meant`: what is pressed, which the eyes turn to.
    void press(const Ray& aim, const Vec3& meant, double at_s);
    void drag(const Ray& from, const Ray& to, const Vec3& meant, double at_s);
    void drop();
    [[nodiscard]] bool busy() const { return plan_.has_value(); }
    [[nodiscard]] bool dragging() const { return plan_ && plan_->pressed_s.has_value(); }
    /// What is to be looked at for the press; none: it is not so far yet.
    [[nodiscard]] std::optional<Vec3> lookedAt(double time_s) const;

    /// Fills in pointer and select. True when it is done with what was planned.
    bool act(const Pose& stage_from_viewer, InputFrame& input);

  private:
    struct Plan {
        Ray from{};
        std::optional<Ray> to{};
        Vec3 meant{0.0};
        double press_at_s = 0.0;
        bool aimed = false;                 ///< the ray has been held out in an earlier frame
        std::optional<double> pressed_s{};  ///< while it drags
        bool arrived = false;
    };
    std::optional<Plan> plan_;
};

/// The head, which turns to what is looked at in its time.
class SimulatedHead {
  public:
    /// Turns towards a point for the time passed; at once where the viewer has been moved.
    void turn(const PresentedFrame& frame, const Vec3& eyes, const Vec3& towards, double time_s);
    [[nodiscard]] Quat orientation() const;

  private:
    Vec3 look_{0.0, 0.0, -1.0};
    std::string place_;
    double seen_s_ = 0.0;
};

/// What to look at while nothing is pressed: the avatar, the balls and it, or the board, where it is read,
/// else between both.
[[nodiscard]] Vec3 placeToLook(const PresentedFrame& frame, const Vec3& eyes, int head_joint,
                               bool reads_board);

}  // namespace deixis::studies
