#include "assets/tables/target_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/number.hpp"

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
    const auto records = parseCsv(text, name);
    if (!records) return tl::unexpected(records.error());
    if (records->size() < 2)
        return fail(name, "holds no targets", "Expected a header target_id,x,y,z and a line for each target");
    const auto& header = records->front().fields;
    std::array<std::size_t, target_columns.size()> places{};
    for (std::size_t i = 0; i < target_columns.size(); ++i) {
        const auto found = std::find(header.begin(), header.end(), target_columns[i]);
        if (found == header.end())
            return fail(fmt::format("{}:{}", name, records->front().line),
                        fmt::format("the column '{}' is missing from the header", target_columns[i]),
                        "The columns are target_id,x,y,z; others are passed over");
        places[i] = static_cast<std::size_t>(found - header.begin());
    }
    std::vector<ListedTarget> targets;
    std::set<std::string> ids;
    for (std::size_t r = 1; r < records->size(); ++r) {
        const CsvRecord& record = (*records)[r];
        const std::string where = fmt::format("{}:{}", name, record.line);
        if (record.fields.size() != header.size())
            return fail(where, fmt::format("found {} fields, expected {} as in the header",
                                           record.fields.size(), header.size()));
        ListedTarget target;
        target.id = record.fields[places[0]];
        if (!usableInFileNames(target.id))
            return fail(
                where + ": target_id",
                fmt::format("found '{}', expected up to 64 letters, digits, '_', '-' or '.'", target.id));
        if (!ids.insert(target.id).second)
            return fail(where + ": target_id",
                        fmt::format("'{}' was given before; ids must differ", target.id));
        for (int axis = 0; axis < 3; ++axis) {
            const auto column = static_cast<std::size_t>(axis) + 1;
            const std::string& cell = record.fields[places[column]];
            const auto value = finiteNumber(cell);
            if (!value || std::abs(*value) > farthest_target_m)
                return fail(fmt::format("{}: {}", where, target_columns[column]),
                            fmt::format("found '{}', expected a finite number of metres, at most {}", cell,
                                        farthest_target_m));
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
