// Tracked frames packed into blocks: the content of tracking_blocks.data.
//
// A block has up to 64 frames of one trial. Times are stored to the microsecond, positions to 2^-16 m (15
// micrometres), rotations to 2^-15 of a quaternion's component (0.004 degrees); each column is written as
// differences from the frame before, and the whole is deflated (zlib). docs/database.md describes the
// bytes and has a short reader.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "studies/station/station.hpp"

namespace deixis::results {

inline constexpr std::size_t max_frames_in_block = 64;

/// Packs consecutive samples (frame numbers may have gaps). Hand joints are left out: they are kept apart.
[[nodiscard]] std::string packTracking(std::span<const studies::TrackingSample> samples);
/// Fails on bytes that packTracking() did not make.
[[nodiscard]] Result<std::vector<studies::TrackingSample>> unpackTracking(std::string_view data);

}  // namespace deixis::results
