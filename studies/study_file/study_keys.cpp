#include "study_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace deixis::studies {

namespace {

constexpr std::string_view any_stage_keys[] = {"name", "kind", "session", "when"};
constexpr std::string_view trials_keys[] = {"items",
                                            "systems",
                                            "layouts",
                                            "layout_meets",
                                            "block_by",
                                            "block_order",
                                            "no_target_twice_running",
                                            "question",
                                            "plays",
                                            "muted",
                                            "break_every",
                                            "break_text",
                                            "break_minimum_s",
                                            "checks"};
constexpr std::string_view practice_keys[] = {"items",        "feedback",      "of",        "criterion",
                                              "max_attempts", "end_if_failed", "again_text"};

bool among(std::span<const std::string_view> keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

constexpr std::string_view root_keys[] = {"study",   "texts",   "words",  "targets", "distances", "layouts",
                                          "systems", "between", "stages", "headset", "analysis"};
constexpr std::string_view study_keys[] = {
    "name",      "title",           "description",   "reference",          "seed",
    "languages", "eye_height_m",    "inter_trial_s", "after_interruption", "instructions_again_after_s",
    "avatar",    "avatar_height_m", "text_status"};
constexpr std::string_view targets_keys[] = {"count",         "height_m",        "arc_deg",
                                             "radius_m",      "fit_manifest",    "from_manifest",
                                             "from_projects", "ball_diameter_m", "visibility"};
constexpr std::string_view distances_keys[] = {"name", "distance_m", "distractors", "avatar_angle_deg",
                                               "participant_angle_deg"};
constexpr std::string_view layouts_keys[] = {"name", "viewer_m", "heading_deg", "desktop_viewer_m",
                                             "desktop_heading_deg"};
constexpr std::string_view systems_keys[] = {"name",     "generator", "manifest",       "projects",
                                             "controls", "hold_s",    "unsteadiness_m", "keep",
                                             "fingers",  "levels",    "compared",       "remark"};
constexpr std::string_view between_keys[] = {"name", "levels"};
constexpr std::string_view checks_keys[] = {"kind",     "count", "tolerance",
                                            "distance", "rule",  "after_failures"};
constexpr std::string_view confidence_keys[] = {"text", "scale"};
constexpr std::string_view reasons_keys[] = {"text", "kind", "options", "required"};
constexpr std::string_view scale_keys[] = {"kind", "low", "high", "labels"};
constexpr std::string_view questions_keys[] = {"id",  "kind", "text",  "scale",    "options",
                                               "low", "high", "whole", "required", "rates"};
constexpr std::string_view rates_keys[] = {"measure", "system"};
constexpr std::string_view options_keys[] = {"id", "text"};
constexpr std::string_view headset_keys[] = {"eye_level", "assumed_eye_height_m", "place_tolerance_m",
                                             "record_gaze", "record_hands"};
constexpr std::string_view analysis_keys[] = {"alpha", "unit", "stations", "equivalence", "leave_out"};
constexpr std::string_view leave_out_keys[] = {"same_rating_share", "one_side_share", "median_time_below_s"};
constexpr std::string_view questionnaire_keys[] = {"name",     "title", "text",      "reference", "languages",
                                                   "per_page", "scale", "questions", "scores",    "texts"};
constexpr std::string_view scores_keys[] = {"name", "items", "reversed", "mean", "factor", "offset"};

}  // namespace

namespace keys {
constinit const Keys root = root_keys;
constinit const Keys study = study_keys;
constinit const Keys targets = targets_keys;
constinit const Keys distances = distances_keys;
constinit const Keys layouts = layouts_keys;
constinit const Keys systems = systems_keys;
constinit const Keys between = between_keys;
constinit const Keys any_stage = any_stage_keys;
constinit const Keys trials = trials_keys;
constinit const Keys practice = practice_keys;
constinit const Keys checks = checks_keys;
constinit const Keys confidence = confidence_keys;
constinit const Keys reasons = reasons_keys;
constinit const Keys scale = scale_keys;
constinit const Keys questions = questions_keys;
constinit const Keys rates = rates_keys;
constinit const Keys options = options_keys;
constinit const Keys headset = headset_keys;
constinit const Keys analysis = analysis_keys;
constinit const Keys leave_out = leave_out_keys;
constinit const Keys questionnaire = questionnaire_keys;
constinit const Keys scores = scores_keys;
}  // namespace keys

bool StageDeclaration::has(std::string_view key) const {
    return among(keys::any_stage, key) || (showsClips() && among(keys::trials, key)) || among(keys, key);
}

bool practiceHas(std::string_view key) {
    return among(keys::any_stage, key) || among(keys::practice, key);
}

Keys stageKeys() {
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> out;
        const auto add = [&out](Keys keys) {
            for (const std::string_view key : keys)
                if (!among(out, key)) out.push_back(key);
        };
        add(keys::any_stage);
        for (const StageDeclaration* kind : allDeclarations())
            if (!kind->showsClips()) add(kind->keys);
        add(keys::trials);
        for (const StageDeclaration* kind : allDeclarations()) add(kind->keys);
        add(keys::practice);
        return out;
    }();
    return all;
}

std::vector<std::string> studyKeys() {
    struct Section {
        std::string_view prefix;
        Keys keys;
    };
    const Section sections[] = {
        {"study", keys::study},
        {"targets", keys::targets},
        {"distances", keys::distances},
        {"layouts", keys::layouts},
        {"systems", keys::systems},
        {"between", keys::between},
        {"stages", stageKeys()},
        {"stages.checks", keys::checks},
        {"stages.confidence", keys::confidence},
        {"stages.reasons", keys::reasons},
        {"stages.scale", keys::scale},
        {"stages.confidence.scale", keys::scale},
        {"stages.questions.scale", keys::scale},
        {"stages.questions", keys::questions},
        {"stages.questions.rates", keys::rates},
        {"stages.questions.options", keys::options},
        {"stages.reasons.options", keys::options},
        {"headset", keys::headset},
        {"analysis", keys::analysis},
    };
    std::vector<std::string> out;
    for (const Section& section : sections)
        for (const std::string_view key : section.keys)
            out.push_back(fmt::format("{}.{}", section.prefix, key));
    return out;
}

}  // namespace deixis::studies
