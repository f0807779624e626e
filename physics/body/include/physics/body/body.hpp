// The body in MuJoCo: set to a state, stepped with targets for its joints, and read. Nobody outside knows
// MuJoCo, which is loaded when the first body is made: without it everything else works.
//
// The same states and targets give the same states, bit for bit, with the same MuJoCo on the same processor.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "physics/figure/figure.hpp"

namespace deixis::physics {

/// Of the pelvis, in the world's axes.
struct RootState {
    Pose pose{};
    Vec3 velocity_m_s{0.0};
    Vec3 angular_velocity_rad_s{0.0};
};

struct BodyState {
    RootState root;                  ///< of a pinned body the pose alone counts
    std::vector<double> angles_rad;  ///< one for each hinge
    std::vector<double> speeds_rad_s;
};

class Body {
  public:
    /// At rest, all angles 0, the pelvis where the avatar's hips are. `library` names MuJoCo's; empty: what
    /// the environment variable DEIXIS_MUJOCO names, else the one that the program was built with. Fails,
    /// with what to do, where MuJoCo is not there or another version, or the program was built without it.
    [[nodiscard]] static Result<Body> make(const Figure& figure, const std::string& library = {});
    /// A copy is a body of its own in the same state; copies share what does not change.
    Body(const Body& other);
    Body(Body&&) noexcept;
    Body& operator=(const Body&) = delete;
    Body& operator=(Body&&) noexcept;
    ~Body();

    [[nodiscard]] const Figure& figure() const;

    void setState(const BodyState& state);
    [[nodiscard]] BodyState state() const;
    /// Views of what is simulated; a step changes what they show.
    [[nodiscard]] std::span<const double> angles_rad() const;
    [[nodiscard]] std::span<const double> speeds_rad_s() const;
    [[nodiscard]] RootState root() const;
    /// Carries a pinned pelvis to another place, at once.
    void moveRoot(const Pose& root);

    /// So many steps of step_s (mjcf.hpp) with these targets, one for each hinge.
    void step(std::span<const double> targets_rad, int steps);

    /// The torques that hold the hinges against gravity and what their speeds cause.
    [[nodiscard]] std::vector<double> biasTorques_nm();
    /// Where each segment's joint is, as MuJoCo has it.
    [[nodiscard]] std::vector<Vec3> jointPositions_m();

  private:
    struct Simulation;
    explicit Body(std::unique_ptr<Simulation> simulation);
    std::unique_ptr<Simulation> simulation_;
};

/// The MuJoCo that the program was built for, such as "libmujoco.so.2.2.2"; empty: none.
[[nodiscard]] std::string mujocoLibraryName();

}  // namespace deixis::physics
