// The plan: everything that one participant answers, fixed before the first trial is shown.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/error.hpp"
#include "studies/design/angles.hpp"
#include "studies/design/targets.hpp"
#include "studies/study_file/kept_values.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// Version of what buildPlan() does: it grows whenever the same study, targets and participant get another
/// plan than before. A study under way is planned by one version (docs/running-a-study.md).
inline constexpr int planner_version = 1;

/// A clip to be shown: a system's for an item.
struct Stimulus {
    std::string system;
    std::string item;  ///< TargetItem::id
    int clip = 0;      ///< which of them, in the order of the manifest, where the system has several
    friend bool operator==(const Stimulus&, const Stimulus&) = default;
    friend bool operator<(const Stimulus& a, const Stimulus& b) {
        return std::tie(a.system, a.item, a.clip) < std::tie(b.system, b.item, b.clip);
    }
};

/// What makes a trial an attention check.
struct TrialCheck {
    CheckKind kind = CheckKind::number;
    int stimulus = 0;       ///< number: which of the trial's stimuli it is shown with
    double expected = 0.0;  ///< number: the number to be given
    int of_trial = -1;      ///< repeat: the trial that is repeated, which comes earlier
};

/// One unit that is answered and kept: a trial, a page of a questionnaire, a consent. Self-contained: with
/// it, the study and the clips, a session can be run or replayed.
struct Trial {
    int index = 0;      ///< 0.. over all sessions in order of presentation, practice included
    std::string stage;  ///< Stage::name
    StageKind kind = StageKind::rating;
    bool practice = false;
    int attempt = 0;  ///< practice: 0, 1, ... Attempts after one that meets the criterion are not done
    int page = 0;     ///< questionnaire: which
    /// Rating, game: one. Pairwise: left, right. Parallel: in the order in which they are shown. None where
    /// nothing is shown.
    std::vector<Stimulus> stimuli{};
    std::string layout{};             ///< also of pages without stimuli, where the study has any layout
    std::string distance{};           ///< game: name of the band
    Vec3 target{0.0};                 ///< of the item, where there is one
    std::vector<Vec3> distractors{};  ///< game only: the other stages show no balls
    /// The balls in the order in which they are shown (and numbered in the record): indices into
    /// {target, distractors...}, shuffled, so that place in the list never gives the target away. Game only.
    std::vector<int> ball_order{};
    /// What is seen of each ball, in the order in which they are shown, from the layout's places. Game only;
    /// empty in plans from before it was kept.
    std::vector<SeenBalls> seen{};
    /// How far the distractors look from the target. Game only; none in plans from before it was kept.
    std::optional<BallAngles> angles{};
    std::optional<TrialCheck> check{};

    /// Position of the ball shown at `place`.
    [[nodiscard]] const Vec3& ball(int place) const;
    [[nodiscard]] int targetPlace() const;  ///< which place holds the target; -1 where no balls are shown
    /// Whether stimulus `i` counts in the analysis: no practice, no number, no catch, no second time.
    [[nodiscard]] bool scored(int stimulus = 0) const;
};

struct StudyPlan {
    std::string participant;
    int number = 1;  ///< 1, 2, ...: of the participant within the study
    std::string study_name;
    std::string study_hash;
    std::uint64_t seed = 0;                     ///< the study's
    std::map<std::string, std::string> groups;  ///< between factor -> the participant's level
    /// 1, 2, ...: of the participant among those with the same groups, which a Williams square goes by. None
    /// if there are no groups (and in plans of before version 5): then it goes by `number`.
    std::optional<int> number_in_cell{};
    std::vector<std::string> stages;  ///< names of those that apply, in order
    std::vector<Trial> trials;
};

/// Whether it can name a participant: 1 to 32 of the letters A-Z a-z, digits, '_' and '-'.
[[nodiscard]] bool validParticipant(std::string_view participant);
/// The same as an error.
[[nodiscard]] Result<void> checkParticipantId(std::string_view participant);
/// The number that an id ends in ("P07" -> 7); none if it ends in no digit, in 0 or in more than 6 digits.
[[nodiscard]] std::optional<int> numberOfParticipant(std::string_view participant);

/// Levels of the between-participants factors, as in StudyPlan::groups.
using Groups = std::map<std::string, std::string>;

/// How many participants have which groups.
using GroupSizes = std::map<Groups, int>;

/// The cell (one level of every between-participants factor) with the fewest in `taken`, which counts
/// everybody who counts: drop-outs do not. Among equals chance decides, by seed and number. Empty if the
/// study has no such factor.
[[nodiscard]] Groups assignGroups(const Study& study, const GroupSizes& taken, int number);

/// Where a participant stands among the others.
struct Assignment {
    Groups groups{};
    std::optional<int> number_in_cell{};  ///< as StudyPlan::number_in_cell
};

/// Of participant `number`, where all before enrolled in the order of their numbers and nobody dropped out,
/// as in a simulated study. `groups` empty: those that are assigned then.
[[nodiscard]] Assignment assignmentOf(const Study& study, int number, const Groups& groups = {});

/// Builds the plan of one participant.
///
/// - Items are targets drawn without replacement, different ones in all stages, the same for all systems
///   where Crossing::crossed (Deichler et al. 2023, 2.4.2). Practice and checks have items of their own, but
///   for repeats and for numbers, which take the place of a stimulus (Yoon et al. 2021, 7.2.2).
/// - Nested levels are shared out evenly over a participant's items, each system alike; where the items do
///   not divide, chance gives the odd ones out, separately for each participant.
/// - Order: blocks as TrialDesign says, shuffled within, under its constraints. Stimuli of a page and of a
///   pair are shuffled for each trial, left and right evenly over a pair's trials.
/// - Where a system has several clips for an item, chance draws one of them, the same for all of the
///   participant's trials (Yoon et al. 2021, 7.2.1).
///
/// Depends on the study's seed and design, the targets, the numbers and the groups alone, and not on the
/// texts. Fails if the id is not valid, a group is missing or unknown, there are too few targets, or the
/// constraints cannot be met.
[[nodiscard]] Result<StudyPlan> buildPlan(const Study& study, const std::vector<TargetItem>& targets,
                                          std::string_view participant, int number, const Groups& groups,
                                          std::optional<int> number_in_cell = {});

/// Rows of a Williams square for n conditions: n rows (2n where n is odd) in which every condition comes in
/// every place, and after every other one, equally often (Williams 1949).
[[nodiscard]] std::vector<std::vector<int>> williamsSquare(int n);

/// The plan as JSON, and back. A round trip gives the same bytes; reading checks every key. Described in
/// docs/database.md.
[[nodiscard]] std::string planJson(const StudyPlan& plan);
[[nodiscard]] Result<StudyPlan> planFromJson(std::string_view json);

/// Trial::seen as JSON: {"headset": {"at_rest": [...], "pointing": [...]}, "desktop": {...}}, shares of each
/// ball's disc in the order in which the balls are shown; empty if it was not kept.
[[nodiscard]] std::string visibilityJson(const Trial& trial);

/// Trial::angles as JSON: {"avatar": [...], "headset": [...], "desktop": [...]}, degrees, in the order of the
/// distractors; empty if they were not kept.
[[nodiscard]] std::string anglesJson(const Trial& trial);

/// What the trial's kind keeps of it beside, as it declares (kept_values.hpp).
[[nodiscard]] std::vector<KeptValue> keptValues(const Trial& trial);

/// The same for people: a table, one line a trial.
[[nodiscard]] std::string planTable(const StudyPlan& plan);

}  // namespace deixis::studies
