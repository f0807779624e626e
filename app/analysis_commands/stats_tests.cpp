#include "stats_tests.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "results/statistics/bootstrap.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/friedman.hpp"
#include "results/statistics/holm.hpp"
#include "results/statistics/proportion.hpp"
#include "results/statistics/rank_sum.hpp"
#include "results/statistics/shapiro_wilk.hpp"
#include "results/statistics/signed_rank.hpp"
#include "results/statistics/spearman.hpp"

namespace deixis::app {

namespace {

using Json = nlohmann::ordered_json;
using results::Rational;

Json orNull(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// Several sentences under one key.
class Note {
  public:
    void add(const std::string& sentence) {
        if (!text_.empty()) text_ += "; ";
        text_ += sentence;
    }
    void addIf(bool condition, const std::string& sentence) {
        if (condition) add(sentence);
    }
    void write(Json& out) const {
        if (!text_.empty()) out["note"] = text_;
    }

  private:
    std::string text_;
};

Result<void> needColumns(const StatsTable& table, std::size_t min, std::size_t max, const std::string& test) {
    const std::size_t found = table.columns.size();
    if (found >= min && found <= max) return {};
    const std::string wanted = min == max ? fmt::format("{}", min)
                               : max == std::numeric_limits<std::size_t>::max()
                                   ? fmt::format("at least {}", min)
                                   : fmt::format("{} or {}", min, max);
    return fail(table.name, fmt::format("{} takes {} column{}, but {} {} chosen", test, wanted,
                                        wanted == "1" ? "" : "s", found, found == 1 ? "is" : "are"));
}

Result<void> needPairs(const StatsTable& table, const std::string& test) {
    if (table.paired) return {};
    return fail(table.name, fmt::format("{} compares paired values", test),
                "Name the column that pairs them: --paired-by participant");
}

int rowsOf(const StatsTable& table) {
    return static_cast<int>(table.columns.front().cells.size());
}

std::vector<Rational> differences(const std::vector<std::vector<Rational>>& rows) {
    std::vector<Rational> out;
    out.reserve(rows.size());
    for (const auto& row : rows) out.push_back(row[0] - row[1]);
    return out;
}

Json hodgesLehmannJson(const results::HodgesLehmann& estimate, double level, Note& note) {
    note.addIf(estimate.level && *estimate.level < level - 1e-9,
               fmt::format("no interval reaches the level {}: the widest is given with its own", level));
    note.addIf(estimate.estimate && !estimate.lower, "the test rejects every shift: there is no interval");
    return {{"estimate", orNull(estimate.estimate)},     {"lower", orNull(estimate.lower)},
            {"upper", orNull(estimate.upper)},           {"lower_included", estimate.lower_included},
            {"upper_included", estimate.upper_included}, {"level", orNull(estimate.level)}};
}

}  // namespace

Json statsObject(const StatsTable& table, const std::string& test) {
    Json out;
    out["test"] = test;
    for (const StatsColumn& column : table.columns) out["columns"].push_back(column.name);
    return out;
}

Result<Json> statsSignedRank(const StatsTable& table, const StatsOptions& options) {
    if (auto good = needColumns(table, 2, 2, "signed-rank"); !good) return tl::unexpected(good.error());
    if (auto good = needPairs(table, "signed-rank"); !good) return tl::unexpected(good.error());
    const auto rows = completeRows(table);
    const auto test = results::signedRankTest(differences(rows), options.level);
    Note note;
    Json out = statsObject(table, "signed-rank");
    out["n_pairs"] = test.n_pairs;
    out["n_missing"] = rowsOf(table) - test.n_pairs;
    out["n_zero"] = test.n_zero;
    out["n_positive"] = test.n_positive;
    out["n_negative"] = test.n_negative;
    out["ties"] = test.ties;
    out["w_plus"] = test.w_plus;
    out["w_minus"] = test.w_minus;
    out["z"] = orNull(test.z);
    out["method"] = test.method;
    out["p_two_sided"] = test.p_two_sided;
    out["p_greater"] = test.p_greater;
    out["p_less"] = test.p_less;
    out["smallest_p"] = test.smallest_p;
    out["pratt"] = {{"w_plus", test.pratt_w_plus}, {"p_two_sided", test.pratt_p_two_sided}};
    out["normal"] = {{"z", orNull(test.z)}, {"p_two_sided", test.normal_p_two_sided}};
    out["rank_biserial"] = orNull(test.rank_biserial);
    out["paired_superiority"] = orNull(test.paired_superiority);
    out["hodges_lehmann"] = hodgesLehmannJson(test.hodges_lehmann, options.level, note);
    note.addIf(test.n_pairs == 0, "there is no complete pair: nothing can be estimated, and p is 1");
    note.addIf(test.n_pairs > 0 && !test.z,
               "all differences are zero: p is 1, and z and the rank-biserial correlation are undefined");
    note.write(out);
    return out;
}

Result<Json> statsRankSum(const StatsTable& table, const StatsOptions& options) {
    if (auto good = needColumns(table, 2, 2, "rank-sum"); !good) return tl::unexpected(good.error());
    const auto test =
        results::rankSumTest(table.columns[0].values(), table.columns[1].values(), options.level);
    Note note;
    Json out = statsObject(table, "rank-sum");
    out["n_a"] = test.n_a;
    out["n_b"] = test.n_b;
    out["n_missing"] = table.columns[0].missing() + table.columns[1].missing();
    out["ties"] = test.ties;
    out["w"] = test.w;
    const bool defined = test.p_two_sided.has_value();
    out["u"] = defined ? Json(test.u) : Json(nullptr);
    out["z"] = orNull(test.z);
    out["method"] = test.method;
    out["p_two_sided"] = orNull(test.p_two_sided);
    out["p_greater"] = orNull(test.p_greater);
    out["p_less"] = orNull(test.p_less);
    out["normal"] = {{"z", orNull(test.z)}, {"p_two_sided", orNull(test.normal_p_two_sided)}};
    out["a12"] = orNull(test.a12);
    out["cliffs_delta"] = orNull(test.cliffs_delta);
    out["hodges_lehmann"] = hodgesLehmannJson(test.hodges_lehmann, options.level, note);
    note.addIf(!defined, "a sample is empty: nothing is defined");
    note.addIf(defined && !test.z, "all values are equal: p is 1, and z is undefined");
    note.write(out);
    return out;
}

Result<Json> statsFriedman(const StatsTable& table, const StatsOptions&) {
    if (auto good = needColumns(table, 2, std::numeric_limits<std::size_t>::max(), "friedman"); !good)
        return tl::unexpected(good.error());
    if (auto good = needPairs(table, "friedman"); !good) return tl::unexpected(good.error());
    const auto test = results::friedmanTest(completeRows(table));
    const int k = static_cast<int>(table.columns.size());
    Json out = statsObject(table, "friedman");
    out["n"] = test.n;
    out["k"] = k;
    out["n_missing"] = rowsOf(table) - test.n;
    out["ties"] = test.ties;
    out["mean_ranks"] = test.mean_ranks;
    out["chi2"] = orNull(test.chi2);
    out["df"] = k - 1;
    out["p"] = orNull(test.p);
    out["kendalls_w"] = orNull(test.kendalls_w);
    const auto& f = test.iman_davenport;
    out["iman_davenport"] = {{"f", orNull(f.f)},
                             {"df1", k - 1},
                             {"df2", test.n > 0 ? Json(f.df2) : Json(nullptr)},
                             {"p", orNull(f.p)}};
    Note note;
    note.addIf(test.n == 0, "no row is complete: nothing is defined");
    note.addIf(test.n > 0 && !test.chi2, "within every row all values are equal: the statistic is undefined");
    note.addIf(test.n == 1 && test.chi2, "Iman and Davenport's F is undefined for a single row");
    note.addIf(test.n > 1 && test.chi2 && !f.f,
               "Iman and Davenport's F is infinite: all rows rank the columns alike");
    note.write(out);
    return out;
}

Result<Json> statsShapiro(const StatsTable& table, const StatsOptions&) {
    if (auto good = needColumns(table, 1, 2, "shapiro"); !good) return tl::unexpected(good.error());
    std::vector<Rational> values = table.columns[0].values();
    int missing = table.columns[0].missing();
    if (table.columns.size() == 2) {
        if (auto good = needPairs(table, "shapiro of two columns"); !good)
            return tl::unexpected(good.error());
        values = differences(completeRows(table));
        missing = rowsOf(table) - static_cast<int>(values.size());
    }
    const auto test = results::shapiroWilk(values);
    Json out = statsObject(table, "shapiro");
    out["of"] = table.columns.size() == 2 ? "differences" : "values";
    out["n"] = test.n;
    out["n_missing"] = missing;
    out["w"] = orNull(test.w);
    out["p"] = orNull(test.p);
    Note note;
    const bool in_range = test.n >= 3 && test.n <= 5000;
    note.addIf(!in_range, fmt::format("defined for 3 to 5000 values, but there are {}", test.n));
    note.addIf(in_range && !test.w, "all values are equal: the statistic is undefined");
    note.write(out);
    return out;
}

Result<Json> statsSpearman(const StatsTable& table, const StatsOptions&) {
    if (auto good = needColumns(table, 2, 2, "spearman"); !good) return tl::unexpected(good.error());
    if (auto good = needPairs(table, "spearman"); !good) return tl::unexpected(good.error());
    std::vector<Rational> x;
    std::vector<Rational> y;
    for (auto& row : completeRows(table)) {
        x.push_back(row[0]);
        y.push_back(row[1]);
    }
    const auto test = results::spearman(x, y);
    const bool defined = test.method != "undefined";
    const auto number = [&](double value) { return defined ? Json(value) : Json(nullptr); };
    Json out = statsObject(table, "spearman");
    out["n"] = test.n;
    out["n_missing"] = rowsOf(table) - test.n;
    out["rho"] = number(test.rho);
    out["p"] = number(test.p);
    out["p_greater"] = number(test.p_greater);
    out["p_less"] = number(test.p_less);
    out["method"] = test.method;
    Note note;
    note.addIf(!defined, test.n < 2 ? "fewer than two pairs: nothing is defined"
                                    : "all values of a column are equal: the correlation is undefined");
    note.write(out);
    return out;
}

Result<Json> statsHolm(const StatsTable& table, const StatsOptions&) {
    if (auto good = needColumns(table, 1, 1, "holm"); !good) return tl::unexpected(good.error());
    const StatsColumn& column = table.columns[0];
    std::vector<double> p;
    for (std::size_t i = 0; i < column.cells.size(); ++i) {
        const auto& cell = column.cells[i];
        if (cell && (cell->sign() < 0 || *cell > Rational(1)))
            return fail(table.lines.empty()
                            ? table.name
                            : fmt::format("{}:{}: column \"{}\"", table.name, table.lines[i], column.name),
                        fmt::format("{} is not a p value; expected a number from 0 to 1", cell->toDouble()));
        p.push_back(cell ? cell->toDouble() : std::numeric_limits<double>::quiet_NaN());
    }
    const int missing = column.missing();
    Json out = statsObject(table, "holm");
    out["n"] = static_cast<int>(p.size()) - missing;
    out["n_missing"] = missing;
    out["p"] = p;
    out["adjusted"] = results::holm(p);
    Note note;
    note.addIf(p.empty(), "there is no p value");
    note.addIf(missing > 0,
               fmt::format("{} missing p value{} null and do{} not count in the family's size", missing,
                           missing == 1 ? " stays" : "s stay", missing == 1 ? "es" : ""));
    note.write(out);
    return out;
}

Result<Json> statsBootstrap(const StatsTable& table, const StatsOptions& options) {
    if (auto good = needColumns(table, 1, std::numeric_limits<std::size_t>::max(), "bootstrap"); !good)
        return tl::unexpected(good.error());
    const std::size_t k = table.columns.size();
    if (k > 1)
        if (auto good = needPairs(table, "bootstrap of several columns"); !good)
            return tl::unexpected(good.error());
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::vector<double>> rows;
    for (std::size_t r = 0; r < table.columns.front().cells.size(); ++r) {
        auto& row = rows.emplace_back();
        for (const StatsColumn& column : table.columns)
            row.push_back(column.cells[r] ? column.cells[r]->toDouble() : missing);
        for (std::size_t i = 0; i < k; ++i)
            for (std::size_t j = i + 1; j < k; ++j) {
                const auto& a = table.columns[i].cells[r];
                const auto& b = table.columns[j].cells[r];
                row.push_back(a && b ? (*a - *b).toDouble() : missing);
            }
    }
    const auto estimates = results::bootstrapMeans(rows, {options.resamples, options.seed, options.level});
    Note note;
    bool undefined = rows.empty();
    const auto write = [&](Json& out, std::size_t at) {
        const results::BootstrapMean none;
        const auto& estimate = at < estimates.size() ? estimates[at] : none;
        const auto interval = [](const std::optional<results::BootstrapInterval>& found) {
            return found ? Json{{"lower", found->lower}, {"upper", found->upper}}
                         : Json{{"lower", nullptr}, {"upper", nullptr}};
        };
        undefined = undefined || !estimate.bca;
        out["n"] = estimate.n;
        out["estimate"] = orNull(estimate.estimate);
        out["se"] = orNull(estimate.se);
        out["percentile"] = interval(estimate.percentile);
        out["bca"] = interval(estimate.bca);
    };
    Json out = statsObject(table, "bootstrap");
    out["statistic"] = "mean";
    out["participants"] = rows.size();
    out["resamples"] = options.resamples;
    out["seed"] = options.seed;
    out["level"] = options.level;
    out["means"] = Json::array();
    for (std::size_t i = 0; i < k; ++i) {
        Json& mean = out["means"].emplace_back();
        mean["column"] = table.columns[i].name;
        write(mean, i);
    }
    out["differences"] = Json::array();
    std::size_t at = k;
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = i + 1; j < k; ++j) {
            Json& difference = out["differences"].emplace_back();
            difference["a"] = table.columns[i].name;
            difference["b"] = table.columns[j].name;
            write(difference, at++);
        }
    note.addIf(undefined,
               "an interval is undefined if there are no values, if their sums are too large, or if the "
               "estimate is beyond all resampled means");
    note.write(out);
    return out;
}

Result<Json> statsProportion(const StatsTable& table, const StatsOptions& options) {
    if (auto good = needColumns(table, 1, 1, "proportion"); !good) return tl::unexpected(good.error());
    const StatsColumn& column = table.columns[0];
    std::int64_t successes = 0;
    std::int64_t n = 0;
    for (std::size_t i = 0; i < column.cells.size(); ++i) {
        const auto& cell = column.cells[i];
        if (!cell) continue;
        if (*cell != Rational(0) && *cell != Rational(1))
            return fail(table.lines.empty()
                            ? table.name
                            : fmt::format("{}:{}: column \"{}\"", table.name, table.lines[i], column.name),
                        fmt::format("{} is neither 0 nor 1", cell->text()));
        successes += cell->sign();
        ++n;
    }
    std::optional<double> chance;
    if (options.chance) chance = options.chance->toDouble();
    const auto found = results::proportion(successes, n, options.level, chance);
    Json out = statsObject(table, "proportion");
    out["successes"] = successes;
    out["n"] = n;
    out["n_missing"] = column.missing();
    out["estimate"] = orNull(found.estimate);
    out["lower"] = orNull(found.lower);
    out["upper"] = orNull(found.upper);
    out["level"] = options.level;
    out["chance"] = orNull(chance);
    out["p_chance"] = orNull(found.p_chance);
    out["p_greater"] = orNull(found.p_greater);
    out["p_less"] = orNull(found.p_less);
    out["assumes"] = "independent answers: clustering by participant and item is ignored";
    Note note;
    note.addIf(n == 0, "there are no answers: nothing is defined");
    note.addIf(n > 0 && !chance, "no chance level was given (--chance): there is no test against it");
    note.write(out);
    return out;
}

Result<Json> statsDescribe(const StatsTable& table, const StatsOptions&) {
    if (auto good = needColumns(table, 1, std::numeric_limits<std::size_t>::max(), "describe"); !good)
        return tl::unexpected(good.error());
    const auto write = [](Json& out, const StatsColumn& column) {
        const auto found = results::describe(column.values());
        out["n"] = found.n;
        out["n_missing"] = column.missing();
        out["mean"] = orNull(found.mean);
        out["sd"] = orNull(found.sd);
        out["se"] = orNull(found.se);
        out["min"] = orNull(found.min);
        out["q05"] = orNull(found.q05);
        out["q25"] = orNull(found.q25);
        out["median"] = orNull(found.median);
        out["q75"] = orNull(found.q75);
        out["q95"] = orNull(found.q95);
        out["max"] = orNull(found.max);
        out["mad"] = orNull(found.mad);
        Note note;
        note.addIf(found.n == 0, "there are no values");
        note.addIf(found.n == 1, "sd and se are undefined for a single value");
        note.write(out);
    };
    Json out = statsObject(table, "describe");
    if (table.columns.size() == 1) {
        write(out, table.columns[0]);
        return out;
    }
    for (const StatsColumn& column : table.columns) write(out["by_column"][column.name], column);
    return out;
}

}  // namespace deixis::app
