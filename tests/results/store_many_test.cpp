// Many participants: who start at once, and who are in the database already.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "fixtures.hpp"
#include "results/participants/participants.hpp"
#include "results/store/store.hpp"

using namespace deixis;
using results::Durability;
using results::Store;

namespace {

// Steps of SQLite's machine in every connection of this process: what a query does, however fast. Only those
// of statements with the words count.
long long steps = 0;
const char* words = "";

int countSteps(unsigned /*what*/, void* /*context*/, void* statement, void* /*time*/) {
    auto* const done = static_cast<sqlite3_stmt*>(statement);
    const int taken = sqlite3_stmt_status(done, SQLITE_STMTSTATUS_VM_STEP, 1);
    const char* const sql = sqlite3_sql(done);
    if (sql != nullptr && std::string_view(sql).find(words) != std::string_view::npos) steps += taken;
    return 0;
}

int watch(sqlite3* database, const char** /*error*/, const sqlite3_api_routines* /*api*/) {
    return sqlite3_trace_v2(database, SQLITE_TRACE_PROFILE, countSteps, nullptr);
}

/// Counts while it lives.
class StepCount {
  public:
    explicit StepCount(const char* of = "") {
        steps = 0;
        words = of;
        sqlite3_auto_extension(reinterpret_cast<void (*)()>(watch));
    }
    ~StepCount() { sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(watch)); }
    StepCount(const StepCount&) = delete;
    StepCount& operator=(const StepCount&) = delete;
};

/// What a simulation asks the store for each participant, twice over as two sessions do.
void takePart(Store& store, const studies::Study& study, int number) {
    const auto plan = fixtures::plan(study, fmt::format("P{:04}", number), 2);
    REQUIRE_FALSE(store.numberTaken(number));
    (void)store.groupsTaken();
    fixtures::store(store, study, plan);
    (void)store.resume(plan.participant, 0.0);
    store.beginSession(fixtures::session(plan.participant, true));
    for (const auto& trial : plan.trials) {
        store.record(studies::Note{studies::NoteKind::stimulus_onset, trial.index, {}, ""}, study, plan,
                     fixtures::clips(plan));
        store.record(fixtures::answer(trial, 1), study, plan, fixtures::clips(plan));
    }
    store.endSession(studies::SessionOutcome::finished, 1.7e9 + 900.0);
    (void)store.resume(plan.participant, 2e9);
}

/// Child processes that wait until it is opened.
class Gate {
  public:
    Gate() { REQUIRE(::pipe(ends_) == 0); }
    ~Gate() { open(); }
    Gate(const Gate&) = delete;
    Gate& operator=(const Gate&) = delete;

    /// A process that then does the work, and ends with whether it did (succeeded()).
    pid_t behind(const std::function<bool()>& work) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child != 0) return child;
        ::close(ends_[1]);
        char byte = 0;
        (void)!::read(ends_[0], &byte, 1);  // ends when the parent closes its end
        ::_exit(work() ? 0 : 1);
    }
    void open() {
        for (int& end : ends_)
            if (end >= 0) ::close(std::exchange(end, -1));
    }

  private:
    int ends_[2]{-1, -1};
};

/// Waits for a process; whether it ended with success.
bool succeeded(pid_t child) {
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// A station's part of a hundred that start at once; says why where it cannot. Whoever is rejected is
/// rejected at once, or waits without end: how long a slow disk makes all hundred wait is no matter here (the
/// program waits for 30 s, which a disk that takes 0.1 s for each transaction exceeds).
bool begins(const std::filesystem::path& path, const studies::Study& study, const std::string& who) {
    constexpr std::chrono::minutes patience{10};
    try {
        const auto plan = fixtures::plan(study, who, 1);
        auto store = Store::open(path, Durability::each_answer, patience);
        if (!store) throw std::runtime_error(store.error().text());
        if (auto stored = store->storePlan(study, fixtures::registration(plan), plan); !stored)
            throw std::runtime_error(stored.error().text());
        store->beginSession(fixtures::session(plan.participant, false));
        store->record(fixtures::answer(plan.trials[0], 1), study, plan, fixtures::clips(plan));
        return true;
    } catch (const std::exception& problem) {
        fmt::print(stderr, "{}: {}\n", who, problem.what());
        return false;
    }
}

}  // namespace

