// A study is locked beside its database when its first participant comes.
#include <SQLiteCpp/SQLiteCpp.h>
#include <sys/stat.h>

#include "core/hash.hpp"
#include "lab_study.hpp"
#include "text.hpp"

using namespace deixis::tests;
using deixis::tests::contains;

namespace {

std::string value(const LabFolder& lab, const std::string& query) {
    return SQLite::Database(lab.path("study.sqlite"), SQLite::OPEN_READONLY).execAndGet(query).getString();
}

/// The only set beside the database.
fs::path onlySet(const LabFolder& lab) {
    return onlySetIn(lab.path("study.locked"));
}

int answersOf(const LabFolder& lab, const std::string& participant) {
    return std::stoi(value(lab, "SELECT count(*) FROM responses WHERE participant = '" + participant + "'"));
}

/// The participant's session broke off after the first answers.
void breakOff(const LabFolder& lab, const std::string& participant) {
    SQLite::Database db(lab.path("study.sqlite"), SQLite::OPEN_READWRITE);
    const std::string later = "response IN (SELECT id FROM responses WHERE participant = '" + participant +
                              "' AND trial_index > 2)";
    db.exec("DELETE FROM answers WHERE " + later + "; DELETE FROM response_stimuli WHERE " + later +
            "; DELETE FROM response_values WHERE " + later + "; DELETE FROM responses WHERE participant = '" +
            participant + "' AND trial_index > 2; UPDATE sessions SET outcome = 'quit'");
}

}  // namespace

