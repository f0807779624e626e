#include "app/study/recorded_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/number.hpp"

namespace deixis::app {

namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

class MarkerReader {
  public:
    MarkerReader(const std::vector<CsvRecord>& records, const std::string& name)
        : records_(records), header_(records.front().fields), name_(name) {}

    [[nodiscard]] bool has(std::string_view column) const {
        return std::find(header_.begin(), header_.end(), column) != header_.end();
    }

    Result<MarkerTrack> read(double frame_time_s, double metres_per_unit) const {
        const std::string_view clock = has("time") ? "time" : "frame";
        for (const std::string_view column : axes)
            if (!has(column))
                return fail(fmt::format("{}:{}", name_, records_.front().line),
                            fmt::format("the column '{}' is missing from the header", column),
                            fmt::format("The columns are {},x,y,z; others are passed over", clock));
        MarkerTrack track;
        for (std::size_t r = 1; r < records_.size(); ++r) {
            const CsvRecord& record = records_[r];
            if (record.fields.size() != header_.size())
                return fail(fmt::format("{}:{}", name_, record.line),
                            fmt::format("found {} fields, expected {} as in the header", record.fields.size(),
                                        header_.size()));
            const auto time = number(record, clock);
            if (!time) return tl::unexpected(time.error());
            if (std::all_of(axes.begin(), axes.end(),
                            [&](std::string_view axis) { return cell(record, axis).empty(); }))
                continue;
            MarkerTrack::Sample sample{*time * (clock == "frame" ? frame_time_s : 1.0), {}};
            for (int axis = 0; axis < 3; ++axis) {
                const auto value = number(record, axes[static_cast<std::size_t>(axis)]);
                if (!value) return tl::unexpected(value.error());
                sample.position[axis] = *value * metres_per_unit;
            }
            track.samples.push_back(sample);
        }
        if (track.samples.empty())
            return fail(name_, "holds no position of the marker",
                        fmt::format("Expected a line {},x,y,z for each moment in which it is seen", clock));
        std::stable_sort(track.samples.begin(), track.samples.end(),
                         [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
        return track;
    }

  private:
    [[nodiscard]] const std::string& cell(const CsvRecord& record, std::string_view column) const {
        const auto at = std::find(header_.begin(), header_.end(), column) - header_.begin();
        return record.fields[static_cast<std::size_t>(at)];
    }

    [[nodiscard]] Result<double> number(const CsvRecord& record, std::string_view column) const {
        const std::string& text = cell(record, column);
        if (const auto value = finiteNumber(text)) return *value;
        return fail(fmt::format("{}:{}: {}", name_, record.line, column),
                    fmt::format("found '{}', expected a finite number", text));
    }

    const std::vector<CsvRecord>& records_;
    const std::vector<std::string>& header_;
    const std::string& name_;
};

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

}  // namespace

std::optional<Vec3> MarkerTrack::median(double from_s, double to_s) const {
    std::array<std::vector<double>, 3> seen;
    for (const Sample& sample : samples)
        if (sample.time_s >= from_s && sample.time_s <= to_s)
            for (int axis = 0; axis < 3; ++axis)
                seen[static_cast<std::size_t>(axis)].push_back(sample.position[axis]);
    if (seen[0].empty()) return std::nullopt;
    return Vec3(medianOf(seen[0]), medianOf(seen[1]), medianOf(seen[2]));
}

Result<RecordedTargets> parseRecordedTargets(std::string_view text, const std::string& name,
                                             double frame_time_s, double metres_per_unit) {
    const auto records = parseCsv(text, name);
    if (!records) return tl::unexpected(records.error());
    if (!records->empty()) {
        const MarkerReader reader(*records, name);
        if (reader.has("time") || reader.has("frame")) {
            auto track = reader.read(frame_time_s, metres_per_unit);
            if (!track) return tl::unexpected(track.error());
            return RecordedTargets(std::move(*track));
        }
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
