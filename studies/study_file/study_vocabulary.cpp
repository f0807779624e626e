#include "study_vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace deixis::studies {

namespace {

using Mask = unsigned;

constexpr Mask bit(StageKind kind) {
    return 1U << static_cast<unsigned>(kind);
}
constexpr Mask instructions = bit(StageKind::instructions);
constexpr Mask questionnaire = bit(StageKind::questionnaire);
constexpr Mask rest = bit(StageKind::rest);
constexpr Mask pages = instructions | bit(StageKind::consent) | rest;
constexpr Mask rating = bit(StageKind::rating);
constexpr Mask parallel = bit(StageKind::parallel_rating);
constexpr Mask pairwise = bit(StageKind::pairwise);
constexpr Mask game = bit(StageKind::game);
constexpr Mask trials = rating | parallel | pairwise | game;
constexpr Mask practice = 1U << practice_kind;
constexpr Mask all = pages | questionnaire | trials | practice;

struct StageKey {
    std::string_view key;
    Mask kinds;
};

constexpr StageKey stage_keys[] = {
    {"name", all},
    {"kind", all},
    {"session", all},
    {"when", all},
    {"text", pages | questionnaire},
    {"emphasis", instructions},
    {"minimum_s", instructions | rest},
    {"file", questionnaire},
    {"questions", questionnaire},
    {"title", questionnaire},
    {"per_page", questionnaire},
    {"about_participant", questionnaire},
    {"items", trials | practice},
    {"systems", trials},
    {"layouts", trials},
    {"distances", game},
    {"system_meets", rating | pairwise | game},
    {"layout_meets", trials},
    {"distance_meets", game},
    {"block_by", trials},
    {"block_order", trials},
    {"max_run_of_system", rating | game},
    {"no_target_twice_running", trials},
    {"measure", rating | parallel | pairwise},
    {"question", trials},
    {"scale", rating | parallel | questionnaire},
    {"plays", trials},
    {"max_replays", rating | game},
    {"break_every", trials},
    {"break_text", trials},
    {"break_minimum_s", trials},
    {"checks", trials},
    {"feedback", game | practice},
    {"time_limit_s", game},
    {"confidence", game},
    {"reasons", pairwise},
    {"of", practice},
    {"criterion", practice},
    {"max_attempts", practice},
    {"end_if_failed", practice},
    {"again_text", practice},
};

constexpr auto stage_key_names = [] {
    std::array<std::string_view, std::size(stage_keys)> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = stage_keys[i].key;
    return names;
}();

constexpr std::string_view root_keys[] = {"study",   "texts",   "words",  "targets", "distances", "layouts",
                                          "systems", "between", "stages", "headset", "analysis"};
constexpr std::string_view study_keys[] = {
    "name",      "title",           "description",   "reference",          "seed",
    "languages", "eye_height_m",    "inter_trial_s", "after_interruption", "instructions_again_after_s",
    "avatar",    "avatar_height_m", "text_status"};
constexpr std::string_view targets_keys[] = {"count",           "height_m",     "arc_deg",
                                             "radius_m",        "fit_manifest", "from_manifest",
                                             "ball_diameter_m", "visibility"};
constexpr std::string_view distances_keys[] = {"name", "distance_m", "distractors", "avatar_angle_deg",
                                               "participant_angle_deg"};
constexpr std::string_view layouts_keys[] = {"name", "viewer_m", "heading_deg", "desktop_viewer_m",
                                             "desktop_heading_deg"};
constexpr std::string_view systems_keys[] = {"name",           "generator", "manifest", "hold_s",
                                             "unsteadiness_m", "keep",      "fingers",  "levels"};
constexpr std::string_view between_keys[] = {"name", "levels"};
constexpr std::string_view checks_keys[] = {"kind",     "count", "tolerance",
                                            "distance", "rule",  "after_failures"};
constexpr std::string_view confidence_keys[] = {"text", "scale"};
constexpr std::string_view reasons_keys[] = {"text", "kind", "options", "required"};
constexpr std::string_view scale_keys[] = {"kind", "low", "high", "labels"};
constexpr std::string_view questions_keys[] = {"id",  "kind", "text",  "scale",   "options",
                                               "low", "high", "whole", "required"};
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
constinit const Keys stages = stage_key_names;
constinit const Keys checks = checks_keys;
constinit const Keys confidence = confidence_keys;
constinit const Keys reasons = reasons_keys;
constinit const Keys scale = scale_keys;
constinit const Keys questions = questions_keys;
constinit const Keys options = options_keys;
constinit const Keys headset = headset_keys;
constinit const Keys analysis = analysis_keys;
constinit const Keys leave_out = leave_out_keys;
constinit const Keys questionnaire = questionnaire_keys;
constinit const Keys scores = scores_keys;
}  // namespace keys

bool stageHasKey(std::size_t kind, std::string_view key) {
    const auto* found = std::find_if(std::begin(stage_keys), std::end(stage_keys),
                                     [&](const StageKey& entry) { return entry.key == key; });
    return found != std::end(stage_keys) && (found->kinds & (1U << kind)) != 0;
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
        {"stages", keys::stages},
        {"stages.checks", keys::checks},
        {"stages.confidence", keys::confidence},
        {"stages.reasons", keys::reasons},
        {"stages.scale", keys::scale},
        {"stages.confidence.scale", keys::scale},
        {"stages.questions.scale", keys::scale},
        {"stages.questions", keys::questions},
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
