// The plan: every trial of one participant, fixed before the first is shown.
#pragma once

#include <cstdint>
#include <string>
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
    std::vector<Vec3> distractors;
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
    std::uint64_t seed = 0;
    std::vector<Trial> trials;
};

/// Builds the plan of one participant: stage 1 (practice, then items x systems in random order), then stage 2
/// (likewise, layouts balanced within participant and system). The systems share the sampled targets. Depends
/// on the study's bytes, its seed and the participant's id alone. Fails where the study asks for more items
/// than targets.
[[nodiscard]] Result<StudyPlan> buildPlan(const Study& study, const std::vector<TargetItem>& targets,
                                          std::string_view participant);

/// The plan as JSON (an object with the participant, the study and "trials" in order; each trial with stage,
/// system, target_id, layout and the rest), and back. A round trip gives the same bytes.
[[nodiscard]] std::string planJson(const StudyPlan& plan);
[[nodiscard]] Result<StudyPlan> planFromJson(std::string_view json);

/// The same for people: a table, one line a trial.
[[nodiscard]] std::string planTable(const StudyPlan& plan);

}  // namespace deixis::studies
