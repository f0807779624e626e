// A small study made by hand, its plans, and answers to them: what the tests of the results share.
#pragma once

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "results/store/store.hpp"

namespace fixtures {

using namespace deixis;

/// A new folder, removed with all it holds.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "deixis-results-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

inline studies::Stage stage(const std::string& name, studies::StageKind kind) {
    studies::Stage out;
    out.name = name;
    out.kind = kind;
    return out;
}

/// Practice and ratings of naturalness on a scale of five, then the game in two layouts, with the systems
/// named.
inline studies::Study study(const std::vector<std::string>& systems) {
    studies::Study out;
    out.name = "small";
    out.title = "A small <study> & its \"title\"";
    out.hash = std::string(64, 'a');
    out.languages = {"en"};
    out.language = "en";
    out.layouts = {{"across", 0.0, 2.0, 180.0}, {"side-by-side", 0.5, 0.0, 0.0}};
    out.distances = {{"near", {0.3, 0.6}, 2}};
    for (const auto& name : systems) out.systems.push_back({name, name, ""});
    auto rating = stage("naturalness", studies::StageKind::rating);
    rating.measure = "naturalness";
    rating.question = "How natural was the movement?";
    rating.design.systems = systems;
    rating.design.layouts = {"across"};
    auto practice = rating;
    practice.name = "naturalness-practice";
    practice.practice = studies::Practice{"naturalness"};
    auto game = stage("game", studies::StageKind::game);
    game.design.systems = systems;
    game.design.layouts = {"across", "side-by-side"};
    game.design.distances = {"near"};
    out.stages = {practice, rating, game};
    return out;
}

/// One practice trial, then `items` ratings a system, then 2 x `items` choices a system, layouts alternating.
inline studies::StudyPlan plan(const studies::Study& of, const std::string& participant, int items) {
    studies::StudyPlan out;
    out.participant = participant;
    out.number = studies::numberOfParticipant(participant).value_or(1);
    out.study_name = of.name;
    out.study_hash = of.hash;
    out.seed = 18446744073709551615ULL;
    for (const auto& each : of.stages) out.stages.push_back(each.name);
    const auto add = [&](const char* stage_name, bool practice, const std::string& system, int item) {
        studies::Trial trial;
        trial.index = static_cast<int>(out.trials.size());
        trial.stage = stage_name;
        trial.kind = of.findStage(stage_name)->kind;
        trial.practice = practice;
        trial.stimuli = {{system, "T00" + std::to_string(item % 10)}};
        const bool game = trial.kind == studies::StageKind::game;
        trial.layout = game && item % 2 == 1 ? "side-by-side" : "across";
        trial.target = {0.1 * item, 1.25, 0.75};
        if (game) {
            trial.distance = "near";
            trial.distractors = {{0.3, 1.5, 0.5}, {-0.3, 1.0, 0.5}};
            trial.ball_order = {2, 0, 1};
        }
        out.trials.push_back(trial);
    };
    add("naturalness-practice", true, of.systems.front().name, 0);
    for (int item = 0; item < items; ++item)
        for (const auto& system : of.systems) add("naturalness", false, system.name, item);
    for (int item = 0; item < 2 * items; ++item)
        for (const auto& system : of.systems) add("game", false, system.name, item);
    return out;
}

inline results::Registration registration(const studies::StudyPlan& of, const std::string& language = "en") {
    return {of.participant, of.number, language, of.groups};
}

inline results::ClipRecords clips(const studies::StudyPlan& of) {
    results::ClipRecords out;
    for (const auto& trial : of.trials)
        for (const auto& stimulus : trial.stimuli)
            out[stimulus] = {stimulus.system + "-" + stimulus.item + ".bvh", std::string(64, 'c')};
    return out;
}

/// An answer without its answers: times, head and, in the game, pointer. A trial lasts 10 s.
inline studies::Response response(const studies::Trial& trial) {
    studies::Response out;
    out.trial_index = trial.index;
    const double begin_s = 10.0 * trial.index;
    const double utc_s = 1.7e9;
    out.onset = {begin_s, utc_s + begin_s};
    out.motion_end = {begin_s + 3.0, utc_s + begin_s + 3.0};
    out.answered = {begin_s + 4.25, utc_s + begin_s + 4.25};
    out.response_time_s = 1.25;
    out.plays.assign(trial.stimuli.size(), 1);
    out.input = "ray";
    out.stage_from_head.position = {0.125, 1.65, 2.0};
    if (trial.kind == studies::StageKind::game) out.pointer = Ray{{0.2, 1.3, 1.9}, {0.0, 0.0, -1.0}};
    return out;
}

/// A rating (1..5) or, in the game, whether the answer was right (0 or 1).
inline studies::Response answer(const studies::Trial& trial, int value) {
    studies::Response out = response(trial);
    if (trial.kind == studies::StageKind::game) {
        const bool correct = value != 0;
        out.values = {{"chosen_place", correct ? trial.targetPlace() : (trial.targetPlace() + 1) % 3, {}},
                      {"correct", correct ? 1.0 : 0.0, {}}};
    } else {
        out.answers = {{"rating", 0, static_cast<double>(value)}};
    }
    return out;
}

inline results::SessionInfo session(const std::string& participant, bool synthetic) {
    return {participant,
            {synthetic ? studies::StationKind::simulated : studies::StationKind::desktop, "made by a test",
             synthetic},
            "0.1.0",
            std::string(64, 'd'),
            1.7e9};
}

/// A frame in which only the head is tracked.
inline studies::TrackingSample frame(std::uint64_t number) {
    studies::TrackingSample out;
    out.frame = number;
    out.display_time_s = static_cast<double>(number) / 90.0;
    out.begun_s = out.display_time_s - 0.030;
    out.submitted_s = out.display_time_s - 0.020;
    out.head = {{{0.0, 1.65, 2.0}, no_rotation}, true, true, true};
    return out;
}

/// Opens or throws.
inline results::Store open(const std::filesystem::path& path,
                           results::Durability how = results::Durability::each_answer) {
    auto store = results::Store::open(path, how);
    if (!store) throw std::runtime_error(store.error().text());
    return std::move(*store);
}

/// Stores the plan or throws.
inline void store(results::Store& in, const studies::Study& of, const studies::StudyPlan& what) {
    if (const auto stored = in.storePlan(of, registration(what), what); !stored)
        throw std::runtime_error(stored.error().text());
}

/// A database of `participants` made-up participants. System k (of the names given) is right in a share
/// right[k] of choices and rated about rating[k]. `keep` tells which trials are answered.
template <typename Keep>
void fill(const std::filesystem::path& path, const studies::Study& of, int participants, int items,
          bool synthetic, const std::vector<double>& right, const std::vector<double>& rating,
          const Keep& keep) {
    results::Store into = open(path, results::Durability::whole_run);
    for (int number = 1; number <= participants; ++number) {
        const std::string id = fmt::format("P{:02}", number);
        const auto trials = plan(of, id, items);
        store(into, of, trials);
        into.beginSession(session(id, synthetic));
        Random random(2023, id);
        const double bias = random.normal(0.0, 0.4);
        for (const auto& trial : trials.trials) {
            std::size_t system = 0;
            while (of.systems[system].name != trial.stimuli.front().system) ++system;
            const bool correct = random.uniform() < right[system];
            const double rated = std::clamp(std::round(random.normal(rating[system] + bias, 0.8)), 1.0, 5.0);
            const bool game = trial.kind == studies::StageKind::game;
            if (!trial.practice && keep(number, trial))
                into.record(answer(trial, game ? static_cast<int>(correct) : static_cast<int>(rated)), of,
                            trials, clips(trials));
        }
        into.endSession(studies::SessionOutcome::finished, 1.7e9 + 900.0);
    }
    into.commit();
}

/// A study of every kind of stage that is answered but single ratings, for one of two groups.
inline studies::Study wideStudy() {
    using studies::QuestionKind;
    using studies::StageKind;
    studies::Study out = study({"direct", "stiff"});
    out.name = "wide";
    out.between = {{"style", {"calm", "lively"}}};
    out.systems[1].levels = {{"hold", "long"}};
    auto consent = stage("consent", StageKind::consent);
    consent.text = "I take part of my own will.";
    auto about = stage("about you", StageKind::questionnaire);
    about.about_participant = true;
    studies::Question age{"age", QuestionKind::number, "How old are you?"};
    age.low = 18.0;
    age.high = 99.0;
    studies::Question gender{"gender", QuestionKind::choice, "Gender"};
    gender.options = {{"f", "female"}, {"m", "male"}, {"x", "other"}};
    about.questionnaire = {"about", "", "", "", {age, gender, {"remark", QuestionKind::text, "Remarks"}},
                           {},      2};
    auto appeal = stage("appeal", StageKind::parallel_rating);
    appeal.measure = "appeal";
    appeal.question = "How appealing?";
    appeal.scale = {studies::ScaleKind::slider, 0, 100, {}};
    auto preference = stage("preference", StageKind::pairwise);
    preference.measure = "preference";
    preference.reasons = studies::Question{"reasons", QuestionKind::choices, "Why?"};
    preference.reasons->options = {{"speed", "its speed"}, {"arm", "its arm"}};
    auto game = stage("game", StageKind::game);
    game.confidence = studies::Question{"sure", QuestionKind::scale, "How sure are you?", {{}, 1, 7, {}}};
    auto load = stage("load", StageKind::questionnaire);
    load.questionnaire.questions = {{"effort", QuestionKind::scale, "Effort", {{}, 0, 20, {}}},
                                    {"calm", QuestionKind::scale, "Calm", {{}, 0, 20, {}}}};
    load.questionnaire.scores = {{"total", {"effort", "calm"}, {"calm"}, true, 5.0, 0.0}};
    out.stages = {stage("welcome", StageKind::instructions), consent, about, appeal, preference, game, load};
    return out;
}

/// Consent, two pages about the participant, a parallel rating, a pair, a choice, a catch, the parallel
/// rating with a number, the choice repeated, a page of a questionnaire: trials 0 to 9.
inline studies::StudyPlan widePlan(const studies::Study& of, const std::string& participant) {
    using studies::StageKind;
    studies::StudyPlan out = plan(study({"direct"}), participant, 0);
    out.study_name = of.name;
    out.stages.clear();
    for (const auto& each : of.stages) out.stages.push_back(each.name);
    out.groups = {{"style", "calm"}};
    out.trials.clear();
    const auto add = [&](const char* name, int page, std::vector<studies::Stimulus> stimuli) -> auto& {
        studies::Trial trial;
        trial.index = static_cast<int>(out.trials.size());
        trial.stage = name;
        trial.kind = of.findStage(name)->kind;
        trial.page = page;
        trial.stimuli = std::move(stimuli);
        trial.layout = "across";
        if (!trial.stimuli.empty()) trial.target = {0.5, 1.25, 0.75};
        if (trial.kind == StageKind::game) {
            trial.distance = "near";
            trial.distractors = {{0.3, 1.5, 0.5}, {-0.3, 1.0, 0.5}};
            trial.ball_order = {2, 0, 1};
        }
        return out.trials.emplace_back(trial);
    };
    add("consent", 0, {});
    add("about you", 0, {});
    add("about you", 1, {});
    add("appeal", 0, {{"stiff", "T001"}, {"direct", "T001"}});
    add("preference", 0, {{"direct", "T002"}, {"stiff", "T002"}});
    add("game", 0, {{"direct", "T003"}});
    add("game", 0, {{"direct", "T004"}}).check = studies::TrialCheck{studies::CheckKind::catch_trial};
    add("appeal", 0, {{"stiff", "T005"}, {"direct", "T005"}}).check =
        studies::TrialCheck{studies::CheckKind::number, 1, 4.0};
    add("game", 0, {{"direct", "T003"}}).check = studies::TrialCheck{studies::CheckKind::repeat, 0, 0.0, 5};
    add("load", 0, {});
    return out;
}

inline bool everything(int, const studies::Trial&) {
    return true;
}

}  // namespace fixtures
