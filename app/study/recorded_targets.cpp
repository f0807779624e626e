#include "app/study/recorded_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "core/order_statistics.hpp"

namespace deixis::app {

namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

Result<MarkerTrack> readMarker(const CsvSheet& sheet, double frame_time_s, double metres_per_unit) {
    const bool timed = sheet.find("time").has_value();
    const std::string_view clock = timed ? "time" : "frame";
    std::array<std::size_t, 3> places{};
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto place =
            sheet.column(axes[i], fmt::format("The columns are {},x,y,z; others are ignored", clock));
        if (!place) return tl::unexpected(place.error());
        places[i] = *place;
    }
    MarkerTrack track;
    for (const CsvRecord& row : sheet.rows) {
        const auto time = sheet.number(row, *sheet.find(clock));
        if (!time) return tl::unexpected(time.error());
        if (std::all_of(places.begin(), places.end(),
                        [&](std::size_t place) { return row.fields[place].empty(); }))
            continue;
        MarkerTrack::Sample sample{*time * (timed ? 1.0 : frame_time_s), {}};
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = sheet.number(row, places[static_cast<std::size_t>(axis)]);
            if (!value) return tl::unexpected(value.error());
            sample.position[axis] = *value * metres_per_unit;
        }
        track.samples.push_back(sample);
    }
    if (track.samples.empty())
        return fail(sheet.name, "has no position of the marker",
                    fmt::format("Expected a line {},x,y,z for each moment in which it is visible", clock));
    std::stable_sort(track.samples.begin(), track.samples.end(),
                     [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
    return track;
}

}  // namespace

std::optional<Vec3> MarkerTrack::median(double from_s, double to_s) const {
    std::array<std::vector<double>, 3> seen;
    for (const Sample& sample : samples)
        if (sample.time_s >= from_s && sample.time_s <= to_s)
            for (int axis = 0; axis < 3; ++axis)
                seen[static_cast<std::size_t>(axis)].push_back(sample.position[axis]);
    if (seen[0].empty()) return std::nullopt;
    return Vec3(deixis::median(seen[0]), deixis::median(seen[1]), deixis::median(seen[2]));
}

Result<RecordedTargets> parseRecordedTargets(std::string_view text, const std::string& name,
                                             double frame_time_s, double metres_per_unit) {
    const auto sheet = parseCsvSheet(text, name);
    if (!sheet) return tl::unexpected(sheet.error());
    if (sheet->find("time") || sheet->find("frame")) {
        auto track = readMarker(*sheet, frame_time_s, metres_per_unit);
        if (!track) return tl::unexpected(track.error());
        return RecordedTargets(std::move(*track));
    }
    auto list = assets::parseTargetList(text, name);
    if (!list) return tl::unexpected(list.error());
    return RecordedTargets(std::move(*list));
}

Result<RecordedTargets> readRecordedTargets(const std::filesystem::path& path, double frame_time_s,
                                            double metres_per_unit) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseRecordedTargets(*text, path.string(), frame_time_s, metres_per_unit);
}

}  // namespace deixis::app
