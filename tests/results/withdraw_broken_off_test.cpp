// A withdrawal that is broken off: by the death of the process, or by a full disk.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "dying_vfs.hpp"
#include "results/participants/participants.hpp"
#include "text.hpp"
#include "withdrawal_fixture.hpp"

using namespace deixis;
using namespace fixtures::withdrawal;
using deixis::tests::contains;
using fixtures::DyingVfs;
using results::Store;
using Deed = DyingVfs::Deed;

namespace {

DyingVfs::At never() {
    return [](int, const std::string&) { return Deed::go_on; };
}

/// Who withdraws, and somebody else, in a closed database.
void makeStudy(const std::filesystem::path& path) {
    const auto study = fixtures::wideStudy();
    Store store = fixtures::open(path);
    for (const auto& [who, says] : {std::pair{id, typed}, {std::string("P02"), std::string("nothing")}}) {
        takePart(store, study, who, says, 40);
        store.endSession(studies::SessionOutcome::finished, 1.7e9 + 600.0);
    }
}

/// What `doing` needs of a disk, operation by operation.
template <typename Doing>
std::vector<std::string> operationsOf(const Doing& doing) {
    std::vector<std::string> out;
    DyingVfs vfs([&](int, const std::string& what) {
        out.push_back(what);
        return Deed::go_on;
    });
    doing();
    return out;
}

/// Runs it in a process of its own, which dies before the operation.
template <typename Doing>
void dieBefore(int operation, const Doing& doing) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        DyingVfs vfs([&](int now, const std::string&) { return now == operation ? Deed::die : Deed::go_on; });
        doing();
        ::_exit(1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
}

std::vector<std::string> namesListed(const std::filesystem::path& path) {
    std::vector<std::string> out;
    const auto list = results::listParticipants(path);
    REQUIRE_MESSAGE(list, list.error().text());
    for (const auto& row : list->rows) out.push_back(row.id);
    return out;
}

/// All but most writes.
bool isTried(const std::vector<std::string>& operations, std::size_t index) {
    constexpr std::size_t writes_between = 9;
    return operations[index] != "write" || index % writes_between == 0;
}

}  // namespace

TEST_SUITE("results/withdraw_broken_off") {
    TEST_CASE(
        "Killed anywhere, a withdrawal is done or not for whoever reads or writes, and can be finished") {
        const fixtures::Folder made;
        makeStudy(made / "a.sqlite");
        std::filesystem::copy_file(made / "a.sqlite", made / "whole.sqlite");
        const auto operations =
            operationsOf([&] { REQUIRE(results::withdrawParticipant(made / "whole.sqlite", id, 1.75e9)); });
        REQUIRE(operations.size() > 50);
        std::set<std::string> states;
        for (std::size_t i = 0; i < operations.size(); ++i) {
            if (!isTried(operations, i)) continue;
            INFO("before operation " << i + 1 << " of " << operations.size() << ": " << operations[i]);
            const fixtures::Folder folder;
            const auto path = folder / "a.sqlite";
            std::filesystem::copy_file(made / "a.sqlite", path);
            dieBefore(static_cast<int>(i) + 1, [&] { (void)results::withdrawParticipant(path, id, 1.75e9); });
            const DyingVfs quick(never());
            const auto names = namesListed(path);
            const auto list = results::listParticipants(path);
            CHECK(fixtures::open(path).participants() == names);
            CHECK(namesListed(path) == names);
            const bool there = names.size() == 2;
            CHECK(list->withdrawn == (there ? 0 : 1));
            states.insert(there ? "there" : list->uncleared > 0 ? "to be cleared" : "done");
            if (there || list->uncleared > 0) {
                const auto again = results::withdrawParticipant(path, id, 1.75e9 + 60.0);
                REQUIRE_MESSAGE(again, again.error().text());
                CHECK((*again == results::Withdrawn::erased) == there);
            }
            CHECK(traces(path, {id, typed, note + " (" + id}).empty());
            CHECK(namesListed(path) == std::vector<std::string>{"P02"});
            CHECK(results::listParticipants(path)->withdrawn == 1);
            CHECK(results::listParticipants(path)->uncleared == 0);
            CHECK_FALSE(results::withdrawParticipant(path, id, 1.75e9 + 120.0));
        }
        CHECK(states == std::set<std::string>{"done", "there", "to be cleared"});
    }

    TEST_CASE("On a full disk a withdrawal says how far it came, and goes on from there") {
        const fixtures::Folder made;
        makeStudy(made / "a.sqlite");
        std::filesystem::copy_file(made / "a.sqlite", made / "whole.sqlite");
        const auto operations =
            operationsOf([&] { REQUIRE(results::withdrawParticipant(made / "whole.sqlite", id, 1.75e9)); });
        int half_done = 0, not_begun = 0;
        for (std::size_t i = 0; i < operations.size(); i += 7) {
            INFO("full before operation " << i + 1 << " of " << operations.size());
            const fixtures::Folder folder;
            const auto path = folder / "a.sqlite";
            std::filesystem::copy_file(made / "a.sqlite", path);
            bool half = false;
            {
                const DyingVfs full([&](int now, const std::string& what) {
                    const bool rejected = now > static_cast<int>(i) && what == "write";
                    return rejected ? Deed::disk_full : Deed::go_on;
                });
                const auto done = results::withdrawParticipant(path, id, 1.75e9);
                if (done) continue;
                CHECK(contains(done.error().message, "the disk is full"));
                half = contains(done.error().message, "free pages");
                ++(half ? half_done : not_begun);
            }
            const DyingVfs quick(never());
            CHECK((namesListed(path).size() == 1) == half);
            const auto again = results::withdrawParticipant(path, id, 1.75e9 + 60.0);
            REQUIRE_MESSAGE(again, again.error().text());
            CHECK(traces(path, {id, typed}).empty());
            CHECK(results::listParticipants(path)->withdrawn == 1);
        }
        CHECK(half_done > 0);
        CHECK(not_begun > 0);
    }

    TEST_CASE("A rollback journal that another program left is undone by who reads, as by who writes") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        makeStudy(path);
        {
            SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
            REQUIRE(database.execAndGet("PRAGMA journal_mode = DELETE").getString() == "delete");
        }
        const auto before = namesListed(path);
        REQUIRE(before.size() == 2);
        std::filesystem::copy_file(path, folder / "whole.sqlite");
        const auto erase = [&](const char* name) {
            SQLite::Database database((folder / name).string(), SQLite::OPEN_READWRITE);
            database.exec("BEGIN; DELETE FROM participants WHERE id = 'P02'; COMMIT");
        };
        const auto operations = operationsOf([&] { erase("whole.sqlite"); });
        REQUIRE(operations.back() == "remove " + (folder / "whole.sqlite-journal").string());
        dieBefore(static_cast<int>(operations.size()), [&] { erase("a.sqlite"); });
        REQUIRE(std::filesystem::file_size(folder / "a.sqlite-journal") > 0);
        CHECK(namesListed(path) == before);
        CHECK(fixtures::open(path).participants() == before);
    }
}
