#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "assets/joints/joint_positions.hpp"
#include "core/csv_sheet.hpp"
#include "core/foreign_csv.hpp"
#include "core/order_statistics.hpp"
#include "core/text.hpp"
#include "number_lines.hpp"
#include "position_import.hpp"

namespace deixis::assets {

namespace {

constexpr double assumed_fps = 30.0;

bool joins(char c) {
    return c == '.' || c == '_' || c == ' ' || c == ':' || c == '-' || c == '/';
}

int axisOf(char c) {
    const auto found = std::string_view("xyzXYZ").find(c);
    return found == std::string_view::npos ? -1 : static_cast<int>(found % 3);
}

struct Coordinate {
    std::string joint;
    int axis;
};

/// "Hips.x", "Hips_X", "x.Hips"; none for anything else.
std::optional<Coordinate> coordinateOf(std::string_view title) {
    const std::size_t n = title.size();
    if (n >= 3 && axisOf(title[n - 1]) >= 0 && joins(title[n - 2]))
        return Coordinate{std::string(title.substr(0, n - 2)), axisOf(title[n - 1])};
    if (n >= 3 && axisOf(title[0]) >= 0 && joins(title[1]))
        return Coordinate{std::string(title.substr(2)), axisOf(title[0])};
    return std::nullopt;
}

struct Columns {
    std::optional<std::size_t> time{};
    double seconds_per_unit = 1.0;
    std::vector<std::string> joints{};                    // in the order in which they first come
    std::vector<std::array<std::size_t, 3>> of_joints{};  // the columns of x, y, z
    std::vector<std::string> passed_over{};
};

bool isTime(const std::string& title, Columns& columns) {
    const bool milliseconds =
        title == "time_ms" || title == "time (ms)" || title == "timestamp_ms" || title == "milliseconds";
    if (!milliseconds && title != "time" && title != "time_s" && title != "time (s)" &&
        title != "timestamp" && title != "seconds" && title != "t")
        return false;
    if (milliseconds) columns.seconds_per_unit = 1e-3;
    return true;
}

Result<Columns> findColumns(const CsvSheet& sheet) {
    constexpr std::size_t missing = static_cast<std::size_t>(-1);
    const std::string where = sheet.place(sheet.header);
    Columns columns;
    std::map<std::string, std::size_t> number_of;
    for (std::size_t c = 0; c < sheet.header.fields.size(); ++c) {
        const std::string& title = sheet.header.fields[c];
        if (!columns.time && isTime(lowerCase(title), columns)) {
            columns.time = c;
            continue;
        }
        const auto coordinate = coordinateOf(title);
        if (!coordinate) {
            if (lowerCase(title) != "frame") columns.passed_over.emplace_back(title);
            continue;
        }
        const auto [at, fresh] = number_of.emplace(coordinate->joint, columns.joints.size());
        if (fresh) {
            columns.joints.push_back(coordinate->joint);
            columns.of_joints.push_back({missing, missing, missing});
        }
        std::size_t& column = columns.of_joints[at->second][static_cast<std::size_t>(coordinate->axis)];
        if (column != missing) return fail(where, "found column '" + title + "' twice, expected it once");
        column = c;
    }
    if (columns.joints.empty())
        return fail(where, "found no columns of joints, expected NAME.x, NAME.y, NAME.z for each");
    for (std::size_t j = 0; j < columns.joints.size(); ++j)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (columns.of_joints[j][axis] == missing)
                return fail(where, "found no column " + columns.joints[j] + "." + "xyz"[axis] +
                                       ", expected x, y and z of every joint");
    return columns;
}

bool isUnknown(std::string_view field) {
    const std::string word = lowerCase(field);
    return word.empty() || word == "nan" || word == "na";
}

/// What the bones' joints did, and when lines were recorded.
struct JointRecording {
    std::array<JointTrack, motion::bone_count> tracks{};
    std::vector<double> times_s{};
};

class JointCsvReader {
  public:
    JointCsvReader(std::string_view text, const std::string& name, const ImportOptions& options)
        : reader_(text, name, formOfNumbers(text)), name_(name), options_(options) {}

    Result<PositionRecording> read() {
        auto sheet = readCsvHeader(reader_, name_);
        if (!sheet) return tl::unexpected(sheet.error());
        sheet_ = std::move(*sheet);
        if (sheet_.header.fields.empty())
            return fail(name_, "found no lines, expected a header with the joints' names");
        auto columns = findColumns(sheet_);
        if (!columns) return tl::unexpected(columns.error());
        columns_ = std::move(*columns);
        bones_ = bonesByName(columns_.joints);
        if (std::all_of(bones_.joint.begin(), bones_.joint.end(), [](int joint) { return joint < 0; }))
            return fail(sheet_.place(sheet_.header),
                        "found no joint with the name of a human bone among '" + columns_.joints.front() +
                            "' and the others",
                        "Name the joints as VRM, Mixamo or Kinect do, such as hips, leftUpperArm");
        if (auto rows = readRows(); !rows) return tl::unexpected(rows.error());
        return sampled();
    }

