#include "assets/tables/ball_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "assets/tables/target_list.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/number.hpp"

namespace deixis::assets {

namespace {

/// A distractor's three columns.
struct DistractorColumns {
    std::string band;
    std::string name;
    std::array<std::size_t, 3> axes{};
};

/// "near_d1_x" is the distractor d1 of the distance "near"; none: another column.
std::optional<DistractorColumns> distractorOf(std::string_view column) {
    if (!column.ends_with("_x")) return std::nullopt;
    column.remove_suffix(2);
    const auto digits = column.find_last_not_of("0123456789");
    if (digits == std::string_view::npos || digits + 1 == column.size() || column[digits] != 'd')
        return std::nullopt;
    if (digits > 0 && column[digits - 1] != '_') return std::nullopt;
    return DistractorColumns{
        std::string(column.substr(0, digits > 0 ? digits - 1 : 0)), std::string(column.substr(digits)), {}};
}

Result<std::vector<DistractorColumns>> distractorColumns(const CsvRecord& header, const std::string& name) {
    const auto& fields = header.fields;
    std::vector<DistractorColumns> out;
    for (std::size_t c = 0; c < fields.size(); ++c) {
        auto found = distractorOf(fields[c]);
        if (!found) continue;
        found->axes[0] = c;
        for (std::size_t axis = 1; axis < 3; ++axis) {
            std::string wanted = fields[c];
            wanted.back() = "xyz"[axis];
            const auto at = std::find(fields.begin(), fields.end(), wanted);
            if (at == fields.end())
                return fail(fmt::format("{}:{}", name, header.line),
                            fmt::format("the column '{}' is missing beside '{}'", wanted, fields[c]));
            found->axes[axis] = static_cast<std::size_t>(at - fields.begin());
        }
        out.push_back(std::move(*found));
    }
    if (out.empty())
        return fail(fmt::format("{}:{}", name, header.line), "no distractors: found no column such as d1_x",
                    "Print one with 'deixis targets STUDY'");
    return out;
}

/// None where all three cells are empty.
Result<std::optional<Vec3>> positionIn(const CsvRecord& record, const CsvRecord& header,
                                       const std::array<std::size_t, 3>& axes, const std::string& where) {
    if (std::all_of(axes.begin(), axes.end(), [&](std::size_t c) { return record.fields[c].empty(); }))
        return std::optional<Vec3>();
    Vec3 out(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::string& cell = record.fields[axes[axis]];
        const auto value = finiteNumber(cell);
        if (!value)
            return fail(fmt::format("{}: {}", where, header.fields[axes[axis]]),
                        fmt::format("found '{}', expected a finite number of metres", cell));
        out[static_cast<int>(axis)] = *value;
    }
    return std::optional<Vec3>(out);
}

}  // namespace

Result<BallList> parseBallList(std::string_view text, const std::string& name) {
    const auto targets = parseTargetList(text, name);
    if (!targets) return tl::unexpected(targets.error());
    const auto records = parseCsv(text, name);
    if (!records) return tl::unexpected(records.error());
    const CsvRecord& header = records->front();
    const auto columns = distractorColumns(header, name);
    if (!columns) return tl::unexpected(columns.error());
    BallList out;
    for (std::size_t r = 1; r < records->size(); ++r) {
        const CsvRecord& record = (*records)[r];
        const ListedTarget& target = (*targets)[r - 1];
        std::vector<BallSet>& sets = out[target.id];
        for (const DistractorColumns& distractor : *columns) {
            auto set = std::find_if(sets.begin(), sets.end(),
                                    [&](const BallSet& s) { return s.band == distractor.band; });
            if (set == sets.end()) set = sets.insert(set, {distractor.band, {target.position}, {"target"}});
            const auto at =
                positionIn(record, header, distractor.axes, fmt::format("{}:{}", name, record.line));
            if (!at) return tl::unexpected(at.error());
            if (!*at) continue;
            set->balls.push_back(**at);
            set->names.push_back(distractor.name);
        }
    }
    return out;
}

Result<BallList> readBallList(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseBallList(*text, path.string());
}

}  // namespace deixis::assets
