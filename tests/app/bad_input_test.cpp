// What a user can get wrong: one clear message and a status that is not zero.
#include <SQLiteCpp/SQLiteCpp.h>

#include "program.hpp"

using namespace deixis::tests;

namespace {

// A study whose first system takes its clips from a manifest beside it; the others stay built in.
std::string studyWithManifest() {
    return replaced(shippedStudy(), "generator = \"direct\"", "manifest = \"clips/manifest.csv\"");
}

// A database with one participant of the shipped study; made once, and copied.
void copySimulated(const std::string& database) {
    static const Scratch lab{WithSharedStimuli{}};
    if (!fs::exists(lab / "study.sqlite"))
        REQUIRE(program("simulate pointing2023-stand-ins --participants 1 --db " + (lab / "study.sqlite"))
                    .status == 0);
    const fs::path to = fs::path(database).parent_path();
    fs::copy(lab / "study.sqlite", database);
    fs::copy(lab / "study.locked", to / "study.locked", fs::copy_options::recursive);
}

// A folder with that study and clips of `direct` for its targets, as a lab would make them.
void makeLabFolder(const Scratch& scratch) {
    static const Scratch lab;  // made once, and copied
    if (fs::is_empty(lab.path())) {
        spill(lab / "study.toml", studyWithManifest());
        const auto targets = program("targets " + (lab / "study.toml") + " --no-picture");
        REQUIRE(targets.status == 0);
        spill(lab / "targets.csv", targets.out);
        const auto made =
            program("generate direct --targets " + (lab / "targets.csv") + " --out " + (lab / "clips"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
    }
    fs::copy(lab.path(), scratch.path(), fs::copy_options::recursive);
}

Finished runIn(const Scratch& scratch) {
    return program("simulate " + (scratch / "study.toml") + " --participants 2 --db " +
                   (scratch / "out.sqlite"));
}

}  // namespace

TEST_SUITE("app/bad-input") {
    TEST_CASE("wrong usage ends with status 2 and says what was expected") {
        for (const std::string arguments :
             {"", "no-such-command", "run", "targets", "generate direct", "plan pointing2023", "report",
              "simulate pointing2023-stand-ins --db x -n 3"}) {
            INFO(arguments);
            const auto finished = program(arguments);
            CHECK(finished.status == 2);
            CHECK_FALSE(finished.err.empty());
        }
        CHECK(program("--help").status == 0);
        CHECK(program("run --help").status == 0);
        CHECK(program("--version").status == 0);
    }

    TEST_CASE("a study that is not there, does not parse or has an unknown key names file, line and key") {
        const Scratch scratch;
        CHECK_FAILS_SAYING(program("plan " + (scratch / "none.toml") + " --participant P01"), "none.toml",
                           "No such file");
        spill(scratch / "broken.toml", "[study\nname=1");
        CHECK_FAILS_SAYING(program("plan " + (scratch / "broken.toml") + " --participant P01"),
                           "broken.toml:1");
        spill(scratch / "unknown.toml", replaced(shippedStudy(), "max_replays", "max_replay"));
        CHECK_FAILS_SAYING(program("plan " + (scratch / "unknown.toml") + " --participant P01"),
                           "unknown.toml:", "max_replay", "max_replays");
        CHECK_FAILS_SAYING(program("plan pointing2023 --participant 'no spaces'"), "no spaces");
    }

    TEST_CASE("ranges in which no distractor can lie fail after a bounded search") {
        const Scratch scratch;
        spill(scratch / "study.toml",
              replaced(shippedStudy(), "distance_m = [0.20, 0.40]", "distance_m = [8.0, 9.0]"));
        CHECK_FAILS_SAYING(program("targets " + (scratch / "study.toml") + " --no-picture"), "study.toml",
                           "8");
    }

    TEST_CASE("a lab's own clips take a system's place, and what is wrong with them is named") {
        const Scratch scratch{WithSharedStimuli{}};
        makeLabFolder(scratch);
        const std::string manifest = slurp(scratch / "clips/manifest.csv");
        const std::string clip = "direct_T001.bvh";
        const auto again = [&] {
            fs::remove(scratch / "out.sqlite");
            // Two participants may miss T001: ask for its clip by leaving only what the test breaks.
            return program("run " + (scratch / "study.toml") +
                           " --station simulated --participant P01 --db " + (scratch / "out.sqlite"));
        };
        // The first target that P01 meets with this system.
        const auto plan = nlohmann::json::parse(
            program("plan " + (scratch / "study.toml") + " --participant P01 --json").out);
        std::string target;
        for (const auto& trial : plan["trials"])
            if (trial.value("system", "") == "direct" && target.empty()) target = trial["target_id"];
        REQUIRE_FALSE(target.empty());
        const std::string file = "direct_" + target + ".bvh";
        const std::string bvh = slurp(scratch / ("clips/" + file));

        SUBCASE("as they are") {
            const auto good = runIn(scratch);
            CHECK_MESSAGE(good.status == 0, good.err);
        }
        SUBCASE("a missing clip") {
            fs::remove(scratch / ("clips/" + file));
            CHECK_FAILS_SAYING(again(), file, "No such file");
        }
        SUBCASE("a truncated clip") {
            spill(scratch / ("clips/" + file), bvh.substr(0, bvh.size() / 2));
            CHECK_FAILS_SAYING(again(), file + ":");
        }
        SUBCASE("a clip with a NaN") {
            const auto motion = bvh.find("Frame Time");
            const auto line = bvh.find('\n', motion) + 1;
            spill(scratch / ("clips/" + file), bvh.substr(0, line) + "nan" + bvh.substr(bvh.find(' ', line)));
            CHECK_FAILS_SAYING(again(), file + ":", "nan");
        }
        SUBCASE("a manifest without the target") {
            const auto row = manifest.find(file);
            const auto end = manifest.find('\n', row) + 1;
            spill(scratch / "clips/manifest.csv", manifest.substr(0, row) + manifest.substr(end));
            CHECK_FAILS_SAYING(again(), "manifest.csv", target, "direct");
        }
        SUBCASE("a manifest with a frame outside the clip") {
            const auto row = manifest.find(file);
            std::string line = manifest.substr(row, manifest.find('\n', row) - row);
            std::vector<std::string> cells;
            for (std::size_t at = 0; at != std::string::npos;) {
                const auto comma = line.find(',', at);
                cells.push_back(line.substr(at, comma - at));
                at = comma == std::string::npos ? comma : comma + 1;
            }
            REQUIRE(cells.size() == 13);
            cells[10] = "99999";
            std::string changed;
            for (const auto& cell : cells) changed += (changed.empty() ? "" : ",") + cell;
            spill(scratch / "clips/manifest.csv", replaced(manifest, line, changed));
            CHECK_FAILS_SAYING(again(), "manifest.csv", file, "99999");
        }
        SUBCASE("a manifest made for other targets") {
            spill(scratch / "study.toml", replaced(studyWithManifest(), "seed = 2023", "seed = 2024"));
            CHECK_FAILS_SAYING(again(), "manifest.csv", "deixis targets");
        }
        SUBCASE("no manifest at all") {
            fs::remove(scratch / "clips/manifest.csv");
            CHECK_FAILS_SAYING(again(), "manifest.csv");
        }
    }

    TEST_CASE("a manifest of several systems gives each system its own clips, or is rejected") {
        const Scratch scratch{WithSharedStimuli{}};
        const auto targets = program("targets pointing2023 --no-picture");
        spill(scratch / "targets.csv", targets.out);
        for (const std::string system : {"direct", "drifting"})
            REQUIRE(program("generate " + system + " --targets " + (scratch / "targets.csv") + " --out " +
                            (scratch / ("clips/" + system)))
                        .status == 0);
        std::string both;
        for (const std::string system : {"drifting", "direct"}) {
            std::string rows = slurp(scratch / ("clips/" + system + "/manifest.csv"));
            if (!both.empty()) rows.erase(0, rows.find('\n') + 1);
            for (auto at = rows.find(system + "_"); at != std::string::npos;
                 at = rows.find("\n" + system + "_", at))
                rows.insert(rows[at] == '\n' ? at + 1 : at, system + "/"), at += system.size() + 2;
            both += rows;
        }
        spill(scratch / "clips/both.csv", both);
        const std::string study =
            replaced(replaced(shippedStudy(), "generator = \"direct\"", "manifest = \"clips/both.csv\""),
                     "generator = \"drifting\"", "manifest = \"clips/both.csv\"");
        spill(scratch / "study.toml", study);
        const auto good = runIn(scratch);
        INFO(good.err);
        REQUIRE(good.status == 0);
        const auto wrong =
            shell("sqlite3 -readonly " + (scratch / "out.sqlite") +
                  " \"select count(*) from responses_flat where system in ('direct', 'drifting') and "
                  "clip_file not like 'clips/' || system || '/T%'\"");
        CHECK(wrong.out == "0\n");
        const fs::path set = onlySetIn(scratch / "out.locked");
        for (const std::string system : {"direct", "drifting"})
            CHECK(slurp(set / "clips" / system / "T007.bvh") ==
                  slurp(scratch / ("clips/" + system + "/" + system + "_T007.bvh")));
        fs::remove(scratch / "out.sqlite");
        spill(scratch / "study.toml", replaced(study, "name = \"drifting\"", "name = \"mine\""));
        CHECK_FAILS_SAYING(runIn(scratch), "both.csv", "direct, drifting", "mine");
    }

    TEST_CASE("a report is never written over a database") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string database = scratch / "study.sqlite";
        REQUIRE(program("simulate pointing2023-stand-ins --participants 1 --db " + database).status == 0);
        const std::string before = slurp(database);
        CHECK_FAILS_SAYING(program("report " + database + " -o " + database), "study.sqlite", "database");
        CHECK_FAILS_SAYING(
            program("report " + database + " -o " + (scratch / "r.html") + " --json " + database),
            "study.sqlite", "database");
        CHECK(slurp(database) == before);
    }

    TEST_CASE("an unknown system and a bad list of targets are named") {
        const Scratch scratch;
        spill(scratch / "t.csv", "target_id,x,y,z\nT001,0.5,1.0,2.0\n");
        CHECK_FAILS_SAYING(
            program("generate mogul --targets " + (scratch / "t.csv") + " --out " + (scratch / "o")), "mogul",
            "drifting");
        spill(scratch / "bad.csv", "target_id,x,y,z\nT001,0.5,one,2.0\n");
        CHECK_FAILS_SAYING(
            program("generate direct --targets " + (scratch / "bad.csv") + " --out " + (scratch / "o")),
            "bad.csv:2", "one");
        spill(scratch / "short.csv", "target_id,x,y\nT001,0.5,1.0\n");
        CHECK_FAILS_SAYING(
            program("generate direct --targets " + (scratch / "short.csv") + " --out " + (scratch / "o")),
            "short.csv", "z");
        CHECK_FALSE(fs::exists(scratch / "o/manifest.csv"));
    }

    TEST_CASE("databases that cannot be used are rejected and left as they are") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string database = scratch / "study.sqlite";
        const auto run = [&] {
            return program("run pointing2023-stand-ins --station simulated --participant P01 --db " +
                           database);
        };
        SUBCASE("not a database") {
            spill(database,
                  "These are my notes, not a database. They are long enough to be read as a header.");
            const std::string before = slurp(database);
            CHECK_FAILS_SAYING(run(), "study.sqlite");
            CHECK(slurp(database) == before);
        }
        SUBCASE("from a newer version") {
            copySimulated(database);
            REQUIRE(shell("sqlite3 " + database + " 'pragma user_version = 999'").status == 0);
            CHECK_FAILS_SAYING(run(), "study.sqlite", "999", "newer");
            CHECK_FAILS_SAYING(program("report " + database + " -o " + (scratch / "r.html")), "study.sqlite",
                               "999");
            CHECK_FALSE(fs::exists(scratch / "r.html"));
        }
        SUBCASE("locked") {
            copySimulated(database);
            SQLite::Database holder(database, SQLite::OPEN_READWRITE);
            holder.exec("pragma locking_mode = exclusive; begin exclusive; create table t (x); ");
            CHECK_FAILS_SAYING(run(), "study.sqlite", "lock");
        }
        SUBCASE("in a folder that cannot be written") {
            CHECK_FAILS_SAYING(program("run pointing2023-stand-ins --station simulated --participant P01 "
                                       "--db /proc/study.sqlite"),
                               "/proc/study.sqlite");
        }
        SUBCASE("of another study") {
            copySimulated(database);
            spill(scratch / "other.toml", replaced(shippedStudy(), "seed = 2023", "seed = 2024"));
            CHECK_FAILS_SAYING(program("run " + (scratch / "other.toml") +
                                       " --station simulated --participant P09 --db " + database),
                               "study.sqlite", "has the study", "another database");
        }
        SUBCASE("missing, for a report") {
            CHECK_FAILS_SAYING(program("report " + (scratch / "none.sqlite") + " -o " + (scratch / "r.html")),
                               "none.sqlite");
            CHECK_FALSE(fs::exists(scratch / "none.sqlite"));
        }
    }

    TEST_CASE("clip files that are no clips are rejected") {
        const Scratch scratch;
        spill(scratch / "empty.bvh", "");
        CHECK_FAILS_SAYING(program("clips joints " + (scratch / "empty.bvh") + " --csv"), "empty.bvh");
        spill(scratch / "noise.bvh", "HIERARCHY\nROOT a\n{\n OFFSET 0 0\n");
        CHECK_FAILS_SAYING(program("clips joints " + (scratch / "noise.bvh") + " --csv"), "noise.bvh:");
        CHECK_FAILS_SAYING(program("clips joints " + (scratch / "none.bvh") + " --csv"), "none.bvh",
                           "No such file");
    }
}
