// The targets of a recording: a list in the order of the gestures, or a marker's trajectory.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "assets/tables/target_list.hpp"
#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::app {

/// A marker on the target, in the recording's axes. Where it was hidden it has no sample.
struct MarkerTrack {
    struct Sample {
        double time_s;
        Vec3 position;  ///< metres
    };
    std::vector<Sample> samples;  ///< in order of time

    /// The median, axis by axis, of what was seen from one time to another; none if nothing was.
    [[nodiscard]] std::optional<Vec3> median(double from_s, double to_s) const;
};

/// The list's positions are in the avatar's axes, the marker's in the recording's.
using RecordedTargets = std::variant<std::vector<assets::ListedTarget>, MarkerTrack>;

/// CSV with a header: `target_id,x,y,z` is a list, one line for each gesture in order; `frame,x,y,z` (from 0)
/// or `time,x,y,z` (seconds) a marker's way, in which empty x, y and z mean that it was hidden. Other columns
/// are skipped. A marker's coordinates are taken times `metres_per_unit`. Errors name file, line and
/// column.
[[nodiscard]] Result<RecordedTargets> readRecordedTargets(const std::filesystem::path& path,
                                                          double frame_time_s, double metres_per_unit);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<RecordedTargets> parseRecordedTargets(std::string_view text, const std::string& name,
                                                           double frame_time_s, double metres_per_unit);

}  // namespace deixis::app
