// deixis stats: statistical tests of the columns of a CSV file.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "stats_points.hpp"
#include "stats_table.hpp"
#include "stats_tests.hpp"

namespace deixis::app {

namespace {

struct StatsArguments {
    ColumnChoice choice;
    std::string columns;  ///< one line of CSV
    StatsOptions test;
    std::string chance;
    DensityOptions density;
    ClusterOptions clusters;
    bool json = false;
};

/// Which options a test has besides its columns.
struct Takes {
    bool long_form = false;
    bool paired_by = false;
    bool level = false;
    bool chance = false;
    bool resamples = false;
    bool density = false;
    bool clusters = false;
};

std::string asText(const nlohmann::ordered_json& value) {
    if (value.is_null()) return "undefined";
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
    if (!value.is_array()) return value.dump();
    std::string out;
    for (const auto& item : value) out += (out.empty() ? "" : ", ") + asText(item);
    return out;
}

/// A line for each number; the numbers of an inner object are indented below its name.
void printText(const nlohmann::ordered_json& object, int indent) {
    for (const auto& [key, value] : object.items()) {
        if (value.is_object() || (value.is_array() && !value.empty() && value[0].is_object())) {
            fmt::print("{:{}}{}\n", "", indent, key);
            if (value.is_object()) {
                printText(value, indent + 2);
                continue;
            }
            for (const auto& item : value) {
                printText(item, indent + 2);
                if (&item != &value.back()) fmt::print("\n");
            }
            continue;
        }
        fmt::print("{:{}}{:<{}} {}\n", "", indent, key, 20 - indent, asText(value));
    }
}

/// JSON has no infinity: whether there was one. An undefined number is null before, and has its note.
bool nullInfinite(nlohmann::ordered_json& value) {
    if (value.is_number_float() && std::isinf(value.get<double>())) {
        value = nullptr;
        return true;
    }
    bool any = false;
    if (value.is_structured())
        for (auto& item : value) any = nullInfinite(item) || any;
    return any;
}

/// `test` is null where `takes` says density or clusters.
Result<void> runTest(StatsTest test, const Takes& takes, const StatsArguments& options) {
    StatsOptions with = options.test;
    if (!(with.level > 0.0 && with.level < 1.0))
        return fail("--level", fmt::format("{} is not between 0 and 1", with.level));
    if (!options.chance.empty()) {
        const auto chance = results::Rational::parse(options.chance);
        if (!chance) return fail("--chance", chance.error());
        if (chance->sign() <= 0 || *chance >= results::Rational(1))
            return fail("--chance", fmt::format("{} is not between 0 and 1", options.chance));
        with.chance = *chance;
    }
    ColumnChoice choice = options.choice;
    if (!options.columns.empty()) {
        auto named = parseColumnNames(options.columns);
        if (!named) return tl::unexpected(named.error());
        choice.columns = std::move(*named);
    }
    const auto table = readStatsTable(choice);
    if (!table) return tl::unexpected(table.error());
    auto found = takes.density    ? statsDensity(*table, options.density)
                 : takes.clusters ? statsMeanShift(*table, options.clusters)
                                  : test(*table, with);
    if (!found) return tl::unexpected(found.error());
    const auto addNote = [&](const std::string& sentence) {
        auto& note = (*found)["note"];
        note = (note.is_string() ? note.get<std::string>() + "; " : std::string()) + sentence;
    };
    if (nullInfinite(*found)) addNote("numbers beyond 1.8e308 in size are null");
    if (table->rounded > 0)
        addNote(fmt::format(
            "decimals that are rounded fractions (7.333333333333333) were read as these fractions: {}",
            table->rounded));
    if (table->decimal_commas) addNote("commas in numbers were read as decimal points");
    if (options.json)
        printAsJson(*found);
    else
        printText(*found, 0);
    return {};
}

void addTest(Parser stats, Command& chosen, const std::string& name, const std::string& description,
             StatsTest test, const Takes& takes, const char* columns_of_example = "a,b") {
    auto options = std::make_shared<StatsArguments>();
    Parser command = stats.addCommand(name, description);
    const std::string example =
        fmt::format("deixis stats {} answers.csv --columns {}", name, columns_of_example);
    describe(command, {.writes = "nothing; it prints the result.",
                       .example = example.c_str(),
                       .page = "docs/statistics.md"});
    command
        .addOption("FILE", options->choice.file,
                   "CSV file with the columns' names in its first line; - "
                   "for standard input")
        .required();
    Option columns =
        command.addOption("--columns", options->columns,
                          takes.long_form ? "Columns, as in a,b; with --group: its levels, in order [all]"
                                          : "Columns, as in a,b");
    if (!takes.long_form) columns.required();
    if (takes.paired_by)
        command.addOption("--paired-by,--cluster", options->choice.paired_by,
                          "Rows with the same value in this column are one participant and are averaged");
    if (takes.long_form) {
        command.addOption("--group", options->choice.group, "Long form: the column with the conditions");
        command.addOption("--value", options->choice.value, "Long form: the column with the numbers");
    }
    if (takes.level)
        command.addOption("--level", options->test.level, "Confidence level of intervals").showDefault();
    if (takes.chance)
        command.addOption("--chance", options->chance, "Chance level to test against, as in 1/3");
    if (takes.resamples) {
        command.addOption("--resamples", options->test.resamples, "Number of resamples")
            .showDefault()
            .check(Range(1, 10'000'000));
        addSeed(command, options->test.seed, "the resampling").check([](const std::string& text) {
            return text.starts_with('-') ? "found " + text + ", expected a whole number from 0" : "";
        });
    }
    if (takes.density) {
        command
            .addOption(
                "--bandwidth", options->density.bandwidth,
                "normal-reference, scott, scott-covariance, or one number for each column, as in 0.1,0.2")
            .showDefault();
        command.addOption("--at", options->density.at,
                          "CSV file of the points at which to compute the density [the rows themselves]");
    }
    if (takes.clusters) {
        command.addOption("--bandwidth", options->clusters.bandwidth, "auto, or a number above 0")
            .showDefault();
        command
            .addOption("--quantile", options->clusters.quantile,
                       "For the automatic bandwidth: the share of all points that are neighbours")
            .showDefault();
    }
    addJson(command, options->json, "Print one JSON object, with all digits");
    command.callback([options, test, takes, &chosen] {
        chosen = [options, test, takes] { return runTest(test, takes, *options); };
    });
}

}  // namespace

void addStatsCommand(Parser cli, Command& chosen) {
    Parser stats = cli.addCommand("stats", "Exact statistical tests of the columns of a CSV file");
    stats.requireCommand();
    describe(stats, {.writes = "nothing; the tests print their results.",
                     .example = "deixis stats signed-rank answers.csv --columns a,b",
                     .page = "docs/statistics.md"});
    addTest(stats, chosen, "signed-rank", "Wilcoxon's signed-rank test of paired columns a and b",
            statsSignedRank, {.long_form = true, .paired_by = true, .level = true});
    addTest(stats, chosen, "rank-sum", "Rank-sum test (Mann and Whitney's U) of independent samples a and b",
            statsRankSum, {.long_form = true, .paired_by = true, .level = true});
    addTest(stats, chosen, "friedman", "Friedman's test of two or more columns, with Kendall's W",
            statsFriedman, {.long_form = true, .paired_by = true});
    addTest(stats, chosen, "shapiro", "Shapiro and Wilk's test of a column, or of the differences of two",
            statsShapiro, {.long_form = true, .paired_by = true});
    addTest(stats, chosen, "spearman", "Spearman's rank correlation of two columns", statsSpearman,
            {.long_form = true, .paired_by = true});
    addTest(stats, chosen, "holm", "Holm's correction of a column of p values", statsHolm, {}, "p");
    addTest(stats, chosen, "bootstrap", "Bootstrap intervals of the columns' means and their differences",
            statsBootstrap, {.long_form = true, .paired_by = true, .level = true, .resamples = true});
    addTest(stats, chosen, "proportion", "Share of ones in a column of 0 and 1, with exact interval and test",
            statsProportion, {.level = true, .chance = true}, "correct");
    addTest(stats, chosen, "describe", "Mean, spread and quantiles of columns", statsDescribe,
            {.long_form = true, .paired_by = true});
    addTest(stats, chosen, "kde", "Gaussian kernel density of points, one column per dimension", nullptr,
            {.density = true}, "x,y,z");
    addTest(stats, chosen, "meanshift", "MeanShift clusters of points, one column per dimension", nullptr,
            {.clusters = true}, "x,y,z");
}

}  // namespace deixis::app
