// What is in the making is nowhere to be met: not before it is whole, not after it was given up.
#include "core/staging.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <optional>
#include <set>

#include "core/files.hpp"
#include "core/unique_name.hpp"

using namespace deixis;
namespace fs = std::filesystem;

namespace {

struct Folder {
    fs::path path = fs::temp_directory_path() / ("deixis_staging" + uniqueName());
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::set<std::string> names() const {
        std::set<std::string> out;
        for (const auto& entry : fs::recursive_directory_iterator(path))
            out.insert(entry.path().lexically_relative(path).generic_string());
        return out;
    }
};

using Names = std::set<std::string>;

}  // namespace

TEST_SUITE("core/staging") {
    TEST_CASE("Files are moved home together, over those that are there; others stay") {
        const Folder folder;
        REQUIRE(writeFile(folder.path / "a.csv", "old"));
        REQUIRE(writeFile(folder.path / "other.txt", "a stranger's"));
        {
            auto staging = Staging::within(folder.path).value();
            REQUIRE(staging.add("a.csv", "new"));
            REQUIRE(staging.add("sub/b.csv", "b"));
            REQUIRE(writeFile(folder.path / "outdated.csv", "x"));
            CHECK(readFile(folder.path / "a.csv").value() == "old");
            CHECK_FALSE(fs::exists(folder.path / "sub"));
            REQUIRE(staging.moveHome({"a.csv", "sub/b.csv"}, {"outdated.csv", "absent.csv"}, true));
        }
        CHECK(folder.names() == Names{"a.csv", "other.txt", "sub", "sub/b.csv"});
        CHECK(readFile(folder.path / "a.csv").value() == "new");
        CHECK(readFile(folder.path / "sub/b.csv").value() == "b");
    }

    TEST_CASE("What is given up leaves nothing, and the home only where it was there before") {
        const Folder folder;
        REQUIRE(writeFile(folder.path / "kept/file", "x"));
        for (const char* home : {"kept", "made"}) {
            auto staging = Staging::within(folder.path / home).value();
            REQUIRE(staging.add("a.csv", "new"));
        }
        CHECK(folder.names() == Names{"kept", "kept/file"});
    }

    TEST_CASE("Where a folder has the name of a file, nothing is moved or removed") {
        const Folder folder;
        fs::create_directories(folder.path / "b.csv");
        REQUIRE(writeFileUnsynced(folder.path / "outdated.csv", "old"));
        {
            auto staging = Staging::within(folder.path).value();
            for (const char* name : {"a.csv", "b.csv"}) REQUIRE(staging.add(name, name));
            const auto moved = staging.moveHome({"a.csv", "b.csv"}, {"outdated.csv"}, false);
            REQUIRE_FALSE(moved);
            CHECK(moved.error().where == (folder.path / "b.csv").string());
        }
        CHECK(folder.names() == Names{"b.csv", "outdated.csv"});
    }

    TEST_CASE("Where a move fails, what has not been moved stays, and goes with the next of that name") {
        const Folder folder;
        REQUIRE(writeFileUnsynced(folder.path / "b", "in the way"));
        {
            auto staging = Staging::within(folder.path, ".mine").value();
            for (const char* name : {"a.csv", "b/b.csv", "c.csv"}) REQUIRE(staging.add(name, name));
            const auto moved = staging.moveHome({"a.csv", "b/b.csv", "c.csv"}, {}, false);
            REQUIRE_FALSE(moved);
            CHECK(moved.error().where == (folder.path / "b/b.csv").string());
        }
        CHECK(fs::exists(folder.path / "a.csv"));
        CHECK(fs::exists(folder.path / ".mine/c.csv"));
        {
            const auto again = Staging::within(folder.path, ".mine").value();
            CHECK(fs::is_empty(again.path()));
        }
        CHECK_FALSE(fs::exists(folder.path / ".mine"));
    }

    TEST_CASE("A whole folder comes into its place at once, and never over another") {
        const Folder folder;
        const auto target = folder.path / "package";
        for (const bool first : {true, false}) {
            auto staging = Staging::within(folder.path).value();
            std::optional<Staging> moved(std::move(staging));
            REQUIRE(moved->add("README.md", first ? "first" : "second"));
            CHECK(moved->become(target, true).has_value() == first);
        }
        CHECK(folder.names() == Names{"package", "package/README.md"});
        CHECK(readFile(target / "README.md").value() == "first");
    }

    TEST_CASE("A file in the making takes its companions with it") {
        const Folder folder;
        const auto target = folder.path / "study.sqlite";
        const auto write = [](const fs::path& file) { std::ofstream(file) << "bytes"; };
        {
            const PartialFile given_up(target);
            write(given_up.path());
            write(given_up.path().string() + "-wal");
        }
        CHECK(folder.names().empty());
        {
            PartialFile made(target);
            write(made.path());
            write(made.path().string() + "-shm");
            REQUIRE(made.finish());
        }
        CHECK(folder.names() == Names{"study.sqlite"});
    }
}
