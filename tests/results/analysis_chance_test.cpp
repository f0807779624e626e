// Choices against chance, and choices that were not made.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "oracles.hpp"
#include "results/answers/long_table.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::close;
using deixis::tests::contains;
using fixtures::analyseText;
using fixtures::csvOf;
using nlohmann::json;

namespace {

/// A database in which a system's choices are right (r), wrong (w), timed out (t) or skipped (s), in turn.
void fillChoices(const std::filesystem::path& path, const std::vector<std::string>& of_systems,
                 int participants) {
    const auto study = fixtures::study({"direct", "stiff"});
    Store into = fixtures::open(path, Durability::whole_run);
    for (int number = 1; number <= participants; ++number) {
        const std::string id = fmt::format("P{:02}", number);
        const auto plan = fixtures::plan(study, id, 2);
        fixtures::store(into, study, plan);
        into.beginSession(fixtures::session(id, false));
        std::size_t place[2] = {0, 0};
        for (const auto& trial : plan.trials) {
            if (trial.kind != studies::StageKind::game) continue;
            const std::size_t system = trial.stimuli.front().system == "direct" ? 0 : 1;
            const char what = of_systems[system].at(place[system]++ % of_systems[system].size());
            studies::Response response = fixtures::answer(trial, what == 'r' ? 1 : 0);
            if (what == 't' || what == 's') {
                response.status =
                    what == 't' ? studies::ResponseStatus::timed_out : studies::ResponseStatus::skipped;
                response.values.clear();
                response.reason = what == 's' ? "noise" : "";
            }
            into.record(response, study, plan, fixtures::clips(plan));
        }
        into.endSession(studies::SessionOutcome::finished, 1.7e9 + 900.0);
    }
    into.commit();
}

}  // namespace

