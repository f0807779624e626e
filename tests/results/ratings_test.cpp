// Single ratings beside participants' means, and clips by their authors' trials.
#include <doctest/doctest.h>

#include <algorithm>

#include "answers_text.hpp"
#include "csv_table.hpp"
#include "oracles.hpp"
#include "results/copies/data_export.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::oracles;
using doctest::Approx;

namespace {

AnalysisOptions byRatings() {
    AnalysisOptions options;
    options.by_ratings = true;
    options.resamples = 100;
    return options;
}

const RatingComparison& pairOf(const AnalysisResult& result, const std::string& a, const std::string& b) {
    const auto found = std::find_if(result.rating_pairs.begin(), result.rating_pairs.end(),
                                    [&](const RatingComparison& one) { return one.a == a && one.b == b; });
    REQUIRE(found != result.rating_pairs.end());
    return *found;
}

/// Two raters, two pages of three movements. On P1's second page an attention check took a's place; P2's
/// first page has no rating of b.
const char* const two_pages =
    "participant,system,item,order,rating,attention\n"
    "P1,a,T1,1,10,\nP1,b,T1,1,30,\nP1,c,T1,1,20,\n"
    "P1,a,T2,2,46,passed\nP1,b,T2,2,40,\nP1,c,T2,2,50,\n"
    "P2,a,T1,1,60,\nP2,b,T1,1,,\nP2,c,T1,1,70,\n"
    "P2,a,T2,2,0,\nP2,b,T2,2,5,\nP2,c,T2,2,5,\n";

}  // namespace

