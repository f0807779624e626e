// What happens in a session, as the store keeps it, and what a later session is told of it.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "fixtures.hpp"

using namespace deixis;
using results::Store;
using studies::Response;
using studies::ResponseStatus;
using studies::SessionOutcome;

namespace {

/// A session of P01 in a study of every kind of stage.
struct Wide {
    fixtures::Folder folder;
    studies::Study study = fixtures::wideStudy();
    studies::StudyPlan plan = fixtures::widePlan(study, "P01");
    Store store = fixtures::open(folder / "a.sqlite");

    Wide() {
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
    }
    [[nodiscard]] Response response(std::size_t trial, std::vector<studies::Answer> answers) const {
        Response out = fixtures::response(plan.trials.at(trial));
        out.answers = std::move(answers);
        return out;
    }
    void record(const studies::SessionEvent& event) {
        store.record(event, study, plan, fixtures::clips(plan));
    }
    [[nodiscard]] std::string rows(const std::string& query) const {
        SQLite::Database database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY, 1000);
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
};

constexpr const char* answers_of_all =
    "SELECT r.trial_index, a.position, question, stimulus, value, text FROM answers AS a JOIN responses AS r "
    "ON r.id = a.response ORDER BY r.id, a.position";

}  // namespace

TEST_SUITE("results/store answers") {
    TEST_CASE("A response is kept with everything that was shown and done") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        const auto plan = fixtures::plan(study, "P01", 1);
        {
            Store store = fixtures::open(folder / "a.sqlite");
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", true));
            store.record(studies::Note{studies::NoteKind::stage_start, -1, {1.0, 1.7e9 + 1.0}, "game"}, study,
                         plan, fixtures::clips(plan));
            auto response = fixtures::answer(plan.trials[1], 4);
            response.replays = 1;
            response.plays = {2};
            response.input = "key";
            store.record(response, study, plan, fixtures::clips(plan));
            auto choice = fixtures::answer(plan.trials[4], 0);
            choice.pauses = 2;
            choice.paused_s = 7.5;
            choice.begun_before = true;
            choice.viewer = {0.25, 2.5, 170.0};  // not the layout's own place
            store.record(choice, study, plan, fixtures::clips(plan));
            store.endSession(SessionOutcome::quit, 1.7e9 + 99.0);
        }
        SQLite::Database database((folder / "a.sqlite").string());
        SQLite::Statement row(database, "SELECT * FROM responses_flat");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("participant").getString() == "P01");
        CHECK(row.getColumn("participant_status").getString() == "active");
        CHECK(row.getColumn("trial_index").getInt() == 1);
        CHECK(row.getColumn("stage").getString() == "naturalness");
        CHECK(row.getColumn("kind").getString() == "rating");
        CHECK(row.getColumn("status").getString() == "answered");
        CHECK(row.getColumn("system").getString() == "direct");
        CHECK(row.getColumn("scored").getInt() == 1);
        CHECK(row.getColumn("question").getString() == "rating");
        CHECK(row.getColumn("value").getDouble() == 4.0);
        CHECK(row.getColumn("correct").isNull());
        CHECK(row.getColumn("balls").isNull());
        CHECK(row.getColumn("replays").getInt() == 1);
        CHECK(row.getColumn("plays").getInt() == 2);
        CHECK(row.getColumn("input").getString() == "key");
        CHECK(row.getColumn("begun_before").getInt() == 0);
        CHECK(row.getColumn("ray_x_m").isNull());
        CHECK(row.getColumn("synthetic").getInt() == 1);
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("stage").getString() == "game");
        CHECK(row.getColumn("kind").getString() == "referential-game");
        CHECK(row.getColumn("system").getString() == "stiff");
        CHECK(row.getColumn("layout").getString() == "across");
        CHECK(row.getColumn("distance").getString() == "near");
        CHECK(row.getColumn("viewer_x_m").getDouble() == 0.25);
        CHECK(row.getColumn("viewer_z_m").getDouble() == 2.5);
        CHECK(row.getColumn("heading_deg").getDouble() == 170.0);
        CHECK(row.getColumn("question").isNull());
        CHECK(row.getColumn("chosen_place").getInt() == 2);
        CHECK(row.getColumn("target_place").getInt() == 1);
        CHECK(row.getColumn("correct").getInt() == 0);
        CHECK(row.getColumn("pauses").getInt() == 2);
        CHECK(row.getColumn("paused_s").getDouble() == 7.5);
        CHECK(row.getColumn("begun_before").getInt() == 1);
        CHECK(row.getColumn("dropped_frames").isNull());  // nothing was tracked
        CHECK(row.getColumn("target_y_m").getDouble() == 1.25);
        CHECK(row.getColumn("distractors").getString() == "[[0.3,1.5,0.5],[-0.3,1,0.5]]");
        // Shown in the order 2, 0, 1: the second distractor, the target, the first distractor.
        CHECK(row.getColumn("balls").getString() == "[[-0.3,1,0.5],[0,1.25,0.75],[0.3,1.5,0.5]]");
        CHECK(row.getColumn("clip_file").getString() == "stiff-T000.bvh");
        CHECK(row.getColumn("clip_hash").getString() == std::string(64, 'c'));
        CHECK(row.getColumn("onset_s").getDouble() == 40.0);
        CHECK(row.getColumn("motion_end_s").getDouble() == 43.0);
        CHECK(row.getColumn("answered_s").getDouble() == 44.25);
        CHECK(row.getColumn("answered_utc").getString() == "2023-11-14T22:14:04.250Z");
        CHECK(row.getColumn("response_time_s").getDouble() == 1.25);
        CHECK(row.getColumn("head_y_m").getDouble() == 1.65);
        CHECK(row.getColumn("head_qw").getDouble() == 1.0);
        CHECK(row.getColumn("ray_dz").getDouble() == -1.0);
        CHECK_FALSE(row.executeStep());
        CHECK(database.execAndGet("SELECT kind || ' ' || detail FROM events").getString() ==
              "stage_start game");
        CHECK(database.execAndGet("SELECT trial_index IS NULL FROM events").getInt() == 1);
        CHECK(database.execAndGet("SELECT outcome FROM sessions").getString() == "quit");
        CHECK(database.execAndGet("SELECT seed FROM plans").getString() == "18446744073709551615");
        CHECK(database.execAndGet("PRAGMA journal_mode").getString() == "wal");
        CHECK(database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() == 0);
        CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
    }

    TEST_CASE("Answers of every kind are kept as they were given") {
        Wide db;
        db.record(db.response(3, {{"rating", 0, 80.0}, {"rating", 1, 15.0}}));
        db.record(db.response(4, {{"preference", -1, -2.0}, {"reasons", -1, {}, "speed;arm"}}));
        auto choice = db.response(5, {{"confidence", -1, 6.0}});
        choice.values = {{"chosen_place", 1, {}}, {"correct", 1, {}}};
        db.record(choice);
        db.record(db.response(9, {{"effort", -1, 12.0}, {"calm", -1, 3.0}}));
        CHECK(db.rows(answers_of_all) ==
              "3|0|rating|0|80.0|NULL\n3|1|rating|1|15.0|NULL\n4|0|preference|NULL|-2.0|NULL\n"
              "4|1|reasons|NULL|NULL|speed;arm\n5|0|confidence|NULL|6.0|NULL\n9|0|effort|NULL|12.0|NULL\n"
              "9|1|calm|NULL|3.0|NULL\n");
        // Each rating beside its own system and clip; a pair's preference beside the one on the left.
        CHECK(db.rows("SELECT trial_index, question, system, item, value, clip_file FROM responses_flat") ==
              "3|rating|stiff|T001|80.0|stiff-T001.bvh\n3|rating|direct|T001|15.0|direct-T001.bvh\n"
              "4|preference|direct|T002|-2.0|NULL\n4|reasons|direct|T002|NULL|NULL\n"
              "5|confidence|direct|T003|6.0|direct-T003.bvh\n9|effort|NULL|NULL|12.0|NULL\n"
              "9|calm|NULL|NULL|3.0|NULL\n");
        CHECK(db.rows("SELECT count(*) FROM response_stimuli") == "5\n");
    }

    TEST_CASE("A consent is kept with the words that were agreed to") {
        Wide db;
        db.record(db.response(0, {{"consent", -1, 1.0}}));
        CHECK(db.rows("SELECT participant, stage, agreed, utc_s, language, text FROM consents") ==
              "P01|consent|1|1700000004.25|en|I take part of my own will.\n");
    }

    TEST_CASE("Who declines is a drop-out with the answer itself, and is asked again until agreeing") {
        Wide db;
        const auto state = [&] {
            return db.rows("SELECT status, reason FROM participants") +
                   db.rows("SELECT session, agreed FROM consents ORDER BY session") +
                   db.rows("SELECT superseded FROM responses ORDER BY id");
        };
        db.record(db.response(0, {{"consent", -1, 0.0}}));
        // As after a kill: the session has not ended.
        CHECK(state() == "dropped|consent was declined\n1|0\nNULL\n");
        CHECK_MESSAGE(db.store.resume("P01", 1.7e9).answered.empty(), "it is asked anew");
        db.store.beginSession(fixtures::session("P01", false));
        db.record(db.response(0, {{"consent", -1, 0.0}}));
        CHECK(state() == "dropped|consent was declined\n1|0\n2|0\nconsent was asked anew\nNULL\n");
        db.store.beginSession(fixtures::session("P01", false));
        db.record(db.response(0, {{"consent", -1, 1.0}}));
        CHECK(state() ==
              "active|NULL\n1|0\n2|0\n3|1\nconsent was asked anew\nconsent was asked anew\nNULL\n");
        CHECK(db.store.resume("P01", 1.7e9).answered == std::map<int, bool>{{0, true}});
    }

    TEST_CASE("An exclusion is kept with the answer that it follows from, an abort with its note") {
        Wide db;
        auto failed = fixtures::answer(db.plan.trials[6], 0);
        failed.check_passed = false;
        failed.exclusion = "attention check failed: game, trial 6";
        db.record(failed);
        CHECK(db.rows("SELECT status, reason FROM participants") ==
              "excluded|attention check failed: game, trial 6\n");
        CHECK(db.rows("SELECT kind, detail FROM events") ==
              "excluded|attention check failed: game, trial 6\n");
        Wide other;
        other.record(studies::Note{studies::NoteKind::operator_abort, -1, {1.0, 1.7e9}, ""});
        CHECK(other.rows("SELECT status, reason FROM participants") ==
              "dropped|the operator ended the session\n");
    }

    TEST_CASE("Pages about the participant become the participant's fields") {
        Wide db;
        db.record(db.response(1, {{"age", -1, 34.0}, {"gender", -1, 1.0, "m"}}));
        db.record(db.response(2, {{"remark", -1, {}, "none; \"really\""}}));
        CHECK(db.rows("SELECT * FROM participant_fields ORDER BY field") ==
              "P01|age|34.0|NULL\nP01|gender|1.0|m\nP01|remark|NULL|none; \"really\"\n");
        db.record(db.response(9, {{"effort", -1, 12.0}}));  // no page about the participant
        CHECK(db.rows("SELECT count(*) FROM participant_fields") == "3\n");
    }

    TEST_CASE("A trial that was timed out or skipped has no choice, and says why") {
        Wide db;
        auto late = db.response(5, {});
        late.status = ResponseStatus::timed_out;
        late.input.clear();
        db.record(late);
        auto skipped = db.response(6, {});
        skipped.status = ResponseStatus::skipped;
        skipped.reason = "the avatar was hidden";
        db.record(skipped);
        CHECK(db.rows("SELECT trial_index, status, reason, (SELECT count(*) FROM response_values), input "
                      "FROM responses") == "5|timed_out|NULL|0|\n6|skipped|the avatar was hidden|0|ray\n");
        CHECK(db.rows("SELECT trial_index, status, question FROM responses_flat") ==
              "5|timed_out|NULL\n6|skipped|NULL\n");
        CHECK(db.store.resume("P01", 1.8e9).answered == std::map<int, bool>{{5, false}, {6, false}});
    }

    TEST_CASE("An answer done again is kept and marked, and the later one counts") {
        Wide db;
        db.record(fixtures::answer(db.plan.trials[5], 0));
        CHECK(db.store.resume("P01", 1.8e9).answered == std::map<int, bool>{{5, false}});
        db.record(studies::Superseded{5, "a phone rang", {50.0, 1.7e9 + 50.0}});
        CHECK(db.store.resume("P01", 1.8e9).answered.empty());
        db.record(fixtures::answer(db.plan.trials[5], 1));
        CHECK(db.store.resume("P01", 1.8e9).answered == std::map<int, bool>{{5, true}});
        CHECK(
            db.rows(
                "SELECT correct, superseded, superseded_utc_s FROM responses AS r JOIN game_choices AS g ON "
                "g.response = r.id ORDER BY id") == "0|a phone rang|1700000050.0\n1|NULL|NULL\n");
        CHECK(db.rows("SELECT correct FROM responses_flat") == "1\n");
        CHECK_THROWS_AS(db.record(studies::Superseded{6, "no answer yet", {}}), std::logic_error);
        CHECK(db.rows("SELECT count(*) FROM responses") == "2\n");
    }

    TEST_CASE("A response that cannot be kept whole is not kept at all") {
        Wide db;
        auto clips = fixtures::clips(db.plan);
        clips.erase({"direct", "T001"});
        const auto rated = db.response(3, {{"rating", 0, 80.0}, {"rating", 1, 15.0}});
        CHECK_THROWS_AS(db.store.record(rated, db.study, db.plan, clips), std::logic_error);
        CHECK(db.rows("SELECT count(*) FROM responses") == "0\n");
        CHECK(db.rows("SELECT count(*) FROM response_stimuli") == "0\n");
        db.record(rated);
        CHECK(db.rows("SELECT count(*) FROM answers") == "2\n");
    }

    TEST_CASE("A later session is told what was answered, begun and failed, and how long ago") {
        Wide db;
        auto failed = fixtures::answer(db.plan.trials[6], 0);
        failed.check_passed = false;
        db.record(failed);
        auto passed = fixtures::answer(db.plan.trials[8], 1);
        passed.check_passed = true;
        db.record(passed);
        auto number = db.response(7, {{"rating", 0, 50.0}, {"rating", 1, 9.0}});
        number.check_passed = false;
        db.record(number);
        const auto onset = [](int trial, double utc_s) {
            return studies::Note{studies::NoteKind::stimulus_onset, trial, {0.0, utc_s}, "0"};
        };
        db.record(onset(8, 1.7e9 + 80.0));
        db.record(onset(4, 1.7e9 + 100.0));  // begun, and broken off
        const auto soon = db.store.resume("P01", 1.7e9 + 160.0);
        CHECK(soon.answered == std::map<int, bool>{{6, false}, {7, true}, {8, true}});
        CHECK(soon.begun == std::set<int>{4});
        CHECK(soon.check_failures ==
              decltype(soon.check_failures){{{"appeal", studies::CheckKind::number}, 1},
                                            {{"game", studies::CheckKind::catch_trial}, 1}});
        CHECK(soon.gap_s == 60.0);
        db.store.endSession(SessionOutcome::quit, 1.7e9 + 130.0);
        CHECK(db.store.resume("P01", 1.7e9 + 160.0).gap_s == 30.0);
        CHECK(db.store.resume("P01", 1.7e9).gap_s == 0.0);  // a clock that was set back

        const auto other = fixtures::widePlan(db.study, "P02");
        fixtures::store(db.store, db.study, other);
        const auto nothing = db.store.resume("P02", 1.8e9);
        CHECK(nothing.answered.empty());
        CHECK(nothing.begun.empty());
        CHECK(nothing.check_failures.empty());
        CHECK(nothing.gap_s == 0.0);
    }

    TEST_CASE("A later session is told the first answers to what is repeated as a check") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        const auto plan = fixtures::widePlan(study, "P01");
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
        CHECK(store.resume("P01", 1.7e9).first_answers.empty());
        auto choice = fixtures::answer(plan.trials[5], 1);  // trial 8 repeats it
        choice.answers = {{"confidence", -1, 6.0}};
        store.record(choice, study, plan, fixtures::clips(plan));
        store.record(fixtures::answer(plan.trials[6], 1), study, plan, fixtures::clips(plan));
        const auto kept = store.resume("P01", 1.7e9).first_answers;
        REQUIRE(kept.size() == 1);
        CHECK(kept[0].trial_index == 5);
        CHECK(kept[0].status == studies::ResponseStatus::answered);
        CHECK(kept[0].chosenPlace() == choice.chosenPlace());
        REQUIRE(kept[0].answers.size() == 1);
        CHECK(kept[0].answers[0].value == 6.0);
        store.record(studies::Superseded{5, "noise", {1.0, 1.7e9}}, study, plan, fixtures::clips(plan));
        CHECK(store.resume("P01", 1.7e9).first_answers.empty());
    }

    TEST_CASE("The time that a unit takes is the median from its start to the next one's") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        Store store = fixtures::open(folder / "a.sqlite");
        const auto run = [&](const char* id, double trial_s, SessionOutcome outcome) {
            const auto plan = fixtures::plan(study, id, 5);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session(id, false));
            for (const auto& trial : plan.trials) {
                auto response = fixtures::answer(trial, 1);
                const double start = 1.7e9 + trial_s * trial.index;
                // The clip began 2 s before its last play did.
                store.record(studies::Note{studies::NoteKind::stimulus_onset, trial.index, {0.0, start}, "0"},
                             study, plan, fixtures::clips(plan));
                response.onset.utc_s = start + 2.0;
                response.answered.utc_s = start + 5.0;
                store.record(response, study, plan, fixtures::clips(plan));
            }
            store.endSession(outcome, 1.7e9 + 900.0);
        };
        CHECK(store.secondsPerUnit().empty());
        run("P01", 30.0, SessionOutcome::quit);
        CHECK(store.secondsPerUnit().empty());
        run("P02", 8.0, SessionOutcome::finished);
        const auto seconds = store.secondsPerUnit();
        REQUIRE(seconds.size() == 3);
        CHECK(seconds.at("naturalness") == 8.0);
        CHECK(seconds.at("game") == 8.0);
        CHECK(seconds.at("naturalness-practice") == 5.0);  // nothing after it in its stage: until its answer
        run("P03", 10.0, SessionOutcome::finished);
        run("P04", 12.0, SessionOutcome::finished);
        CHECK(store.secondsPerUnit().at("game") == 10.0);
    }
}
