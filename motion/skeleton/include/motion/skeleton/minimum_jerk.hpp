// The time course of a human reach (Flash & Hogan 1985).
#pragma once

namespace deixis::motion {

/// Share of the way done at share `u` of the time: 10u^3 - 15u^4 + 6u^5, u clamped to [0, 1]. Its speed peaks
/// at 1.875 ways per time, in the middle.
[[nodiscard]] double minimumJerk(double u);

/// The same with time warped: minimumJerk(u^exponent); an exponent below 1 puts the peak speed earlier.
[[nodiscard]] double warpedMinimumJerk(double u, double exponent);

}  // namespace deixis::motion
