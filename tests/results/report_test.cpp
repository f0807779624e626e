#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "paths.hpp"
#include "results/analysis/analysis.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

struct Page {
    std::string html;
    std::string text;  ///< without the markup
};

/// The page of a database, checked to be self-contained, and left in the build folder to be looked at.
Page pageOf(const std::filesystem::path& database, const char* name) {
    const auto table = loadResponses(database);
    REQUIRE(table);
    const auto html = renderReport(analyse(*table));
    const std::filesystem::path folder = deixis::tests::buildDir() / "test-reports";
    std::filesystem::create_directories(folder);
    REQUIRE(writeFile(folder / (std::string(name) + ".html"), html));
    const tests::XmlDocument page(html);
    CHECK(page.count("//h:link | //h:img | //@src | //@href[not(starts-with(., '#'))]") == 0);
    CHECK(page.count("//h:table[not(parent::*[@tabindex='0' and @role='region' and @aria-label != ''])]") ==
          0);
    CHECK(page.count("//h:body/h:main") == 1);
    // The list of contents leads to each section.
    CHECK(page.count("//h:nav[@aria-label]//h:a") == page.count("//h:h2"));
    CHECK(page.count("//h:a[not(substring(@href, 2) = //h:h2/@id)]") == 0);
    return {html, page.text()};
}

const std::vector<std::string> systems{"demonstration-nn", "direct", "stiff", "drifting"};

}  // namespace

TEST_SUITE("results/report") {
    TEST_CASE("The report of a whole study is well formed and shows the numbers of the analysis") {
        const fixtures::Folder folder;
        const auto study = fixtures::study(systems);
        fixtures::fill(folder / "a.sqlite", study, 39, 5, true, {0.86, 0.95, 0.83, 0.46},
                       {4.0, 3.6, 2.6, 2.9}, fixtures::everything);
        const auto page = pageOf(folder / "a.sqlite", "whole");
        CHECK(page.html == renderReport(analyse(*loadResponses(folder / "a.sqlite"))));
        const std::string& text = page.text;
        CHECK(contains(text, "Simulated participants: these numbers test the pipeline"));
        CHECK(contains(text, "A small <study> & its \"title\""));
        CHECK(contains(text, std::string(64, 'a')));
        const auto json = nlohmann::json::parse(analysisJson(analyse(*loadResponses(folder / "a.sqlite"))));
        for (const auto& system : json["systems"]) {
            CHECK(contains(text,
                           fmt::format("{:.1f}\u00a0%", 100.0 * system["accuracy"]["mean"].get<double>())));
            CHECK(contains(text, fmt::format("{:.2f}", system["naturalness"]["sd_trials"].get<double>())));
        }
        for (const auto& row : json["layouts"])
            CHECK(contains(text, fmt::format("{:.2f} \u00b1 {:.2f}", row["mean"].get<double>(),
                                             row["sd_trials"].get<double>())));
        const tests::XmlDocument document(page.html);
        for (const auto& pair : json["pairwise"])
            CHECK(document.count(fmt::format("//h:td[.='{}']", pair["w_plus"].get<double>())) > 0);
        CHECK(contains(text, "had the highest mean accuracy, drifting ("));
        CHECK(document.count("//h:h2[.='Remarks']") == 0);
    }

    TEST_CASE("Design, a paragraph on methods and the limitations are told of each study as it is") {
        const fixtures::Folder folder;
        fixtures::fill(folder / "a.sqlite", fixtures::study(systems), 12, 5, true, {0.86, 0.95, 0.83, 0.46},
                       {3.9, 4.6, 2.9, 4.3}, fixtures::everything);
        const Page page = pageOf(folder / "a.sqlite", "for-the-paper");
        CHECK(contains(page.text,
                       "4: demonstration-nn (synthetic), direct (synthetic), stiff (synthetic) and drifting "
                       "(synthetic) (within participants)"));
        CHECK(contains(page.text, "12 of 12 planned have answered"));
        CHECK(contains(page.text, "720 in all, 60 per participant"));
        CHECK(
            contains(page.text,
                     "not people, take the place of a sample of 12 participants, who gave 60 answers each"));
        CHECK(contains(page.text,
                       "participants' means of each pair of systems and their means of each pair "
                       "of a factor's levels by two-sided Wilcoxon signed-rank tests"));
        CHECK(contains(page.text, "the 6 pairs of systems within one measure"));
        CHECK(contains(page.text, "nothing about people"));
        CHECK(contains(page.text, "families of tests of this page"));

        ResponseTable preferred;
        preferred.systems = {"a", "b"};
        preferred.measures = {{"preference", MeasureKind::preference, -2.0, 2.0, 0, 2}};
        for (const std::string participant : {"P1", "P2"}) {
            ResponseRow row;
            row.participant = participant;
            row.measure = "preference";
            row.system = "a";
            row.other_system = "b";
            row.value = 1.0;
            preferred.rows.push_back(row);
        }
        const std::string html = renderReport(analyse(preferred));
        CHECK(contains(html, "preference (between two systems, side by side)"));
        CHECK_FALSE(contains(html, "Means treat a rating"));
        CHECK_FALSE(contains(html, "simulated participants: they show"));
    }

    TEST_CASE("One participant gives a report without tests that says so") {
        const fixtures::Folder folder;
        fixtures::fill(folder / "a.sqlite", fixtures::study(systems), 1, 5, false, {0.9, 0.9, 0.8, 0.4},
                       {4.0, 3.6, 2.6, 2.9}, fixtures::everything);
        const auto text = pageOf(folder / "a.sqlite", "one").text;
        CHECK(contains(text, "With one participant there is nothing to test yet"));
        CHECK_FALSE(contains(text, "all pairs of systems"));
        CHECK_FALSE(contains(text, "Simulated participants:"));
    }

    TEST_CASE("Ratings without a game, and a participant who stopped, are reported as what they are") {
        const fixtures::Folder folder;
        const auto study = fixtures::study(systems);
        fixtures::fill(folder / "a.sqlite", study, 12, 5, false, {0.9, 0.9, 0.8, 0.4}, {4.0, 3.6, 2.6, 2.9},
                       [](int, const studies::Trial& trial) { return trial.stage == "naturalness"; });
        const auto ratings = pageOf(folder / "a.sqlite", "ratings").text;
        CHECK(contains(ratings, "There are no answers on accuracy: it is not reported."));
        CHECK_FALSE(contains(ratings, "Accuracy, all pairs of systems"));
        CHECK(contains(ratings, "Naturalness, all pairs of systems"));
        CHECK_FALSE(contains(ratings, "levels of layout within each system"));
        fixtures::fill(folder / "b.sqlite", study, 12, 5, false, {0.9, 0.9, 0.8, 0.4}, {4.0, 3.6, 2.6, 2.9},
                       [](int participant, const studies::Trial& trial) {
                           return participant != 7 || trial.index < 23;
                       });
        const auto stopped = pageOf(folder / "b.sqlite", "stopped").text;
        CHECK(contains(stopped, "incomplete: 442 of 480 planned on accuracy are answered"));
        CHECK_FALSE(contains(stopped, "\u22120.0\u00a0%"));
        CHECK(contains(stopped, "11 to 12 of 12 participants are used"));
    }
}
