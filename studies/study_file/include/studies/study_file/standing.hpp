// Where participant and avatars stand in a layout.
#pragma once

#include <array>
#include <string_view>

#include "core/pose.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// Whose place in a layout: in a headset one stands there; a flat screen may need a step back, to show all.
enum class Standing : unsigned char { headset, desktop };
[[nodiscard]] std::string_view standingName(Standing standing);  ///< "headset", "desktop"

[[nodiscard]] ViewerPlace viewerPlace(const Layout& layout, Standing standing);

/// The participant's place on the floor; -z is forward. Of a layout: in a headset.
[[nodiscard]] Pose viewerPose(const ViewerPlace& place);
[[nodiscard]] Pose viewerPose(const Layout& layout);

/// The study as participants meet it: its layouts have one place each. Simulated participants stand as at a
/// desktop: their picture, where one is drawn, is flat.
[[nodiscard]] Study standingAs(Study study, Standing standing);

/// Places of a pair of avatars, left and right as the participant sees them.
[[nodiscard]] std::array<Vec3, 2> pairPlaces(const Pose& stage_from_viewer);

}  // namespace deixis::studies
