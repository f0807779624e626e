// A study that names its avatar: checked, simulated, kept with the sessions.
#include <SQLiteCpp/SQLiteCpp.h>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "program.hpp"
#include "shared_data.hpp"

using namespace deixis::tests;

namespace {

std::string withAvatar(const std::string& avatar) {
    return replaced(shippedStudy(), "[study]\n", "[study]\navatar = \"" + avatar + "\"\n");
}

std::string avatarHashes(const std::string& database) {
    return SQLite::Database(database, SQLite::OPEN_READONLY)
        .execAndGet("SELECT group_concat(DISTINCT avatar_hash) FROM sessions WHERE outcome = 'finished'")
        .getString();
}

}  // namespace

TEST_SUITE("app/study_avatar") {
    TEST_CASE("An avatar that is not there, or is none, is a problem that names the study's key") {
        const Scratch scratch;
        spill(scratch / "study.toml", withAvatar("lost.glb"));
        auto checked = program("check " + (scratch / "study.toml"));
        CHECK(checked.status == 1);
        CAPTURE(checked.err);
        CHECK(checked.err.find("study.avatar: " + (scratch / "lost.glb")) != std::string::npos);
        spill(scratch / "lost.glb", "HIERARCHY\n");
        checked = program("check " + (scratch / "study.toml"));
        CHECK(checked.status == 1);
        CHECK(checked.err.find("neither a glTF binary nor glTF text") != std::string::npos);
        CHECK_FAILS_SAYING(program("simulate " + (scratch / "study.toml") + " --participants 1 --db " +
                                   (scratch / "s.sqlite")),
                           "study.avatar");
    }

    TEST_CASE("Sessions keep the hash of the avatar that was shown; the generators' clips are the same") {
        const Scratch scratch;
        const std::string own = (buildDir() / "share/deixis/avatar.glb").string();
        std::string bytes = slurp(own);
        bytes[bytes.find("deixis_make_avatar")] = 'D';  // another file of the same figure
        spill(scratch / "figures/mine.glb", bytes);
        spill(scratch / "study.toml", withAvatar("figures/mine.glb"));
        const std::string stimuli = sharedStimuli();
        const auto checked = program("check " + (scratch / "study.toml"));
        CHECK_MESSAGE(checked.status == 0, checked.err);
        CHECK(checked.out.find("figures/mine.glb, 55 joints") != std::string::npos);
        const auto ran = program("simulate " + (scratch / "study.toml") + " --participants 1 --db " +
                                 (scratch / "s.sqlite") + " --stimuli " + stimuli);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        CHECK(avatarHashes(scratch / "s.sqlite") == deixis::sha256Hex(bytes));
        const auto plain = program("simulate pointing2023-stand-ins --participants 1 --db " +
                                   (scratch / "p.sqlite") + " --stimuli " + stimuli);
        REQUIRE_MESSAGE(plain.status == 0, plain.err);
        CHECK(avatarHashes(scratch / "p.sqlite") == deixis::sha256Hex(slurp(own)));
        const auto clips = [](const std::string& database) {
            return SQLite::Database(database, SQLite::OPEN_READONLY)
                .execAndGet(
                    "SELECT count(DISTINCT clip_hash) || group_concat(DISTINCT clip_hash) FROM "
                    "(SELECT clip_hash FROM response_stimuli ORDER BY 1)")
                .getString();
        };
        CHECK(clips(scratch / "s.sqlite") == clips(scratch / "p.sqlite"));
    }

    TEST_CASE("A replay finds the study's avatar beside the database, and tells a wrong one by its bytes") {
        const Scratch scratch;
        const std::string own = (buildDir() / "share/deixis/avatar.glb").string();
        std::string bytes = slurp(own);
        bytes[bytes.find("deixis_make_avatar")] = 'D';  // another file of the same figure
        spill(scratch / "lab/figures/mine.glb", bytes);
        spill(scratch / "lab/study.toml", withAvatar("figures/mine.glb"));
        const std::string stimuli = sharedStimuli();
        const auto ran = program("simulate " + (scratch / "lab/study.toml") + " --participants 1 --db " +
                                 (scratch / "lab/s.sqlite") + " --stimuli " + stimuli);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        const auto replayed = [&](const std::string& folder, const std::string& more = "") {
            return program("replay " + (scratch / (folder + "/s.sqlite")) + " --participant S001 --choices" +
                           more);
        };
        const auto here = replayed("lab");
        CHECK_MESSAGE(here.status == 0, here.err);
        CHECK(here.out.find(" the same from the ray") != std::string::npos);
        CHECK(here.err.empty());
        // The database and the figure alone, in another folder.
        spill(scratch / "moved/mine.glb", bytes);
        fs::copy_file(scratch / "lab/s.sqlite", scratch / "moved/s.sqlite");
        const std::string clips = " --stimuli " + (scratch / "lab/s.locked");
        CHECK(replayed("moved", clips).status == 0);
        bytes[bytes.find("Deixis_make_avatar")] = 'E';
        spill(scratch / "moved/mine.glb", bytes);
        CHECK_FAILS_SAYING(
            replayed("moved", clips), (scratch / "moved/figures/mine.glb") + " is not there",
            (scratch / "moved/mine.glb") + " is another one (SHA-256 " + deixis::sha256Hex(bytes) + ")",
            avatarHashes(scratch / "moved/s.sqlite"), "name it with --avatar");
        CHECK(replayed("moved", clips + " --avatar " + (scratch / "moved/mine.glb")).status == 0);
        spill(scratch / "moved/mine.glb", "no figure");
        CHECK_FAILS_SAYING(replayed("moved", clips), "neither a glTF binary nor glTF text");
    }

    TEST_CASE("A figure without fingers and eyes carries a whole session") {
        const fs::path figure = sharedData("avatars/kaykit_mannequin/manny_med_mod.gltf");
        DEIXIS_SKIP_WITHOUT(figure);
        const Scratch scratch;
        spill(scratch / "study.toml", replaced(withAvatar(fs::weakly_canonical(figure).string()), "[study]\n",
                                               "[study]\navatar_height_m = 1.8\n"));
        const std::string stimuli = sharedStimuli();
        const auto ran = program("simulate " + (scratch / "study.toml") + " --participants 1 --db " +
                                 (scratch / "s.sqlite") + " --stimuli " + stimuli);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        CHECK(avatarHashes(scratch / "s.sqlite").size() == 64);
    }

    TEST_CASE("A robot of 4.56 m is rejected until the study says how tall it is, and then replayed so") {
        const fs::path robot = sharedData("repro/RobotExpressive.glb");
        DEIXIS_SKIP_WITHOUT(robot);
        const Scratch scratch;
        spill(scratch / "robot.glb", slurp(robot));
        spill(scratch / "study.toml", withAvatar("robot.glb"));
        const auto rejected = program("check " + (scratch / "study.toml"));
        CHECK(rejected.status == 1);
        CHECK(rejected.err.find("study.avatar: " + (scratch / "robot.glb") + ": is 4.56 m tall") !=
              std::string::npos);
        CHECK(rejected.err.find("has 1 problem") != std::string::npos);
        spill(scratch / "study.toml",
              replaced(withAvatar("robot.glb"), "[study]\n", "[study]\navatar_height_m = 1.7\n"));
        const auto checked = program("check " + (scratch / "study.toml"));
        CHECK_MESSAGE(checked.status == 0, checked.err);
        CHECK(checked.out.find("scaled to 1.70 m, as requested") != std::string::npos);
        const std::string stimuli = sharedStimuli();
        const auto ran = program("simulate " + (scratch / "study.toml") + " --participants 1 --db " +
                                 (scratch / "s.sqlite") + " --stimuli " + stimuli);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        const auto replayed = program("replay " + (scratch / "s.sqlite") + " --participant S001 --choices");
        CHECK_MESSAGE(replayed.status == 0, replayed.err);
        spill(scratch / "study.toml",
              replaced(shippedStudy(), "[study]\n", "[study]\navatar_height_m = 1.7\n"));
        CHECK(program("check " + (scratch / "study.toml")).err.find("study.avatar_height_m") !=
              std::string::npos);
    }
}
