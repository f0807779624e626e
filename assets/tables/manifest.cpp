#include "assets/tables/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <type_traits>
#include <utility>

#include "assets/tables/target_list.hpp"
#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "core/number.hpp"

namespace deixis::assets {

namespace {

enum Column {
    clip,
    system,
    target_id,
    target_x,
    target_y,
    target_z,
    hand,
    onset,
    peak,
    hold,
    end,
    fps,
    seed,
    source_error_deg,
    avatar_error_deg,
    author,
    trial,
    target_frame,
    processing,
    sound
};
constexpr std::array<std::string_view, 20> manifest_columns{"clip",
                                                            "system",
                                                            "target_id",
                                                            "target_x",
                                                            "target_y",
                                                            "target_z",
                                                            "hand",
                                                            "onset",
                                                            "peak",
                                                            "hold",
                                                            "end",
                                                            "fps",
                                                            "seed",
                                                            "source_error_deg",
                                                            "avatar_error_deg",
                                                            "author",
                                                            "trial",
                                                            "target_frame",
                                                            "processing",
                                                            "sound"};
constexpr std::size_t required_columns = 13;  // the first ones
constexpr std::size_t absent = ~std::size_t{0};

std::string header() {
    return fmt::format("{}",
                       fmt::join(manifest_columns.begin(), manifest_columns.begin() + required_columns, ","));
}

/// Where each column stands in the file.
using Places = std::array<std::size_t, manifest_columns.size()>;

/// One record by column name; notes the first problem.
class RowReader {
  public:
    RowReader(const CsvSheet& sheet, const CsvRecord& record, const Places& places)
        : sheet_(sheet), record_(record), places_(places) {}

    std::string text(Column column) {
        const std::string& found = record_.fields[places_[column]];
        if (found.empty()) problem(column, "is empty", "Give it a value");
        return found;
    }

    template <typename Number>
    Number number(Column column, std::string_view expected) {
        const std::string& found = record_.fields[places_[column]];
        if constexpr (std::is_floating_point_v<Number>) {
            if (const auto value = finiteNumber(found)) return *value;
        } else if constexpr (std::is_unsigned_v<Number>) {
            if (const auto value = naturalNumber(found)) return *value;
        } else if (const auto value = wholeNumber(found); value && std::in_range<Number>(*value)) {
            return static_cast<Number>(*value);
        }
        problem(column, fmt::format("found '{}', expected {}", found, expected));
        return {};
    }

    double coordinate(Column column) {
        const auto value = number<double>(column, "a finite number of metres");
        if (std::abs(value) > farthest_target_m)
            problem(column, fmt::format("found {}, expected at most {} metres", value, farthest_target_m));
        return value;
    }

    /// Whether any of the columns, which belong together, has a value.
    [[nodiscard]] bool any(std::initializer_list<Column> columns) const {
        return std::any_of(columns.begin(), columns.end(),
                           [this](Column column) { return !record_.fields[places_[column]].empty(); });
    }

    void problem(Column column, const std::string& message, std::string hint = {}) {
        if (!first_) first_ = Error{sheet_.place(record_, places_[column]), message, std::move(hint)};
    }

    /// Whether an optional column is there and has a value.
    [[nodiscard]] bool has(Column column) const { return places_[column] != absent && any({column}); }

    /// Degrees from 0 to 180; none where there is no such column, or the field is empty.
    std::optional<double> angle(Column column) {
        if (!has(column)) return std::nullopt;
        constexpr std::string_view expected = "degrees from 0 to 180";
        const auto value = number<double>(column, expected);
        if (value < 0.0 || value > 180.0)
            problem(column, fmt::format("found {}, expected {}", value, expected));
        return value;
    }

    [[nodiscard]] const std::optional<Error>& first() const { return first_; }

