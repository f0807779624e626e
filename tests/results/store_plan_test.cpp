// Studies, participants and plans in the store.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "fixtures.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::Store;
using studies::SessionOutcome;

namespace {

/// All rows of a query, columns parted by '|'.
std::string rows(const std::filesystem::path& path, const std::string& query) {
    SQLite::Database database(path.string(), SQLite::OPEN_READONLY, 1000);
    SQLite::Statement row(database, query);
    std::string out;
    while (row.executeStep()) {
        for (int i = 0; i < row.getColumnCount(); ++i) {
            if (i > 0) out += "|";
            out += row.getColumn(i).isNull() ? "NULL" : row.getColumn(i).getString();
        }
        out += "\n";
    }
    return out;
}

}  // namespace

TEST_SUITE("results/store plan") {
    TEST_CASE("The stored plan and registration come back as they were, and storing again changes nothing") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        const auto plan = fixtures::widePlan(study, "P07");
        Store store = fixtures::open(folder / "a.sqlite");
        CHECK_FALSE(store.plan("P07").has_value());
        CHECK_FALSE(store.registration("P07").has_value());
        CHECK(store.firstFreeNumber() == 1);
        REQUIRE(store.storePlan(study, fixtures::registration(plan, "sv"), plan));
        REQUIRE(store.storePlan(study, fixtures::registration(plan, "sv"), plan));
        const auto back = store.plan("P07");
        REQUIRE(back.has_value());
        CHECK(studies::planJson(*back) == studies::planJson(plan));
        CHECK(store.participants() == std::vector<std::string>{"P07"});
        const auto registered = store.registration("P07");
        REQUIRE(registered.has_value());
        CHECK(registered->number == 7);
        CHECK(registered->language == "sv");
        CHECK(registered->groups == studies::Groups{{"style", "calm"}});
        CHECK(store.firstFreeNumber() == 8);
    }

    TEST_CASE("A study is kept with its stages, questions, scores, systems and distances") {
        const fixtures::Folder folder;
        auto study = fixtures::wideStudy();
        study.source = "[study]\nname = \"wide\"\n";
        {
            Store store = fixtures::open(folder / "a.sqlite");
            fixtures::store(store, study, fixtures::widePlan(study, "P01"));
        }
        const auto path = folder / "a.sqlite";
        CHECK(rows(path, "SELECT name, hash, source, alpha FROM study") ==
              "wide|" + std::string(64, 'a') + "|[study]\nname = \"wide\"\n|0.01\n");
        CHECK(rows(path,
                   "SELECT name, kind, sitting, measure, scale_low, scale_high FROM stages "
                   "ORDER BY position") ==
              "welcome|instructions|1|NULL|NULL|NULL\nconsent|consent|1|NULL|NULL|NULL\n"
              "about you|questionnaire|1|NULL|NULL|NULL\nappeal|parallel-rating|1|appeal|0|100\n"
              "preference|pairwise|1|preference|NULL|NULL\ngame|referential-game|1|NULL|NULL|NULL\n"
              "load|questionnaire|1|NULL|NULL|NULL\n");
        CHECK(rows(path,
                   "SELECT stage, question, kind, low, high, options FROM questions ORDER BY stage, "
                   "position") ==
              "about you|age|number|18.0|99.0|NULL\n"
              "about you|gender|choice|NULL|NULL|[{\"id\":\"f\",\"text\":\"female\"},{\"id\":\"m\","
              "\"text\":\"male\"},{\"id\":\"x\",\"text\":\"other\"}]\n"
              "about you|remark|text|NULL|NULL|NULL\nappeal|rating|scale|0.0|100.0|NULL\n"
              "game|confidence|scale|1.0|7.0|NULL\nload|effort|scale|0.0|20.0|NULL\n"
              "load|calm|scale|0.0|20.0|NULL\npreference|preference|scale|-2.0|2.0|NULL\n"
              "preference|reasons|choices|NULL|NULL|[{\"id\":\"speed\",\"text\":\"its speed\"},{\"id\":"
              "\"arm\",\"text\":\"its arm\"}]\n");
        CHECK(rows(path, "SELECT stage, name, items, reversed, mean, factor, offset_ FROM scores") ==
              "load|total|[\"effort\",\"calm\"]|[\"calm\"]|1|5.0|0.0\n");
        CHECK(rows(path, "SELECT name, levels FROM systems ORDER BY position") ==
              "direct|{}\nstiff|{\"hold\":\"long\"}\n");
        CHECK(rows(path, "SELECT * FROM distances") == "0|near|0.3|0.6|2\n");
        CHECK(rows(path, "SELECT * FROM participant_groups") == "P01|style|calm\n");
    }

    TEST_CASE("A practice stage names the stage that is practised") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, fixtures::plan(study, "P01", 1));
        CHECK(rows(folder / "a.sqlite", "SELECT name, practice_of FROM stages ORDER BY position") ==
              "naturalness-practice|naturalness\nnaturalness|NULL\ngame|NULL\n");
    }

    TEST_CASE("Trials are kept with what is shown, what is checked and what counts") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        {
            Store store = fixtures::open(folder / "a.sqlite");
            fixtures::store(store, study, fixtures::widePlan(study, "P01"));
        }
        const auto path = folder / "a.sqlite";
        CHECK(rows(path,
                   "SELECT trial_index, stage, page, layout, distance, target_id, target_place, "
                   "check_kind, check_stimulus, check_expected, check_of_trial FROM trials LEFT JOIN "
                   "game_trials "
                   "USING (participant, trial_index) ORDER BY trial_index") ==
              "0|consent|0|across|NULL|NULL|NULL|NULL|NULL|NULL|NULL\n"
              "1|about you|0|across|NULL|NULL|NULL|NULL|NULL|NULL|NULL\n"
              "2|about you|1|across|NULL|NULL|NULL|NULL|NULL|NULL|NULL\n"
              "3|appeal|0|across|NULL|T001|NULL|NULL|NULL|NULL|NULL\n"
              "4|preference|0|across|NULL|T002|NULL|NULL|NULL|NULL|NULL\n"
              "5|game|0|across|near|T003|1|NULL|NULL|NULL|NULL\n"
              "6|game|0|across|near|T004|1|catch|NULL|NULL|NULL\n"
              "7|appeal|0|across|NULL|T005|NULL|number|1|4.0|NULL\n"
              "8|game|0|across|near|T003|1|repeat|NULL|NULL|5\n"
              "9|load|0|across|NULL|NULL|NULL|NULL|NULL|NULL|NULL\n");
        CHECK(rows(path, "SELECT trial_index, position, system, item, scored FROM trial_stimuli") ==
              "3|0|stiff|T001|1\n3|1|direct|T001|1\n4|0|direct|T002|1\n4|1|stiff|T002|1\n"
              "5|0|direct|T003|1\n6|0|direct|T004|0\n7|0|stiff|T005|1\n7|1|direct|T005|0\n"
              "8|0|direct|T003|0\n");
        CHECK(rows(path, "SELECT distractors, balls FROM game_trials WHERE trial_index = 5") ==
              "[[0.3,1.5,0.5],[-0.3,1,0.5]]|[[-0.3,1,0.5],[0.5,1.25,0.75],[0.3,1.5,0.5]]\n");
    }

    TEST_CASE("An item that points at nothing has no target") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        auto plan = fixtures::plan(study, "P01", 1);
        plan.trials[1].target = Vec3(0.0);
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, plan);
        CHECK(rows(folder / "a.sqlite",
                   "SELECT target_id, target_x_m, target_y_m FROM trials WHERE trial_index = 1") ==
              "T000|NULL|NULL\n");
    }

    TEST_CASE("Another plan for the participant is rejected, and what differs is listed") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        Store store = fixtures::open(folder / "a.sqlite");
        const auto kept = fixtures::plan(study, "P01", 1);
        fixtures::store(store, study, kept);
        const auto longer = fixtures::plan(study, "P01", 2);
        const auto rejected = store.storePlan(study, fixtures::registration(longer), longer);
        REQUIRE_FALSE(rejected);
        CHECK(rejected.error().where == (folder / "a.sqlite").string());
        CHECK(contains(rejected.error().message, "another plan for participant P01"));
        CHECK(contains(rejected.error().message, "the number of trials is kept as 7, given as 13"));
        auto other = kept;
        other.number = 5;
        other.groups = {{"style", "calm"}};
        other.trials[2].stimuli[0].system = "direct";
        other.trials[6].ball_order = {0, 1, 2};
        const auto again = store.storePlan(study, fixtures::registration(other), other);
        REQUIRE_FALSE(again);
        CHECK(contains(again.error().message, "the number is kept as 1, given as 5"));
        CHECK(contains(again.error().message, "the groups is kept as none, given as style=calm"));
        CHECK(contains(again.error().message, "trial 2 is kept as 'naturalness rating, stiff T000"));
        CHECK(contains(again.error().message, "balls 0 1 2'"));
        CHECK_FALSE(contains(again.error().message, "trial 3"));
    }

    TEST_CASE("Another study is rejected, and what differs is listed") {
        const fixtures::Folder folder;
        auto study = fixtures::study({"direct", "stiff"});
        study.source = "seed = 1\nalpha = 0.01\n";
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, fixtures::plan(study, "P01", 1));
        auto other = fixtures::study({"direct", "other"});
        other.name = "other";
        other.hash = std::string(64, 'b');
        other.source = "seed = 1\nalpha = 0.05\n";
        other.stages.pop_back();
        const auto plan = fixtures::plan(study, "P02", 1);
        auto theirs = plan;
        theirs.study_hash = other.hash;
        const auto rejected = store.storePlan(other, fixtures::registration(theirs), theirs);
        REQUIRE_FALSE(rejected);
        const auto& message = rejected.error().message;
        CHECK(contains(message, "study 'small' (hash aaaaaaaaaaaa)"));
        CHECK(contains(message, "'other' (hash bbbbbbbbbbbb)"));
        CHECK(contains(message, "systems is kept as direct, stiff, given as direct, other"));
        CHECK(contains(message, "given as naturalness-practice (rating), naturalness (rating)"));
        CHECK(
            contains(message, "line 2 of the study file is kept as 'alpha = 0.01', given as 'alpha = 0.05'"));
        CHECK_FALSE(contains(message, "layouts"));
        CHECK_FALSE(store.storePlan(other, fixtures::registration(plan), plan));  // made for another study
        CHECK(store.participants() == std::vector<std::string>{"P01"});
    }

    TEST_CASE("A number belongs to one participant") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, fixtures::plan(study, "P01", 1));
        auto plan = fixtures::plan(study, "anna", 1);
        const auto rejected = store.storePlan(study, fixtures::registration(plan), plan);
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().message, "number 1: it is participant P01's"));
        plan.number = store.firstFreeNumber();
        CHECK(plan.number == 2);
        fixtures::store(store, study, plan);
    }

    TEST_CASE("Who is excluded, dropped out or declined does not count for the balance") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        Store store = fixtures::open(folder / "a.sqlite");
        for (const char* id : {"P01", "P02", "P03", "P04", "P05"}) {
            auto plan = fixtures::widePlan(study, id);
            plan.groups["style"] = id == std::string("P05") ? "lively" : "calm";
            fixtures::store(store, study, plan);
        }
        CHECK(store.groupsTaken() ==
              studies::GroupSizes{{{{"style", "calm"}}, 4}, {{{"style", "lively"}}, 1}});
        const auto run = [&](const char* id, const std::vector<studies::SessionEvent>& events,
                             SessionOutcome outcome) {
            const auto plan = *store.plan(id);
            store.beginSession(fixtures::session(id, false));
            for (const auto& event : events) store.record(event, study, plan, fixtures::clips(plan));
            store.endSession(outcome, 1.7e9 + 60.0);
        };
        run("P01", {studies::Note{studies::NoteKind::operator_abort, -1, {}, "felt sick"}},
            SessionOutcome::aborted);
        run("P02", {studies::Exclusion{"attention check failed: game, trial 6", {5.0, 1.7e9}}},
            SessionOutcome::finished);
        auto declined = fixtures::response(fixtures::widePlan(study, "P03").trials[0]);
        declined.answers = {{"consent", -1, 0.0}};
        run("P03", {declined}, SessionOutcome::declined);
        run("P04", {}, SessionOutcome::quit);
        CHECK(store.groupsTaken() ==
              studies::GroupSizes{{{{"style", "calm"}}, 1}, {{{"style", "lively"}}, 1}});
        CHECK(rows(folder / "a.sqlite", "SELECT id, status, reason FROM participants ORDER BY id") ==
              "P01|dropped|felt sick\nP02|excluded|attention check failed: game, trial 6\n"
              "P03|dropped|consent was declined\nP04|active|NULL\nP05|active|NULL\n");
        CHECK(rows(folder / "a.sqlite", "SELECT outcome FROM sessions ORDER BY id") ==
              "aborted\nfinished\ndeclined\nquit\n");
        CHECK(rows(folder / "a.sqlite", "SELECT kind, detail, utc_s FROM events WHERE kind = 'excluded'") ==
              "excluded|attention check failed: game, trial 6|1700000000.0\n");
    }

    TEST_CASE("The first session tells when somebody was registered") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, fixtures::plan(study, "P01", 1));
        auto session = fixtures::session("P01", false);
        for (const double start : {1.7e9, 1.8e9}) {
            session.started_utc_s = start;
            store.beginSession(session);
            store.endSession(SessionOutcome::quit, start + 1.0);
        }
        CHECK(rows(folder / "a.sqlite", "SELECT registered_utc_s FROM participants") == "1700000000.0\n");
    }
}