TEST_SUITE("app/locked_study") {
    TEST_CASE("All that a participant sees or that decides it is locked, with hashes that sha256sum checks") {
        const LabFolder lab;
        const auto made = lab.simulate();
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const fs::path set = onlySet(lab);
        const std::string list = slurp(set / "locked.sha256");
        CHECK(deixis::sha256Hex(list) == value(lab, "SELECT locked_hash FROM study"));
        CHECK(value(lab, "SELECT DISTINCT locked_hash FROM plans") == deixis::sha256Hex(list));
        CHECK(set.filename().string() == deixis::sha256Hex(list).substr(0, 16));
        CHECK(shell("cd " + set.string() + " && sha256sum --strict -c locked.sha256").status == 0);
        // Every file but the list stands in it.
        int files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(set)) files += entry.is_regular_file();
        CHECK(std::count(list.begin(), list.end(), '\n') == files - 1);
        for (const char* name : {"study.text.toml", "languages/en.toml", "avatar/avatar.glb", "targets.json",
                                 "demonstrations.toml", "set.json", "clips/ours/manifest.csv",
                                 "clips/ours/T006.bvh", "clips/builtin/T001.bvh"})
            CHECK_MESSAGE(contains(list, std::string("  ") + name + "\n"), name);
        CHECK(slurp(set / "study.text.toml") == lab_study);
        CHECK(slurp(set / "clips/ours/T003.bvh") == lab.read("clips/direct_T003.bvh"));
        const auto description = nlohmann::json::parse(slurp(set / "set.json"));
        CHECK(description["planner"].get<int>() >= 1);
        CHECK(description["lab_files"].size() == 8);  // study, manifest, six clips
        // Nobody else may read them.
        for (const fs::path& folder : {set, set.parent_path()}) {
            struct stat status {};
            REQUIRE(stat(folder.c_str(), &status) == 0);
            CHECK((status.st_mode & 0777) == 0700);
        }
        // What was shown is said by its place in the set.
        CHECK(value(lab, "SELECT min(clip_file LIKE 'clips/%/T00_.bvh') FROM response_stimuli") == "1");
    }

    TEST_CASE("A lab's changed files are rejected with what has changed, and nothing is recorded") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        const auto rejected = [&](const std::vector<std::string>& words) {
            const auto ran = lab.run("P02");
            CHECK_FAILS_SAYING(ran, "study.sqlite", "locked", "deixis run --db", "--accept-changes");
            for (const std::string& word : words) CHECK_MESSAGE(contains(ran.err, word), ran.err);
            CHECK(value(lab, "SELECT count(*) FROM participants") == "1");
        };
        SUBCASE("a target moved in the manifest") {
            const std::string manifest = lab.read("clips/manifest.csv");
            const auto at = manifest.find("T004,") + 5;
            lab.write("clips/manifest.csv",
                      manifest.substr(0, at) + "9" + manifest.substr(manifest.find(',', at)));
            rejected({"clips/manifest.csv has changed", "the target of T004 was (", "is (9, "});
        }
        SUBCASE("another clip, one gone, and another text: all are told") {
            lab.write("clips/direct_T002.bvh", lab.read("clips/direct_T002.bvh") + "\n");
            fs::remove(lab.path("clips/direct_T005.bvh"));
            lab.change("study.toml", "How natural?", "How lifelike?");
            rejected(
                {"study.toml has changed (line 35 was 'question = \"How natural?\"', is 'question = \"How "
                 "lifelike?\"')",
                 "clips/direct_T002.bvh has changed", "clips/direct_T005.bvh is missing"});
        }
        SUBCASE("another study") {
            lab.change("study.toml", "name = \"lab\"", "name = \"bal\"");
            CHECK_FAILS_SAYING(lab.run("P02"), "has the study 'lab'", "'bal'", "another database");
        }
    }

    TEST_CASE("A session goes on with what was locked, by the database alone, whatever became of the files") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        breakOff(lab, "S001");
        const std::string plan = value(lab, "SELECT json FROM plans");
        fs::remove_all(lab.path("clips"));
        fs::remove_all(lab.path("stimuli"));
        fs::remove(lab.path("study.toml"));
        const auto same = lab.run("S001", "", "");
        REQUIRE_MESSAGE(same.status == 0, same.err);
        CHECK(answersOf(lab, "S001") == 10);
        CHECK(value(lab, "SELECT json FROM plans") == plan);
        const auto further = lab.run("P02", "", "");
        REQUIRE_MESSAGE(further.status == 0, further.err);
        CHECK(answersOf(lab, "P02") == 10);
        CHECK(value(lab, "SELECT count(DISTINCT locked_hash) FROM plans") == "1");
        // Both saw the same clip of the same system and target.
        CHECK(value(lab,
                    "SELECT max(n) FROM (SELECT count(DISTINCT clip_hash) AS n FROM response_stimuli GROUP "
                    "BY clip_file)") == "1");
        const auto replayed = program("replay " + lab.path("study.sqlite") + " --participant P02 --choices");
        CHECK_MESSAGE(replayed.status == 0, replayed.err);
    }

    TEST_CASE(
        "Changes that are accepted are kept with their reason: new plans get them, stored ones do not") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        breakOff(lab, "S001");
        const std::string before = value(lab, "SELECT locked_hash FROM study");
        CHECK_FAILS_SAYING(lab.run("P02", "--accept-changes 'no reason'"), "nothing has changed");
        lab.change("study.toml", "How natural?", "How lifelike?");
        lab.write("clips/direct_T002.bvh", lab.read("clips/direct_T002.bvh") + "\n");
        CHECK(lab.run("P02", "--accept-changes ' '").status == 2);
        const auto accepted = lab.run("P02", "--accept-changes 'T002 was broken'");
        REQUIRE_MESSAGE(accepted.status == 0, accepted.err);
        CHECK(contains(accepted.out, "clips/direct_T002.bvh has changed"));
        const std::string after = value(lab, "SELECT locked_hash FROM study");
        CHECK(after != before);
        CHECK(value(lab, "SELECT reason FROM locked_changes") == "T002 was broken");
        const auto what = nlohmann::json::parse(value(lab, "SELECT what FROM locked_changes"));
        CHECK(what["from"] == before);
        CHECK(what["to"] == after);
        CHECK(what["changes"].size() == 2);
        CHECK(value(lab, "SELECT locked_hash FROM plans WHERE participant = 'P02'") == after);
        CHECK(value(lab, "SELECT locked_hash FROM plans WHERE participant = 'S001'") == before);
        // The report's reader is told.
        REQUIRE(program("report " + lab.path("study.sqlite") + " -o " + lab.path("r.html") + " --json " +
                        lab.path("r.json"))
                    .status == 0);
        const std::string remarks = nlohmann::json::parse(lab.read("r.json"))["remarks"].dump();
        CHECK_MESSAGE(
            contains(remarks, "changed while it was running (T002 was broken): study.toml has changed"),
            remarks);
        CHECK(contains(remarks, "1 participant has seen it as it was before"));
        // Who was planned before goes on with the old clips, by the new study file, too.
        REQUIRE(lab.run("S001").status == 0);
        CHECK(answersOf(lab, "S001") == 10);
        const std::string old_clip = deixis::sha256Hex(
            slurp(lab.path("study.locked/" + before.substr(0, 16) + "/clips/ours/T002.bvh")));
        const std::string new_clip = deixis::sha256Hex(lab.read("clips/direct_T002.bvh"));
        CHECK(value(lab,
                    "SELECT count(*) FROM response_stimuli JOIN responses ON id = response WHERE "
                    "participant = 'S001' AND clip_hash = '" +
                        new_clip + "' AND clip_file LIKE '%T002%'") == "0");
        CHECK(value(lab,
                    "SELECT count(*) FROM response_stimuli JOIN responses ON id = response WHERE "
                    "participant = 'P02' AND clip_hash = '" +
                        old_clip + "'") == "0");
        // The old files are now those that are other ones.
        lab.change("study.toml", "How lifelike?", "How natural?");
        CHECK_FAILS_SAYING(lab.run("P03"), "study.toml has changed");
        // What answers hang on cannot be changed.
        lab.change("study.toml", "high = 5", "high = 7");
        CHECK_FAILS_SAYING(lab.run("P03", "--accept-changes 'finer'"), "another study", "from 1 to 7");
    }

    TEST_CASE("A damaged or missing set is rejected with one message, and nothing is recorded") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        const fs::path set = onlySet(lab);
        const auto rejected = [&](const std::string& words) {
            for (const std::string study : {"study.toml", ""})
                CHECK_FAILS_SAYING(lab.run("P02", "", study), set.string(), words, "from a copy");
            CHECK(value(lab, "SELECT count(*) FROM participants") == "1");
        };
        SUBCASE("a clip was changed, another file is gone") {
            fs::copy_file(set / "clips/ours/T001.bvh", set / "clips/builtin/T002.bvh",
                          fs::copy_options::overwrite_existing);
            fs::remove(set / "languages/en.toml");
            rejected("damaged: clips/builtin/T002.bvh was changed, languages/en.toml is missing");
        }
        SUBCASE("the list was changed") {
            spill(set / "locked.sha256", slurp(set / "locked.sha256") + "\n");
            rejected("is no longer the list");
        }
        SUBCASE("all is gone") {
            fs::remove_all(set.parent_path());
            rejected("not there");
        }
    }

    TEST_CASE("What is shown is what was locked, to the byte, whatever is remembered of the files") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        const fs::path set = onlySet(lab);
        std::string remembered;
        for (const auto& entry : fs::recursive_directory_iterator(set)) {
            if (!entry.is_regular_file()) continue;
            const std::string hash = deixis::sha256Hex(slurp(entry.path()));
            if (contains(entry.path().string(), "/clips/ours/T00"))
                spill(entry.path(), slurp(entry.path()) + "\n");
            struct stat status {};
            REQUIRE(stat(entry.path().c_str(), &status) == 0);
            const auto nanoseconds = [](const timespec& time) {
                return std::to_string(1'000'000'000 * static_cast<long long>(time.tv_sec) + time.tv_nsec);
            };
            remembered += hash + " " + std::to_string(status.st_size) + " " + nanoseconds(status.st_mtim) +
                          " " + nanoseconds(status.st_ctim) + " " + std::to_string(status.st_ino) + " " +
                          std::to_string(status.st_dev) + " " + entry.path().string() + "\n";
        }
        spill(lab.path("study.locked/seen"), deixis::sha256Hex(remembered) + "\n" + remembered);
        CHECK_FAILS_SAYING(lab.run("P02"), set.string(), "damaged: clips/ours/T00", "was changed",
                           "from a copy");
        CHECK(value(lab, "SELECT count(*) FROM participants") == "1");
    }

    TEST_CASE(
        "Of a database from before, stored plans keep their targets, and the set is locked at the next run") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        breakOff(lab, "S001");
        {
            SQLite::Database db(lab.path("study.sqlite"), SQLite::OPEN_READWRITE);
            db.exec("UPDATE study SET locked_hash = NULL; UPDATE plans SET locked_hash = NULL");
        }
        fs::remove_all(lab.path("study.locked"));
        CHECK_FAILS_SAYING(lab.run("S001", "", ""), "named again", "deixis run STUDY --db");
        SUBCASE("as it was") {
            const auto ran = lab.run("S001");
            REQUIRE_MESSAGE(ran.status == 0, ran.err);
            CHECK(contains(ran.err, "begun by an earlier version"));
            CHECK(answersOf(lab, "S001") == 10);
            CHECK(value(lab, "SELECT count(*) FROM plans JOIN study USING (locked_hash)") == "1");
            CHECK(lab.run("P02", "", "").status == 0);
        }
        SUBCASE("with a manifest whose target moved meanwhile") {
            const std::string manifest = lab.read("clips/manifest.csv");
            const auto at = manifest.find("T004,") + 5;
            lab.write("clips/manifest.csv",
                      manifest.substr(0, at) + "9" + manifest.substr(manifest.find(',', at)));
            CHECK_FAILS_SAYING(lab.run("S001"), "clips/manifest.csv:5: target_x", "T004");
        }
    }

    TEST_CASE("Two stations that begin a study at once lock it once, and both take part") {
        const LabFolder lab;
        const auto command = [&](const std::string& participant) {
            return programFile() + " run " + lab.path("study.toml") + " --station simulated --participant " +
                   participant + " --db " + lab.path("study.sqlite") + " >" + lab.path(participant) + " 2>&1";
        };
        Background first(command("P01")), second(command("P02"));
        CHECK_MESSAGE(first.wait() == 0, lab.read("P01"));
        CHECK_MESSAGE(second.wait() == 0, lab.read("P02"));
        onlySet(lab);
        CHECK(value(lab, "SELECT count(*) FROM plans JOIN study USING (locked_hash)") == "2");
    }

    TEST_CASE("Two systems of one generator start at once, and show the same clips") {
        const LabFolder lab;
        lab.change("study.toml", "manifest = \"clips/manifest.csv\"", "generator = \"stiff\"");
        const auto made = lab.simulate();
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const fs::path set = onlySet(lab);
        for (const char* item : {"T001", "T004", "T006"}) {
            const std::string clip = slurp(set / "clips/ours" / (std::string(item) + ".bvh"));
            CHECK(clip.size() > 1000);
            CHECK(clip == slurp(set / "clips/builtin" / (std::string(item) + ".bvh")));
        }
    }

    TEST_CASE("Joined databases need the same set; it goes with them") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        const std::string first = lab.path("first.sqlite");
        fs::rename(lab.path("study.sqlite"), first);
        fs::rename(lab.path("study.locked"), lab.path("first.locked"));
        lab.write("clips/direct_T002.bvh", lab.read("clips/direct_T002.bvh") + "\n");
        REQUIRE(lab.run("P02").status == 0);
        const std::string join = "merge " + first + " " + lab.path("study.sqlite") + " -o ";
        const auto rejected = program(join + lab.path("all.sqlite"));
        CHECK(rejected.status == 1);
        CHECK_MESSAGE(contains(rejected.err, "locked"), rejected.err);
        fs::remove(lab.path("study.sqlite"));
        lab.write("clips/direct_T002.bvh",
                  slurp(onlySetIn(lab.path("first.locked")) / "clips/ours/T002.bvh"));
        REQUIRE(lab.run("P02").status == 0);
        const auto joined = program(join + lab.path("all.sqlite"));
        REQUIRE_MESSAGE(joined.status == 0, joined.err);
        CHECK(joined.err.empty());
        const auto more = program("run --station simulated --participant P03 --db " + lab.path("all.sqlite"));
        CHECK_MESSAGE(more.status == 0, more.err);
    }
}