  private:
    const CsvSheet& sheet_;
    const CsvRecord& record_;
    const Places& places_;
    std::optional<Error> first_;
};

motion::GesturePhases readPhases(RowReader& reader) {
    motion::GesturePhases phases;
    const std::string side = reader.text(hand);
    if (side != "left" && side != "right")
        reader.problem(hand, fmt::format("found '{}', expected left or right", side));
    phases.hand = side == "left" ? motion::Side::left : motion::Side::right;
    constexpr std::string_view frame = "a whole number of frames";
    phases.onset_frame = reader.number<int>(onset, frame);
    phases.peak_frame = reader.number<int>(peak, frame);
    phases.hold_frame = reader.number<int>(hold, frame);
    phases.end_frame = reader.number<int>(end, frame);
    if (phases.onset_frame < 0)
        reader.problem(onset, fmt::format("found {}, expected 0 or more", phases.onset_frame));
    if (phases.peak_frame <= phases.onset_frame)
        reader.problem(peak, fmt::format("found {}, expected a frame after the onset ({})", phases.peak_frame,
                                         phases.onset_frame));
    if (phases.hold_frame < phases.peak_frame)
        reader.problem(hold, fmt::format("found {}, expected the peak ({}) or later", phases.hold_frame,
                                         phases.peak_frame));
    if (phases.end_frame <= phases.hold_frame)
        reader.problem(end, fmt::format("found {}, expected a frame after the hold ({})", phases.end_frame,
                                        phases.hold_frame));
    return phases;
}

Result<ManifestRow> readRow(RowReader reader) {
    ManifestRow row;
    row.clip = reader.text(clip);
    row.system = reader.text(system);
    row.target_id = reader.text(target_id);
    if (reader.any({target_x, target_y, target_z})) {
        row.target = Vec3(reader.coordinate(target_x), 0.0, 0.0);
        row.target->y = reader.coordinate(target_y);
        row.target->z = reader.coordinate(target_z);
    }
    if (reader.any({hand, onset, peak, hold, end})) row.phases = readPhases(reader);
    row.fps = reader.number<double>(fps, "frames per second, more than 0");
    if (row.fps <= 0.0) reader.problem(fps, fmt::format("found {}, expected more than 0", row.fps));
    row.seed = reader.number<std::uint64_t>(seed, "a whole number from 0 to 18446744073709551615");
    row.source_error_deg = reader.angle(source_error_deg);
    row.avatar_error_deg = reader.angle(avatar_error_deg);
    if (reader.has(author)) row.author = reader.text(author);
    if (reader.has(trial)) {
        row.trial = reader.number<int>(trial, "a whole number from 1");
        if (*row.trial < 1) reader.problem(trial, fmt::format("found {}, expected 1 or more", *row.trial));
    }
    if (reader.has(target_frame)) {
        const std::string found = reader.text(target_frame);
        if (found != "clip" && found != "figure")
            reader.problem(target_frame, fmt::format("found '{}', expected clip or figure", found));
        row.target_frame = found == "figure" ? TargetFrame::figure : TargetFrame::clip;
    }
    if (reader.has(processing)) row.processing = reader.text(processing);
    if (reader.has(sound)) row.sound = reader.text(sound);
    if (reader.first()) return tl::unexpected(*reader.first());
    return row;
}

Result<Places> findColumns(const CsvSheet& sheet) {
    Places places{};
    places.fill(absent);
    for (std::size_t i = 0; i < manifest_columns.size(); ++i) {
        if (i >= required_columns && !sheet.find(manifest_columns[i])) continue;
        const auto place = sheet.column(manifest_columns[i], fmt::format("The columns are {}", header()));
        if (!place) return tl::unexpected(place.error());
        places[i] = *place;
    }
    return places;
}

tl::expected<Manifest, std::vector<Error>> checkManifestText(std::string_view text,
                                                             const std::filesystem::path& name) {
    const std::string file = name.string();
    const auto one = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
    CsvReader reader(text, file);
    const auto sheet = readCsvHeader(reader, file);
    if (!sheet) return one(sheet.error());
    if (sheet->header.fields.empty())
        return one({file, "the manifest is empty", fmt::format("Its first line is {}", header())});
    const auto places = findColumns(*sheet);
    if (!places) return one(places.error());
    Manifest manifest;
    manifest.file = name;
    std::vector<Error> problems;
    CsvRecord record;
    for (;;) {
        const auto more = reader.next(record);
        if (!more) return one(more.error());
        if (!*more) break;
        if (const auto width = sheet->checkWidth(record); !width) {
            problems.push_back(width.error());
            continue;
        }
        auto row = readRow(RowReader(*sheet, record, *places));
        if (!row) {
            problems.push_back(row.error());
            continue;
        }
        row->line = static_cast<std::size_t>(record.line);
        manifest.rows.push_back(std::move(*row));
    }
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    return manifest;
}

}  // namespace

tl::expected<Manifest, std::vector<Error>> checkManifest(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(std::vector<Error>{text.error()});
    return checkManifestText(*text, path);
}

Result<Manifest> parseManifest(std::string_view text, const std::filesystem::path& name) {
    auto manifest = checkManifestText(text, name);
    if (!manifest) return tl::unexpected(std::move(manifest.error().front()));
    return std::move(*manifest);
}

Result<Manifest> readManifest(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseManifest(*text, path);
}

std::string manifestCsv(const std::vector<ManifestRow>& rows) {
    const auto any = [&](const auto& has) { return std::any_of(rows.begin(), rows.end(), has); };
    const bool errors = any([](const auto& row) { return row.source_error_deg || row.avatar_error_deg; });
    const bool authors = any([](const auto& row) { return !row.author.empty(); });
    const bool trials = any([](const auto& row) { return row.trial.has_value(); });
    const bool frames = any([](const auto& row) { return row.target_frame == TargetFrame::figure; });
    const bool processed = any([](const auto& row) { return !row.processing.empty(); });
    const bool sounds = any([](const auto& row) { return !row.sound.empty(); });
    std::string out = header();
    if (errors) out += ",source_error_deg,avatar_error_deg";
    if (authors) out += ",author";
    if (trials) out += ",trial";
    if (frames) out += ",target_frame";
    if (processed) out += ",processing";
    if (sounds) out += ",sound";
    out += "\n";
    for (const ManifestRow& row : rows) {
        out += fmt::format("{},{},{},", csvField(row.clip), csvField(row.system), csvField(row.target_id));
        out += row.target ? fmt::format("{},{},{},", row.target->x, row.target->y, row.target->z) : ",,,";
        if (const auto& p = row.phases)
            out += fmt::format("{},{},{},{},{},", motion::sideName(p->hand), p->onset_frame, p->peak_frame,
                               p->hold_frame, p->end_frame);
        else
            out += ",,,,,";
        out += fmt::format("{},{}", row.fps, row.seed);
        if (errors)
            for (const auto& error : {row.source_error_deg, row.avatar_error_deg})
                out += error ? fmt::format(",{}", *error) : ",";
        if (authors) out += "," + csvField(row.author);
        if (trials) out += row.trial ? fmt::format(",{}", *row.trial) : ",";
        if (frames) out += row.target_frame == TargetFrame::figure ? ",figure" : ",clip";
        if (processed) out += "," + csvField(row.processing);
        if (sounds) out += "," + csvField(row.sound);
        out += "\n";
    }
    return out;
}

}  // namespace deixis::assets
