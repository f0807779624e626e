#include "results/store/recording_thread.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

#include "fixtures.hpp"

using namespace deixis;
using results::RecordingOptions;
using results::RecordingThread;
using results::Store;

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

studies::Note note(studies::NoteKind kind, int trial_index = -1, std::string detail = {}) {
    return {kind, trial_index, {1.0, 1.7e9}, std::move(detail)};
}

/// A session of P01 with a thread that keeps it.
struct Recorded {
    fixtures::Folder folder;
    studies::Study study = fixtures::study({"direct"});
    studies::StudyPlan plan = fixtures::plan(study, "P01", 5);
    Store store = fixtures::open(folder / "a.sqlite");
    std::optional<RecordingThread> thread;

    explicit Recorded(const RecordingOptions& options = {}) {
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
        thread.emplace(store, study, plan, fixtures::clips(plan), options);
    }
    [[nodiscard]] studies::Response answer(std::size_t trial, int value) const {
        return fixtures::answer(plan.trials[trial], value);
    }
    [[nodiscard]] int number(const std::string& query) const {
        return SQLite::Database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY, 1000)
            .execAndGet(query)
            .getInt();
    }
    /// How many frames are kept.
    [[nodiscard]] int frames(const std::string& where = "") const {
        return number("SELECT coalesce(sum(frames), 0) FROM tracking_blocks " + where);
    }
    [[nodiscard]] std::string text(const std::string& query) const {
        return SQLite::Database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY, 1000)
            .execAndGet(query)
            .getString();
    }
};

