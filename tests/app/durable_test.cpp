// Folders of results are on the disk when they are told to be there, by the calls that ask the disk for it.
#include <doctest/doctest.h>

#include "app/clips/clip_output.hpp"
#include "program.hpp"
#include "results/copies/data_export.hpp"
#include "sync_log.hpp"

using namespace deixis;
using namespace deixis::tests;

TEST_SUITE("app/durable") {
    TEST_CASE("Clips of a folder are on the disk before they have their places, and then the places are") {
        const Scratch scratch;
        disk_calls.clear();
        for (const bool durable : {true, false}) {
            INFO("durable " << durable);
            app::OutputFolder folder(scratch / "clips", true, durable);
            REQUIRE(folder.add("far/T001.bvh", "words"));
            REQUIRE(folder.add("manifest.csv", "words"));
            disk_calls.clear();
            REQUIRE(folder.finish());
            CHECK(callAt("rename T001.bvh") < callAt("rename manifest.csv"));
            CHECK(callAt("rename manifest.csv") < disk_calls.size());
            if (durable) {
                CHECK(callAt("syncfs .making") < callAt("rename T001.bvh"));
                for (const char* synced : {"fsync far", "fsync clips", "fsync deixis_test_"}) {
                    CHECK(callAt(synced) < disk_calls.size());
                    CHECK(callAt("rename manifest.csv") < callAt(synced));
                }
            } else {
                CHECK(disk_calls.size() == 2);
            }
        }
    }

    TEST_CASE("An export is on the disk before it has its place, and then the place is") {
        const Scratch scratch;
        const auto made = program("simulate genea-pairwise --participants 1 --db " + (scratch / "a.sqlite"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
        disk_calls.clear();
        REQUIRE(results::exportCsv(scratch / "a.sqlite", scratch / "tables", {}));
        const std::size_t codebook = callAt("fsync tables");
        REQUIRE(codebook < disk_calls.size());
        CHECK(disk_calls[codebook - 1] == "rename codebook.json");
        const auto synced = callAt("syncfs .export-under-way");
        CHECK(synced < codebook);
        for (const char* name : {"responses.csv", "codebook.json"}) {
            const auto last =
                std::find(disk_calls.rbegin(), disk_calls.rend(), std::string("rename ") + name);
            CHECK(disk_calls.rend() - last - 1 > static_cast<std::ptrdiff_t>(synced));
        }
        CHECK(callAt("fsync deixis_test_") > codebook);
        CHECK(callAt("fsync deixis_test_") < disk_calls.size());
    }
}
