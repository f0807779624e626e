#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "paths.hpp"
#include "studies/design/plan.hpp"
#include "studies/design/targets.hpp"
#include "studies/study_file/study.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

const fs::path data = deixis::tests::sourceDir() / "assets/data";
const StudyFolders folders{data / "languages", data / "questionnaires", {}, data / "speeches"};

/// All that ship, in the order of their names.
std::vector<fs::path> shippedFiles() {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(data / "studies")) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    REQUIRE(files.size() >= 6);
    return files;
}

Study load(const fs::path& file, const std::string& language = {}) {
    const auto study = loadStudy(file, folders, language);
    if (!study) {
        std::string problems;
        for (const Error& error : study.error()) problems += "\n" + error.text();
        FAIL(file.filename().string() << ":" << problems);
    }
    return *study;
}

Study shipped(const std::string& name) {
    return load(data / "studies" / (name + ".toml"));
}

const Stage& stage(const Study& study, const std::string& name) {
    const Stage* found = study.findStage(name);
    REQUIRE_MESSAGE(found != nullptr, name);
    return *found;
}

/// The plan of the participant of this number, in the cell that comes next after nobody.
StudyPlan planOf(const Study& study, const std::vector<TargetItem>& targets, int number,
                 const Groups& groups) {
    const Result<StudyPlan> plan = buildPlan(study, targets, fmt::format("P{:02}", number), number, groups);
    if (!plan) FAIL(study.name << ": " << plan.error().text());
    return *plan;
}

std::vector<TargetItem> targetsOf(const Study& study) {
    if (!study.targets.from_projects.empty()) {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(study.targets.from_projects))
            names.insert(entry.path().stem().stem().string());
        std::vector<TargetItem> items;
        for (const std::string& name : names) items.push_back({name, Vec3(0.0), false, {}});
        return items;
    }
    const Result<std::vector<TargetItem>> targets = sampleTargets(study);
    if (!targets) FAIL(study.name << ": " << targets.error().text());
    return *targets;
}

std::vector<Trial> trialsOf(const StudyPlan& plan, const std::string& stage_name) {
    std::vector<Trial> trials;
    for (const Trial& trial : plan.trials) {
        if (trial.stage == stage_name) trials.push_back(trial);
    }
    return trials;
}

/// Whether it is done in the studio's page.
bool isAuthored(const Study& study) {
    return std::any_of(study.stages.begin(), study.stages.end(),
                       [](const Stage& one) { return one.kind == StageKind::authoring; });
}

/// Everything that a participant reads of a study's own.
std::vector<std::string> texts(const Study& study) {
    std::vector<std::string> all{study.title};
    const auto addQuestion = [&](const Question& question) {
        all.push_back(question.text);
        all.insert(all.end(), question.scale.labels.begin(), question.scale.labels.end());
        for (const QuestionOption& option : question.options) all.push_back(option.text);
    };
    for (const Stage& one : study.stages) {
        for (const std::string& text : {one.text, one.emphasis, one.question, one.break_text,
                                        one.questionnaire.title, one.questionnaire.text}) {
            all.push_back(text);
        }
        if (one.practice) all.push_back(one.practice->again_text);
        all.insert(all.end(), one.scale.labels.begin(), one.scale.labels.end());
        for (const Question& question : one.questionnaire.questions) addQuestion(question);
        if (one.confidence) addQuestion(*one.confidence);
        if (one.reasons) addQuestion(*one.reasons);
    }
    return all;
}

}  // namespace

