// Studies whose clips are made of the studio's projects, through the real program.
#include <SQLiteCpp/SQLiteCpp.h>

#include <set>

#include "assets/projects/studio_project.hpp"
#include "program.hpp"
#include "speech/sound/wav.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

constexpr const char* study_text = R"(
[study]
name = "spoken"
title = "Spoken"
seed = 3

[targets]
from_projects = "speeches"

[[layouts]]
name = "across"
viewer_m = [0.0, 3.4]
heading_deg = 180.0

[[systems]]
name = "REF"
projects = "speeches"
compared = false
remark = "by rules: synthetic"

[[systems]]
name = "AUTO"
projects = "speeches"

[[systems]]
name = "MANUAL"
projects = "speeches"

[[stages]]
name = "fit"
kind = "parallel-rating"
items = 2
layouts = ["across"]
question = "How well do they match?"
scale = {low = 1, high = 5}
)";

std::string project(const std::string& text, const std::string& system) {
    return json{{"format", "deixis-studio"},
                {"version", 2},
                {"document",
                 {{"name", "x"},
                  {"text", text},
                  {"voice", "kal16"},
                  {"seed", 1},
                  {"speech", nullptr},
                  {"motion", nullptr},
                  {"system", system},
                  {"bypass", {{"pose", false}, {"style", false}}},
                  {"poseControls", json::array()},
                  {"styleControls", json::array()}}}}
        .dump();
}

/// The study above, with two speeches.
struct SpokenStudy {
    Scratch scratch{};
    std::string study = scratch / "study.toml";

    SpokenStudy() {
        spill(study, study_text);
        for (const auto& [item, text] :
             {std::pair("big", "This is big."), std::pair("here", "Come over here.")})
            for (const auto& [name, maker] :
                 {std::pair("REF", "rules"), std::pair("AUTO", "model"), std::pair("MANUAL", "keyframes")})
                spill(file(item, name), project(text, maker));
    }
    [[nodiscard]] std::string file(const std::string& item, const std::string& system) const {
        return scratch / ("speeches/" + item + "." + system + ".json");
    }
    void change(const std::string& from, const std::string& to) const {
        spill(study, replaced(slurp(study), from, to));
    }
    [[nodiscard]] Finished check() const { return program("check " + study); }
};

/// That it failed, with these words.
void checkTold(const Finished& finished, std::initializer_list<const char*> words) {
    INFO(finished.err);
    CHECK(finished.status == 1);
    for (const char* word : words) CHECK_MESSAGE(contains(finished.err, word), word);
}

/// Of the only set that is locked beside a database.
fs::path onlySet(const fs::path& locked) {
    for (const auto& entry : fs::directory_iterator(locked))
        if (entry.is_directory()) return entry.path();
    return {};
}

}  // namespace

