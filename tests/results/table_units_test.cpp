// Every table says what its numbers are taken over: participants' means, single ratings, choices, ...
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "fixtures.hpp"
#include "page_text.hpp"
#include "results/analysis/analysis.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::pageText;

namespace {

/// Ratings, choices, questionnaires' scores and groups, of people who miss an answer.
AnalysisResult everyKind() {
    const fixtures::Folder folder;
    const auto study = fixtures::study({"direct", "stiff", "drifting"});
    fixtures::fill(folder / "a.sqlite", study, 6, 4, true, {0.9, 0.5, 0.7}, {4.0, 2.0, 3.0},
                   [](int number, const studies::Trial& trial) { return number > 1 || trial.index != 3; });
    ResponseTable table = loadResponses(folder / "a.sqlite").value();
    table.between = {{"style", {"calm", "lively"}}};
    for (int p = 1; p <= 6; ++p) {
        const std::string who = fmt::format("P{:02}", p);
        table.groups[who]["style"] = p % 2 == 0 ? "calm" : "lively";
        for (const char* stage : {"before", "after"}) table.scores.push_back({who, stage, "load", 1.0 * p});
        for (const auto& [left, right] : {std::pair{"direct", "stiff"}, std::pair{"stiff", "drifting"}}) {
            ResponseRow row;
            row.participant = who;
            row.measure = "preference";
            row.system = left;
            row.other_system = right;
            row.value = p % 3 - 1;
            row.synthetic = true;
            table.rows.push_back(row);
        }
    }
    table.measures.push_back({"preference", MeasureKind::preference, -2.0, 2.0});
    table.repeated_questionnaires = {{"before", "after"}};
    table.checks = {{"game", "number", 5, 1}};
    table.left_out = {{"P09", false, "test"}};
    table.equivalence = {{"naturalness", 0.5}};
    return analyse(table);
}

/// Of CSV, without their ends.
std::vector<std::string> linesOf(const std::string& bytes) {
    std::vector<std::string> out;
    for (std::size_t at = 0; at < bytes.size(); at = bytes.find("\r\n", at) + 2)
        out.push_back(bytes.substr(at, bytes.find("\r\n", at) - at));
    return out;
}

/// The texts between `begin` and `end`.
std::vector<std::string> between(const std::string& text, const std::string& begin, const std::string& end) {
    std::vector<std::string> out;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1))
        out.push_back(text.substr(at + begin.size(), text.find(end, at) - at - begin.size()));
    return out;
}

}  // namespace

TEST_SUITE("results/table_units") {
    TEST_CASE("Every CSV and LaTeX file names its unit, and the ones that matter the right one") {
        const AnalysisResult result = everyKind();
        std::map<std::string, std::string> units;
        for (const auto& [name, bytes] : analysisTables(result, TableFormat::csv)) {
            if (name == "answers.csv" || name == "settings.csv") continue;
            const std::string file = name;  // Clang 14 captures no structured binding
            CAPTURE(file);
            const std::vector<std::string> lines = linesOf(bytes);
            REQUIRE(lines.size() > 1);
            CHECK(lines[0].ends_with(",unit"));
            units[name] = lines[1].substr(lines[1].rfind(',') + 1);
            CHECK_FALSE(units[name].empty());
            for (std::size_t i = 1; i < lines.size(); ++i) CHECK(lines[i].ends_with("," + units[name]));
        }
        CHECK(units.size() > 18);
        CHECK(units["means.csv"] == "participants' means");
        CHECK(units["pairwise.csv"] == "participants' means");
        CHECK(units["levels.csv"] == "single answers");
        CHECK(units["pooled_ratings.csv"] == "ratings");
        CHECK(units["confusion.csv"] == "choices");
        CHECK(units["scores.csv"] == "participants' scores");
        CHECK(units["interactions.csv"] == "participants' differences of means");
        CHECK(units["checks.csv"] == "attention checks");
        for (const auto& [name, text] : analysisTables(result, TableFormat::latex)) {
            const std::string file = name;  // Clang 14 captures no structured binding
            CAPTURE(file);
            const std::string csv = name.substr(0, name.size() - 4) + ".csv";
            for (const std::string& caption : between(text, "\\caption{", "\n"))
                CHECK(contains(caption, ". Unit: " + units[csv]));
        }
    }

    TEST_CASE("Every table of the page names its unit in its caption") {
        std::string page = renderReport(everyKind());
        for (auto at = page.find("<script"); at != std::string::npos; at = page.find("<script"))
            page.erase(at, page.find("</script>", at) - at + 9);
        const auto tables = between(page, "<table", "</table>");
        CHECK(tables.size() > 18);
        std::set<std::string> units;
        for (const std::string& table : tables) {
            INFO(table.substr(0, 400));
            const auto captions = between(table, "<caption>", "</caption>");
            REQUIRE(captions.size() == 1);
            const std::string caption = pageText(captions[0]);
            const auto at = caption.find("Unit:\u00a0");
            REQUIRE(at != std::string::npos);
            units.insert(caption.substr(at + 7, caption.rfind('.') - at - 7));
        }
        for (const std::string unit : {"participants' means", "ratings", "choices", "single answers",
                                       "participants' mean preferences; counts: single preferences"})
            CHECK_MESSAGE(units.contains(unit), unit);
    }
}
