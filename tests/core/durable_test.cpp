// What is on the disk when a file has been written, by the calls that ask the disk for it.
#include "core/durable.hpp"

#include <doctest/doctest.h>

#include "core/files.hpp"
#include "sync_log.hpp"

using namespace deixis;
using tests::callAt;
using tests::disk_calls;

TEST_SUITE("core/durable") {
    TEST_CASE(
        "A file's bytes are on the disk before it has its name, and then the name and new folders are") {
        const auto folder = std::filesystem::temp_directory_path() / "deixis_durable_test";
        std::filesystem::remove_all(folder);
        disk_calls.clear();
        REQUIRE(writeFile(folder / "new" / "report.html", "words"));
        CHECK(callAt("fsync report.html.partial") < callAt("rename report.html"));
        CHECK(callAt("rename report.html") < callAt("fsync new"));
        CHECK(callAt("fsync new") < callAt("fsync deixis_durable_test"));
        CHECK(callAt("fsync deixis_durable_test") < disk_calls.size());
        disk_calls.clear();
        REQUIRE(writeFile(folder / "new" / "report.html", "other words"));
        CHECK(disk_calls.size() == 3);  // no folder is new
        disk_calls.clear();
        REQUIRE(writeFileUnsynced(folder / "cached.bvh", "words"));
        CHECK(disk_calls == std::vector<std::string>{"rename cached.bvh"});
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("Where the disk does not take the bytes the old file stays, and the reason is told") {
        const auto folder = std::filesystem::temp_directory_path() / "deixis_durable_test";
        const auto file = folder / "report.html";
        REQUIRE(writeFile(file, "old"));
        tests::fsync_fails_with = EIO;
        const auto failed = writeFile(file, "new");
        tests::fsync_fails_with = EINVAL;  // a file system that cannot be asked
        const auto unasked = writeFile(folder / "other.html", "new");
        tests::fsync_fails_with = 0;
        REQUIRE_FALSE(failed);
        CHECK(failed.error().text().find("report.html: cannot be written: Input/output error") !=
              std::string::npos);
        CHECK(readFile(file).value() == "old");
        CHECK(unasked);
        CHECK(std::distance(std::filesystem::directory_iterator(folder), {}) == 2);  // no part is left
        std::filesystem::remove_all(folder);
    }
}