TEST_SUITE("app/project_studies") {
    TEST_CASE("A study of projects is checked, run, locked with its projects, and reported") {
        const SpokenStudy spoken;
        const auto checked = spoken.check();
        REQUIRE_MESSAGE(checked.status == 0, checked.err);
        CHECK(contains(checked.out,
                       "system REF: 2 projects (by rules, synthetic); not compared: by rules: synthetic"));
        CHECK(contains(checked.out, "system AUTO: 2 projects (by model, learned-from-synthetic)"));
        CHECK(contains(checked.out, "system MANUAL: 2 projects (by keyframes)"));
        const std::string database = spoken.scratch / "study.sqlite";
        const std::string run = "simulate " + spoken.study + " --participants 3 --db " + database;
        const auto ran = program(run);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);

        const fs::path set = onlySet(spoken.scratch / "study.locked");
        const std::string manifest = slurp(set / "clips/REF/manifest.csv");
        CHECK(contains(manifest, "big.bvh,REF,big,"));
        CHECK(contains(manifest, ",synthetic,big.bvh.wav"));
        CHECK(contains(slurp(set / "clips/AUTO/manifest.csv"), ",learned-from-synthetic,"));
        CHECK(slurp(set / "clips/AUTO/big.bvh.json") == slurp(spoken.file("big", "AUTO")));
        // A speech is the same in all conditions, and so is its sound.
        CHECK(slurp(set / "clips/AUTO/big.bvh.wav") == slurp(set / "clips/MANUAL/big.bvh.wav"));
        const auto sound = speech::readWav(set / "clips/AUTO/big.bvh.wav");
        REQUIRE(sound.has_value());
        CHECK(durationOf(*sound) > 0.5);

        // Found again; a changed project is told.
        std::set<std::string> made;
        for (const auto& entry : fs::directory_iterator(spoken.scratch / "stimuli"))
            made.insert(entry.path().filename().string());
        CHECK(made.size() == 3);
        spill(spoken.file("big", "AUTO"), project("This is very big.", "model"));
        const auto changed =
            program("run " + spoken.study + " --station simulated --participant S010 --db " + database);
        CHECK_MESSAGE(contains(changed.err, "speeches/big.AUTO.json has changed"),
                      (changed.err + changed.out));
        spill(spoken.file("big", "AUTO"), project("This is big.", "model"));

        const auto reported = program("report " + database + " -o " + (spoken.scratch / "r.html") +
                                      " --json " + (spoken.scratch / "r.json"));
        REQUIRE_MESSAGE(reported.status == 0, reported.err);
        const json out = json::parse(slurp(spoken.scratch / "r.json"));
        CHECK(out["pairwise"].size() == 1);
        REQUIRE(out["not_compared"].size() == 1);
        CHECK(out["not_compared"][0]["system"] == "REF");
        CHECK(out["not_compared"][0]["n"] == 6);
        CHECK(out["synthetic_systems"] == json{{"AUTO", "learned from synthetic"}, {"REF", "synthetic"}});
        const std::string page = slurp(spoken.scratch / "r.html");
        CHECK(contains(page, "REF (synthetic)"));
        CHECK(contains(page,
                       "The motion of AUTO was made by a system that learned from synthetic demonstrations"));
    }

    TEST_CASE("Authors begin with projects without what is in them") {
        const SpokenStudy spoken;
        json posed = json::parse(project("This is big.", "model"));
        json frame = json::array();
        for (const double number : motion::numbersOf(motion::relaxedUpperBody())) frame.push_back(number);
        posed["document"]["poseControls"].push_back({{"start", 2}, {"length", 1}, {"base", {frame}}});
        spill(spoken.file("big", "AUTO"), posed.dump());
        spoken.change("name = \"AUTO\"\nprojects = \"speeches\"\n",
                      "name = \"AUTO\"\nprojects = \"speeches\"\ncontrols = false\n");
        REQUIRE(
            program("simulate " + spoken.study + " --participants 1 --db " + (spoken.scratch / "s.sqlite"))
                .status == 0);
        const json begun =
            json::parse(slurp(onlySet(spoken.scratch / "s.locked") / "clips/AUTO/big.bvh.json"));
        CHECK(begun["document"]["poseControls"].empty());
        CHECK(begun["document"]["text"] == "This is big.");
    }

    TEST_CASE("What is wrong with a study's projects is told with its place") {
        const SpokenStudy spoken;
        fs::rename(spoken.file("here", "AUTO"), spoken.file("here", "OTHER"));
        checkTold(spoken.check(),
                  {"systems.projects: ", "has no project of system 'AUTO' for 1 of 2 items: here.AUTO.json"});
        fs::rename(spoken.file("here", "OTHER"), spoken.file("here", "AUTO"));
        spill(spoken.file("here", "AUTO"), "{");
        checkTold(spoken.check(), {"here.AUTO.json", "no project of the studio"});
        json newer = json::parse(project("Hm.", "model"));
        newer["version"] = 3;
        spill(spoken.file("here", "AUTO"), newer.dump());
        checkTold(spoken.check(), {"here.AUTO.json.version", "found 3, expected at most 2"});
        spill(spoken.file("here", "AUTO"), project(" ", "model"));
        checkTold(spoken.check(), {"here.AUTO.json.document.speech", "is not there yet"});
        spill(spoken.file("here", "AUTO"), project("Come over here.", "model"));
        spill(spoken.scratch / "speeches/note.json", "{}");
        checkTold(spoken.check(), {"targets.from_projects", "found note.json, expected names"});
        fs::remove(spoken.scratch / "speeches/note.json");
        spoken.change("from_projects = \"speeches\"", "from_projects = \"nowhere\"");
        checkTold(spoken.check(), {"study.toml:8: targets.from_projects", "No such folder"});
        spoken.change("from_projects = \"nowhere\"",
                      "count = 2\nheight_m = [1.0, 1.5]\narc_deg = [-60, 60]\nradius_m = [1.5, 2.0]");
        checkTold(spoken.check(), {"systems.projects", "projects point at nothing"});
    }

    TEST_CASE("A voice that there is not is told where the clips are made") {
        const SpokenStudy spoken;
        json other = json::parse(project("Come over here.", "model"));
        other["document"]["voice"] = "nobody";
        spill(spoken.file("here", "AUTO"), other.dump());
        CHECK_FAILS_SAYING(
            program("simulate " + spoken.study + " --participants 1 --db " + (spoken.scratch / "s.sqlite")),
            "here.AUTO.json", "nobody");
    }

    TEST_CASE("The speeches that ship last 5 to 10 s, or 17 to 24 s, in four conditions") {
        for (const auto& [folder, low, high] :
             {std::tuple("relaxed", 5.0, 10.0), std::tuple("rushed", 17.0, 24.0)}) {
            const Scratch scratch;
            const fs::path shipped = sourceDir() / "assets/data/speeches" / folder;
            std::string files;
            int speeches = 0;
            for (const auto& entry : fs::directory_iterator(shipped)) {
                if (!entry.path().filename().string().ends_with(".MANUAL.json"))
                    continue;  // of four, the quickest
                files += entry.path().string() + " ";
                ++speeches;
                std::string item = entry.path().filename().string();
                item.resize(item.find('.'));
                std::set<std::string> texts;
                for (const char* system : {"REF", "AUTO", "SGT", "MANUAL"}) {
                    const auto read = assets::readStudioProject(shipped / (item + "." + system + ".json"));
                    REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
                    texts.insert(read->voice + ": " + read->text);
                    CHECK(read->author == "deixis");
                    CHECK(read->wav.empty());
                    CHECK(read->system == (system == std::string("REF")      ? "rules"
                                           : system == std::string("MANUAL") ? "keyframes"
                                                                             : "model"));
                    CHECK((read->pose_controls >= 3) ==
                          (system == std::string("SGT") || system == std::string("MANUAL")));
                    CHECK((read->style_controls > 0) == (system == std::string("SGT")));
                }
                CHECK(texts.size() == 1);
            }
            CHECK(speeches == 12);
            const auto made = program("clips author " + files + " -o " + (scratch / "clips"));
            REQUIRE_MESSAGE(made.status == 0, made.err);
            for (const auto& entry : fs::directory_iterator(scratch / "clips")) {
                if (entry.path().extension() != ".wav") continue;
                CAPTURE(entry.path().filename().string());
                const auto sound = speech::readWav(entry.path());
                REQUIRE(sound.has_value());
                CHECK(durationOf(*sound) >= low);
                CHECK(durationOf(*sound) <= high);
            }
        }
    }
}