  private:
    Result<void> readRows() {
        CsvRecord row;
        const bool timed = columns_.time && !options_.fps;
        for (;;) {
            const auto more = reader_.next(row);
            if (!more) return tl::unexpected(more.error());
            if (!*more) break;
            if (auto width = sheet_.checkWidth(row); !width) return width;
            double time_s =
                static_cast<double>(recording_.times_s.size()) / options_.fps.value_or(assumed_fps);
            if (timed) {
                const std::string& field = row.fields[*columns_.time];
                const auto time = finiteNumber(field);
                if (!time)
                    return fail(sheet_.place(row, *columns_.time),
                                "found '" + field.substr(0, 40) + "', expected a number");
                time_s = *time * columns_.seconds_per_unit;
                if (!recording_.times_s.empty() && time_s <= recording_.times_s.back())
                    return fail(sheet_.place(row, *columns_.time),
                                "found a time that is not after the one before, expected increasing times");
            }
            recording_.times_s.push_back(time_s);
            for (std::size_t b = 0; b < motion::bone_count; ++b) {
                if (bones_.joint[b] < 0) continue;
                if (auto read = readPosition(row, b, time_s); !read) return read;
            }
        }
        if (recording_.times_s.empty()) return fail(name_, "found no frames under the header");
        return {};
    }

    Result<void> readPosition(const CsvRecord& row, std::size_t bone, double time_s) {
        const auto& columns = columns_.of_joints[static_cast<std::size_t>(bones_.joint[bone])];
        Vec3 position(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            const std::size_t column = columns[static_cast<std::size_t>(axis)];
            const std::string& field = row.fields[column];
            if (isUnknown(field)) {
                unknown_ = true;
                return {};
            }
            const auto value = finiteNumber(field);
            if (!value)
                return fail(sheet_.place(row, column),
                            "found '" + field.substr(0, 40) + "', expected a finite number or nothing",
                            hintOfNumber(field));
            position[axis] = *value;
        }
        recording_.tracks[bone].time_s.push_back(time_s);
        recording_.tracks[bone].position.push_back(position);
        return {};
    }

    /// Steps of time between lines: their median, and whether all are near it.
    struct Steps {
        double middle_s;
        bool steady;
    };
    [[nodiscard]] Steps steps() const {
        std::vector<double> steps;
        for (std::size_t i = 1; i < recording_.times_s.size(); ++i)
            steps.push_back(recording_.times_s[i] - recording_.times_s[i - 1]);
        const double median = orderStatistic(steps, (steps.size() - 1) / 2);
        constexpr double tolerance = 0.02;
        constexpr double rounding_s = 1.1e-3;  // times in whole milliseconds
        const bool steady = std::all_of(steps.begin(), steps.end(), [&](double step) {
            return std::abs(step - median) <=
                   std::max(tolerance * median, std::min(rounding_s, 0.1 * median));
        });
        return {median, steady};
    }

    Result<PositionRecording> sampled() {
        PositionRecording out;
        out.format = "CSV of joint positions";
        const auto& times = recording_.times_s;
        double step_s = 1.0 / options_.fps.value_or(assumed_fps);
        std::size_t count = times.size();
        bool evenly = true;
        out.rate =
            options_.fps ? FoundRate{*options_.fps, Origin::given} : FoundRate{assumed_fps, Origin::assumed};
        if (columns_.time && !options_.fps && times.size() > 1) {
            const Steps found = steps();
            step_s = found.steady ? (times.back() - times.front()) / static_cast<double>(times.size() - 1)
                                  : found.middle_s;
            if (auto good = checkStep(step_s, name_,
                                      "A column of milliseconds is called time_ms; or give the rate with "
                                      "--fps");
                !good)
                return tl::unexpected(good.error());
            out.rate = {tidyRate(1.0 / step_s), Origin::declared};
            evenly = found.steady;
            if (!evenly) {
                const auto frames = framesOver(times, step_s, name_, out.remarks);
                if (!frames) return tl::unexpected(frames.error());
                count = *frames;
                out.remarks.emplace_back("times are not evenly spaced: resampled at their median step");
            }
        }
        out.frames.resize(count);
        for (std::size_t f = 0; f < count; ++f) {
            for (std::size_t b = 0; b < motion::bone_count; ++b)
                if (const JointTrack& track = recording_.tracks[b]; !track.empty())
                    out.frames[f].at[b] =
                        track.at(evenly ? times[f] : times.front() + static_cast<double>(f) * step_s);
            standInForTrunk(out.frames[f]);
        }
        if (unknown_) out.remarks.emplace_back("missing positions are interpolated linearly");
        remarkOnColumns(out.remarks);
        return out;
    }

    /// Times have few digits: 30.0003 fps are 30.
    static double tidyRate(double fps) {
        constexpr double tolerance = 5e-4;
        const double whole = std::round(fps);
        return std::abs(fps - whole) < tolerance * fps && whole > 0.0 ? whole : fps;
    }

    void remarkOnColumns(std::vector<std::string>& remarks) const {
        if (!columns_.passed_over.empty())
            remarks.push_back("columns that are not coordinates are ignored: '" +
                              columns_.passed_over.front() + "'" +
                              (columns_.passed_over.size() > 1
                                   ? " and " + std::to_string(columns_.passed_over.size() - 1) + " more"
                                   : ""));
    }

    CsvReader reader_;
    CsvSheet sheet_{};
    const std::string& name_;
    const ImportOptions& options_;
    Columns columns_;
    motion::HumanoidMap bones_;
    JointRecording recording_;
    bool unknown_ = false;
};

}  // namespace

Result<ImportedClip> parseJointCsv(std::string_view text, const std::string& name,
                                   const ImportOptions& options) {
    const auto csv = readForeignCsv(std::string(text), name);
    if (!csv) return tl::unexpected(csv.error());
    auto recording = JointCsvReader(csv->text, name, options).read();
    if (!recording) return tl::unexpected(recording.error());
    return clipOfPositions(std::move(*recording), name, options);
}

}  // namespace deixis::assets
