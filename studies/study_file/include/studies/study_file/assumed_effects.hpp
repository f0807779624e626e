// What a power analysis assumes about future answers: means of the systems, and how much answers differ.
// The file is documented in docs/power.md.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

/// What a study measures of its systems, over the scored stages for it.
struct StudyMeasure {
    std::string name;  ///< "accuracy", "confidence", "preference", or Stage::measure
    AnswerKind kind = AnswerKind::rating;
    int low = 0;
    int high = 1;
    int balls = 0;  ///< accuracy: shown in a trial, the most there are
};

/// What one stage measures, as its kind declares it.
[[nodiscard]] std::vector<StudyMeasure> measuresOf(const Study& study, const Stage& stage);
/// Accuracy first, then in the order of the stages.
[[nodiscard]] std::vector<StudyMeasure> studyMeasures(const Study& study);

/// By name of a system, a layout or a distance.
using ByName = std::map<std::string, double>;

/// By between-participants factor: a shift of each of its levels; 0 if one is not named.
using GroupShifts = std::map<std::string, ByName>;

/// SDs over participants, over participants for each system of its own, and over items. Independent of one
/// another and normal.
struct AssumedSpread {
    double participant_sd = 0.0;
    double participant_system_sd = 0.0;
    double item_sd = 0.0;
};

/// The game. SDs and shifts are on the logit scale.
struct AssumedAccuracy {
    ByName systems;  ///< expected share of correct choices, over participants, items and levels
    AssumedSpread spread{};
    double lapse_rate = 0.0;  ///< of choices that fall on any ball
    ByName layouts{};         ///< shift of each; 0 if it is not named
    ByName distances{};
    GroupShifts groups{};
};

/// A rating, or the game's confidence. SDs are in steps of the scale, before rounding to a step.
struct AssumedRating {
    ByName systems;  ///< expected answer on the measure's scale
    AssumedSpread spread{};
    double noise_sd = 1.0;  ///< of one answer; above 0
    GroupShifts groups{};   ///< in steps of the scale, before rounding
};

/// Preferences: the difference of two strengths with noise, cut into five answers.
struct AssumedPreference {
    ByName systems;  ///< strengths; only differences count
    double participant_system_sd = 0.0;
    double noise_sd = 1.0;
    double tie_zone = 0.0;    ///< a difference no larger is no preference
    double clear_zone = 1.0;  ///< one no larger is a slight one
};

/// Measures of which nothing is assumed are not simulated.
struct AssumedEffects {
    std::optional<AssumedAccuracy> accuracy{};
    std::map<std::string, AssumedRating> ratings{};  ///< by measure
    std::optional<AssumedPreference> preference{};
};

/// Errors name file, line and key: the first problem of the file.
[[nodiscard]] Result<AssumedEffects> loadAssumedEffects(const std::filesystem::path& path,
                                                        const Study& study);
/// The same as a file, which reads back as the same numbers.
[[nodiscard]] std::string assumedEffectsToml(const AssumedEffects& effects);

/// All sums of one shift of each between-participants factor; {0} if there is none.
[[nodiscard]] std::vector<double> groupShifts(const Study& study, const GroupShifts& groups);
/// All sums of one of these, one shift of a layout and one of a distance that the games of the study have.
[[nodiscard]] std::vector<double> gameShifts(const Study& study, const AssumedAccuracy& accuracy);

}  // namespace deixis::studies
