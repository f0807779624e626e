#include "results/participants/participants.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "fixtures.hpp"
#include "results/store/participant_lock.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::Consent;
using results::excludeParticipant;
using results::includeParticipant;
using results::listParticipants;
using results::ParticipantStatus;
using results::showParticipant;
using results::Store;
using results::withdrawParticipant;
using studies::SessionOutcome;

namespace {

/// P01 went through a study of every kind of stage and was interrupted; P02 declined; P03 never came.
void makeDatabase(const std::filesystem::path& path) {
    const auto study = fixtures::wideStudy();
    Store store = fixtures::open(path);
    for (const char* id : {"P03", "P01", "P02"}) fixtures::store(store, study, fixtures::widePlan(study, id));
    const auto plan = fixtures::widePlan(study, "P01");
    const auto record = [&](const studies::SessionEvent& event, const studies::StudyPlan& of) {
        store.record(event, study, of, fixtures::clips(of));
    };
    const auto page = [](const studies::StudyPlan& of, std::size_t trial,
                         std::vector<studies::Answer> answers) {
        auto out = fixtures::response(of.trials[trial]);
        out.answers = std::move(answers);
        return out;
    };
    store.beginSession(fixtures::session("P01", false));
    record(page(plan, 0, {{"consent", -1, 1.0}}), plan);
    record(page(plan, 1, {{"age", -1, 34.0}, {"gender", -1, 1.0, "m"}}), plan);
    record(studies::Note{studies::NoteKind::pause, 5, {55.0, 1.7e9 + 55.0}, "headset taken off"}, plan);
    record(studies::Note{studies::NoteKind::stimulus_onset, 5, {56.0, 1.7e9 + 56.0}, "0"}, plan);
    record(fixtures::answer(plan.trials[5], 0), plan);
    record(studies::Superseded{5, "a phone rang", {60.0, 1.7e9 + 60.0}}, plan);
    record(fixtures::answer(plan.trials[5], 1), plan);
    auto failed = fixtures::answer(plan.trials[6], 0);
    failed.check_passed = false;
    record(failed, plan);
    auto skipped = fixtures::response(plan.trials[7]);
    skipped.status = studies::ResponseStatus::skipped;
    skipped.reason = "no sound";
    record(skipped, plan);
    store.endSession(SessionOutcome::quit, 1.7e9 + 600.0);
    const auto theirs = fixtures::widePlan(study, "P02");
    store.beginSession(fixtures::session("P02", true));
    record(page(theirs, 0, {{"consent", -1, 0.0}}), theirs);
    store.endSession(SessionOutcome::declined, 1.7e9 + 30.0);
}

}  // namespace

