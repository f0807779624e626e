// Small studies, plans and clips by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "motion/humanoid/reference_humanoid.hpp"
#include "studies/session/session.hpp"

namespace deixis::tests {

using namespace deixis::studies;

inline const Scale five_steps{
    ScaleKind::steps, 1, 5, {"very unnatural", "unnatural", "neither", "natural", "very natural"}};

inline Stage pageStage(const char* name, const char* text, StageKind kind = StageKind::instructions) {
    Stage stage;
    stage.name = name;
    stage.kind = kind;
    stage.text = text;
    return stage;
}

inline Stage practiceOf(const Stage& stage) {
    Stage practice = stage;
    practice.name += "-practice";
    practice.practice = Practice{stage.name, 0.0, 1, false, {}};
    practice.break_every = 0;
    practice.checks.clear();
    return practice;
}

/// A rating stage and a game, each with its pages and a practice.
inline Study handStudy() {
    Study study;
    study.name = "hand";
    study.title = "A study by hand";
    study.words = LanguageTable::english();
    study.inter_trial_s = 0.6;
    study.layouts = {{"across", 0.0, 3.4, 180.0}, {"side-by-side", 0.7, -0.2, 0.0}};
    study.targets.ball_diameter_m = 0.1;
    Stage rating;
    rating.name = "naturalness";
    rating.kind = StageKind::rating;
    rating.measure = "naturalness";
    rating.question = "How natural do you find the animation?";
    rating.scale = five_steps;
    rating.break_every = 2;
    Stage game;
    game.name = "game";
    game.kind = StageKind::game;
    game.question = "Which ball?";
    study.stages = {pageStage("welcome", "Hello."),
                    pageStage("naturalness-instructions", "Watch and rate."),
                    practiceOf(rating),
                    pageStage("naturalness-begin", "Now it counts."),
                    rating,
                    pageStage("game-instructions", "Watch and choose."),
                    practiceOf(game),
                    pageStage("game-begin", "Now it counts."),
                    game,
                    pageStage("goodbye", "Goodbye.")};
    study.stages[1].emphasis = rating.question;
    return study;
}

inline void removeStage(Study& study, const std::string& name) {
    for (std::size_t i = 0; i < study.stages.size(); ++i)
        if (study.stages[i].name == name)
            study.stages.erase(study.stages.begin() + static_cast<std::ptrdiff_t>(i));
}

/// A trial of a stage for item 0, 1, ..., put at the end of the plan.
inline Trial& addTrial(StudyPlan& plan, const Stage& stage, int item, std::vector<std::string> systems) {
    Trial trial;
    trial.index = static_cast<int>(plan.trials.size());
    trial.stage = stage.name;
    trial.kind = stage.kind;
    trial.practice = stage.practice.has_value();
    trial.layout = "across";
    const std::string id = "T00" + std::to_string(item + 1);
    for (std::string& system : systems) trial.stimuli.push_back({std::move(system), id});
    if (showsClips(stage.kind)) trial.target = {0.2 * item, 1.0 + 0.1 * item, 2.0};
    if (stage.kind == StageKind::game) {
        trial.layout = trial.index % 2 == 0 ? "across" : "side-by-side";
        trial.distractors = {trial.target + Vec3(0.3, 0.0, 0.0), trial.target + Vec3(0.0, 0.3, 0.0)};
        trial.ball_order = {0, 1, 2};
        for (int turn = 0; turn < trial.index % 3; ++turn)
            trial.ball_order = {trial.ball_order[2], trial.ball_order[0], trial.ball_order[1]};
    }
    plan.trials.push_back(std::move(trial));
    return plan.trials.back();
}

/// The stages that the study has, without trials.
inline StudyPlan emptyPlan(const Study& study) {
    StudyPlan plan;
    plan.participant = "P01";
    plan.study_name = study.name;
    for (const Stage& stage : study.stages) plan.stages.push_back(stage.name);
    return plan;
}

/// Two systems for `items` items in each stage; practice has one trial.
inline StudyPlan handPlan(const Study& study, int items) {
    StudyPlan plan = emptyPlan(study);
    for (const Stage& stage : study.stages) {
        if (!showsClips(stage.kind)) continue;
        if (stage.practice) addTrial(plan, stage, items, {"one"});
        for (int item = 0; item < items && !stage.practice; ++item)
            for (const char* system : {"one", "two"}) addTrial(plan, stage, item, {system});
    }
    return plan;
}

/// The right arm goes up in front within `length_s` and stays there.
inline motion::Clip handClip(double length_s, double fps = 30.0) {
    motion::Clip clip;
    clip.skeleton = motion::referenceHumanoid();
    clip.frame_time_s = 1.0 / fps;
    const motion::LocalPose idle = motion::relaxedPose(clip.skeleton);
    const auto arm = static_cast<std::size_t>(clip.skeleton.find("rightUpperArm"));
    const int count = static_cast<int>(length_s * fps + 0.5) + 1;
    for (int i = 0; i < count; ++i) {
        motion::LocalPose pose = idle;
        const double angle = 0.3 + (count > 1 ? 1.0 * i / (count - 1) : 0.0);
        pose.joints[arm].orientation = yawRotation(-angle) * pose.joints[arm].orientation;
        clip.frames.push_back(pose);
    }
    return clip;
}

class OneClip : public ClipSource {
  public:
    explicit OneClip(motion::Clip clip) : clip_(std::move(clip)) {}
    [[nodiscard]] const motion::Clip& clip(const Stimulus&) const override { return clip_; }
    [[nodiscard]] const std::string* project(const Stimulus&) const override { return &project_text; }

    std::string project_text = R"({"version":2})";

  private:
    motion::Clip clip_;
};

}  // namespace deixis::tests