TEST_SUITE("results/analysis_chance") {
    TEST_CASE("Who guesses among two, three and five balls is at chance, not above one of the most") {
        // Right once in two, once in three and once in five trials: exactly what guessing gives.
        std::string text = "participant,system,balls,correct\n";
        for (int p = 1; p <= 20; ++p)
            for (const int balls : {2, 3, 5})
                for (int i = 0; i < balls; ++i)
                    text += fmt::format("P{},a,{},{}\n", p, balls, i == 0 ? 1 : 0);
        const AnalysisResult result = analyseText(text);
        REQUIRE(result.chance.size() == 1);
        CHECK(result.chance[0].test.p_two_sided == 1.0);
        CHECK(result.chance[0].test.n_zero == 20);
        CHECK(result.chance[0].mean_above == 0.0);
        CHECK(result.chance[0].chance == 0.3);  // 3 right of 10
        CHECK(contains(renderReport(result), "1 of 2 to 5 balls"));
    }

    TEST_CASE("Each trial's own chance is taken from it, worked by hand") {
        // Five are right of two balls and wrong of five: ((1 - 1/2) + (0 - 1/5)) / 2 = 0.15; one is wrong of
        // both: -0.35. Ranks 3, 3, 3, 3, 3 and 6: W- = 6, which {}, one 3 (5 ways), two 3s (10) and {6} do
        // not exceed: 17 of 64 sign patterns, twice.
        std::string text = "participant,system,balls,correct\n";
        for (int p = 1; p <= 6; ++p) text += fmt::format("P{0},a,2,{1}\nP{0},a,5,0\n", p, p < 6 ? 1 : 0);
        const AnalysisResult result = analyseText(text);
        CHECK(result.chance[0].test.p_two_sided == 34.0 / 64.0);
        CHECK(result.chance[0].mean_above == doctest::Approx((5 * 0.15 - 0.35) / 6.0));
        CHECK(result.chance[0].family == "accuracy: chance");
    }

    TEST_CASE("R's exact tests of participants' means agree, with trials whose balls are not known") {
        const json expected = tests::oracles("chance")[0];
        const AnalysisResult result = analyseText(expected["csv"].get<std::string>());
        REQUIRE(result.chance.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const ChanceResult& one = result.chance[i];
            const json& right = expected["systems"][i];
            CHECK(one.system == right["system"].get<std::string>());
            CHECK(one.successes == right["successes"].get<int>());
            CHECK(one.n == right["choices"].get<int>());
            CHECK(one.n_known == right["choices_with_balls"].get<int>());
            CHECK(one.test.n_pairs == right["n"].get<int>());
            CHECK(close(one.mean_above, right["mean_above"], 1e-8));
            CHECK(close(one.chance, right["chance"], 1e-12));
            CHECK(close(one.test.p_two_sided, right["p"], 1e-9));
            CHECK(close(one.p_holm, right["p_holm"], 1e-9));
        }
        bool told = false;
        for (const std::string& remark : result.remarks)
            told = told || contains(remark, "For 3 of 294 choices the number of balls is not known");
        CHECK(told);
        const json out = json::parse(analysisJson(result))["chance"][0];
        CHECK(out["p"] == result.chance[0].test.p_two_sided);
        CHECK(out["choices"] == 98);
        const tests::CsvTable answers(csvOf(result, "answers.csv"));
        CHECK(answers.column("balls") + 1 == answers.column("status"));
    }

    TEST_CASE("Wrong answers that become time-outs leave the accuracy as it was, and are counted") {
        const fixtures::Folder folder;
        fillChoices(folder / "wrong.sqlite", {"rwww", "rrrw"}, 6);
        fillChoices(folder / "late.sqlite", {"rttt", "rrrw"}, 6);
        const AnalysisResult wrong = analyse(loadResponses(folder / "wrong.sqlite").value());
        const AnalysisResult late = analyse(loadResponses(folder / "late.sqlite").value());
        CHECK(wrong.unanswered.empty());
        CHECK(late.systems[0].measures[0].mean == 0.25);
        CHECK(late.systems[0].measures[0].mean == wrong.systems[0].measures[0].mean);
        CHECK(late.pairwise[0].test.p_two_sided == wrong.pairwise[0].test.p_two_sided);
        REQUIRE(late.unanswered.size() == 2);
        CHECK(late.unanswered[0].timed_out == 18);
        CHECK(late.unanswered[0].answered == 6);
        CHECK(late.unanswered[0].headline == 0.25);
        CHECK(late.unanswered[0].answered_only == 1.0);
        CHECK(late.unanswered[1].timed_out == 0);
        const auto& answered_only = late.sensitivity[0].other(AnswerChoice::answered_only);
        CHECK(answered_only.test.test.w_plus > answered_only.test.test.w_minus);  // the other way round
        CHECK(late.pairwise[0].test.w_plus < late.pairwise[0].test.w_minus);
        const std::string page = renderReport(late);
        CHECK(contains(page, "without timed out"));
        CHECK(contains(page, "Choices that were not made"));
        const json out = json::parse(analysisJson(late));
        CHECK(out["unanswered"][0]["timed_out"] == 18);
        CHECK(out["sensitivity"]["answered_only"]["answers"] == 30);

        // The table of answers says as much when it is read again.
        const AnalysisResult again = analyseText(csvOf(late, "answers.csv"));
        CHECK(again.unanswered[0].timed_out == 18);
        CHECK(again.pairwise[0].test.p_two_sided == late.pairwise[0].test.p_two_sided);
        CHECK(again.chance[0].test.p_two_sided == late.chance[0].test.p_two_sided);
    }

    TEST_CASE("Choices that the experimenter skipped are left out, and count as wrong beside it") {
        const fixtures::Folder folder;
        fillChoices(folder / "a.sqlite", {"rsrs", "rrrw"}, 5);
        const AnalysisResult result = analyse(loadResponses(folder / "a.sqlite").value());
        CHECK(result.systems[0].measures[0].mean == 1.0);
        CHECK(result.unanswered[0].skipped == 10);
        CHECK(result.unanswered[0].unanswered_wrong == 0.5);
        CHECK(result.other_answers[3].answers == result.headline_answers.answers + 10);
        const AnalysisResult again = analyseText(csvOf(result, "answers.csv"));
        CHECK(again.unanswered[0].skipped == 10);
        CHECK(again.systems[0].measures[0].mean == 1.0);
    }

    TEST_CASE("One measure on two scales is two measures, and the reader is told") {
        const fixtures::Folder folder;
        auto study = fixtures::study({"direct", "stiff"});
        study.stages[1].scale = {studies::ScaleKind::steps, 1, 5, {}};
        auto wide = study.stages[1];
        wide.name = "again";
        wide.scale.high = 10;
        study.stages.push_back(wide);
        {
            Store into = fixtures::open(folder / "a.sqlite", Durability::whole_run);
            for (const char* id : {"P01", "P02"}) {
                auto plan = fixtures::plan(study, id, 1);
                for (const char* system : {"direct", "stiff"}) {
                    studies::Trial trial = plan.trials[1];
                    trial.index = static_cast<int>(plan.trials.size());
                    trial.stage = "again";
                    trial.stimuli = {{system, "T000"}};
                    plan.trials.push_back(trial);
                }
                fixtures::store(into, study, plan);
                into.beginSession(fixtures::session(id, false));
                for (const auto& trial : plan.trials)
                    if (!trial.practice && trial.kind == studies::StageKind::rating)
                        into.record(fixtures::answer(trial, trial.stage == "again" ? 10 : 5), study, plan,
                                    fixtures::clips(plan));
                into.endSession(studies::SessionOutcome::finished, 1.7e9 + 900.0);
            }
            into.commit();
        }
        const auto table = loadResponses(folder / "a.sqlite");
        REQUIRE(table);
        const AnalysisResult result = analyse(*table);
        REQUIRE(result.measures.size() == 3);
        CHECK(result.measures[1].name == "naturalness (1 to 5)");
        CHECK(result.measures[1].high == 5.0);
        CHECK(result.measures[2].name == "naturalness (1 to 10)");
        CHECK(result.systems[0].measures[1].mean == 5.0);
        CHECK(result.systems[0].measures[2].mean == 10.0);
        bool told = false;
        for (const std::string& remark : result.remarks)
            told = told || contains(remark, "naturalness is asked on different scales");
        CHECK(told);
    }
}
