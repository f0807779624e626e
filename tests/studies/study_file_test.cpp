#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "core/hash.hpp"
#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

const fs::path shipped_pointing = shipped_studies / "pointing2023.toml";

const Stage& stageOf(const Study& study, std::string_view name) {
    const Stage* stage = study.findStage(name);
    REQUIRE_MESSAGE(stage != nullptr, std::string(name));
    return *stage;
}

/// Keys in the tables of docs/study-file.md: below a heading that names sections in backticks every first
/// cell in backticks that is no quoted value. A heading "### Word" goes on with the section before it.
std::vector<std::string> documentedKeys() {
    std::istringstream lines(readText(source / "docs/study-file.md"));
    std::vector<std::string> out;
    std::vector<std::string> sections;
    std::vector<std::string> rows;
    const auto flush = [&] {
        for (const std::string& section : sections)
            for (const std::string& row : rows) out.push_back(section + "." + row);
        rows.clear();
    };
    for (std::string line; std::getline(lines, line);) {
        if (line == "## Questionnaire files") break;
        if (line.rfind("##", 0) == 0) {
            const bool top = line.rfind("## ", 0) == 0;
            if (!top && line.find("`[") == std::string::npos) continue;
            flush();
            sections.clear();
            for (std::size_t at = line.find("`["); at != std::string::npos; at = line.find("`[", at + 1)) {
                std::string section;
                for (std::size_t i = at + 1; line[i] != '`'; ++i)
                    if (line[i] != '[' && line[i] != ']') section += line[i];
                sections.push_back(section);
            }
        }
        if (line.rfind("| `", 0) == 0 && line[3] != '"')
            rows.push_back(line.substr(3, line.find('`', 3) - 3));
    }
    flush();
    return out;
}

}  // namespace

