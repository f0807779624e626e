// What cannot be together in a study, and how that is told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

TEST_SUITE("studies/study_combinations") {
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
             {"viewer_m = [0, 3]",
              "viewer_m = [0, 3]\ndesktop_viewer_m = [0.1, 0.1]",
              "desktop_viewer_m",
              "layouts.desktop_viewer_m",
              {"at least 0.3 m", "avatar"}},
             {"viewer_m = [0, 3]",
              "viewer_m = [0, 3]\ndesktop_heading_deg = 10",
              "desktop_heading_deg",
              "layouts.desktop_heading_deg",
              {"without desktop_viewer_m"}},
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
             {"generator = \"direct\"",
              "generator = \"direct\"\nprojects = \"authored\"",
              "projects = \"authored\"",
              "systems.projects",
              {"both generator and projects"}},
             {"manifest = \"clips.csv\"",
              "projects = \"authored\"\nhold_s = 1",
              "hold_s",
              "systems.hold_s",
              {"with projects"}},
             {"generator = \"direct\"",
              "generator = \"direct\"\ncontrols = false",
              "controls",
              "systems.controls",
              {"without projects"}},
             {"generator = \"direct\"",
              "generator = \"direct\"\nremark = \"none\"",
              "remark",
              "systems.remark",
              {"with a system that is compared"}},
             {"count = 20",
              "from_projects = \"authored\"",
              "from_projects",
              "targets.from_projects",
              {"without places"}},
             {"manifest = \"clips.csv\"",
              "manifest = \"clips.csv\"\nhold_s = 1",
              "hold_s",
              "systems.hold_s",
              {"with a manifest"}},
             {"generator = \"direct\"",
              "generator = \"direct\"\nkeep = \"pointing-ray\"",
              "keep",
              "systems.keep",
              {"with a generator"}},
             {"generator = \"direct\"",
              "generator = \"direct\"\nfingers = \"pointing\"",
              "fingers",
              "systems.fingers",
              {"with a generator"}},
             {"manifest = \"clips.csv\"",
              "manifest = \"clips.csv\"\nkeep = \"pointing-rey\"",
              "keep",
              "systems.keep",
              {"Did you mean pointing-ray?"}},
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
              {"expected 1 or 2", "no gaps"}},
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
              {"found 1", "do not decrease"}},
             {"kind = \"break\"\ntext = \"@page\"\nminimum_s = 30\n\n[[stages]]\nname = \"play\"\nkind = "
              "\"referential-game\"\nsession = 2",
              "kind = \"break\"\nsession = 2\ntext = \"@page\"\nminimum_s = 30\n\n[[stages]]\nname = "
              "\"play\"\nkind = \"referential-game\"\nsession = 3",
              "session = 2\n",
              "stages.session",
              {"session 2 asks nothing"}},
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
              {"at most count (3)", "never apply"}},
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
             {"kind = \"repeat\"\ncount = 1",
              "kind = \"repeat\"\ncount = 5",
              "count = 5",
              "stages.checks.count",
              {"at most 4"}},
             {"kind = \"repeat\"\ncount = 1",
              "kind = \"repeat\"\ncount = 3",
              "[[stages.checks]]",
              "stages.checks",
              {"6 numbers and repeats", "at most 4"}},
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
              {"occurs twice"}},
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
             {"alpha = 0.05", "alpha = 1.0", "alpha", "analysis.alpha", {"0.5"}},
             {"unit = \"ratings\"", "unit = \"means\"", "unit", "analysis.unit", {"\"participants\""}},
             {"stations = \"together\"",
              "stations = \"mixed\"",
              "stations",
              "analysis.stations",
              {"\"together\""}},
             {"equivalence = {accuracy = 0.1}",
              "equivalence = {accuracy = 2.0}",
              "equivalence",
              "analysis.equivalence.accuracy",
              {"1"}},
             {"leave_out = {same_rating_share = 0.95}",
              "leave_out = {same_rating_share = 95}",
              "leave_out",
              "analysis.leave_out.same_rating_share",
              {"1"}},
             {"leave_out = {same_rating_share = 0.95}",
              "leave_out = {median_time = 0.5}",
              "leave_out",
              "analysis.leave_out.median_time",
              {"median_time_below_s"}}});
    }

    TEST_CASE(
        "Practice of a stage whose answers are neither right nor wrong has no criterion and no feedback.") {
        const Folder folder;
        const std::vector<Error> errors = problemsOf(
            folder.write(replaced(readText(fixtures / "full.toml"), "of = \"play\"", "of = \"rate\"")));
        std::vector<std::string> keys;
        for (const Error& error : errors) keys.push_back(error.where.substr(error.where.rfind(' ') + 1));
        CHECK(keys == std::vector<std::string>{"stages.criterion", "stages.max_attempts",
                                               "stages.end_if_failed", "stages.again_text",
                                               "stages.feedback"});
    }

    TEST_CASE("Practice comes before what is practised, and for participants who come to it.") {
        const Folder folder;
        const std::string practice =
            "[[stages]]\nname = \"try\"\nkind = \"practice\"\nof = \"rate\"\nitems = 1\n";
        const std::string full = readText(fixtures / "full.toml");
        const std::string rate = "[[stages]]\nname = \"rate\"\n";
        const auto first = [&](const std::string& text) {
            return problemsOf(folder.write(text)).at(0).text();
        };
        CHECK(first(replaced(full, "[headset]", practice + "[headset]")).find("comes before its practice") !=
              std::string::npos);
        CHECK(first(replaced(full, rate, practice + "when = {group = \"unseen\"}\n" + rate))
                  .find("expected group = \"seen\"") != std::string::npos);
        CHECK(loaded(folder.write(replaced(full, rate,
                                           practice + "when = {group = \"seen\", order = \"a\"}\n" + rate)))
                  .findStage("try")
                  ->when.size() == 2);
    }

    TEST_CASE("A pair of avatars needs a layout in which neither stands on the participant.") {
        const Folder folder;
        const std::string pairs =
            "kind = \"pairwise\"\nwhen = {group = \"unseen\", order = \"b\"}\nitems = 2\n";
        const std::vector<Error> errors = problemsOf(
            folder.write(replaced(readText(fixtures / "full.toml"), pairs + "layouts = [\"across\"]",
                                  pairs + "layouts = [\"beside\"]")));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].text().find("stages.layouts") != std::string::npos);
        CHECK(errors[0].message.find("m from the participant") != std::string::npos);
    }

    TEST_CASE("A stage has each kind of check once.") {
        const Folder folder;
        const std::vector<Error> errors =
            problemsOf(folder.write(replaced(readText(fixtures / "full.toml"), "kind = \"repeat\"\ncount = 1",
                                             "kind = \"number\"\ncount = 1")));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].text().find("stages.checks.kind") != std::string::npos);
        CHECK(errors[0].message.find("a second time") != std::string::npos);
    }

    TEST_CASE("Factors between participants have no more combinations than participants could fill.") {
        const Folder folder;
        const auto study = [](int factors) {
            std::string text = "[study]\nname = \"s\"\ntitle = \"S\"\nseed = 1\n";
            for (int i = 0; i < factors; ++i)
                text +=
                    fmt::format("[[between]]\nname = \"f{}\"\nlevels = [\"a\", \"b\", \"c\", \"d\"]\n", i);
            return text + "[[stages]]\nname = \"page\"\nkind = \"instructions\"\ntext = \"x\"\n";
        };
        CHECK(loaded(folder.write(study(4))).between.size() == 4);  // 256
        const std::vector<Error> errors = problemsOf(folder.write(study(5)));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].text().find("between.levels: found 1024 combinations") != std::string::npos);
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
        CHECK(errors[0].text().find("\"age\" of a participant already comes from the stage \"one\"") !=
              std::string::npos);
        CHECK(loaded(folder.write(start + "when = {g = \"a\"}\n" + about +
                                  "[[stages]]\nname = \"two\"\nwhen = {g = \"b\"}\n" + about))
                  .stages.size() == 2);
    }

    TEST_CASE("Targets must do for whichever group needs most of them.") {
        // seen: practice 2 x 3, rate 4, play 6 and 2 catch trials; unseen: side 3 or pairs 2 instead of rate;
        // all: author 4.
        const Folder folder;
        const std::string full = readText(fixtures / "full.toml");
        CHECK(loaded(folder.write(replaced(full, "count = 60", "count = 22"))).targets.count == 22);
        const std::vector<Error> errors =
            problemsOf(folder.write(replaced(full, "count = 60", "count = 21")));
        REQUIRE(errors.size() == 1);
        CHECK(errors[0].message.find("at least 22") != std::string::npos);
        CHECK(errors[0].message.find("practice (6), rate (4), play (8), author (4)") != std::string::npos);
    }
}
