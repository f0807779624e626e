// Files of the kept folder: turns, what is left of killed servers, what is no plain file.
#include "server/kept/kept_folder.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "app/program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using server::KeptFolder;

namespace {

KeptFolder opened(const fs::path& path, KeptFolder::Make make = KeptFolder::Make::now) {
    auto folder = KeptFolder::open(path, make);
    REQUIRE_MESSAGE(folder.has_value(), (folder ? "" : folder.error().text()));
    return std::move(*folder);
}

}  // namespace

TEST_SUITE("server/kept_folder") {
    TEST_CASE("What is written is there, by its name, and nothing else") {
        const Scratch scratch;
        const auto folder = opened(scratch / "a/b");
        struct stat there {};
        REQUIRE(::stat((scratch / "a/b").c_str(), &there) == 0);
        CHECK((there.st_mode & 0777U) == 0700);
        const std::string id = server::newKeptId();
        CHECK(server::isKeptId(id));
        CHECK(folder.ids("things").empty());
        {
            const auto turn = folder.turn();
            REQUIRE(turn);
            REQUIRE(folder.write("things/" + id + ".json", "{}"));
        }
        CHECK(folder.ids("things") == std::vector<std::string>{id});
        CHECK(*folder.read("things/" + id + ".json", 2) == "{}");
        CHECK(*folder.readBeginning("things/" + id + ".json", 1) == "{");
        CHECK(!folder.read("things/" + id + ".json", 1));
        CHECK(folder.bytesOf("things/" + id + ".json") == 2);
        CHECK(slurp(scratch / ("a/b/things/" + id + ".json")) == "{}");
        const auto absent = folder.read("things/0123456789abcdef.json", 10);
        REQUIRE(!absent);
        CHECK(absent.error().where == "things/0123456789abcdef.json");
        REQUIRE(folder.remove("things/" + id + ".json"));
        CHECK(!folder.has("things/" + id + ".json"));
    }

    TEST_CASE("Ids are 16 hexadecimal digits, never the same") {
        std::set<std::string> ids;
        for (int i = 0; i < 1000; ++i) ids.insert(server::newKeptId());
        CHECK(ids.size() == 1000);
        for (const char* text : {"", "0123456789abcde", "0123456789abcdef0", "0123456789abcdeg",
                                 "0123456789ABCDEF", "../../../../../x", "0123456789abcde/"})
            CHECK_MESSAGE(!server::isKeptId(text), text);
    }

    TEST_CASE("A folder is made when something is kept, not before") {
        const Scratch scratch;
        const auto folder = opened(scratch / "later", KeptFolder::Make::when_something_is_kept);
        CHECK(folder.ids("things").empty());
        CHECK(!fs::exists(scratch / "later"));
        CHECK(folder.turn());
        CHECK(fs::exists(scratch / "later"));
        spill(scratch / "file", "x");
        CHECK(contains(KeptFolder::open(scratch / "file", KeptFolder::Make::now).error().text(),
                       "file: found a file, expected a folder"));
        CHECK(!KeptFolder::open(scratch / "file/below", KeptFolder::Make::now));
    }

    TEST_CASE("What killed servers left unfinished goes, other files stay") {
        const Scratch scratch;
        spill(scratch / "kept/things/0123456789abcdef.json.partial77", "half");
        spill(scratch / "kept/rules.json.partial88", "half");
        spill(scratch / "kept/things/notes.txt", "mine");
        spill(scratch / "kept/things/mine.json", "mine");
        const auto folder = opened(scratch / "kept");
        CHECK(!fs::exists(scratch / "kept/things/0123456789abcdef.json.partial77"));
        CHECK(!fs::exists(scratch / "kept/rules.json.partial88"));
        CHECK(fs::exists(scratch / "kept/things/notes.txt"));
        CHECK(folder.ids("things").empty());  // of other names
    }

    TEST_CASE("Links and folders are no files of it") {
        const Scratch scratch;
        const auto folder = opened(scratch / "kept");
        spill(scratch / "secret", "secret");
        fs::create_directories(scratch / "kept/things/1111111111111111.json");
        fs::create_symlink(scratch / "secret", scratch / "kept/things/2222222222222222.json");
        for (const char* id : {"1111111111111111", "2222222222222222"}) {
            const auto read = folder.read(std::string("things/") + id + ".json", 100);
            REQUIRE(!read);
            CHECK(contains(read.error().text(), "is no plain file"));
            CHECK(!folder.readBeginning(std::string("things/") + id + ".json", 100));
        }
    }

    TEST_CASE("One has the turn at a time: threads, and other servers") {
        const Scratch scratch;
        const auto folder = opened(scratch / "kept");
        REQUIRE(folder.write("count.json", "0"));
        constexpr int each = 30;
        const auto count = [&](const KeptFolder& in) {
            for (int i = 0; i < each; ++i) {
                const auto turn = in.turn();
                if (!turn) return;
                const int before = std::atoi(in.read("count.json", 100)->c_str());
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                if (!in.write("count.json", std::to_string(before + 1))) return;
            }
        };
        const pid_t child = fork();
        if (child == 0) {
            const auto other = KeptFolder::open(scratch / "kept", KeptFolder::Make::now);
            if (other) count(*other);
            _exit(0);
        }
        const auto another = opened(scratch / "kept");
        std::thread one([&] { count(folder); }), two([&] { count(another); });
        one.join();
        two.join();
        int status = 0;
        waitpid(child, &status, 0);
        CHECK(*folder.read("count.json", 100) == std::to_string(3 * each));
    }
}