TEST_SUITE("results/ratings") {
    TEST_CASE("R gives the same tests of single ratings, and of clips by their authors' trials") {
        for (const auto& oracle : oracles("ratings")) {
            const AnalysisResult result = fixtures::analyseText(oracle["csv"], {}, byRatings());
            REQUIRE(result.rating_pairs.size() == oracle["pairs"].size());
            for (const auto& right : oracle["pairs"]) {
                const RatingComparison& ours = pairOf(result, right["a"], right["b"]);
                CAPTURE(ours.a + " " + ours.b);
                CHECK(ours.test.n_pairs == right["n"]);
                CHECK(ours.n_missing == right["n_missing"]);
                CHECK(ours.participants == right["participants"]);
                CHECK(ours.mean_difference == Approx(right["mean_difference"].get<double>()));
                CHECK(ours.median_a == Approx(right["median_a"].get<double>()));
                CHECK(ours.median_b == Approx(right["median_b"].get<double>()));
                CHECK(ours.test.p_two_sided == Approx(right["p"].get<double>()).epsilon(1e-8));
                CHECK(std::abs(*ours.test.z) == Approx(right["z"].get<double>()).epsilon(1e-8));
                CHECK(*ours.p_holm == Approx(right["p_holm"].get<double>()).epsilon(1e-8));
                CHECK_FALSE(ours.test.hodges_lehmann.lower.has_value());
            }
            // More than means of 12 people can reach: every sign alike gives |z| = 3.02.
            CHECK(std::abs(*pairOf(result, "sgt", "manual").test.z) > 5.0);
            for (const Comparison& one : result.pairwise) CHECK(std::abs(*one.test.z) < 3.03);

            REQUIRE(result.author_trials.size() == oracle["trials"].size());
            REQUIRE(result.author_trials_paired.size() == oracle["trials"].size());
            for (std::size_t i = 0; i < oracle["trials"].size(); ++i) {
                const auto& right = oracle["trials"][i];
                const AuthorTrialResult& ours = result.author_trials[i];
                CAPTURE(ours.system);
                CHECK(ours.system == right["system"]);
                CHECK(ours.a == "1");
                CHECK(ours.b == "2");
                CHECK(ours.test.n_a == right["ratings"]["n_a"]);
                CHECK(ours.test.n_b == right["ratings"]["n_b"]);
                CHECK(ours.median_a == right["ratings"]["median_a"]);
                CHECK(ours.median_b == right["ratings"]["median_b"]);
                CHECK(*ours.test.p_two_sided == Approx(right["ratings"]["p"].get<double>()).epsilon(1e-8));
                CHECK(std::abs(*ours.test.z) == Approx(right["ratings"]["z"].get<double>()).epsilon(1e-8));
                CHECK(*ours.p_holm == Approx(right["ratings"]["p_holm"].get<double>()).epsilon(1e-8));
                const MedianComparison& paired = result.author_trials_paired[i];
                const auto& people = right["participants"];
                CHECK(paired.system == right["system"]);
                CHECK(paired.test.n_pairs == people["n"]);
                CHECK(paired.median_a == Approx(people["median_a"].get<double>()));
                CHECK(paired.median_b == Approx(people["median_b"].get<double>()));
                CHECK(paired.mean_difference == Approx(people["mean_difference"].get<double>()));
                CHECK(paired.test.p_two_sided == Approx(people["p"].get<double>()).epsilon(1e-8));
                CHECK(*paired.p_holm == Approx(people["p_holm"].get<double>()).epsilon(1e-8));
            }
        }
    }

    TEST_CASE("A missing rating and one whose place a check took make no pair; the rest of their page does") {
        const AnalysisResult result = fixtures::analyseText(two_pages, {}, byRatings());
        const RatingComparison& ab = pairOf(result, "a", "b");  // 10 - 30, 0 - 5
        CHECK(ab.test.n_pairs == 2);
        CHECK(ab.n_missing == 2);
        CHECK(ab.participants == 2);
        CHECK(ab.mean_difference == -12.5);
        CHECK(ab.test.p_two_sided == 0.5);
        CHECK(ab.median_a == 10.0);                             // of 10, 60, 0
        CHECK(ab.median_b == 30.0);                             // of 30, 40, 5
        const RatingComparison& ac = pairOf(result, "a", "c");  // -10, -10, -5
        CHECK(ac.test.n_pairs == 3);
        CHECK(ac.n_missing == 1);
        CHECK(ac.test.p_two_sided == 0.25);
        const RatingComparison& bc = pairOf(result, "b", "c");  // 10, -10, 0
        CHECK(bc.test.n_pairs == 3);
        CHECK(bc.test.n_zero == 1);
        CHECK(bc.test.p_two_sided == 1.0);
        CHECK(bc.family == "rating: pairs of systems, by ratings");
        CHECK(bc.family_size == 3);
        // Participants' means are what they were: b of P1 is 35, of P2 5.
        CHECK(result.pairwise.size() == 3);
        CHECK(result.pairwise[2].mean_difference == Approx((35.0 - 35.0 + 5.0 - 37.5) / 2));
    }

    TEST_CASE("Ratings that stand alone are paired by item and layout, and a number of trial makes no page") {
        // Trials are counted again for each system, and come in another order of items.
        const AnalysisResult result = fixtures::analyseText(
            "participant,system,item,layout,trial,rating\n"
            "P1,a,T1,across,1,1\nP1,a,T2,across,2,2\nP1,a,T1,beside,3,5\n"
            "P1,b,T2,across,1,4\nP1,b,T1,across,2,1\nP1,b,T1,beside,4,3\nP1,b,T1,beside,5,4\n"
            "P2,a,T3,across,1,5\nP2,b,T1,across,1,2\n",
            {}, byRatings());
        const RatingComparison& ab = pairOf(result, "a", "b");
        CHECK(ab.test.n_pairs == 3);  // T1 across 1 - 1, T2 2 - 4, T1 beside 5 - (3 + 4) / 2
        CHECK(ab.test.n_zero == 1);
        CHECK(ab.mean_difference == Approx((0.0 - 2.0 + 1.5) / 3));
        CHECK(ab.n_missing == 2);
        CHECK(ab.participants == 1);
        CHECK(ab.median_b == 3.0);  // of 4, 1, 3, 4, 2

        const AnalysisResult without = fixtures::analyseText(
            "participant,system,rating\nP1,a,1\nP1,b,2\nP2,a,1\nP2,b,4\n", {}, byRatings());
        CHECK(without.rating_pairs.front().test.n_pairs == 0);
        CHECK_FALSE(without.rating_pairs.front().p_holm.has_value());
        CHECK(without.pairwise.front().test.n_pairs == 2);
        const auto told = [](const std::string& one) { return contains(one, "can be paired"); };
        CHECK(std::any_of(without.remarks.begin(), without.remarks.end(), told));
        CHECK_FALSE(contains(renderReport(without), "again by single ratings"));
    }

    TEST_CASE("Only who asks gets them; the page, CSV, LaTeX and JSON say that they are pseudo-replicated") {
        const auto oracle = oracles("ratings")[0];
        const AnalysisResult plain = fixtures::analyseText(oracle["csv"]);
        CHECK(plain.rating_pairs.empty());
        CHECK(nlohmann::json::parse(analysisJson(plain))["pairwise_ratings"] == nlohmann::json::array());
        CHECK(fixtures::csvOf(plain, "pairwise_ratings.csv").empty());
        CHECK_FALSE(contains(renderReport(plain), "again by single ratings"));

        AnalysisOptions options = byRatings();
        options.resamples = plain.options.resamples;
        const AnalysisResult asked = fixtures::analyseText(oracle["csv"], {}, options);
        // What decides is untouched.
        CHECK(fixtures::csvOf(asked, "pairwise.csv") == fixtures::csvOf(plain, "pairwise.csv"));
        CHECK(fixtures::csvOf(asked, "sensitivity.csv") == fixtures::csvOf(plain, "sensitivity.csv"));
        const std::string page = renderReport(asked);
        CHECK(contains(page,
                       "again by single ratings, <b>pseudo-replicated</b>: ratings of one "
                       "participant are not independent, so p is too small"));
        const auto& right = oracle["pairs"][2];
        REQUIRE(right["a"] == "sgt");
        REQUIRE(right["b"] == "manual");
        const tests::XmlDocument document(page);
        const auto shown =
            document.row("//h:tr[*[.='sgt'] and *[.='manual'] and ../../h:thead/h:tr/h:th[.='|Z|']]");
        CHECK(shown.at("pairs") == right["n"].dump());
        CHECK(shown.at("|Z|") == fmt::format("{:.2f}", right["z"].get<double>()));
        CHECK(shown.at("p") == "<0.001");
        CHECK(contains(page, "highest first: sgt 65.00, auto 50.00, manual 45.00."));
        CHECK(document.count("//h:p[h:b='Single ratings.']") == 1);
        CHECK(page.find("all pairs of systems. n counts") < page.find("again by single ratings"));
        const tests::CsvTable table(fixtures::csvOf(asked, "pairwise_ratings.csv"));
        const auto rows = table.find({{"measure", "human-likeness"}, {"a", "sgt"}, {"b", "manual"}});
        REQUIRE(rows.size() == 1);
        for (const char* column : {"median_a", "median_b", "participants", "n_missing", "mean_difference"})
            CHECK(std::stod(table.cell(rows[0], column)) == Approx(right[column].get<double>()));
        const auto json = nlohmann::json::parse(analysisJson(asked));
        CHECK(json["settings"]["unit"] == "ratings");
        CHECK(json["pairwise_ratings"][2]["n"] == right["n"]);
        CHECK(json["pairwise_ratings"][2]["n_missing"] == right["n_missing"]);
        CHECK(contains(json["pairwise_ratings"][2]["note"].get<std::string>(), "pseudo-replicated"));
        for (const auto& [name, text] : analysisTables(asked, TableFormat::latex))
            if (name == "pairwise_ratings.tex") {
                CHECK(contains(text, "pseudo-replicated"));
                CHECK(contains(text, " & $Z$ & "));
                CHECK(contains(text, "sgt & manual & 65.000 & 45.000 & 73 & "));
            }
    }

    TEST_CASE("Authors' trials: shown where answers carry two, by ratings and by participants") {
        const auto oracle = oracles("ratings")[0];
        const std::string page = renderReport(fixtures::analyseText(oracle["csv"]));
        CHECK(contains(page, "to see whether authors learn"));
        CHECK(contains(page, "The same by participants"));
        const tests::XmlDocument document(page);
        const auto& right = oracle["trials"][0]["ratings"];
        const auto shown = document.row(
            "//h:tr[*[.='sgt'] and *[.='trial 1'] and *[.='trial 2'] and "
            "../../h:thead/h:tr/h:th[.='|Z|']]");
        CHECK(shown.at("n A") == right["n_a"].dump());
        CHECK(shown.at("n B") == right["n_b"].dump());
        CHECK(shown.at("Median A") == fmt::format("{:.2f}", right["median_a"].get<double>()));
        CHECK(shown.at("Median B") == fmt::format("{:.2f}", right["median_b"].get<double>()));
        CHECK(shown.at("|Z|") == fmt::format("{:.2f}", right["z"].get<double>()));
        CHECK(shown.at("p") == fmt::format("{:.3f}", right["p"].get<double>()));
        CHECK(document.count("//h:p[h:b=\"Authors' trials.\"]") == 1);
        const AnalysisResult none = fixtures::analyseText(
            "participant,system,item,author_trial,rating\nP1,a,T1,1,3\nP1,b,T1,1,4\nP2,a,T1,,5\nP2,b,T1,1,"
            "2\n");
        CHECK(none.author_trials.empty());
        CHECK_FALSE(contains(renderReport(none), "to see whether authors learn"));

        // Three trials are three pairs, a family with those of the other system; nobody rated 1 and 3 of a.
        const AnalysisResult three = fixtures::analyseText(
            "participant,system,item,author_trial,rating\n"
            "P1,a,T1,1,3\nP1,a,T2,2,4\nP2,a,T1,2,5\nP2,a,T2,3,2\nP1,b,T1,1,1\nP1,b,T2,2,5\n");
        REQUIRE(three.author_trials.size() == 4);
        CHECK(three.author_trials[1].a == "1");
        CHECK(three.author_trials[1].b == "3");
        CHECK(three.author_trials[0].test.n_b == 2);
        CHECK(three.author_trials[0].family_size == 4);
        CHECK(three.author_trials_paired[1].test.n_pairs == 0);
        CHECK_FALSE(three.author_trials_paired[1].p_holm.has_value());
        CHECK(three.author_trials_paired[0].family_size == 3);
        CHECK(tests::CsvTable(fixtures::csvOf(three, "answers.csv")).has({{"author_trial", "3"}}));
    }

    TEST_CASE(
        "A clip's trial goes from the database into the report, and through answers.csv and the export") {
        const fixtures::Folder folder;
        auto study = fixtures::study({"sgt"});
        study.by_ratings = true;
        {
            Store store = fixtures::open(folder / "a.sqlite");
            for (const char* who : {"P01", "P02", "P03"}) {
                const auto plan = fixtures::plan(study, who, 4);
                fixtures::store(store, study, plan);
                store.beginSession(fixtures::session(who, false));
                for (const auto& trial : plan.trials) {
                    if (trial.stage != "naturalness") continue;
                    auto clips = fixtures::clips(plan);
                    clips[trial.stimuli.front()].author = "A07";
                    clips[trial.stimuli.front()].trial = 1 + trial.index % 2;
                    store.record(fixtures::answer(trial, 1 + trial.index), study, plan, clips);
                }
            }
        }
        const auto table = loadResponses(folder / "a.sqlite");
        REQUIRE(table);
        CHECK(table->by_ratings);
        const AnalysisResult result = analyse(*table);
        REQUIRE(result.author_trials.size() == 1);
        CHECK(result.author_trials[0].test.n_a == 6);  // trials 2 and 4 of three people: 3 and 5
        CHECK(result.author_trials[0].median_a == 4.0);
        CHECK(result.author_trials[0].median_b == 3.0);  // 2 and 4
        CHECK(result.author_trials_paired[0].mean_difference == 1.0);

        const AnalysisResult again = fixtures::analyseText(fixtures::csvOf(result, "answers.csv"));
        CHECK(fixtures::csvOf(again, "author_trials.csv") == fixtures::csvOf(result, "author_trials.csv"));
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "data", {}));
        const auto exported = loadAnswers(folder / "data/responses.csv");
        REQUIRE_MESSAGE(exported.has_value(), (exported ? "" : exported.error().text()));
        CHECK(fixtures::csvOf(analyse(*exported), "author_trials_by_participants.csv") ==
              fixtures::csvOf(result, "author_trials_by_participants.csv"));

        const fixtures::Folder other;
        REQUIRE(writeFile(other / "bad.csv", "participant,system,author_trial,rating\nP1,a,0,3\n"));
        const auto rejected = loadAnswers(other / "bad.csv");
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().text(), "bad.csv:2: column \"author_trial\": found \"0\""));
    }
}
