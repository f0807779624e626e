// Studies made by hand, for tests and benchmarks of the plan: they need neither a study file nor its reader.
#pragma once

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "studies/design/plan.hpp"

namespace deixis::studies::plan_fixture {

/// Two layouts, two bands, the systems named, no stages.
inline Study studyOf(const std::vector<std::string>& systems) {
    Study study;
    study.name = "by-hand";
    study.title = "Made by hand";
    study.seed = 2023;
    study.languages = {"en"};
    study.language = "en";
    study.targets.height_m = {0.1, 2.1};
    study.targets.arc_deg = {-85.0, 85.0};
    study.targets.radius_m = {1.9, 2.2};
    study.distances = {{"near", {0.2, 0.4}, 2}, {"far", {0.8, 1.2}, 2}};
    study.layouts = {{"across", 0.0, 3.4, 180.0}, {"side-by-side", -0.6, -0.95, 15.0}};
    for (const std::string& name : systems) {
        SystemSource system;
        system.name = name;
        system.generator = "direct";
        study.systems.push_back(system);
    }
    study.hash = "0123456789abcdef";
    return study;
}

inline Stage page(const std::string& name, StageKind kind) {
    Stage stage;
    stage.name = name;
    stage.kind = kind;
    stage.text = "Read this.";
    return stage;
}

inline Stage questionnaire(const std::string& name, int questions, int per_page) {
    Stage stage = page(name, StageKind::questionnaire);
    stage.questionnaire.name = name;
    stage.questionnaire.per_page = per_page;
    for (int i = 0; i < questions; ++i) {
        Question question;
        question.id = fmt::format("q{}", i + 1);
        stage.questionnaire.questions.push_back(question);
    }
    return stage;
}

/// A stage with clips of all of the study's systems; across, and in a game side by side as well.
inline Stage trials(const Study& study, const std::string& name, StageKind kind, int items) {
    Stage stage = page(name, kind);
    stage.text = "";
    stage.design.items = items;
    for (const SystemSource& system : study.systems) stage.design.systems.push_back(system.name);
    stage.design.layouts = {"across"};
    if (kind == StageKind::game) {
        stage.design.layouts = {"across", "side-by-side"};
        stage.design.distances = {"near"};
    }
    stage.measure = kind == StageKind::game ? "" : "naturalness";
    return stage;
}

inline Stage practiceOf(const Stage& of, int items, int attempts = 1) {
    Stage stage = of;
    stage.name = "practice-" + of.name;
    stage.design.items = items;
    stage.checks.clear();
    Practice practice;
    practice.of = of.name;
    practice.max_attempts = attempts;
    if (attempts > 1) practice.criterion = 0.5;
    stage.practice = practice;
    return stage;
}

inline AttentionChecks check(CheckKind kind, int count) {
    AttentionChecks out;
    out.kind = kind;
    out.count = count;
    if (kind == CheckKind::catch_trial) out.distance = "far";
    return out;
}

/// As the study of Deichler et al. (2023) that ships with stand-ins: 2 + 20 ratings, then 2 + 40 games.
inline Study pointing() {
    Study study = studyOf({"demonstration-nn", "direct", "stiff", "drifting"});
    study.name = "pointing2023";
    study.distances.resize(1);
    const Stage rating = trials(study, "naturalness", StageKind::rating, 5);
    const Stage game = trials(study, "game", StageKind::game, 10);
    study.stages = {page("welcome", StageKind::instructions), practiceOf(rating, 2), rating,
                    page("pause", StageKind::rest),           practiceOf(game, 2),   game,
                    page("goodbye", StageKind::instructions)};
    return study;
}

/// As that of Yoon et al. (2021): pages of four systems on sliders, two numbers a person, one of two measures
/// for each.
inline Study rating() {
    Study study = studyOf({"reference", "automatic", "manual", "toolkit"});
    study.name = "rating2021";
    study.distances.clear();
    study.between = {{"measure", {"human-likeness", "appropriateness"}}};
    study.stages = {page("consent", StageKind::consent)};
    for (const std::string& level : study.between[0].levels) {
        Stage stage = trials(study, level, StageKind::parallel_rating, 12);
        stage.when = {{"measure", level}};
        stage.measure = level;
        stage.scale.kind = ScaleKind::slider;
        stage.scale.low = 0;
        stage.scale.high = 100;
        stage.checks = {check(CheckKind::number, 2)};
        Stage practice = practiceOf(stage, 1);
        study.stages.push_back(practice);
        study.stages.push_back(stage);
    }
    study.stages.push_back(questionnaire("about-you", 5, 4));
    return study;
}

/// Targets on whole decimetres, with distractors for each band.
inline std::vector<TargetItem> targetsFor(const Study& study, int count) {
    std::vector<TargetItem> out;
    for (int i = 0; i < count; ++i) {
        TargetItem item;
        item.id = fmt::format("T{:03}", i + 1);
        item.target = {i % 10 - 4.5, 1.0, 2.0 + i / 10};
        for (const DistanceBand& band : study.distances) {
            item.distractors.emplace_back();
            for (int d = 1; d <= band.distractors; ++d)
                item.distractors.back().push_back(item.target + Vec3(0.0, band.distance_m.low * d, 0.0));
        }
        out.push_back(item);
    }
    return out;
}

inline StudyPlan planOf(const Study& study, const std::vector<TargetItem>& targets, int number,
                        const Groups& groups = {}) {
    Result<StudyPlan> plan = buildPlan(study, targets, fmt::format("P{:04}", number), number, groups);
    if (!plan) throw std::runtime_error(plan.error().text());
    return *plan;
}

inline std::vector<Trial> trialsOf(const StudyPlan& plan, const std::string& stage) {
    std::vector<Trial> out;
    for (const Trial& trial : plan.trials)
        if (trial.stage == stage) out.push_back(trial);
    return out;
}

inline int countChecks(const std::vector<Trial>& trials, CheckKind kind) {
    int count = 0;
    for (const Trial& trial : trials) count += trial.check && trial.check->kind == kind;
    return count;
}

/// One number for a whole plan but its participant's id: equal where nothing differs.
inline std::string fingerprint(StudyPlan plan) {
    plan.participant = "P";
    return planJson(plan);
}

}  // namespace deixis::studies::plan_fixture