TEST_SUITE("results/participants") {
    TEST_CASE("Everybody is listed by number, with what is kept of them") {
        const fixtures::Folder folder;
        makeDatabase(folder / "a.sqlite");
        const auto list = listParticipants(folder / "a.sqlite");
        REQUIRE(list);
        CHECK(list->withdrawn == 0);
        REQUIRE(list->rows.size() == 3);
        const auto& first = list->rows[0];
        CHECK(first.id == "P01");
        CHECK(first.number == 1);
        CHECK(first.language == "en");
        CHECK(first.status == ParticipantStatus::active);
        CHECK(first.groups == studies::Groups{{"style", "calm"}});
        CHECK_FALSE(first.synthetic);
        CHECK(first.sessions == 1);
        CHECK(first.answered == 5);
        CHECK(first.planned == 10);
        CHECK(first.checks_failed == 1);
        CHECK(first.last_utc_s == 1.7e9 + 600.0);
        CHECK(first.consent == Consent::agreed);
        const auto& second = list->rows[1];
        CHECK(second.id == "P02");
        CHECK(second.status == ParticipantStatus::dropped);
        CHECK(second.reason == "consent was declined");
        CHECK(second.synthetic);
        CHECK(second.consent == Consent::declined);
        const auto& third = list->rows[2];
        CHECK(third.id == "P03");
        CHECK(third.sessions == 0);
        CHECK(third.last_utc_s == 0.0);
        CHECK(third.consent == Consent::not_asked);
    }

    TEST_CASE("One participant is told in lines for people") {
        const fixtures::Folder folder;
        makeDatabase(folder / "a.sqlite");
        const auto shown = showParticipant(folder / "a.sqlite", "P01");
        REQUIRE(shown);
        CHECK(shown->row.id == "P01");
        CHECK(shown->fields ==
              std::vector<std::pair<std::string, std::string>>{{"age", "34"}, {"gender", "m"}});
        CHECK(shown->sessions ==
              std::vector<std::string>{"1: 2023-11-14 22:13 UTC, desktop, quit after 10 min, 5 answered"});
        CHECK(shown->events ==
              std::vector<std::string>{"2023-11-14 22:14:15 pause in trial 5: headset taken off",
                                       "2023-11-14 22:14:20 answer of trial 5 superseded: a phone rang",
                                       "2023-11-14 22:14:34 trial 7 skipped: no sound"});
    }

    TEST_CASE("Exclusion takes a reason, inclusion undoes it, and nothing is lost") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        makeDatabase(path);
        for (const char* reason : {"", "  \n"}) {
            const auto rejected = excludeParticipant(path, "P01", reason);
            REQUIRE_FALSE(rejected);
            CHECK(contains(rejected.error().message, "without a reason"));
        }
        REQUIRE(excludeParticipant(path, "P01", "knew the systems"));
        CHECK(showParticipant(path, "P01")->row.status == ParticipantStatus::excluded);
        CHECK(showParticipant(path, "P01")->row.reason == "knew the systems");
        CHECK(showParticipant(path, "P01")->row.answered == 5);
        CHECK(fixtures::open(path).groupsTaken() == studies::GroupSizes{{{{"style", "calm"}}, 1}});  // P03
        const auto included = includeParticipant(path, "P01", 1.7e9 + 900.0);
        REQUIRE(included);
        CHECK_FALSE(included->consent_asked_anew);
        CHECK(included->practice.empty());
        CHECK(included->failed_checks_forgiven == 1);
        CHECK(showParticipant(path, "P01")->row.status == ParticipantStatus::active);
        CHECK(showParticipant(path, "P01")->row.reason.empty());
        CHECK(fixtures::open(path).groupsTaken() == studies::GroupSizes{{{{"style", "calm"}}, 2}});
    }

    TEST_CASE("Whoever declined is let in only to be asked again, and does not count before agreeing") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        makeDatabase(path);
        const auto study = fixtures::wideStudy();
        const auto theirs = fixtures::widePlan(study, "P02");
        const auto countsTaken = [&] {
            int count = 0;
            for (const auto& cell : fixtures::open(path).groupsTaken()) count += cell.second;
            return count;
        };
        const auto consent = [&](double given) {
            Store store = fixtures::open(path);
            store.beginSession(fixtures::session("P02", true));
            auto response = fixtures::response(theirs.trials[0]);
            response.answers = {{"consent", -1, given}};
            store.record(response, study, theirs, fixtures::clips(theirs));
        };
        const auto row = [&] { return showParticipant(path, "P02")->row; };
        CHECK_FALSE(results::mayTakePart(row()));
        CHECK(row().answered == 0);
        CHECK(countsTaken() == 2);
        for (const double given : {0.0, 1.0}) {
            CAPTURE(given);
            const auto included = includeParticipant(path, "P02", 1.7e9 + 900.0);
            REQUIRE(included);
            CHECK(included->consent_asked_anew);
            CHECK(results::mayTakePart(row()));
            CHECK(row().status == ParticipantStatus::dropped);
            CHECK(row().reason == "consent was declined; it is asked anew");
            CHECK(fixtures::open(path).resume("P02", 1.8e9).answered.empty());
            CHECK(countsTaken() == 2);
            consent(given);
            CHECK(results::mayTakePart(row()) == (given == 1.0));
            CHECK(row().status == (given == 1.0 ? ParticipantStatus::active : ParticipantStatus::dropped));
            CHECK(row().consent == (given == 1.0 ? Consent::agreed : Consent::declined));
            CHECK(countsTaken() == (given == 1.0 ? 3 : 2));
        }
        // What an earlier version, or anybody's SQL, left: the status alone lets nobody in.
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE consents SET agreed = 0 WHERE participant = 'P02'");
        CHECK(row().status == ParticipantStatus::dropped);
        CHECK(row().reason == "consent was declined");
        CHECK_FALSE(results::mayTakePart(row()));
        CHECK(countsTaken() == 2);
    }

    TEST_CASE("Inclusion forgives failed checks and begins a failed practice again, and keeps the answers") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);  // trial 0 is practice, the others are not
        {
            Store store = fixtures::open(path);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", false));
            auto practised = fixtures::answer(plan.trials[0], 1);
            practised.exclusion = "practice failed: naturalness-practice";
            store.record(practised, study, plan, fixtures::clips(plan));
            store.endSession(SessionOutcome::excluded, 1.7e9 + 60.0);
            CHECK(store.resume("P01", 1.8e9).answered == std::map<int, bool>{{0, true}});
        }
        const auto included = includeParticipant(path, "P01", 1.7e9 + 900.0);
        REQUIRE(included);
        CHECK(included->practice == std::vector<std::string>{"naturalness-practice"});
        CHECK(showParticipant(path, "P01")->row.status == ParticipantStatus::active);
        CHECK(showParticipant(path, "P01")->events ==
              std::vector<std::string>{
                  "2023-11-14 22:13:24 excluded: practice failed: naturalness-practice",
                  "2023-11-14 22:28:20 answer of trial 0 superseded: the practice begins anew",
                  "2023-11-14 22:28:20 included: practice failed: naturalness-practice"});
        Store store = fixtures::open(path);
        const auto resumed = store.resume("P01", 1.7e9 + 1000.0);
        CHECK(resumed.answered.empty());
        CHECK_MESSAGE(resumed.gap_s == 940.0, "the inclusion is no sitting");
        // A check that fails from now on counts, one forgiven does not.
        store.beginSession(fixtures::session("P01", false));
        auto failed = fixtures::answer(plan.trials[1], 1);
        failed.check_passed = false;
        store.record(failed, study, plan, fixtures::clips(plan));
        store.endSession(SessionOutcome::quit, 1.7e9 + 1100.0);
        CHECK(store.resume("P01", 1.8e9).check_failures.size() == 1);
        REQUIRE(excludeParticipant(path, "P01", "why not"));
        CHECK(includeParticipant(path, "P01", 1.7e9 + 1200.0)->failed_checks_forgiven == 1);
        CHECK(store.resume("P01", 1.8e9).check_failures.empty());
    }

    TEST_CASE("Nobody is let in while a session of theirs runs") {
        const fixtures::Folder folder;
        makeDatabase(folder / "a.sqlite");
        const auto lock = results::ParticipantLock::take(folder / "a.sqlite", "P01");
        REQUIRE(lock);
        const auto rejected = includeParticipant(folder / "a.sqlite", "P01", 0.0);
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().message, "already being run"));
    }

    TEST_CASE("Somebody unknown and a database that is not there are told by name, and none is made") {
        const fixtures::Folder folder;
        makeDatabase(folder / "a.sqlite");
        const auto here = folder / "a.sqlite";
        for (const auto& message : {showParticipant(here, "P09").error().message,
                                    includeParticipant(here, "P09", 0.0).error().message,
                                    excludeParticipant(here, "P09", "why").error().message,
                                    withdrawParticipant(here, "P09", 0.0).error().message})
            CHECK(message == "there is no participant P09");
        const auto nowhere = folder / "nowhere.sqlite";
        CHECK(contains(listParticipants(nowhere).error().message, "no such file"));
        CHECK(contains(showParticipant(nowhere, "P01").error().message, "no such file"));
        CHECK(contains(excludeParticipant(nowhere, "P01", "why").error().message, "no such file"));
        CHECK(contains(includeParticipant(nowhere, "P01", 0.0).error().message, "no such file"));
        CHECK(contains(withdrawParticipant(nowhere, "P01", 0.0).error().message, "no such file"));
        CHECK_FALSE(std::filesystem::exists(nowhere));
    }

    TEST_CASE("A list can be had while a session writes") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
        store.record(fixtures::answer(plan.trials[1], 3), study, plan, fixtures::clips(plan));
        CHECK(listParticipants(folder / "a.sqlite")->rows.at(0).answered == 1);
        store.record(fixtures::answer(plan.trials[2], 1), study, plan, fixtures::clips(plan));
        CHECK(listParticipants(folder / "a.sqlite")->rows.at(0).answered == 2);
    }
}
