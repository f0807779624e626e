#include "assets/tables/target_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "core/csv_sheet.hpp"
#include "core/files.hpp"

namespace deixis::assets {

namespace {

constexpr std::array<std::string_view, 4> target_columns{"target_id", "x", "y", "z"};

bool usableInFileNames(const std::string& id) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-' || c == '.';
    };
    return !id.empty() && id.front() != '.' && id.size() <= 64 && std::all_of(id.begin(), id.end(), allowed);
}

}  // namespace

Result<std::vector<ListedTarget>> parseTargetList(std::string_view text, const std::string& name) {
    const auto sheet = parseCsvSheet(text, name);
    if (!sheet) return tl::unexpected(sheet.error());
    if (sheet->rows.empty())
        return fail(name, "has no targets", "Expected a header target_id,x,y,z and a line for each target");
    std::array<std::size_t, target_columns.size()> places{};
    for (std::size_t i = 0; i < target_columns.size(); ++i) {
        const auto place =
            sheet->column(target_columns[i], "The columns are target_id,x,y,z; others are ignored");
        if (!place) return tl::unexpected(place.error());
        places[i] = *place;
    }
    const std::string expected = fmt::format("a finite number of metres, at most {}", farthest_target_m);
    std::vector<ListedTarget> targets;
    std::set<std::string> ids;
    for (const CsvRecord& row : sheet->rows) {
        ListedTarget target;
        target.id = row.fields[places[0]];
        if (!usableInFileNames(target.id))
            return fail(
                sheet->place(row, places[0]),
                fmt::format("found '{}', expected up to 64 letters, digits, '_', '-' or '.'", target.id));
        if (!ids.insert(target.id).second)
            return fail(sheet->place(row, places[0]),
                        fmt::format("'{}' was already given; ids must differ", target.id));
        for (int axis = 0; axis < 3; ++axis) {
            const auto value =
                sheet->number(row, places[static_cast<std::size_t>(axis) + 1], expected, farthest_target_m);
            if (!value) return tl::unexpected(value.error());
            target.position[axis] = *value;
        }
        targets.push_back(std::move(target));
    }
    return targets;
}

Result<std::vector<ListedTarget>> readTargetList(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseTargetList(*text, path.string());
}

}  // namespace deixis::assets