TEST_SUITE("results/store many") {
    TEST_CASE("A hundred participants who start at once on a new database all begin their session") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        constexpr int stations = 100;
        Gate gate;
        std::vector<pid_t> children;
        for (int i = 1; i <= stations; ++i)
            children.push_back(gate.behind([&] { return begins(path, study, fmt::format("P{:03}", i)); }));
        gate.open();
        int failed = 0;
        for (const pid_t child : children) failed += succeeded(child) ? 0 : 1;
        CHECK(failed == 0);
        CHECK(SQLite::Database(path.string()).execAndGet("SELECT count(*) FROM responses").getInt() ==
              stations);
    }

    TEST_CASE("Whoever waits while the machine stands still waits on when it goes on") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        constexpr std::chrono::milliseconds before{300}, stopped{3000}, after{1500}, patience{2600};
        Gate gate;
        // Before this process opens the database: locks are a process's own, and SQLite remembers them.
        const pid_t child = gate.behind([&] {
            const auto opened = Store::open(path, Durability::each_answer, patience);
            if (!opened) fmt::print(stderr, "{}\n", opened.error().text());
            return opened.has_value();
        });
        { const Store made = fixtures::open(path, Durability::each_answer); }
        std::optional<SQLite::Database> other(std::in_place, path.string(), SQLite::OPEN_READWRITE);
        other->exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE");
        gate.open();
        std::this_thread::sleep_for(before);
        ::kill(child, SIGSTOP);  // to the child it is as if the machine stood still
        std::this_thread::sleep_for(stopped);
        ::kill(child, SIGCONT);
        std::this_thread::sleep_for(after);
        other.reset();
        CHECK(succeeded(child));
    }

    TEST_CASE("What a further participant costs does not grow with those who are there") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        const StepCount count;
        Store store = fixtures::open(folder / "a.sqlite", Durability::whole_run);
        int number = 0;
        const auto stepsOfTen = [&] {
            const long long before = steps;
            for (int i = 0; i < 10; ++i) takePart(store, study, ++number);
            return static_cast<double>(steps - before);
        };
        (void)stepsOfTen();  // the study itself is stored with the first
        const double first = stepsOfTen();
        while (number < 200) takePart(store, study, ++number);
        const double last = stepsOfTen();
        CHECK(first > 10'000);
        CHECK(last < 1.1 * first);
        store.commit();
    }

    TEST_CASE(
        "Nor does looking at one participant, as every start of a session does; at all, it grows with them") {
        const auto study = fixtures::study({"direct", "stiff"});
        std::vector<double> looked, listed;
        for (const int participants : {20, 200}) {
            const fixtures::Folder folder;
            {
                Store store = fixtures::open(folder / "a.sqlite", Durability::whole_run);
                for (int number = 1; number <= participants; ++number) takePart(store, study, number);
                store.commit();
            }
            // Whose consent is asked for is looked at in that person's alone.
            SQLite::Database((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE)
                .exec(
                    "INSERT INTO consents SELECT participant, 'naturalness', id, id % 5 > 0, 0.0, 'en', '' "
                    "FROM "
                    "sessions");
            {
                const StepCount count("AS p WHERE p.id = ?1");  // all of the file is looked over besides
                REQUIRE(results::showParticipant(folder / "a.sqlite", "P0007"));
                looked.push_back(static_cast<double>(steps));
            }
            const StepCount count("ORDER BY p.number");
            REQUIRE(results::listParticipants(folder / "a.sqlite")->rows.size() == participants);
            listed.push_back(static_cast<double>(steps));
        }
        CHECK(looked[0] > 100);
        CHECK(looked[1] < 1.1 * looked[0]);
        CHECK(listed[1] > 9.0 * listed[0]);
        CHECK(listed[1] < 11.0 * listed[0]);
    }
}
