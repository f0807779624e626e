#include "stats_points.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "core/number.hpp"
#include "results/statistics/density.hpp"
#include "results/statistics/mean_shift.hpp"
#include "stats_tests.hpp"

namespace deixis::app {

namespace {

using Json = nlohmann::ordered_json;

/// The rows in which no cell is missing, and for each row of the table its place among them, or -1.
struct PointRows {
    results::Points points;
    std::vector<int> place;
    [[nodiscard]] std::size_t missing() const { return place.size() - points.size(); }
};

PointRows pointRows(const StatsTable& table) {
    PointRows out;
    const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().cells.size();
    for (std::size_t r = 0; r < rows; ++r) {
        std::vector<double> point;
        for (const StatsColumn& column : table.columns)
            if (column.cells[r]) point.push_back(column.cells[r]->toDouble());
        const bool whole = point.size() == table.columns.size();
        out.place.push_back(whole ? static_cast<int>(out.points.size()) : -1);
        if (whole) out.points.push_back(std::move(point));
    }
    return out;
}

std::optional<double> positive(std::string_view text) {
    const auto value = finiteNumber(text);
    return value && *value > 0.0 ? value : std::nullopt;
}

Result<results::GaussianDensity> fitted(const results::Points& points, const std::string& bandwidth,
                                        std::size_t dimensions, Json& out) {
    if (const auto rule = results::bandwidthRuleFromName(bandwidth)) {
        out["rule"] = bandwidth;
        return results::GaussianDensity::fit(points, *rule);
    }
    std::vector<double> widths;
    for (std::size_t at = 0; at <= bandwidth.size();) {
        const std::size_t comma = std::min(bandwidth.find(',', at), bandwidth.size());
        const auto width = positive(std::string_view(bandwidth).substr(at, comma - at));
        if (!width)
            return fail(
                "--bandwidth",
                fmt::format("found \"{}\", expected normal-reference, scott, scott-covariance or numbers "
                            "above 0, one for each column",
                            bandwidth));
        widths.push_back(*width);
        at = comma + 1;
    }
    if (widths.size() != dimensions)
        return fail("--bandwidth",
                    fmt::format("found {} numbers, but {} columns are chosen", widths.size(), dimensions));
    out["rule"] = "given";
    return results::GaussianDensity::fit(points, widths);
}

}  // namespace

Result<Json> statsDensity(const StatsTable& table, const DensityOptions& options) {
    const PointRows rows = pointRows(table);
    Json out = statsObject(table, "kde");
    out.update(
        {{"n", rows.points.size()}, {"n_missing", rows.missing()}, {"dimensions", table.columns.size()}});
    const auto density = fitted(rows.points, options.bandwidth, table.columns.size(), out);
    if (!density)
        return fail(density.error().where.empty() ? table.name : density.error().where,
                    density.error().message, density.error().hint);
    PointRows asked = rows;
    if (!options.at.empty()) {
        ColumnChoice choice{.file = options.at};
        for (const StatsColumn& column : table.columns) choice.columns.push_back(column.name);
        const auto others = readStatsTable(choice);
        if (!others) return tl::unexpected(others.error());
        asked = pointRows(*others);
    }
    out["bandwidths"] = density->bandwidths();
    out["densities"] = Json::array();
    for (const int place : asked.place)
        out["densities"].push_back(
            place < 0 ? Json(nullptr) : Json((*density)(asked.points[static_cast<std::size_t>(place)])));
    return out;
}

Result<Json> statsMeanShift(const StatsTable& table, const ClusterOptions& options) {
    const PointRows rows = pointRows(table);
    if (!(options.quantile > 0.0 && options.quantile <= 1.0))
        return fail("--quantile", fmt::format("{} is not above 0 and at most 1", options.quantile));
    double bandwidth = 0.0;
    if (options.bandwidth == "auto") {
        if (rows.points.empty()) return fail(table.name, "there are no points");
        bandwidth = results::estimateBandwidth(rows.points, options.quantile);
        if (!(bandwidth > 0.0))
            return fail(table.name, "the bandwidth cannot be estimated: the nearest points coincide",
                        "Give one with --bandwidth");
    } else if (const auto given = positive(options.bandwidth)) {
        bandwidth = *given;
    } else {
        return fail("--bandwidth",
                    fmt::format("found \"{}\", expected auto or a number above 0", options.bandwidth));
    }
    const auto found = results::meanShift(rows.points, bandwidth);
    if (!found) return fail(table.name, found.error().message, found.error().hint);
    std::vector<int> counts(found->centres.size(), 0);
    for (const int label : found->labels) ++counts[static_cast<std::size_t>(label)];
    Json out = statsObject(table, "meanshift");
    out.update({{"n", rows.points.size()},
                {"n_missing", rows.missing()},
                {"dimensions", table.columns.size()},
                {"bandwidth", bandwidth},
                {"clusters", found->centres.size()},
                {"centres", found->centres},
                {"counts", counts}});
    out["labels"] = Json::array();
    for (const int place : rows.place)
        out["labels"].push_back(place < 0 ? Json(nullptr)
                                          : Json(found->labels[static_cast<std::size_t>(place)]));
    return out;
}

}  // namespace deixis::app
