// What was chosen in the game and where, and what a database tells of answers besides their values.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "page_text.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::pageText;
using nlohmann::json;

namespace {

const ConfusionResult& roleOf(const AnalysisResult& result, const std::string& system,
                              const std::string& role) {
    const auto found =
        std::find_if(result.confusion.begin(), result.confusion.end(),
                     [&](const ConfusionResult& one) { return one.system == system && one.role == role; });
    REQUIRE(found != result.confusion.end());
    return *found;
}

}  // namespace

TEST_SUITE("results/analysis_choices") {
    TEST_CASE("Choices are counted by the balls' nearness and side, worked by hand") {
        ResponseTable table;
        table.systems = {"x", "y"};
        // The target is at (0, 1, 1); 0.3 m to the avatar's left (+x) is `near_by`, 0.6 m to its right
        // `far_off`, 0.45 m straight up `above`.
        const Vec3 target{0.0, 1.0, 1.0};
        const Vec3 near_by{0.3, 1.0, 1.0};
        const Vec3 far_off{-0.6, 1.0, 1.0};
        const Vec3 above{0.0, 1.45, 1.0};
        // Across, at z = 2, the avatar's left is the participant's right; behind the avatar it is left, too.
        table.choices = {{"A", "x", "T1", {near_by, target, far_off}, 1, 0, 0.0, 2.0},
                         {"A", "x", "T1", {near_by, target, far_off}, 1, 0, 0.0, -1.0},
                         {"A", "x", "T1", {far_off, near_by, target}, 2, 0, 0.0, 2.0},
                         {"B", "x", "T1", {target, far_off, above}, 0, 0, 0.0, 2.0},
                         {"B", "y", "T2", {above, {0.5, 1.0, 2.0}, far_off}, 1, 1, 0.0, 3.0}};
        const AnalysisResult result = analyse(table);
        const auto check = [&](const char* system, const char* role, int chosen, int shown) {
            CAPTURE(role);
            CHECK(roleOf(result, system, role).chosen == chosen);
            CHECK(roleOf(result, system, role).shown == shown);
        };
        check("x", "target", 1, 4);
        check("x", "nearest 1", 2, 4);  // twice near_by; in B's trial it is `above`
        check("x", "nearest 2", 1, 4);  // far_off
        // Trial 1: near_by is right, far_off left. Trial 2: the other way round. Trial 3: as 1. B: far_off
        // left, `above` on neither side.
        check("x", "left", 2, 4);
        check("x", "right", 1, 3);
        check("y", "target", 1, 1);

        REQUIRE(result.target_space.size() == 4);
        const TargetPlace& all = result.target_space[0];
        CHECK(all.system == "all");
        CHECK(all.target_id == "T1");
        CHECK(all.position_m.z == 1.0);
        CHECK(all.n == 4);
        CHECK(all.mean == 0.25);
        CHECK(result.target_space[3].system == "y");
        CHECK(result.target_space[3].position_m.x == 0.5);

        const json out = json::parse(analysisJson(result));
        CHECK(out["confusion"][0] == json{{"system", "x"}, {"role", "target"}, {"chosen", 1}, {"shown", 4}});
        CHECK(out["target_space"][0]["z_m"] == 1.0);
        CHECK(tests::CsvTable(fixtures::csvOf(result, "confusion.csv"))
                  .has({{"system", "x"},
                        {"role", "nearest 1"},
                        {"chosen", "2"},
                        {"shown", "4"},
                        {"share", "0.5"}}));
        CHECK(contains(pageText(renderReport(result)), "50.0\u00a0% (2 of 4)|"));
    }

    TEST_CASE("The balls come from the database; what was chosen adds up to the accuracy") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        fixtures::fill(folder / "a.sqlite", study, 6, 4, true, {0.8, 0.4}, {4.0, 3.0}, fixtures::everything);
        const auto table = loadResponses(folder / "a.sqlite");
        REQUIRE(table);
        REQUIRE(table->choices.size() == 96);
        const ChoiceRow& first = table->choices.front();
        // fixtures::plan: the target of item 0 at x = 0, shown second; the fixture chooses it or the third.
        CHECK(first.target_place == 1);
        CHECK(first.balls[1] == Vec3{0.0, 1.25, 0.75});
        CHECK(first.balls[2] == Vec3{0.3, 1.5, 0.5});
        CHECK(first.head_z_m == 2.0);
        const AnalysisResult result = analyse(*table);
        for (std::size_t i = 0; i < 2; ++i) {
            const auto& system = result.systems[i].system;
            CHECK(roleOf(result, system, "target").chosen == result.chance[i].successes);
            CHECK(roleOf(result, system, "target").shown == 48);
            CHECK(roleOf(result, system, "nearest 1").chosen + roleOf(result, system, "nearest 2").chosen ==
                  48 - result.chance[i].successes);
            int right = 0;
            for (const TargetPlace& one : result.target_space)
                if (one.system == system) right += static_cast<int>(std::lround(one.mean * one.n));
            CHECK(right == result.chance[i].successes);
        }
        CHECK(result.target_space.size() == 3 * 8);  // eight places, over all and for two systems
    }

    TEST_CASE("A database tells what is in doubt, who failed a check, and whose consent is missing") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        {
            Store store = fixtures::open(folder / "a.sqlite");
            for (const char* id : {"P01", "P02", "P03"}) {
                const std::string who = id;
                const auto plan = fixtures::widePlan(study, who);
                fixtures::store(store, study, plan);
                store.beginSession(fixtures::session(who, false));
                const auto record = [&](const studies::SessionEvent& event) {
                    store.record(event, study, plan, fixtures::clips(plan));
                };
                auto consent = fixtures::response(plan.trials[0]);
                consent.answers = {{"consent", -1, who == "P03" ? 0.0 : 1.0}};
                record(consent);
                auto ratings = fixtures::response(plan.trials[3]);
                ratings.answers = {{"rating", 0, 30.0}, {"rating", 1, 80.0}};
                ratings.pauses = 1;
                record(studies::Note{studies::NoteKind::off_place, 3, {2.0, 1.7e9}, "0.41 m"});
                record(ratings);
                auto choice = fixtures::answer(plan.trials[5], 1);
                choice.answers = {{"confidence", -1, 6.0}};
                record(choice);
                auto caught = fixtures::answer(plan.trials[6], 0);
                caught.check_passed = false;
                record(caught);
                if (who != "P01") record(studies::Exclusion{"attention check failed", {1.0, 1.7e9}});
                store.endSession(studies::SessionOutcome::quit, 1.7e9 + 60.0);
            }
        }
        const auto table = loadResponses(folder / "a.sqlite");
        REQUIRE(table);
        REQUIRE(table->rows.size() == 4);  // two ratings, the choice, the confidence
        for (const ResponseRow& row : table->rows) {
            CHECK(row.participant == "P01");
            CHECK(row.marked == (row.measure == "appeal" ? "interrupted, off place" : ""));
        }
        CHECK(table->failed_checks == std::set<std::string>{"P01"});
        CHECK(table->left_out.size() == 2);
        REQUIRE(table->left_out_rows.size() == 4);  // P03 declined consent
        CHECK(table->left_out_rows[0].participant == "P02");
        CHECK(table->left_out_rows[0].excluded == "excluded: attention check failed");
        CHECK(table->groups.at("P01").at("style") == "calm");
        CHECK(table->between[0].levels == std::vector<std::string>{"calm"});
        // The factor nested in one of the systems only; the other has none.
        REQUIRE(table->within.size() == 1);
        CHECK(table->within[0].name == "hold");
        CHECK(levelOf(*table, table->rows[0], "hold") == (table->rows[0].system == "stiff" ? "long" : ""));
        CHECK(table->choices.size() == 1);
    }
}
