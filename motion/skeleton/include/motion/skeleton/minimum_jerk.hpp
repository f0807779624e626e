// The time course of a human reach (Flash & Hogan 1985).
#pragma once

namespace deixis::motion {

/// Share of the way done at share `u` of the time: 10u^3 - 15u^4 + 6u^5, u clamped to [0, 1]. Its speed peaks
/// at 1.875 ways per time, in the middle.
[[nodiscard]] double minimumJerk(double u);

/// Where the way is left, or reached, with a speed: by so many times that speed and the whole time more is
/// done at share `u`, so that all of it, way x minimumJerk(u) + time x (speed at the start x
/// minimumJerkLeaving(u) + speed at the end x minimumJerkArriving(u)), is the polynomial of fifth degree
/// without acceleration at both ends. `u` is in [0, 1].
[[nodiscard]] double minimumJerkLeaving(double u);
[[nodiscard]] double minimumJerkArriving(double u);

/// minimumJerk() with time warped: minimumJerk(u^exponent); an exponent below 1 puts the peak speed earlier.
[[nodiscard]] double warpedMinimumJerk(double u, double exponent);

}  // namespace deixis::motion
