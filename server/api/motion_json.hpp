// Motion of the upper body as the routes take and answer it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/upper_body/upper_body.hpp"
#include "server/http/json_shape.hpp"

namespace deixis::server {

/// Frames of half an hour, the longest sound.
inline constexpr std::size_t max_motion_frames = 30 * 60 * 15;

/// Of a request with a motion, or several.
inline constexpr std::size_t largest_motion_bytes = std::size_t{32} << 20U;

/// 27 numbers each: x y z of nine directions.
[[nodiscard]] Shape framesShape();
/// Rounded to 6 decimals.
[[nodiscard]] nlohmann::json framesJson(const motion::UpperBodyMotion& motion);
/// Of what framesShape() passes. The error names the frame in `field`: a direction that is none.
[[nodiscard]] Result<motion::UpperBodyMotion> motionFromJson(const nlohmann::json& frames,
                                                             const std::string& field);

/// How the avatar's bones turn: for whoever draws it.
[[nodiscard]] Shape tracksShape();
/// The bones that are turned in any frame; rounded to 6 decimals. Of a clip on referenceHumanoid().
[[nodiscard]] nlohmann::json tracksJson(const motion::Clip& clip);

[[nodiscard]] double rounded(double value, double steps);

}  // namespace deixis::server
