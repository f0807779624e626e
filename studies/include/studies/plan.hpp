// The plan: every trial of one participant, fixed before the first is shown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "studies/study.hpp"
#include "studies/targets.hpp"

namespace deixis::studies {

enum class StageKind : unsigned char { naturalness, game };
[[nodiscard]] std::string_view stageName(StageKind kind);  ///< "naturalness" or "game"

/// One trial. Self-contained: with it and the clips, a session can be run or replayed.
struct Trial {
    int index = 0;  ///< 0.. over the whole session in order of presentation, practice included
    StageKind stage = StageKind::naturalness;
    bool practice = false;
    std::string system;
    std::string target_id;
    std::string layout;
    Vec3 target{0.0};
    std::vector<Vec3> distractors;  ///< game only: the naturalness stage shows no balls
    /// The balls in the order in which they are shown (and numbered in the record): indices into
    /// {target, distractors...}, shuffled, so that place in the list never gives the target away. Game only.
    std::vector<int> ball_order;

    /// Position of the ball shown at `place`.
    [[nodiscard]] const Vec3& ball(int place) const;
    [[nodiscard]] int targetPlace() const;  ///< which place holds the target; -1 where no balls are shown
};

struct StudyPlan {
    std::string participant;
    std::string study_name;
    std::string study_hash;
    std::uint64_t seed = 0;  ///< the study's
    std::vector<Trial> trials;
};

/// Whether it can name a participant: 1 to 32 of the letters A-Z a-z, digits, '_' and '-'.
[[nodiscard]] bool validParticipant(std::string_view participant);

/// Builds the plan of one participant (Deichler et al. 2023, 2.4.2): stage 1, then stage 2, each with its
/// practice trials first and then every item with every system in one random order.
///
/// - Items are targets drawn without replacement, different ones in the two stages, the same for all systems.
/// - In the game a target has one layout, shared by all systems, and the layouts share a participant's
/// targets
///   out evenly: every system meets every layout equally often and on the same targets. Where the items do
///   not divide by the layouts, chance gives the odd ones out, anew for each participant.
/// - Practice takes targets that no scored trial uses, and goes round the systems and layouts.
///
/// Depends on the study's seed and numbers, the targets and the participant's id alone; a change to the
/// study's texts changes nothing but study_hash. Fails where the id is not valid or where there are too few
/// targets.
[[nodiscard]] Result<StudyPlan> buildPlan(const Study& study, const std::vector<TargetItem>& targets,
                                          std::string_view participant);

/// The plan as JSON, and back. An object with participant, study, study_hash, seed and "trials" in order,
/// each with index, stage ("naturalness" or "game"), practice, system, target_id, layout, target [x, y, z],
/// distractors and ball_order. A round trip gives the same bytes; reading checks every key.
[[nodiscard]] std::string planJson(const StudyPlan& plan);
[[nodiscard]] Result<StudyPlan> planFromJson(std::string_view json);

/// The same for people: a table, one line a trial.
[[nodiscard]] std::string planTable(const StudyPlan& plan);

}  // namespace deixis::studies