TEST_SUITE("studies/shipped_studies") {
    TEST_CASE(
        "Every study that ships loads in all its languages, and its hash and design are the same in each.") {
        for (const fs::path& file : shippedFiles()) {
            const Study study = load(file);
            CAPTURE(study.name);
            CHECK(study.name == file.stem().string());
            CHECK(study.languages == std::vector<std::string>{"en", "de", "sv", "ko"});
            CHECK(study.language == "en");
            CHECK(study.hash.size() == 64);
            CHECK_FALSE(study.reference.empty());
            const std::vector<TargetItem> targets = targetsOf(study);
            const Groups groups = assignGroups(study, {}, 1);
            const std::string plan = planJson(planOf(study, targets, 1, groups));
            for (const std::string& language : study.languages) {
                CAPTURE(language);
                const Study other = load(file, language);
                CHECK(other.language == language);
                CHECK(other.words.code() == language);
                CHECK(other.hash == study.hash);
                CHECK((language == "en" || other.title != study.title));
                REQUIRE(texts(other).size() == texts(study).size());
                CHECK(planJson(planOf(other, targets, 1, groups)) == plan);
            }
        }
    }

    TEST_CASE("No text of a study that ships speaks of a device: it is read at a desk and in a headset.") {
        const std::map<std::string, std::vector<std::string>> words{
            {"en",
             {" key ", " keys ", "keyboard", "mouse", "click", " press ", "trigger", "screen", "controller"}},
            {"de", {"Taste", "Tastatur", "Maus", "klick", "drücken Sie", "Bildschirm", "Controller"}},
            {"sv", {"tangent", " mus ", "musen", "klick", "tryck på", "skärm", "kontroll"}},
            {"ko", {"키보드", "마우스", "클릭", "누르", "화면", "컨트롤러"}}};
        for (const fs::path& file : shippedFiles()) {
            if (isAuthored(load(file))) continue;  // in a browser
            for (const auto& [language, banned] : words) {
                for (const std::string& text : texts(load(file, language))) {
                    for (const std::string& word : banned) {
                        CAPTURE(text);
                        CAPTURE(word);
                        CHECK(text.find(word) == std::string::npos);
                    }
                }
            }
        }
    }

    TEST_CASE(
        "Every example but the paper's own, and it with other systems, asks for consent before anything "
        "else, then about the "
        "participant.") {
        for (const fs::path& file : shippedFiles()) {
            if (file.stem().string().starts_with("pointing2023")) continue;
            const Study study = load(file);
            CAPTURE(study.name);
            REQUIRE(study.stages.size() > 2);
            CHECK(study.stages[0].kind == StageKind::consent);
            CHECK(study.stages[1].kind == StageKind::questionnaire);
            CHECK(study.stages[1].about_participant);
            for (const char* id : {"age", "gender", "handedness", "vision", "vr_experience"}) {
                CHECK(study.stages[1].questionnaire.find(id) != nullptr);
            }
        }
    }

    TEST_CASE("The paper's study and its stand-ins' have the same trials, system for system") {
        const Study paper = shipped("pointing2023"), stand_ins = shipped("pointing2023-stand-ins");
        std::map<std::string, std::string> in_place_of;
        REQUIRE(paper.systems.size() == stand_ins.systems.size());
        for (std::size_t i = 0; i < paper.systems.size(); ++i)
            in_place_of[paper.systems[i].name] = stand_ins.systems[i].name;
        const auto targets = targetsOf(paper), same_targets = targetsOf(stand_ins);
        REQUIRE(targets.size() == 100);
        for (std::size_t i = 0; i < targets.size(); ++i) CHECK(targets[i].target == same_targets[i].target);
        for (const int number : {1, 2, 39}) {
            const auto trials = planOf(paper, targets, number, {}).trials,
                       same_trials = planOf(stand_ins, same_targets, number, {}).trials;
            REQUIRE(trials.size() == same_trials.size());
            for (std::size_t i = 0; i < trials.size(); ++i) {
                const Trial &one = trials[i], &same = same_trials[i];
                REQUIRE(one.stimuli.size() == same.stimuli.size());
                for (std::size_t k = 0; k < one.stimuli.size(); ++k) {
                    CHECK(one.stimuli[k].item == same.stimuli[k].item);
                    CHECK(in_place_of.at(one.stimuli[k].system) == same.stimuli[k].system);
                }
                CHECK(one.layout == same.layout);
                CHECK(one.distractors == same.distractors);
                CHECK(one.ball_order == same.ball_order);
            }
        }
    }

    TEST_CASE(
        "Both scenarios of sgtoolkit2021 have the numbers of section 7.2: pages of 4 from a set of 12, and "
        "one "
        "failure of 2 checks rejects.") {
        // "8 pages (32 videos in total, the rushed scenario) or 12 pages (48 videos in total, the relaxed
        // scenario)".
        const std::map<std::string, int> scenarios{{"sgtoolkit2021-rushed", 8}, {"sgtoolkit2021", 12}};
        int ratings = 0;
        std::vector<std::vector<TargetItem>> sets;
        for (const auto& scenario : scenarios) {
            const int of_pages = scenario.second;
            CAPTURE(scenario.first);
            const Study study = shipped(scenario.first);
            CHECK(study.systems.size() == 4);
            const Stage& rating = stage(study, "human-likeness");
            CHECK(rating.kind == StageKind::parallel_rating);
            CHECK(rating.design.items == of_pages);
            CHECK(rating.design.systems.size() == 4);
            CHECK(rating.scale.kind == ScaleKind::slider);
            CHECK(rating.scale.low == 0);
            CHECK(rating.scale.high == 100);
            CHECK(rating.scale.labels ==
                  std::vector<std::string>{"bad", "poor", "fair", "good", "excellent"});
            REQUIRE(rating.checks.size() == 1);
            CHECK(rating.checks[0].kind == CheckKind::number);
            CHECK(rating.checks[0].count == 2);
            CHECK(rating.checks[0].rule == CheckRule::end);  // "immediately rejected"
            CHECK(rating.checks[0].after_failures == 1);
            // "although 10 self-reported that they are non-native English speakers in the demographic survey"
            const Stage& language = stage(study, "native-language");
            CHECK(language.about_participant);
            CHECK(language.questionnaire.questions.front().id == "native_language");

            const std::vector<TargetItem> targets = sets.emplace_back(targetsOf(study));
            REQUIRE(targets.size() == 12);
            std::set<std::vector<int>> check_pages;
            std::set<std::vector<std::string>> orders;
            std::set<std::string> all_items;
            for (int number = 1; number <= 30;
                 ++number) {  // "thirty subjects participated in each study" (7.2.2)
                CAPTURE(number);
                const std::vector<Trial> pages = trialsOf(planOf(study, targets, number, {}), rating.name);
                REQUIRE(static_cast<int>(pages.size()) == of_pages);
                int scored = 0;
                std::vector<int> with_check;
                std::set<std::string> items;
                for (std::size_t i = 0; i < pages.size(); ++i) {
                    REQUIRE(pages[i].stimuli.size() == 4);
                    std::set<std::string> systems;
                    std::vector<std::string> order;
                    for (int s = 0; s < 4; ++s) {
                        const Stimulus& stimulus = pages[i].stimuli[static_cast<std::size_t>(s)];
                        CHECK(stimulus.item == pages[i].stimuli[0].item);
                        systems.insert(stimulus.system);
                        order.push_back(stimulus.system);
                        scored += pages[i].scored(s) ? 1 : 0;
                    }
                    CHECK(systems.size() == 4);
                    orders.insert(order);
                    items.insert(pages[i].stimuli[0].item);
                    if (pages[i].check) {
                        with_check.push_back(static_cast<int>(i));
                        CHECK(pages[i].check->expected >= 0);
                        CHECK(pages[i].check->expected <= 100);
                    }
                }
                CHECK(static_cast<int>(items.size()) == of_pages);
                CHECK(with_check.size() == 2);  // on two different pages
                CHECK(scored == 4 * of_pages - 2);
                ratings += scored;
                check_pages.insert(with_check);
                all_items.insert(items.begin(), items.end());
            }
            CHECK(all_items.size() == 12);
            CHECK(check_pages.size() > 10);  // "two random pages per participant"
            CHECK(orders.size() == 24);      // every order of four comes up in 240 pages
        }
        // The paper's two measures, with 60 raters in each scenario: 4560 (7.2.3).
        CHECK(2 * ratings == 4560);
        // Two sets of speeches: none is in both.
        for (const TargetItem& rushed : sets[0])
            for (const TargetItem& relaxed : sets[1]) CHECK(rushed.id != relaxed.id);
    }

    TEST_CASE("sgtoolkit2021 is four studies: two scenarios by two measures, human-likeness muted.") {
        for (const char* scenario : {"", "-rushed"}) {
            const Study likeness = shipped(std::string("sgtoolkit2021") + scenario);
            const Study appropriateness = shipped(std::string("sgtoolkit2021-appropriateness") + scenario);
            const Stage &muted = stage(likeness, "human-likeness"),
                        &heard = stage(appropriateness, "appropriateness");
            CHECK(muted.muted);
            CHECK_FALSE(heard.muted);
            CHECK(heard.measure == "appropriateness");
            CHECK(heard.design.items == muted.design.items);
            CHECK(appropriateness.targets.from_projects == likeness.targets.from_projects);
            CHECK(appropriateness.seed != likeness.seed);
            for (const Study* study : {&likeness, &appropriateness})
                for (const SystemSource& system : study->systems) {
                    CHECK(system.projects == study->targets.from_projects);
                    CHECK(system.compared ==
                          (system.name != "REF"));  // the rules' own clip is no recorded motion
                    CHECK((system.remark.find("synthetic") != std::string::npos) == (system.name == "REF"));
                }
        }
    }

    TEST_CASE("The two scenarios of sgtoolkit2021 differ in their set, their pages and the minutes alone.") {
        const auto withoutDigits = [](std::string text) {
            std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
            return text;
        };
        for (const char* language : {"en", "de", "sv", "ko"}) {
            CAPTURE(language);
            for (const std::string name : {"sgtoolkit2021", "sgtoolkit2021-appropriateness"}) {
                const Study relaxed = load(data / ("studies/" + name + ".toml"), language);
                const Study rushed = load(data / ("studies/" + name + "-rushed.toml"), language);
                const std::vector<std::string> a = texts(relaxed);
                const std::vector<std::string> b = texts(rushed);
                REQUIRE(a.size() == b.size());
                int differ = 0;
                for (std::size_t i = 0; i < a.size(); ++i) {
                    CHECK(withoutDigits(a[i]) == withoutDigits(b[i]));
                    differ += a[i] != b[i];
                }
                CHECK(differ == 1);  // the consent's minutes
            }
        }
    }

    TEST_CASE("genea-pairwise shows every pair of systems equally often, and as often either way round.") {
        const Study study = shipped("genea-pairwise");
        const Stage& preference = stage(study, "preference");
        CHECK(preference.kind == StageKind::pairwise);
        CHECK(preference.measure == "naturalness");
        REQUIRE(preference.reasons.has_value());
        CHECK(preference.reasons->kind == QuestionKind::choices);
        const std::vector<TargetItem> targets = targetsOf(study);
        std::map<std::pair<std::string, std::string>, int> shown;
        for (int number = 1; number <= 40; ++number) {
            CAPTURE(number);
            const std::vector<Trial> trials = trialsOf(planOf(study, targets, number, {}), preference.name);
            CHECK(trials.size() == 32);  // 30 and two of them again
            std::map<std::set<std::string>, int> pairs;
            for (const Trial& trial : trials) {
                REQUIRE(trial.stimuli.size() == 2);
                CHECK(trial.stimuli[0].item == trial.stimuli[1].item);
                if (trial.check) continue;
                ++pairs[{trial.stimuli[0].system, trial.stimuli[1].system}];
                ++shown[{trial.stimuli[0].system, trial.stimuli[1].system}];
            }
            CHECK(pairs.size() == 6);
            for (const auto& pair : pairs) CHECK(pair.second == 5);
        }
        CHECK(shown.size() == 12);
        for (const auto& way : shown) CHECK(std::abs(way.second - 100) <= 40);
    }

    TEST_CASE("distractor-distance crosses systems and distances, and no two balls of a trial touch.") {
        const Study study = shipped("distractor-distance");
        const Stage& game = stage(study, "game");
        CHECK(game.kind == StageKind::game);
        CHECK(game.design.distance_meets == Crossing::crossed);
        REQUIRE(game.design.distances.size() == 3);
        const std::array<Range, 3> bands{{{0.1, 0.2}, {0.2, 0.4}, {0.4, 0.8}}};
        for (std::size_t i = 0; i < 3; ++i) {
            const DistanceBand* band = study.findDistance(game.design.distances[i]);
            REQUIRE(band != nullptr);
            CHECK(band->distance_m.low == bands[i].low);
            CHECK(band->distance_m.high == bands[i].high);
        }
        CHECK(game.confidence.has_value());
        CHECK(stage(study, "sickness-before").questionnaire.name == "ssq");
        CHECK(stage(study, "sickness-after").questionnaire.name == "ssq");

        const std::vector<TargetItem> targets = targetsOf(study);
        GroupSizes taken;
        std::set<std::string> first_layouts;
        for (int number = 1; number <= 8; ++number) {
            CAPTURE(number);
            const Groups groups = assignGroups(study, taken, number);
            ++taken[groups];
            const StudyPlan plan = planOf(study, targets, number, groups);
            const bool feedback = groups.at("training") == "feedback";
            CHECK(trialsOf(plan, "training-with-feedback").empty() == !feedback);
            CHECK(trialsOf(plan, "training-without-feedback").empty() == feedback);

            std::map<std::pair<std::string, std::string>, int> cells;
            std::vector<std::string> layouts;
            int checks = 0;
            for (const Trial& trial : trialsOf(plan, game.name)) {
                REQUIRE(trial.distractors.size() == 2);
                CHECK(glm::distance(trial.distractors[0], trial.distractors[1]) > 0.069);
                for (const Vec3& ball : trial.distractors) {
                    const DistanceBand& band = *study.findDistance(trial.distance);
                    CHECK(glm::distance(ball, trial.target) >= band.distance_m.low - 1e-3);
                    CHECK(glm::distance(ball, trial.target) <= band.distance_m.high + 1e-3);
                }
                if (layouts.empty() || layouts.back() != trial.layout) layouts.push_back(trial.layout);
                if (trial.check) {
                    ++checks;
                    CHECK(trial.distance == "unmistakable");
                } else {
                    ++cells[{trial.stimuli[0].system, trial.distance}];
                }
            }
            CHECK(checks == 3);
            CHECK(cells.size() == 12);
            for (const auto& cell : cells) CHECK(cell.second == 4);
            CHECK(layouts.size() == 2);  // two blocks
            first_layouts.insert(layouts.front());
        }
        CHECK(first_layouts.size() == 2);
        int fed = 0;
        for (const auto& [groups, size] : taken) fed += groups.at("training") == "feedback" ? size : 0;
        CHECK(fed == 4);
    }

    TEST_CASE(
        "pointing-style varies hold and steadiness two by two, and rates certainty before any ball is "
        "seen.") {
        const Study study = shipped("pointing-style");
        std::map<std::pair<std::string, std::string>, const SystemSource*> cells;
        for (const SystemSource& system : study.systems) {
            CHECK(system.generator == "direct");
            cells[{system.levels.at("hold"), system.levels.at("steadiness")}] = &system;
        }
        REQUIRE(cells.size() == 4);
        for (const char* steadiness : {"steady", "unsteady"}) {
            CHECK(cells.at({"long", steadiness})->hold_s.value() >
                  cells.at({"short", steadiness})->hold_s.value());
        }
        for (const char* hold : {"short", "long"}) {
            CHECK(cells.at({hold, "steady"})->unsteadiness_m.value() == 0.0);
            CHECK(cells.at({hold, "unsteady"})->unsteadiness_m.value() > 0.0);
        }
        const StudyPlan plan = planOf(study, targetsOf(study), 1, {});
        const std::vector<Trial> ratings = trialsOf(plan, "certainty");
        const std::vector<Trial> choices = trialsOf(plan, "game");
        CHECK(ratings.size() == 26);  // 24 and two again
        CHECK(choices.size() == 24);
        CHECK(ratings.back().index < choices.front().index);
        CHECK(std::all_of(ratings.begin(), ratings.end(),
                          [](const Trial& trial) { return trial.distractors.empty(); }));
        CHECK(stage(study, "certainty").scale.high == stage(study, "game").confidence->scale.high);
    }
}