/// Waits as a session does; false after 20 s.
bool eventuallyKept(const RecordingThread& thread) {
    const auto begin = Clock::now();
    while (!thread.allKept()) {
        if (secondsSince(begin) > 20.0) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

}  // namespace

TEST_SUITE("results/recording thread") {
    TEST_CASE("Once all is kept, another connection sees the answer") {
        Recorded session;
        CHECK(session.thread->allKept());
        for (std::size_t trial = 1; trial <= 5; ++trial) {
            session.thread->record(session.answer(trial, static_cast<int>(trial)));
            REQUIRE(eventuallyKept(*session.thread));
            CHECK(session.number("SELECT value FROM answers ORDER BY response DESC LIMIT 1") ==
                  static_cast<int>(trial));
        }
    }

    TEST_CASE("An answer is not called kept before it is written") {
        Recorded session(RecordingOptions{4096, 0.3});
        session.thread->record(session.answer(1, 4));
        CHECK_FALSE(session.thread->allKept());
        CHECK(session.number("SELECT count(*) FROM responses") == 0);
        REQUIRE(eventuallyKept(*session.thread));
        CHECK(session.number("SELECT count(*) FROM responses") == 1);
    }

    TEST_CASE("Events are kept in the order in which they were handed over, and none is dropped") {
        Recorded session;
        std::string expected;
        for (int i = 0; i < 500; ++i) {
            session.thread->record(note(studies::NoteKind::operator_note, -1, "n" + std::to_string(i)));
            expected += (i > 0 ? "," : "") + ("n" + std::to_string(i));
        }
        session.thread->finish();
        CHECK(session.text("SELECT group_concat(detail) FROM (SELECT detail FROM events ORDER BY id)") ==
              expected);
        CHECK(session.thread->allKept());
    }

    TEST_CASE(
        "Samples go to practice trials, to trials and to what is between them; each trial has a tally") {
        Recorded session;
        std::uint64_t number = 0;
        const auto frames = [&](int trial_index, int count) {
            for (int i = 0; i < count; ++i) {
                auto sample = fixtures::frame(++number);
                sample.dropped_frames = i == 2 ? 2 : 0;
                sample.off_place_m = 0.01 * static_cast<double>(number % 50);
                sample.head.tracked = i % 10 != 0;
                session.thread->sample(std::move(sample), trial_index);
            }
        };
        frames(-1, 30);
        frames(0, 100);  // practice
        frames(-1, 20);
        frames(1, 40);
        frames(2, 60);  // at once after trial 1
        session.thread->record(session.answer(2, 3));
        session.thread->finish();

        CHECK(session.frames() == 250);
        CHECK(session.frames("WHERE trial_index IS NULL") == 50);
        CHECK(session.frames("WHERE trial_index = 0") == 100);
        CHECK(session.number(
                  "SELECT max(first_frame + frames) - 1 FROM tracking_blocks WHERE trial_index = 0") == 130);
        CHECK(session.text(
                  "SELECT group_concat(trial_index || ':' || frames || ':' || dropped_frames || ':' || "
                  "samples_missing || ':' || head_untracked_frames, ' ') FROM trial_tracking") ==
              "0:100:2:0:10 1:40:2:0:4 2:60:2:0:6");
        // Practice had frames 31 to 130, and was farthest off at 49 and 99; trial 1 had 151 to 190.
        CHECK(session.number(
                  "SELECT round(100 * max_off_place_m) FROM trial_tracking WHERE trial_index = 0") == 49);
        CHECK(session.number(
                  "SELECT round(90 * first_display_time_s) = 151 AND "
                  "round(90 * last_display_time_s) = 190 FROM trial_tracking WHERE trial_index = 1") == 1);
        CHECK(session.number("SELECT dropped_frames FROM responses_flat WHERE trial_index = 2") == 2);
    }

    TEST_CASE("Samples and tallies are kept soon, without anything else happening") {
        Recorded session;
        session.thread->sample(fixtures::frame(1), 1);
        session.thread->sample(fixtures::frame(2), -1);
        const auto begin = Clock::now();
        while (session.frames() < 2 && secondsSince(begin) < 20.0)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        CHECK(session.frames() == 2);
        CHECK(session.number("SELECT frames FROM trial_tracking WHERE trial_index = 1") == 1);
    }

    TEST_CASE(
        "The session goes on while the store is slow, and the trial says how many samples are missing") {
        const double delay_s = 1.0;
        Recorded session(RecordingOptions{100, delay_s});
        const auto begin = Clock::now();
        for (std::uint64_t i = 1; i <= 600; ++i) session.thread->sample(fixtures::frame(i), 1);
        for (std::uint64_t i = 601; i <= 1000; ++i) session.thread->sample(fixtures::frame(i), 2);
        session.thread->record(session.answer(2, 3));
        CHECK(secondsSince(begin) < delay_s / 2);
        session.thread->finish();

        const int first = session.frames("WHERE trial_index = 1");
        const int second = session.frames("WHERE trial_index = 2");
        CHECK(first >= 100);
        CHECK(first + second < 600);
        CHECK(session.number("SELECT samples_missing FROM trial_tracking WHERE trial_index = 1") ==
              600 - first);
        CHECK(session.number("SELECT samples_missing FROM trial_tracking WHERE trial_index = 2") ==
              400 - second);
        CHECK(session.number("SELECT sum(frames) FROM trial_tracking") == 1000);
        CHECK(session.number("SELECT samples_missing FROM responses_flat") == 400 - second);
        // The first to come are kept.
        CHECK(
            session.number(
                "SELECT sum(min(frames, 101 - first_frame)) FROM tracking_blocks WHERE first_frame <= 100") ==
            100);

        // And there is room again.
        session.thread->sample(fixtures::frame(1001), 3);
        session.thread->finish();
        CHECK(session.number("SELECT samples_missing FROM trial_tracking WHERE trial_index = 3") == 0);
        CHECK(session.frames("WHERE first_frame = 1001") == 1);
    }

    TEST_CASE("An answer overtakes samples that wait") {
        Recorded session(RecordingOptions{4096, 0.2});
        for (std::uint64_t i = 1; i <= 640; ++i) session.thread->sample(fixtures::frame(i), 1);
        session.thread->record(session.answer(1, 3));
        REQUIRE(eventuallyKept(*session.thread));
        CHECK(session.number("SELECT count(*) FROM responses") == 1);
        CHECK(session.frames() < 640);
    }

    TEST_CASE("What goes wrong beside the session is thrown into it, and what was kept before stands") {
        Recorded session;
        session.thread->record(session.answer(1, 4));
        REQUIRE(eventuallyKept(*session.thread));
        session.thread->record(session.answer(1, 5));  // a trial can be answered once
        CHECK_THROWS_AS(eventuallyKept(*session.thread), SQLite::Exception);
        CHECK_THROWS_AS(session.thread->record(session.answer(2, 5)), SQLite::Exception);
        CHECK_THROWS_AS(session.thread->sample(fixtures::frame(1), 2), SQLite::Exception);
        CHECK_THROWS_AS(session.thread->finish(), SQLite::Exception);
        session.thread.reset();
        CHECK(session.number("SELECT group_concat(cast(value AS INTEGER)) FROM answers") == 4);
        // The store is its owner's again.
        session.store.endSession(studies::SessionOutcome::quit, 1.7e9 + 9.0);
        CHECK(session.text("SELECT outcome FROM sessions") == "quit");
    }

    TEST_CASE("A failure that comes while the end is waited for is thrown there") {
        Recorded session(RecordingOptions{4096, 0.1});
        session.thread->record(session.answer(1, 4));
        session.thread->record(session.answer(1, 5));
        CHECK_THROWS_AS(session.thread->finish(), SQLite::Exception);
    }

    TEST_CASE("A thread that is destroyed writes what it was given") {
        Recorded session(RecordingOptions{4096, 0.05});
        for (std::uint64_t i = 1; i <= 10; ++i) session.thread->sample(fixtures::frame(i), 1);
        session.thread->record(session.answer(1, 4));
        session.thread->record(note(studies::NoteKind::quit));
        session.thread.reset();
        CHECK(session.number("SELECT count(*) FROM responses") == 1);
        CHECK(session.number("SELECT count(*) FROM events") == 1);
        CHECK(session.number("SELECT frames FROM trial_tracking") == 10);
        CHECK(session.frames() == 10);
    }

    TEST_CASE("Every answer that was called kept survives the process, killed amid writing") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 200);
        int kept[2];
        REQUIRE(::pipe(kept) == 0);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            Store store = fixtures::open(path);
            if (!store.storePlan(study, fixtures::registration(plan), plan)) ::_exit(1);
            store.beginSession(fixtures::session("P01", false));
            RecordingThread thread(store, study, plan, fixtures::clips(plan), {});
            std::uint64_t frame = 0;
            for (std::size_t trial = 1; trial < plan.trials.size(); ++trial) {
                for (int i = 0; i < 100; ++i)
                    thread.sample(fixtures::frame(++frame), static_cast<int>(trial));
                thread.record(fixtures::answer(plan.trials[trial], 1));
                while (!thread.allKept()) std::this_thread::yield();
                if (::write(kept[1], "x", 1) != 1) ::_exit(1);
            }
            for (;;) ::pause();
        }
        ::close(kept[1]);
        int acknowledged = 0;
        char byte = 0;
        while (acknowledged < 20 && ::read(kept[0], &byte, 1) == 1) ++acknowledged;
        ::kill(child, SIGKILL);
        while (::read(kept[0], &byte, 1) == 1) ++acknowledged;
        ::close(kept[0]);
        int status = 0;
        ::waitpid(child, &status, 0);
        REQUIRE(WIFSIGNALED(status));
        REQUIRE(acknowledged >= 20);

        const auto answered = fixtures::open(path).resume("P01", 1.8e9).answered;
        for (int trial = 1; trial <= acknowledged; ++trial) CHECK(answered.contains(trial));
        // At most the one that was on its way is there beyond them.
        CHECK(static_cast<int>(answered.size()) <= acknowledged + 1);
        SQLite::Database reader(path.string());
        CHECK(reader.execAndGet("PRAGMA integrity_check").getString() == "ok");
    }
}
