#include "assets/tables/ball_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "assets/tables/target_list.hpp"
#include "core/csv_sheet.hpp"
#include "core/files.hpp"

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

Result<std::vector<DistractorColumns>> distractorColumns(const CsvSheet& sheet) {
    const auto& fields = sheet.header.fields;
    std::vector<DistractorColumns> out;
    for (std::size_t c = 0; c < fields.size(); ++c) {
        auto found = distractorOf(fields[c]);
        if (!found) continue;
        found->axes[0] = c;
        for (std::size_t axis = 1; axis < 3; ++axis) {
            std::string wanted = fields[c];
            wanted.back() = "xyz"[axis];
            const auto at = sheet.find(wanted);
            if (!at)
                return fail(fmt::format("{}:{}", sheet.name, sheet.header.line),
                            fmt::format("the column '{}' is missing, but '{}' is there", wanted, fields[c]));
            found->axes[axis] = *at;
        }
        out.push_back(std::move(*found));
    }
    if (out.empty())
        return fail(fmt::format("{}:{}", sheet.name, sheet.header.line),
                    "no distractors: found no column such as d1_x", "Print one with 'deixis targets STUDY'");
    return out;
}

/// None where all three cells are empty.
Result<std::optional<Vec3>> positionIn(const CsvSheet& sheet, const CsvRecord& row,
                                       const std::array<std::size_t, 3>& axes) {
    if (std::all_of(axes.begin(), axes.end(), [&](std::size_t c) { return row.fields[c].empty(); }))
        return std::optional<Vec3>();
    Vec3 out(0.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto value = sheet.number(row, axes[axis], "a finite number of metres");
        if (!value) return tl::unexpected(value.error());
        out[static_cast<int>(axis)] = *value;
    }
    return std::optional<Vec3>(out);
}

}  // namespace

Result<BallList> parseBallList(std::string_view text, const std::string& name) {
    const auto targets = parseTargetList(text, name);
    if (!targets) return tl::unexpected(targets.error());
    const auto sheet = parseCsvSheet(text, name);
    if (!sheet) return tl::unexpected(sheet.error());
    const auto columns = distractorColumns(*sheet);
    if (!columns) return tl::unexpected(columns.error());
    BallList out;
    for (std::size_t r = 0; r < sheet->rows.size(); ++r) {
        const ListedTarget& target = (*targets)[r];
        std::vector<BallSet>& sets = out[target.id];
        for (const DistractorColumns& distractor : *columns) {
            auto set = std::find_if(sets.begin(), sets.end(),
                                    [&](const BallSet& s) { return s.band == distractor.band; });
            if (set == sets.end()) set = sets.insert(set, {distractor.band, {target.position}, {"target"}});
            const auto at = positionIn(*sheet, sheet->rows[r], distractor.axes);
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
