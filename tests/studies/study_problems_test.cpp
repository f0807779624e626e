// What is wrong with a study file, and how that is told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <set>
#include <sstream>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

struct BadEdit {
    std::string from, to;
    std::string line_of;  ///< text on the line that the error names, in the edited file
    std::string key;
    std::vector<std::string> words;  ///< what the error must tell
};

/// Each edit gives one problem and no others that only follow from it.
void checkEdits(const std::string& fixture, const std::vector<BadEdit>& edits) {
    const std::string original = readText(fixtures / fixture);
    const Folder folder;
    for (const BadEdit& edit : edits) {
        CAPTURE(edit.from);
        CAPTURE(edit.to);
        const std::string text = replaced(original, edit.from, edit.to);
        const fs::path file = folder.write(text);
        const std::vector<Error> errors = problemsOf(file);
        CHECK_MESSAGE(errors.size() == 1, allText(errors));
        CHECK(errors[0].where ==
              fmt::format("{}:{}: {}", file.string(), lineOf(text, edit.line_of), edit.key));
        for (const std::string& word : edit.words)
            CHECK_MESSAGE(errors[0].text().find(word) != std::string::npos,
                          "'" << word << "' should stand in: " << errors[0].text());
    }
}

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Every error must name the file and a line or a key of it.
void checkErrors(const fs::path& file, const std::string& bytes, int& failures) {
    const auto study = loadStudy(file, shipped_folders);
    if (study) return;
    ++failures;
    CHECK_FALSE(study.error().empty());
    const std::string start = file.string() + ":";
    const long lines = std::count(bytes.begin(), bytes.end(), '\n') + 1;
    for (const Error& error : study.error()) {
        CAPTURE(error.text());
        REQUIRE(error.where.rfind(start, 0) == 0);
        const std::string rest = error.where.substr(start.size());
        const long line = std::strtol(rest.c_str(), nullptr, 10);
        CHECK((rest[0] == ' ' || (line >= 1 && line <= lines)));
        CHECK(rest.size() > 1 - static_cast<std::size_t>(rest[0] != ' '));
        CHECK_FALSE(error.message.empty());
    }
}

}  // namespace

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
             {"seed = 7\n", "", "[study]", "study.seed", {"missing", "a whole number from 0 up"}},
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
             {"seed = 7", "seed = -1", "seed = -1", "study.seed", {"-1", "from 0 up"}},
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
              {"comes twice"}},
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
              {"the built-in systems", "Did you mean direct?"}},
             {"[[distances]]",
              "[[layouts]]\nname = \"across\"\nviewer_m = [1, 1]\nheading_deg = 0\n[[distances]]",
              "name = \"across\"\nviewer_m = [0, 3]",
              "layouts.name",
              {"\"across\" comes twice"}},
             {"name = \"game\"",
              "name = \"naturalness\"",
              "name = \"naturalness\"\nkind = \"ref",
              "stages.name",
              {"\"naturalness\" comes twice"}},
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

    TEST_CASE("Things that do not go together are told.") {
        const std::string game = "question = \"Which?\"";
        const std::string rating = "question = \"How natural?\"";
        checkEdits(
            "small.toml",
            {{"height_m = [0.5, 1.5]",
              "height_m = [0.01, 1.5]",
              "height_m",
              "targets.height_m",
              {"0.05 m", "floor"}},
             {"distance_m = [0.2, 0.4]",
              "distance_m = [0.05, 0.4]",
              "distance_m",
              "distances.distance_m",
              {"0.05 m", "overlap"}},
             {"count = 20",
              "count = 5",
              "count = 5",
              "targets.count",
              {"found 5", "at least 6", "naturalness (2), game (4)"}},
             {"viewer_m = [0, 3]",
              "viewer_m = [0, 0.1]",
              "viewer_m = [0, 0.1]",
              "layouts.viewer_m",
              {"at least 0.3 m", "avatar"}},
             {"count = 20",
              "count = 20\nfrom_manifest = \"clips.csv\"",
              "count = 20",
              "targets.count",
              {"from_manifest"}},
             {"generator = \"direct\"",
              "generator = \"direct\"\nmanifest = \"clips.csv\"",
              "manifest = \"clips.csv\"\n\n[[systems]]",
              "systems.manifest",
              {"both"}},
             {"generator = \"direct\"\n", "", "[[systems]]", "systems.generator", {"missing"}},
             {"manifest = \"clips.csv\"",
              "manifest = \"clips.csv\"\nhold_s = 1",
              "hold_s",
              "systems.hold_s",
              {"with a manifest"}},
             {rating,
              rating + "\ndistances = [\"near\"]",
              "distances = [\"near\"]\nscale",
              "stages.distances",
              {"kind \"rating\"", "\"referential-game\" only"}},
             {rating, rating + "\nfeedback = true", "feedback", "stages.feedback", {"\"practice\" only"}},
             {game, game + "\nmeasure = \"m\"", "measure", "stages.measure", {"kind \"referential-game\""}},
             {"layouts = [\"across\"]\n",
              "",
              "[[stages]]\nname = \"naturalness\"",
              "stages.layouts",
              {"missing"}},
             {"distances = [\"near\"]\n", "", "[[stages]]\nname = \"game\"", "stages.distances", {"missing"}},
             {rating, rating + "\nblock_by = \"layout\"", "block_by", "stages.block_by", {"one level"}},
             {rating,
              rating + "\nblock_order = \"williams\"",
              "block_order",
              "stages.block_order",
              {"without block_by"}},
             {rating,
              rating + "\nblock_by = \"distance\"",
              "block_by",
              "stages.block_by",
              {"one of \"system\", \"layout\""}},
             {rating,
              rating + "\nblock_by = \"system\"\nmax_run_of_system = 2",
              "max_run",
              "stages.max_run_of_system",
              {"block_by"}},
             {rating,
              rating + "\nsystems = [\"ours\"]\nmax_run_of_system = 1",
              "max_run",
              "stages.max_run_of_system",
              {"2 trials, all of one system"}},
             {"items = 2",
              "items = 1\nno_target_twice_running = true",
              "no_target",
              "stages.no_target_twice_running",
              {"2 trials, all of one target"}},
             {rating,
              rating + "\nbreak_every = 2",
              "[[stages]]\nname = \"naturalness\"",
              "stages.break_text",
              {"missing"}},
             {rating,
              rating + "\nbreak_text = \"x\"",
              "break_text",
              "stages.break_text",
              {"without break_every"}},
             {"name = \"welcome\"",
              "name = \"welcome\"\nsession = 2",
              "session",
              "stages.session",
              {"found 2, expected 1 in the first stage"}},
             {"name = \"game\"",
              "name = \"game\"\nsession = 3",
              "session",
              "stages.session",
              {"expected 1 or 2", "left out"}},
             {"kind = \"rating\"",
              "kind = \"parallel-rating\"\nsystems = [\"ours\"]",
              "systems = ",
              "stages.systems",
              {"1 system", "2 to 6"}},
             {"kind = \"rating\"",
              "kind = \"rating\"\nsession = 1\nwhen = {}",
              "when",
              "stages.when",
              {"{factor = \"level\"}"}},
             {"[study]",
              "between = 3\n[study]",
              "between = 3",
              "between",
              {"the whole number 3", "[[between]]"}}});
    }

    TEST_CASE("What no study of several stages can be is told.") {
        checkEdits(
            "full.toml",
            {{"name = \"after\"",
              "name = \"after\"\nsession = 1",
              "session = 1\n",
              "stages.session",
              {"found 1", "do not go back"}},
             {"levels = [\"a\", \"b\"]",
              "levels = [\"a\"]",
              "levels = [\"a\"]",
              "between.levels",
              {"a list of 1"}},
             {"[[stages]]\nname = \"consent\"",
              "[[between]]\nname = \"hold\"\nlevels = [\"x\", \"y\"]\n[[stages]]\nname = \"consent\"",
              "name = \"hold\"",
              "between.name",
              {"systems' levels"}},
             {"[[stages]]\nname = \"consent\"",
              "[[between]]\nname = \"group\"\nlevels = [\"x\", \"y\"]\n[[stages]]\nname = \"consent\"",
              "name = \"group\"\nlevels = [\"x\"",
              "between.name",
              {"twice"}},
             {"levels = {hold = \"long\"}",
              "levels = {hold = \"short\"}",
              "hold = \"short\"",
              "systems.levels.hold",
              {"\"short\" for all systems", "two levels"}},
             {"criterion = 0.6\nmax_attempts = 2\nend_if_failed = true",
              "max_attempts = 2",
              "max_attempts",
              "stages.max_attempts",
              {"expected 1 without a criterion"}},
             {"again_text = \"@page\"\n",
              "",
              "[[stages]]\nname = \"practice\"",
              "stages.again_text",
              {"missing"}},
             {"max_attempts = 2\n", "", "again_text", "stages.again_text", {"without max_attempts over 1"}},
             {"after_failures = 2",
              "after_failures = 4",
              "after_failures",
              "stages.checks.after_failures",
              {"at most count (3)", "never hold"}},
             {"tolerance = 10",
              "tolerance = 101",
              "tolerance = 101",
              "stages.checks.tolerance",
              {"0 to 100"}},
             {"tolerance = 10",
              "tolerance = 10\nafter_failures = 1",
              "after_failures = 1",
              "stages.checks.after_failures",
              {"rule \"note\""}},
             {"count = 2\ndistance = \"far\"",
              "count = 2",
              "[[stages.checks]]\nkind = \"catch\"",
              "stages.checks.distance",
              {"missing"}},
             {"kind = \"catch\"",
              "kind = \"number\"",
              "kind = \"number\"\ncount = 2",
              "stages.checks.kind",
              {"the text \"number\", expected \"catch\""}},
             {"kind = \"repeat\"\ncount = 2",
              "kind = \"repeat\"\ncount = 5",
              "count = 5",
              "stages.checks.count",
              {"at most 4"}},
             {"per_page = 3",
              "per_page = 3\nfile = \"comfort\"",
              "[[stages.questions]]",
              "stages.questions",
              {"both"}},
             {"file = \"comfort\"\n\n[headset]",
              "file = \"comfort\"\nper_page = 2\n[headset]",
              "per_page = 2",
              "stages.per_page",
              {"file"}},
             {"id = \"sure\"",
              "id = \"tired\"",
              "id = \"tired\"\nkind = \"scale\"\ntext = \"@ask\"\nscale",
              "stages.questions.id",
              {"comes twice"}},
             {"id = \"right\"",
              "id = \"left\"",
              "options = [{id = \"left\"",
              "stages.questions.options.id",
              {"twice"}},
             {"low = 0.5\nhigh = 2.5",
              "low = 2.5\nhigh = 2.5",
              "high = 2.5",
              "stages.questions.high",
              {"more than low"}},
             {"text = \"@ask\"\nlow = 0.5",
              "text = \"@ask\"\noptions = []\nlow = 0.5",
              "options = []",
              "stages.questions.options",
              {"kind \"number\""}},
             {"session = 2",
              "session = 2\nabout_participant = true",
              "about_participant = true\nitems",
              "stages.about_participant",
              {"\"questionnaire\" only"}},
             {"eye_level = \"scale\"", "eye_level = \"lift\"", "lift", "headset.eye_level", {"\"raise\""}},
             {"alpha = 0.05", "alpha = 1.0", "alpha", "analysis.alpha", {"0.5"}}});
    }

    TEST_CASE("Fields of participants come from one question, unless no participant is asked twice.") {
        const Folder folder;
        const std::string about =
            "kind = \"questionnaire\"\nabout_participant = true\nquestions = [{id = \"age\", kind = "
            "\"number\", text = "
            "\"Age?\"}]\n";
        const std::string start =
            "[study]\nname = \"s\"\ntitle = \"S\"\nseed = 1\n[[between]]\nname = \"g\"\nlevels = "
            "[\"a\", \"b\"]\n[[stages]]\nname = \"one\"\n";
        const std::vector<Error> errors =
            problemsOf(folder.write(start + about + "[[stages]]\nname = \"two\"\n" + about));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].text().find("\"age\" of a participant comes from the stage \"one\"") !=
              std::string::npos);
        CHECK(loaded(folder.write(start + "when = {g = \"a\"}\n" + about +
                                  "[[stages]]\nname = \"two\"\nwhen = {g = \"b\"}\n" + about))
                  .stages.size() == 2);
    }

    TEST_CASE("Targets must do for whichever group needs most of them.") {
        // seen: practice 2 x 3, rate 4, play 6 and 2 catch trials; unseen: side 3 or pairs 2 instead of rate.
        const Folder folder;
        const std::string full = readText(fixtures / "full.toml");
        CHECK(loaded(folder.write(replaced(full, "count = 60", "count = 18"))).targets.count == 18);
        const std::vector<Error> errors =
            problemsOf(folder.write(replaced(full, "count = 60", "count = 17")));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].message.find("at least 18") != std::string::npos);
        CHECK(errors[0].message.find("practice (6), rate (4), play (8)") != std::string::npos);
    }

    TEST_CASE("Texts: what lacks a language, is used nowhere, is nowhere or stands as written is told.") {
        checkEdits(
            "full.toml",
            {{"mid = \"mittel\"\n", "", "[texts.de]", "texts.de.mid", {"missing", "[texts.en]"}},
             {"mid = \"middle\"\n", "", "[texts.en]", "texts.en.mid", {"missing", "[texts.de]"}},
             {"mid = \"mittel\"",
              "mit = \"mittel\"",
              "mit = ",
              "texts.de.mit",
              {"used nowhere", "Did you mean mid?"}},
             {"mid = \"mittel\"", "mid = \" \"", "mid = \" \"", "texts.de.mid", {"empty text"}},
             {"mid = \"mittel\"", "mid = 3", "mid = 3", "texts.de.mid", {"the whole number 3", "a text"}},
             {"mid = \"mittel\"",
              "mid = \"mittel\"\nfoe = \"x\"",
              "foe",
              "texts.de.foe",
              {"used nowhere", "Remove it"}},
             {"emphasis = \"@line\"",
              "emphasis = \"@lime\"",
              "@lime",
              "stages.emphasis",
              {"no text \"lime\"", "Did you mean line?"}},
             {"languages = [\"en\", \"de\"]",
              "languages = [\"en\", \"de\", \"de\"]",
              "languages = [",
              "study.languages",
              {"\"de\" comes twice"}},
             {"[texts.de]",
              "[texts.dee]",
              "[texts.dee]",
              "texts.dee",
              {"not among languages", "Did you mean de?"}},
             {"[targets]",
              "[texts.sv]\npage = \"Sida\"\n[targets]",
              "[texts.sv]",
              "texts.sv",
              {"not among languages"}},
             {"[targets]",
              "[texts]\nsv = 2\n[targets]",
              "sv = 2",
              "texts.sv",
              {"the whole number 2", "[texts.en]"}},
             {"title = \"@title\"\ndescription",
              "title = \"Plain\"\ndescription",
              "title = \"Plain\"",
              "study.title",
              {"in one language", "2 languages"}}});
    }

    TEST_CASE(
        "The study is told where the program or a questionnaire has no words in one of its languages.") {
        const Folder folder;
        std::string text = replaced(readText(fixtures / "full.toml"), "[\"en\", \"de\"]", "[\"en\", \"fr\"]");
        text = replaced(text, "[texts.de]", "[texts.fr]");
        const std::vector<Error> errors = problemsOf(folder.write(text));
        REQUIRE_MESSAGE(errors.size() == 2, allText(errors));
        CHECK(errors[0].where.find("study.languages") != std::string::npos);
        CHECK(errors[0].message.find("fr.toml") != std::string::npos);
        CHECK(errors[1].where.find("stages.file") != std::string::npos);
        CHECK(errors[1].message.find("has no texts in \"fr\", only in de, en, sv") != std::string::npos);

        const std::vector<Error> wanted = problemsOf(fixtures / "full.toml", "sv");
        REQUIRE(wanted.size() == 1);
        CHECK(wanted[0].message.find("no language \"sv\"") != std::string::npos);
        CHECK(wanted[0].message.find("en, de") != std::string::npos);
    }

    TEST_CASE("The problems of a questionnaire file come in its own lines, at the place where it is named.") {
        const Folder folder;
        std::string comfort = readText(fixtures / "comfort.toml");
        comfort = replaced(comfort, "reversed = [\"tense\"]", "reversed = [\"tens\"]");
        comfort = replaced(comfort, "per_page = 2", "per_page = 0");
        const fs::path questionnaire = folder.write(comfort, "comfort.toml");
        std::string text = replaced(readText(fixtures / "full.toml"), "seed = 11", "sead = 11");
        text = replaced(text, "minimum_s = 30", "minimum_s = -30");
        const fs::path file = folder.write(text);
        const std::vector<Error> errors = problemsOf(file);
        std::vector<std::string> places;
        for (const Error& error : errors) places.push_back(error.where);
        CHECK(places ==
              std::vector<std::string>{
                  fmt::format("{}:{}: study.sead", file.string(), lineOf(text, "sead")),
                  fmt::format("{}:{}: per_page", questionnaire.string(), lineOf(comfort, "per_page")),
                  fmt::format("{}:{}: scores.reversed", questionnaire.string(), lineOf(comfort, "tens\"]")),
                  fmt::format("{}:{}: stages.minimum_s", file.string(), lineOf(text, "-30"))});
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

    TEST_CASE("Whatever happens to a line of a file, loading tells of it by line or key and never throws.") {
        const Folder folder;
        for (const fs::path& path : {shipped_studies / "pointing2023.toml", fixtures / "full.toml"}) {
            const std::vector<std::string> lines = linesOf(readText(path));
            int failures = 0;
            int tries = 0;
            const auto attempt = [&](const std::vector<std::string>& edited) {
                const std::string bytes = joined(edited);
                const fs::path file = folder.write(bytes);
                ++tries;
                CHECK_NOTHROW(checkErrors(file, bytes, failures));
            };
            for (std::size_t i = 0; i < lines.size(); ++i) {
                CAPTURE(i);
                CAPTURE(lines[i]);
                std::vector<std::string> edited = lines;
                edited.erase(edited.begin() + static_cast<std::ptrdiff_t>(i));
                attempt(edited);
                edited = lines;
                edited.insert(edited.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
                attempt(edited);
                const std::size_t equals = lines[i].find(" = ");
                if (equals == std::string::npos) continue;
                for (const char* value : {"-1", "1e300", "\"\"", "\"@\"", "true", "[]", "{}", "[[1]]", "[{}]",
                                          "1979-05-27", "nan", "\"x\""}) {
                    edited = lines;
                    edited[i] = lines[i].substr(0, equals) + " = " + value;
                    attempt(edited);
                }
                edited = lines;
                edited[i] = "x" + lines[i];
                attempt(edited);
            }
            CHECK(failures > tries / 2);
        }
    }
}
