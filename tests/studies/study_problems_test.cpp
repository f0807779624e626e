// What is wrong with a study file, and how that is told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

TEST_SUITE("studies/study_problems") {
    TEST_CASE("A mistyped, missing or misplaced key is told with a proposal.") {
        checkEdits(
            "small.toml",
            {{"seed = 7", "sead = 7", "sead = 7", "study.sead", {"unknown key", "Did you mean seed?"}},
             {"items = 4", "itmes = 4", "itmes = 4", "stages.itmes", {"unknown key", "Did you mean items?"}},
             {"seed = 7",
              "seed = 7\ncolour = 3",
              "colour = 3",
              "study.colour",
              {"unknown key", "Known here: name, "}},
             {"[study]", "[studi]", "[studi]", "studi", {"unknown section", "Did you mean study?"}},
             {"heading_deg = 10",
              "heading_deg = 10\nhight_m = 1",
              "hight_m",
              "layouts.hight_m",
              {"unknown key"}},
             {"[study]", "lose = 1\n[study]", "lose = 1", "lose", {"unknown section or key"}},
             {"seed = 7\n", "", "[study]", "study.seed", {"missing", "a whole number, 0 or more"}},
             {"question = \"How natural?\"\n",
              "",
              "[[stages]]\nname = \"naturalness\"",
              "stages.question",
              {"missing", "a text"}},
             {"viewer_m = [0, 3]\n", "", "[[layouts]]", "layouts.viewer_m", {"missing", "two numbers"}},
             {"radius_m = [1.5, 2.0]\n", "", "[targets]", "targets.radius_m", {"missing", "0.3 to 20"}},
             {"kind = \"rating\"\n",
              "",
              "[[stages]]\nname = \"naturalness\"",
              "stages.kind",
              {"missing", "\"referential-game\""}},
             {"kind = \"rating\"", "kind = \"ratting\"", "ratting", "stages.kind", {"Did you mean rating?"}},
             {"name = \"naturalness\"\n", "", "[[stages]]\nkind", "stages.name", {"missing", "a name"}},
             {"low = 1, ", "", "scale = ", "stages.scale.low", {"missing"}},
             {"low = 1, ", "lo = 1, ", "scale = ", "stages.scale.lo", {"unknown key", "low?"}}});
    }

    TEST_CASE("A value of the wrong type or out of range is told with what was found and expected.") {
        checkEdits(
            "small.toml",
            {{"seed = 7", "seed = \"7\"", "seed = ", "study.seed", {"the text \"7\"", "a whole number"}},
             {"kind = \"rating\"",
              "kind = \"rating\"\nmeasure = \"accuracy\"",
              "measure = ",
              "stages.measure",
              {"the report's name for correct choices of the game"}},
             {"items = 4",
              "items = 4.0",
              "items = 4.0",
              "stages.items",
              {"the number 4", "a whole number from 1"}},
             {"title = \"Small\"", "title = 5", "title = 5", "study.title", {"the whole number 5", "a text"}},
             {"title = \"Small\"", "title = 2023-01-01", "title = ", "study.title", {"a date", "a text"}},
             {"title = \"Small\"", "title = \"  \"", "title", "study.title", {"empty text"}},
             {"height_m = [0.5, 1.5]",
              "height_m = 0.5",
              "height_m = 0.5",
              "targets.height_m",
              {"0.5", "[a, b]"}},
             {"height_m = [0.5, 1.5]", "height_m = [0.5]", "height_m", "targets.height_m", {"a list of 1"}},
             {"height_m = [0.5, 1.5]",
              "height_m = [0.5, \"a\"]",
              "height_m",
              "targets.height_m",
              {"entry 2"}},
             {"height_m = [0.5, 1.5]",
              "height_m = [1.5, 0.5]",
              "height_m",
              "targets.height_m",
              {"smaller number first"}},
             {"arc_deg = [-60, 60]",
              "arc_deg = [-60, 200]",
              "arc_deg",
              "targets.arc_deg",
              {"entry 2", "-180 to 180"}},
             {"\"bad\", \"good\"",
              "\"bad\", 2",
              "labels",
              "stages.scale.labels",
              {"entry 2 is the whole number 2"}},
             {"\"bad\", \"good\"", "\"bad\", \"\"", "labels", "stages.scale.labels", {"empty text"}},
             {"items = 4",
              "items = 0",
              "items = 0",
              "stages.items",
              {"the whole number 0", "from 1 to 10000"}},
             {"seed = 7", "seed = -1", "seed = -1", "study.seed", {"-1", "0 or more"}},
             {"distractors = 2",
              "distractors = 9",
              "distractors",
              "distances.distractors",
              {"9", "from 1 to 8"}},
             {"distractors = 2",
              "distractors = 0",
              "distractors",
              "distances.distractors",
              {"0", "from 1 to 8"}},
             {"question = \"Which?\"",
              "question = \"Which?\"\nplays = 0",
              "plays",
              "stages.plays",
              {"0", "from 1"}},
             {"radius_m = [1.5, 2.0]",
              "radius_m = [1.5, 2.0]\nball_diameter_m = nan",
              "ball_diameter_m",
              "targets.ball_diameter_m",
              {"nan", "0.01 to 1"}},
             {"name = \"small\"",
              "name = \"a study\"",
              "name = \"a study\"",
              "study.name",
              {"a study", "letters"}},
             {"layouts = [\"across\"]", "layouts = []", "layouts = []", "stages.layouts", {"a list of 0"}},
             {"layouts = [\"across\"]",
              "layouts = \"across\"",
              "layouts = \"across\"",
              "stages.layouts",
              {"the text", "a list"}}});
    }

    TEST_CASE("No number of a study file may be nan or infinite.") {
        const Folder folder;
        const std::string text = readText(fixtures / "full.toml");
        std::istringstream lines(text);
        int numbers = 0;
        std::size_t at = 0;
        for (std::string line; std::getline(lines, line); at += line.size() + 1) {
            const auto equals = line.find(" = ");
            if (line.starts_with('#') || equals == std::string::npos) continue;
            const std::size_t first = equals + (line[equals + 3] == '[' ? 4 : 3);
            const std::size_t end = std::min(line.find_first_not_of("-.0123456789", first), line.size());
            if (end == first) continue;
            ++numbers;
            const char* bad = std::array{"nan", "inf", "-inf"}[static_cast<std::size_t>(numbers % 3)];
            const std::string changed = std::string(text).replace(at + first, end - first, bad);
            const auto study = loadStudy(folder.write(changed), shipped_folders);
            CAPTURE(line);
            REQUIRE_FALSE(study.has_value());
            const std::string key = line.substr(0, equals).substr(line.find_first_not_of(' '));
            CHECK(allText(study.error()).find(key) != std::string::npos);
            CHECK(allText(study.error()).find(std::string(bad)) != std::string::npos);
        }
        CHECK(numbers > 40);
    }

    TEST_CASE("A scale must rise, fit on a board and have a label for every step, for its ends or none.") {
        const std::string scale = "low = 1, high = 2, labels = [\"bad\", \"good\"]";
        checkEdits(
            "small.toml",
            {{scale, "low = 2, high = 2", "scale", "stages.scale.high", {"found 2", "more than low (2)"}},
             {scale, "low = 5, high = 1", "scale", "stages.scale.high", {"found 1", "more than low (5)"}},
             {scale, "low = 0, high = 11", "scale", "stages.scale.high", {"at most 10", "slider"}},
             {scale,
              "low = 1, high = 5, labels = [\"a\", \"b\", \"c\"]",
              "scale",
              "stages.scale.labels",
              {"a list of 3", "5 texts"}},
             {scale, "low = 1, high = 5, labels = []", "scale", "stages.scale.labels", {"a list of 0"}},
             {scale,
              "kind = \"slider\", low = 1, high = 5, labels = [\"a\"]",
              "scale",
              "stages.scale.labels",
              {"a list of 1", "2 to 11"}},
             {scale,
              "kind = \"slide\", low = 1, high = 5",
              "scale",
              "stages.scale.kind",
              {"Did you mean slider?"}}});
    }

    TEST_CASE("A name that is nowhere is told with the nearest one, at its own place in a list.") {
        checkEdits(
            "small.toml",
            {{"layouts = [\"across\"]",
              "layouts = [\"acros\"]",
              "acros\"]",
              "stages.layouts",
              {"no \"acros\" in [[layouts]]", "Did you mean across?"}},
             {"layouts = [\"across\", \"side-by-side\"]",
              "layouts = [\n\"across\",\n\"behind\"]",
              "behind",
              "stages.layouts",
              {"no \"behind\"", "across, side-by-side"}},
             {"layouts = [\"across\", \"side-by-side\"]",
              "layouts = [\"across\",\n\"across\"]",
              "\"across\"]\ndist",
              "stages.layouts",
              {"occurs twice"}},
             {"distances = [\"near\"]", "distances = [\"neer\"]", "neer", "stages.distances", {"mean near?"}},
             {"question = \"How natural?\"",
              "question = \"How natural?\"\nsystems = [\"our\"]",
              "systems = ",
              "stages.systems",
              {"no \"our\" in [[systems]]", "Did you mean ours?"}},
             {"generator = \"direct\"",
              "generator = \"dirct\"",
              "dirct",
              "systems.generator",
              {"the systems that come with the program", "Did you mean direct?"}},
             {"[[distances]]",
              "[[layouts]]\nname = \"across\"\nviewer_m = [1, 1]\nheading_deg = 0\n[[distances]]",
              "name = \"across\"\nviewer_m = [0, 3]",
              "layouts.name",
              {"\"across\" occurs twice"}},
             {"name = \"game\"",
              "name = \"naturalness\"",
              "name = \"naturalness\"\nkind = \"ref",
              "stages.name",
              {"\"naturalness\" occurs twice"}},
             {"name = \"game\"",
              "name = \"game\"\nwhen = {group = \"a\"}",
              "when",
              "stages.when.group",
              {"no factor \"group\" in [[between]]"}}});
        checkEdits(
            "full.toml",
            {{"when = {group = \"seen\"}",
              "when = {groop = \"seen\"}",
              "groop",
              "stages.when.groop",
              {"mean group?"}},
             {"when = {group = \"seen\"}",
              "when = {group = \"sen\"}",
              "\"sen\"",
              "stages.when.group",
              {"no level \"sen\" of \"group\"", "Did you mean seen?"}},
             {"distance = \"far\"", "distance = \"fur\"", "fur", "stages.checks.distance", {"mean far?"}},
             {"of = \"play\"",
              "of = \"plai\"",
              "plai",
              "stages.of",
              {"no stage \"plai\"", "Did you mean play?"}},
             {"of = \"play\"",
              "of = \"about\"",
              "of = \"about\"",
              "stages.of",
              {"no stage \"about\" with trials"}},
             {"file = \"comfort\"\n\n[headset]",
              "file = \"ssk\"\n\n[headset]",
              "ssk",
              "stages.file",
              {"no ssk.toml in", "Did you mean ssq?"}}});
    }

    TEST_CASE("All problems of a file are told at once, in the order of its lines.") {
        const Folder folder;
        std::string text = readText(fixtures / "small.toml");
        text = replaced(text, "question = \"Which?\"", "quesion = \"Which?\"\nfeedback = 1");
        text = replaced(text, "count = 20", "count = 0");
        text = replaced(text, "seed = 7", "seed = 1.5\nhue = 1");
        text = replaced(text, "layouts = [\"across\"]", "layouts = [\"behind\"]");
        text = replaced(text, "generator = \"direct\"", "generator = \"fast\"");
        const std::vector<Error> errors = problemsOf(folder.write(text));
        std::vector<std::string> keys;
        std::vector<long> lines;
        for (const Error& error : errors) {
            keys.push_back(error.where.substr(error.where.rfind(' ') + 1));
            const std::string tail = error.where.substr(error.where.find(".toml:") + 6);
            lines.push_back(std::strtol(tail.c_str(), nullptr, 10));
        }
        CAPTURE(allText(errors));
        CHECK(keys == std::vector<std::string>{"study.seed", "study.hue", "targets.count",
                                               "systems.generator", "stages.layouts", "stages.quesion",
                                               "stages.feedback"});
        CHECK(std::is_sorted(lines.begin(), lines.end()));
    }

    TEST_CASE("Ratings are tested only where a stage asks for them.") {
        const Folder folder;
        const std::string pairs = readText(shipped_studies / "genea-pairwise.toml");
        const auto file = folder.write(replaced(pairs, "[analysis]\n", "[analysis]\nunit = \"ratings\"\n"));
        CHECK(allText(problemsOf(file))
                  .find("analysis.unit: found \"ratings\", but no stage asks for ratings") !=
              std::string::npos);
    }

    TEST_CASE("A section that is missing altogether is named, for want of a line.") {
        const Folder folder;
        const std::string text = readText(fixtures / "small.toml");
        const auto without = [&](const std::string& from, const std::string& to) {
            const auto at = text.find(from);
            return text.substr(0, at) + text.substr(text.find(to));
        };
        const std::vector<std::array<std::string, 3>> cuts{{"[targets]", "[[distances]]", "targets"},
                                                           {"[[distances]]", "[[layouts]]", "distances"},
                                                           {"[[layouts]]", "[[systems]]", "layouts"},
                                                           {"[[systems]]", "[[stages]]", "systems"},
                                                           {"[study]", "[targets]", "study"}};
        for (const auto& cut : cuts) {
            CAPTURE(cut[2]);
            const fs::path file = folder.write(without(cut[0], cut[1]));
            const std::vector<Error> errors = problemsOf(file);
            REQUIRE_MESSAGE(errors.size() == 1, allText(errors));
            CHECK(errors[0].where == file.string() + ": " + cut[2]);
            CHECK(errors[0].message.find("missing; expected ") == 0);
        }
        const std::vector<Error> empty = problemsOf(folder.write(""));
        CHECK(empty.size() == 2);
        CHECK(empty[0].message == "missing; expected a section [study]");
    }

    TEST_CASE("A file that is no TOML is told with its line, and a file that is not there by its name.") {
        const Folder folder;
        const std::string text = replaced(readText(fixtures / "small.toml"), "seed = 7", "seed == 7");
        const fs::path file = folder.write(text);
        const std::vector<Error> errors = problemsOf(file);
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].where == fmt::format("{}:{}", file.string(), lineOf(text, "seed == 7")));
        CHECK(errors[0].message.find("not valid TOML") != std::string::npos);
        for (const std::string& bytes : {std::string("title = \"\xff\xfe\"\n"), std::string("[study\n"),
                                         std::string("\0\0\0", 3), std::string("a = 1\na = 2\n")})
            CHECK_FALSE(loadStudy(folder.write(bytes), shipped_folders).has_value());
        CHECK(problemsOf(fixtures / "nowhere.toml")[0].text().find("nowhere.toml") != std::string::npos);
    }
}