TEST_SUITE("studies/study_file") {
    TEST_CASE("The study that ships holds the numbers of the paper's sections 2.4.2, 2.4.3 and 3.1.") {
        const Study study = loaded(shipped_pointing);
        CHECK(study.name == "pointing2023");
        CHECK(study.seed == 2023);
        CHECK(study.systems.size() == 4);
        CHECK(study.targets.count == 100);
        CHECK(study.alpha == 0.01);
        const Stage& rating = stageOf(study, "naturalness");
        CHECK(rating.kind == StageKind::rating);
        CHECK(rating.scored());
        CHECK(rating.measure == "naturalness");
        CHECK(rating.question == "How natural do you find the animation?");
        CHECK(rating.scale.low == 1);
        CHECK(rating.scale.high == 5);
        CHECK(rating.scale.labels.size() == 5);
        CHECK(rating.design.layouts == std::vector<std::string>{"across"});
        const Stage& game = stageOf(study, "game");
        CHECK(game.design.layouts == std::vector<std::string>{"across", "side-by-side"});
        CHECK(game.design.layout_meets == Crossing::nested);
        REQUIRE(game.design.distances == std::vector<std::string>{"near"});
        const DistanceBand* band = study.findDistance("near");
        REQUIRE(band != nullptr);
        CHECK(band->distractors == 2);
        CHECK(band->distance_m.low == 0.20);
        CHECK(band->distance_m.high == 0.40);
        // 39 participants gave 780 ratings and 1,560 choices.
        CHECK(39 * static_cast<std::size_t>(rating.design.items) * rating.design.systems.size() == 780);
        CHECK(39 * static_cast<std::size_t>(game.design.items) * game.design.systems.size() == 1560);
        CHECK(stageOf(study, "naturalness-practice").design.items == 2);
        CHECK(stageOf(study, "game-practice").design.items == 2);
        // "age: min = 20, median = 23, max = 39; female: 16, male: 23" (3.1); and a comment.
        const Stage& about = stageOf(study, "about-you");
        CHECK(about.about_participant);
        CHECK(about.questionnaire.find("age") != nullptr);
        CHECK(about.questionnaire.find("gender") != nullptr);
        const Stage& comment = stageOf(study, "comment");
        CHECK_FALSE(comment.about_participant);
        CHECK(comment.questionnaire.questions.front().kind == QuestionKind::text);
        CHECK_FALSE(comment.questionnaire.questions.front().required);
        CHECK(study.hash == sha256Hex(readText(shipped_pointing)));
        CHECK(study.file == shipped_pointing);
    }

    TEST_CASE("Across looks back at the avatar from beyond the balls; side-by-side stands at its shoulder.") {
        const Study study = loaded(shipped_pointing);
        const Layout* across = study.findLayout("across");
        const Layout* beside = study.findLayout("side-by-side");
        REQUIRE(across != nullptr);
        REQUIRE(beside != nullptr);
        CHECK(study.findLayout("behind") == nullptr);
        CHECK(across->viewer_z_m > study.targets.radius_m.high);
        CHECK(across->heading_deg == 180.0);
        CHECK(std::abs(beside->viewer_x_m) < 1.5);
        CHECK(std::abs(beside->viewer_x_m) > 0.5);
        CHECK(std::abs(beside->heading_deg) <= 30.0);
    }

    TEST_CASE("Every study that ships loads in each of its four languages, with other texts and one hash.") {
        int files = 0;
        for (const fs::directory_entry& entry : fs::directory_iterator(shipped_studies)) {
            CAPTURE(entry.path().string());
            ++files;
            const Study first = loaded(entry.path());
            CHECK(first.languages == std::vector<std::string>{"en", "de", "sv", "ko"});
            CHECK(first.language == "en");
            std::set<std::string> titles;
            for (const std::string& language : first.languages) {
                const Study study = loaded(entry.path(), language);
                CHECK(study.language == language);
                CHECK(study.words.code() == language);
                CHECK(study.hash == first.hash);
                CHECK(study.stages.size() == first.stages.size());
                titles.insert(study.title + "\n" + study.stages.front().text);
            }
            CHECK(titles.size() == 4);
        }
        CHECK(files >= 5);
    }

    TEST_CASE("A file with the required keys alone loads, and the rest has the documented defaults.") {
        const Study study = loaded(fixtures / "small.toml");
        CHECK(study.languages == std::vector<std::string>{"en"});
        CHECK(study.eye_height_m == 1.65);
        CHECK(study.inter_trial_s == 0.6);
        CHECK(study.instructions_again_after_s == 3600.0);
        CHECK(study.after_interruption == AfterInterruption::resume);
        CHECK(study.alpha == 0.01);
        CHECK(study.description.empty());
        CHECK(study.targets.ball_diameter_m == 0.1);
        CHECK(study.between.empty());
        CHECK(study.headset.eye_level == EyeLevel::measured);
        CHECK(study.headset.assumed_eye_height_m == 1.65);
        CHECK(study.headset.place_tolerance_m == 0.3);
        CHECK_FALSE(study.headset.record_gaze);
        CHECK_FALSE(study.headset.record_hands);
        CHECK_FALSE(study.systems[0].hold_s.has_value());
        CHECK(study.systems[0].levels.empty());
        const Stage& rating = stageOf(study, "naturalness");
        CHECK(rating.design.systems == std::vector<std::string>{"ours", "theirs"});
        CHECK(rating.design.system_meets == Crossing::crossed);
        CHECK(rating.design.layout_meets == Crossing::nested);
        CHECK(rating.design.block_by.empty());
        CHECK(rating.design.max_run_of_system == 0);
        CHECK_FALSE(rating.design.no_target_twice_running);
        CHECK(rating.measure == "naturalness");
        CHECK(rating.scale.kind == ScaleKind::steps);
        CHECK(rating.plays == 1);
        CHECK(rating.max_replays == 0);
        CHECK(rating.break_every == 0);
        CHECK(rating.session == 1);
        CHECK(rating.when.empty());
        CHECK(rating.checks.empty());
        const Stage& game = stageOf(study, "game");
        CHECK(game.measure.empty());
        CHECK(game.design.distance_meets == Crossing::nested);
        CHECK_FALSE(game.feedback);
        CHECK(game.time_limit_s == 0.0);
        CHECK_FALSE(game.confidence.has_value());
    }

    TEST_CASE("What a file says of study, systems, factors, headset and analysis is what the study holds.") {
        const Study study = loaded(fixtures / "full.toml");
        CHECK(study.title == "Everything");
        CHECK(study.description == "every key");
        CHECK(study.eye_height_m == 1.5);
        CHECK(study.inter_trial_s == 1.0);
        CHECK(study.after_interruption == AfterInterruption::repeat);
        CHECK(study.instructions_again_after_s == 60.0);
        CHECK(study.avatar == fixtures / "figures/child.vrm");
        CHECK(study.targets.ball_diameter_m == 0.08);
        CHECK_FALSE(study.targets.clear_view);
        REQUIRE(study.layouts.size() == 2);
        CHECK_FALSE(study.layouts[0].desktop.has_value());
        REQUIRE(study.layouts[1].desktop.has_value());
        CHECK(study.layouts[1].desktop->x_m == -0.7);
        CHECK(study.layouts[1].desktop->z_m == -1.2);
        CHECK(study.layouts[1].desktop->heading_deg == 5.0);
        REQUIRE(study.distances.size() == 2);
        CHECK(study.distances[1].distractors == 1);
        const SystemSource* system = study.findSystem("long");
        REQUIRE(system != nullptr);
        CHECK(system->hold_s == 2.0);
        CHECK(system->unsteadiness_m == 0.01);
        CHECK(system->levels == std::map<std::string, std::string>{{"hold", "long"}});
        CHECK(system->keep == motion::Keep::joint_angles);
        CHECK_FALSE(system->pointing_fingers);
        const SystemSource* lab = study.findSystem("lab");
        CHECK(lab->manifest == (fixtures / "clips.csv").string());
        CHECK(lab->keep == motion::Keep::pointing_ray);
        CHECK(lab->pointing_fingers);
        REQUIRE(study.between.size() == 2);
        CHECK(study.between[1].name == "order");
        CHECK(study.between[1].levels == std::vector<std::string>{"a", "b"});
        CHECK(study.headset.eye_level == EyeLevel::scale);
        CHECK(study.headset.assumed_eye_height_m == 1.2);
        CHECK(study.headset.place_tolerance_m == 0.45);
        CHECK(study.headset.record_gaze);
        CHECK(study.headset.record_hands);
        CHECK(study.alpha == 0.05);
        CHECK(study.by_ratings);
        CHECK(study.stations_together);
        CHECK(study.equivalence == std::map<std::string, double>{{"accuracy", 0.1}});
        CHECK(study.leave_out.same_rating_share == 0.95);
        CHECK_FALSE(study.leave_out.one_side_share);
    }

    TEST_CASE("What a file says of pages and questionnaires is what the stages hold.") {
        const Study study = loaded(fixtures / "full.toml");
        CHECK(stageOf(study, "consent").text == "A page.");
        CHECK(stageOf(study, "how").emphasis == "A line.");
        CHECK(stageOf(study, "how").minimum_s == 5.0);
        CHECK(stageOf(study, "rest").kind == StageKind::rest);
        CHECK(stageOf(study, "rest").minimum_s == 30.0);
        const Stage& about = stageOf(study, "about");
        CHECK(about.about_participant);
        CHECK_FALSE(stageOf(study, "before").about_participant);
        const Questionnaire& questions = about.questionnaire;
        CHECK(questions.name == "about");
        CHECK(questions.title == "Everything");
        CHECK(questions.text == "A page.");
        CHECK(questions.per_page == 3);
        REQUIRE(questions.questions.size() == 6);
        CHECK(questions.questions[0].scale.labels == std::vector<std::string>{"low", "middle", "high"});
        CHECK(questions.questions[1].scale.kind == ScaleKind::slider);
        CHECK(questions.questions[1].scale.high == 50);
        CHECK(questions.questions[2].kind == QuestionKind::choice);
        CHECK_FALSE(questions.questions[2].required);
        CHECK(questions.questions[3].kind == QuestionKind::choices);
        REQUIRE(questions.questions[3].options.size() == 2);
        CHECK(questions.questions[3].options[1].id == "screen");
        CHECK(questions.questions[3].options[1].text == "two");
        CHECK(questions.questions[4].kind == QuestionKind::number);
        CHECK(questions.questions[4].low == 0.5);
        CHECK(questions.questions[4].high == 2.5);
        CHECK_FALSE(questions.questions[4].whole);
        CHECK(questions.questions[5].kind == QuestionKind::text);
        CHECK(stageOf(study, "after").questionnaire.name == "comfort");
        CHECK(stageOf(study, "after").questionnaire.questions.size() == 3);
    }

    TEST_CASE("What a file says of trials is what the stages hold.") {
        const Study study = loaded(fixtures / "full.toml");
        const Stage& rate = stageOf(study, "rate");
        CHECK(rate.when == std::map<std::string, std::string>{{"group", "seen"}});
        CHECK(rate.design.systems == std::vector<std::string>{"short", "long"});
        CHECK(rate.design.system_meets == Crossing::nested);
        CHECK(rate.design.block_by == "system");
        CHECK(rate.design.block_order == BlockOrder::williams);
        CHECK(rate.design.no_target_twice_running);
        CHECK(rate.measure == "naturalness");
        CHECK(rate.plays == 2);
        CHECK(rate.muted);
        CHECK(rate.max_replays == 1);
        CHECK(rate.scale.kind == ScaleKind::slider);
        CHECK(rate.scale.labels == std::vector<std::string>{"low", "high"});
        REQUIRE(rate.checks.size() == 2);
        CHECK(rate.checks[0].kind == CheckKind::number);
        CHECK(rate.checks[0].count == 3);
        CHECK(rate.checks[0].tolerance == 5.0);
        CHECK(rate.checks[0].rule == CheckRule::exclude);
        CHECK(rate.checks[0].after_failures == 2);
        CHECK(rate.checks[1].kind == CheckKind::repeat);
        CHECK(rate.checks[1].rule == CheckRule::note);
        const Stage& side = stageOf(study, "side");
        CHECK(side.kind == StageKind::parallel_rating);
        CHECK(side.design.layout_meets == Crossing::crossed);
        CHECK(side.scale.steps() == 5);
        const Stage& pairs = stageOf(study, "pairs");
        REQUIRE(pairs.reasons.has_value());
        CHECK(pairs.reasons->id == "reasons");
        CHECK(pairs.reasons->kind == QuestionKind::choice);
        CHECK(pairs.reasons->options.size() == 2);
        CHECK_FALSE(pairs.reasons->required);
        const Stage& play = stageOf(study, "play");
        CHECK(play.session == 2);
        CHECK(play.design.distances == std::vector<std::string>{"near", "far"});
        CHECK(play.design.distance_meets == Crossing::crossed);
        CHECK(play.design.max_run_of_system == 3);
        CHECK(play.break_every == 8);
        CHECK(play.break_text == "A page.");
        CHECK(play.break_minimum_s == 10.0);
        CHECK(play.feedback);
        CHECK(play.time_limit_s == 15.0);
        REQUIRE(play.confidence.has_value());
        CHECK(play.confidence->id == "confidence");
        CHECK(play.confidence->text == "And this?");
        CHECK(play.confidence->scale.high == 4);
        REQUIRE(play.checks.size() == 1);
        CHECK(play.checks[0].kind == CheckKind::catch_trial);
        CHECK(play.checks[0].distance == "far");
        CHECK(play.checks[0].rule == CheckRule::end);
        // A stage without a session belongs to that of the stage before it.
        CHECK(stageOf(study, "rest").session == 1);
        CHECK(stageOf(study, "after").session == 2);
    }

    TEST_CASE("A practice stage is as the stage that it practises, but for items, checks and breaks.") {
        const Study study = loaded(fixtures / "full.toml");
        const Stage& practice = stageOf(study, "practice");
        const Stage& play = stageOf(study, "play");
        REQUIRE(practice.practice.has_value());
        CHECK_FALSE(practice.scored());
        CHECK(practice.practice->of == "play");
        CHECK(practice.practice->criterion == 0.6);
        CHECK(practice.practice->max_attempts == 2);
        CHECK(practice.practice->end_if_failed);
        CHECK(practice.practice->again_text == "A page.");
        CHECK(practice.kind == StageKind::game);
        CHECK(practice.session == 1);
        CHECK(practice.design.items == 3);
        CHECK(practice.design.systems == play.design.systems);
        CHECK(practice.design.distances == play.design.distances);
        CHECK(practice.question == play.question);
        CHECK(practice.time_limit_s == play.time_limit_s);
        CHECK(practice.confidence.has_value());
        CHECK_FALSE(practice.feedback);
        CHECK(practice.checks.empty());
        CHECK(practice.break_every == 0);
        const Folder folder;
        const Study same =
            loaded(folder.write(replaced(readText(fixtures / "full.toml"), "feedback = false\n", "")));
        CHECK(stageOf(same, "practice").feedback);
        const std::string rated =
            readText(fixtures / "small.toml") + "[[between]]\nname = \"group\"\nlevels = [\"a\", \"b\"]\n";
        const std::string stage = "[[stages]]\nname = \"naturalness\"\n";
        const Study grouped = loaded(folder.write(
            replaced(rated, stage,
                     "[[stages]]\nname = \"try\"\nkind = \"practice\"\nof = \"naturalness\"\nitems = 1\n" +
                         stage + "when = {group = \"a\"}\n")));
        CHECK(stageOf(grouped, "try").when == std::map<std::string, std::string>{{"group", "a"}});
        CHECK(stageOf(grouped, "try").kind == StageKind::rating);
        CHECK(stageOf(grouped, "try").scale.high == 2);
    }

    TEST_CASE("Line ends inside a paragraph are spaces and a blank line starts a new one.") {
        CHECK(stageOf(loaded(fixtures / "small.toml"), "welcome").text ==
              "Hello, first line and second line.\n\nA new paragraph.");
    }

    TEST_CASE(
        "Texts come in the language asked for, the study's own, its questionnaires' and the program's.") {
        const Study english = loaded(fixtures / "full.toml");
        const Study german = loaded(fixtures / "full.toml", "de");
        CHECK(english.language == "en");
        CHECK(german.language == "de");
        CHECK(german.title == "Alles");
        CHECK(stageOf(german, "rate").scale.labels == std::vector<std::string>{"niedrig", "hoch"});
        CHECK(stageOf(english, "before").questionnaire.title == "Comfort");
        CHECK(stageOf(german, "before").questionnaire.title == "Wohlbefinden");
        CHECK(stageOf(german, "before").questionnaire.questions[0].scale.labels ==
              std::vector<std::string>{"wenig", "sehr"});
        CHECK(german.words("continue") != english.words("continue"));
        CHECK(german.hash == english.hash);
    }

    TEST_CASE(
        "The hash is that of the study file and of its questionnaires, each once, and of nothing else.") {
        const std::string study = readText(fixtures / "full.toml");
        const std::string comfort = readText(fixtures / "comfort.toml");
        CHECK(loaded(fixtures / "full.toml").hash == sha256Hex(study + comfort));
        const Folder folder;
        static_cast<void>(folder.write(comfort + "# changed\n", "comfort.toml"));
        CHECK(loaded(folder.write(study)).hash == sha256Hex(study + comfort + "# changed\n"));
    }

    TEST_CASE("Paths are resolved against the folder of the study file.") {
        CHECK(loaded(fixtures / "small.toml").systems[1].manifest == (fixtures / "clips.csv").string());
        const Folder folder;
        const std::string ranges = "height_m = [0.5, 1.5]\narc_deg = [-60, 60]\nradius_m = [1.5, 2.0]";
        const std::string small = readText(fixtures / "small.toml");
        const fs::path file = folder.write(replaced(small, ranges, "fit_manifest = \"./clips.csv\""));
        CHECK(loaded(file).targets.fit_manifest == (file.parent_path() / "clips.csv").string());
    }

    TEST_CASE("The items of a manifest need neither a count nor, without a game, ranges.") {
        const Folder folder;
        const std::string small = readText(fixtures / "small.toml");
        const std::string targets =
            small.substr(small.find("count = 20"), small.find("[[distances]]") - small.find("count = 20"));
        const std::string no_game =
            replaced(small, targets, "from_manifest = \"clips.csv\"\n").substr(0, small.rfind("[[stages]]"));
        const fs::path file = folder.write(no_game.substr(0, no_game.rfind("[[stages]]")));
        const Study rated = loaded(file);
        CHECK(rated.targets.from_manifest == (file.parent_path() / "clips.csv").string());
        CHECK(rated.targets.count == 0);
        const Study played =
            loaded(folder.write(replaced(small, "count = 20", "from_manifest = \"clips.csv\"")));
        CHECK(played.targets.count == 0);
        CHECK(played.targets.radius_m.high == 2.0);
    }

    TEST_CASE("A study of questionnaires alone needs no targets, layouts or systems.") {
        const Folder folder;
        const Study study =
            loaded(folder.write("[study]\nname = \"q\"\ntitle = \"Q\"\nseed = 1\n[[stages]]\n"
                                "name = \"now\"\nkind = \"questionnaire\"\nfile = \"comfort\"\n"));
        CHECK(study.stages.size() == 1);
        CHECK(study.targets.count == 0);
    }

    TEST_CASE("Kinds, checks and rules have the names of the file.") {
        CHECK(stageKindName(StageKind::parallel_rating) == "parallel-rating");
        CHECK(stageKindName(StageKind::game) == "referential-game");
        CHECK(stageKindName(StageKind::rest) == "break");
        for (int i = 0; i <= static_cast<int>(StageKind::rest); ++i) {
            const StageKind kind = static_cast<StageKind>(i);
            CHECK(stageKindFromName(stageKindName(kind)) == kind);
        }
        CHECK_FALSE(stageKindFromName("practice").has_value());
        CHECK_FALSE(stageKindFromName("").has_value());
        CHECK(showsClips(StageKind::pairwise));
        CHECK_FALSE(showsClips(StageKind::consent));
        CHECK(checkKindName(CheckKind::catch_trial) == "catch");
        CHECK(checkRuleName(CheckRule::exclude) == "exclude");
    }

    TEST_CASE("The documentation has a row for every key that the loader accepts, and for no other.") {
        const std::vector<std::string> keys = studyKeys();
        CHECK(keys.size() > 100);
        const std::vector<std::string> documented = documentedKeys();
        REQUIRE(documented.size() == keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) CHECK(documented[i] == keys[i]);
    }

    TEST_CASE("The fixture with every key has every key, but for two that exclude others.") {
        const std::string text = readText(fixtures / "full.toml");
        std::set<std::string> unused;
        for (const std::string& key : studyKeys()) {
            const std::string name = key.substr(key.rfind('.') + 1);
            bool found = false;
            for (const std::string& form :
                 {"\n" + name + " = ", "{" + name + " = ", ", " + name + " = ", "[stages." + name + "]"})
                found = found || text.find(form) != std::string::npos;
            if (!found) unused.insert(key);
        }
        CHECK(unused == std::set<std::string>{"targets.fit_manifest", "targets.from_manifest",
                                              "targets.from_projects"});
    }
}
