// Feet that stand are kept in their place and out of the floor; private to retargeting.
#pragma once

#include <vector>

#include "assembly.hpp"

namespace deixis::motion {

/// When one point of a sole stands on the floor, for each frame. It comes to stand when it is lower than 60
/// mm and slower than 0.3 m/s, and leaves when it is higher than 90 mm or faster than 0.5 m/s (hysteresis);
/// the speed is that over 50 ms. Gaps shorter than 60 ms are closed, and contacts shorter than 100 ms passed
/// over.
[[nodiscard]] std::vector<char> floorContacts(const std::vector<Vec3>& point, double frame_time_s);

/// Plants the feet of a motion that stands on the floor. While the heel or the ball of a foot
/// stands it stays in its place: the ball where both do, and the foot is then level. Between two stands the
/// foot's shift changes smoothly, and it fades out within 0.3 s where no other stand is near. A stand that
/// slides by more than 0.12 m is cut in two. Legs follow by bending at hip and knee; where a foot that stands
/// is out of reach, the hips come down, smoothed over 0.1 s. No point of a sole stays under the floor; toes
/// bend up instead. Of the report all is filled in but lowest_before_m.
[[nodiscard]] PlantedFeet plantFeet(const AvatarRest& avatar, std::vector<BodyFrame>& frames,
                                    double frame_time_s);

}  // namespace deixis::motion
