// The analysis of Deichler et al. 2023, section 3.1, for the measures of any study, and its outputs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "results/analysis/bradley_terry.hpp"
#include "results/analysis/objective.hpp"
#include "results/answers/data_quality.hpp"
#include "results/answers/response_table.hpp"
#include "results/statistics/bootstrap.hpp"
#include "results/statistics/friedman.hpp"
#include "results/statistics/rank_sum.hpp"
#include "results/statistics/shapiro_wilk.hpp"
#include "results/statistics/signed_rank.hpp"

namespace deixis::results {

struct AnalysisOptions {
    std::optional<double> alpha{};                 ///< in (0, 1); none: the study's
    std::optional<double> level{};                 ///< of intervals, in (0, 1); none: 1 - alpha
    std::map<std::string, double> equivalence{};   ///< bounds by measure, before those of the study
    std::optional<bool> by_ratings{};              ///< single ratings are tested, too; none: the study's
    int resamples = 10000;                         ///< of bootstraps, at least 1
    std::uint64_t seed = 1;                        ///< of bootstraps
    std::optional<ObjectiveAccuracy> objective{};  ///< of the clips that were answered about
    std::string program{};                         ///< that analyses, and its version; for provenance
    std::vector<std::pair<std::string, std::string>> build{};  ///< of the program: name, value; likewise
};

struct Summary {
    double mean = 0.0;                            ///< of participants' means
    double median = 0.0;                          ///< likewise
    double sd_participants = 0.0;                 ///< over participants' means
    double sd_trials = 0.0;                       ///< over single trials
    int n = 0;                                    ///< trials
    std::vector<double> by_participant{};         ///< participants' means, participants in order
    std::optional<BootstrapInterval> interval{};  ///< of the mean, resampling participants; BCa, or
                                                  ///< percentile if there is none; from two participants on
    /// So few participants that the range of their means itself covers the middle less often than the level.
    bool interval_falls_short = false;
};

struct SystemResult {
    std::string system;
    std::vector<Summary> measures;  ///< in the order of AnalysisResult::measures
};

/// One level of a factor within a measure.
struct LevelResult {
    std::string measure;
    std::string factor;  ///< one of withinFactors()
    std::string system;  ///< "all" for the first rows of a measure and factor
    std::string level;
    double mean = 0.0;  ///< over trials, as in the paper's Table 1
    double sd_trials = 0.0;
    int n = 0;
    Summary over_participants{};  ///< participants' means under this level; not in runTests()
};

/// Whether a shift lies within a bound that was declared before, by two one-sided tests.
struct Equivalence {
    double bound = 0.0;  ///< in the measure, above 0
    double p = 1.0;      ///< the larger of the two one-sided p
    double p_holm = 1.0;
    bool equivalent = false;  ///< p_holm <= alpha
};

/// A signed-rank test of participants' means in its family of Holm's correction.
struct AdjustedTest {
    SignedRankTest test{};  ///< n_pairs: the participants who have both conditions
    std::string family{};
    int family_size = 0;                    ///< tests of the family that have a p
    std::optional<double> p_holm{};         ///< none if no participant has both
    std::optional<double> p_holm_pratt{};   ///< the family corrected with Pratt's p of each test
    std::optional<double> p_holm_normal{};  ///< likewise with the normal approximation's
    bool significant = false;               ///< p_holm <= alpha
    bool depends_on_zeros = false;          ///< the decision would be another with Pratt's p
    bool depends_on_approximation = false;  ///< likewise with the normal approximation's
    /// Even the smallest p possible with this many differences, times the family's size, exceeds alpha:
    /// significant at most where others of the family have a smaller p.
    bool out_of_reach = false;
    ShapiroWilk normality{};                   ///< of the differences; for description only
    std::optional<Equivalence> equivalence{};  ///< where a bound was declared
};

struct Comparison : AdjustedTest {
    std::string measure;
    std::string factor{};  ///< empty: a and b are systems; else levels of it, within `system`
    std::string system{};  ///< "all" where each system has one level of the factor
    std::string a, b;
    double mean_difference = 0.0;       ///< a - b, mean over the participants paired
    std::vector<double> differences{};  ///< a - b of each of them, participants in order
};

/// With the medians of what is compared.
struct MedianComparison : Comparison {
    std::optional<double> median_a{};
    std::optional<double> median_b{};
};

/// A pair of systems in single ratings (the unit of Yoon et al. 2021, 7.2.3). A pair of them is a
/// participant's two ratings on one page, or of one item. Ratings of a participant are not independent, so p
/// is too small: pseudo-replicated. No interval is given.
struct RatingComparison : MedianComparison {  ///< medians: of all ratings of the system
    int participants = 0;                     ///< whose ratings are paired
    int n_missing = 0;                        ///< pages and items with a rating of one of the two only
};

/// Friedman's test over all systems, of the participants who have answers under each of them.
struct OmnibusResult {
    std::string measure;
    FriedmanTest test;  ///< mean ranks in the order of the systems; 1 is the lowest score
};

/// How often one system was preferred to another; over trials. The test is of participants' mean preferences
/// against 0.
struct PreferenceResult : AdjustedTest {
    std::string a, b;
    int prefers_a = 0;
    int ties = 0;
    int prefers_b = 0;
    double mean = 0.0;  ///< of participants' mean preferences; positive: for a, up to 2
};

/// A questionnaire's score over participants.
struct ScoreResult {
    std::string stage;
    std::string score;
    double mean = 0.0;
    double sd = 0.0;
    int n = 0;
    double q25 = 0.0, median = 0.0, q75 = 0.0;
    std::string factor{};  ///< between participants, of whom these have `level`; empty: all participants
    std::string level{};
};

/// Another choice of answers than the headline's.
enum class AnswerChoice : unsigned char {
    with_left_out,     ///< who is excluded or dropped out counts, but not who declined consent
    without_doubtful,  ///< without marked trials, and without participants who failed an attention check
    answered_only,     ///< choices that timed out are left out; the headline counts them as wrong
    unanswered_wrong   ///< choices that were skipped count as wrong, too; the headline leaves them out
};
inline constexpr std::array all_choices{AnswerChoice::with_left_out, AnswerChoice::without_doubtful,
                                        AnswerChoice::answered_only, AnswerChoice::unanswered_wrong};
/// As in analysis.json: "with_left_out", ...
[[nodiscard]] const char* nameOf(AnswerChoice choice);

/// A pair of systems under other choices of answers, each with its own families of the same pairs.
struct SensitivityResult {
    struct Other {
        AnswerChoice choice{};
        AdjustedTest test{};
        bool changes = false;  ///< the decision would be another than the headline's
    };
    std::string measure;  ///< "preference" too
    std::string a, b;
    AdjustedTest headline;        ///< as in pairwise and preferences
    std::vector<Other> others{};  ///< all_choices, in their order

    [[nodiscard]] const Other& other(AnswerChoice choice) const {
        return others.at(static_cast<std::size_t>(choice));
    }
};

/// How many answers and participants a choice takes.
struct AnswerCounts {
    int participants = 0;  ///< with answers
    int answers = 0;
};

/// Choices that a system's trials of the game did not get, where any system has such ones.
struct UnansweredResult {
    std::string system;
    int answered = 0;
    int timed_out = 0;  ///< the time limit passed: wrong in the headline
    int skipped = 0;    ///< by the experimenter: left out of the headline
    /// Means of participants' means; none without such choices.
    std::optional<double> headline{};
    std::optional<double> answered_only{};
    std::optional<double> unanswered_wrong{};
};

/// Two groups of participants, by the rank-sum test of a score of each participant.
struct GroupTest {
    std::string factor;
    std::string a, b;     ///< levels
    double mean_a = 0.0;  ///< of participants' scores; 0 if there are none
    double mean_b = 0.0;
    RankSumTest test{};
    std::string family{};
    int family_size = 0;  ///< tests of it that have a p
    std::optional<double> p_holm{};
    bool significant = false;
    std::optional<Equivalence> equivalence{};  ///< where a bound was declared
};

/// Whether the difference a - b is another one under c than under d: a signed-rank test of participants'
/// differences of these differences.
struct InteractionResult : AdjustedTest {
    std::string measure;
    std::string factor;  ///< of a and b: "system" or one within participants
    std::string a, b;
    std::string other_factor;  ///< of c and d, within participants
    std::string c, d;
    double mean_difference = 0.0;
};

/// Whether participants' difference c - d is another one in group a than in group b: a rank-sum test.
struct GroupInteractionResult : GroupTest {
    std::string measure;
    std::string other_factor;  ///< of c and d: "system" or one within participants
    std::string c, d;
};

/// Of participants' means. The family: all pairs of levels, over all and within each system.
struct BetweenResult : GroupTest {
    std::string measure;
    std::string system;  ///< "all": of each participant, the mean of the means under each system
};

/// A group's answers to one pair of systems.
struct PreferenceCounts {
    int wins = 0;  ///< for the first of the pair
    int ties = 0;
    int losses = 0;

    [[nodiscard]] int answers() const { return wins + ties + losses; }
    /// None without answers.
    [[nodiscard]] std::optional<double> share(int of) const {
        return answers() > 0 ? std::optional<double>(static_cast<double>(of) / answers()) : std::nullopt;
    }
};

/// How two groups differ in one pair of systems. A participant's score is the net preference: the mean of the
/// answers, positive for `system`, from -2 to 2. The family: all pairs of systems and of levels.
struct PreferenceBetweenResult : GroupTest {
    std::string system;
    std::string other_system;
    PreferenceCounts answers_a, answers_b;
};

/// A system's ratings by the author's trial in which the clips were made: the earlier one (a) against the
/// later (b), by the rank-sum test of single ratings, which is pseudo-replicated, too. No interval is given.
struct AuthorTrialResult : GroupTest {
    std::string measure;
    std::string system;
    double median_a = 0.0;
    double median_b = 0.0;
};

/// How often balls of one role were chosen in a system's trials of the game.
struct ConfusionResult {
    std::string system;
    /// "target"; "nearest 1", "nearest 2", ...: the distractors by their distance from the target; "left",
    /// "right": the distractors on that side of the target, as seen from where the participant's head was.
    std::string role;
    int chosen = 0;
    int shown = 0;  ///< such balls, over all trials
};

/// Correct choices for the targets at one place.
struct TargetPlace {
    std::string system;  ///< "all" first
    std::string target_id;
    Vec3 position_m{0.0};  ///< in the avatar's frame
    int n = 0;             ///< choices
    double mean = 0.0;     ///< share of right ones
};

/// Ratings taken one by one. Those of a participant are correlated, so they are pseudo-replicated: this
/// describes, and no test belongs to it.
struct PooledResult {
    std::string measure;
    std::string system;
    int n = 0;
    double mean = 0.0;
    double sd = 0.0;
    double q05 = 0.0, q25 = 0.0, median = 0.0, q75 = 0.0, q95 = 0.0;
};

/// A system's choices against chance. The test is of participants' means of correct - 1 / balls, each trial's
/// own balls, against 0; trials whose number of balls is not known have no part in it.
struct ChanceResult : AdjustedTest {
    std::string system;
    int successes = 0;
    int n = 0;                ///< choices
    int n_known = 0;          ///< of them, those whose number of balls is known
    double chance = 0.0;      ///< mean of participants' means of 1 / balls; 0 if it is not known
    double mean_above = 0.0;  ///< mean of participants' means of correct - 1 / balls; likewise
};

/// Response times of a system in one measure, seconds; answers without one are left out.
struct TimeResult {
    std::string measure;
    std::string system;
    int n = 0;
    double q25_s = 0.0, median_s = 0.0, q75_s = 0.0;
};

/// Whether answers change while a participant goes on: the means of the first and the second half of each
/// participant's answers on a measure, in their order; the middle one of an odd number belongs to the first.
struct OrderResult : AdjustedTest {  ///< of second - first, over participants
    std::string measure;
    double first = 0.0;  ///< mean of participants' means
    double second = 0.0;
};

/// One target or stimulus, over all systems and participants.
struct ItemResult {
    std::string measure;
    std::string item;
    double mean = 0.0;
    int n = 0;
};

/// How many answers of a participant there are on each of AnalysisResult::measures, for each system.
struct PresenceRow {
    std::string participant;
    std::vector<std::vector<int>> answers{};  ///< [measure][system]
};

/// What participants told of themselves.
struct FieldResult {
    std::string field;
    int n = 0;
    double median = 0.0, min = 0.0, max = 0.0;           ///< of numbers
    std::vector<std::pair<std::string, int>> options{};  ///< how many chose each; empty: numbers
};

/// Of participants' sessions together, minutes.
struct SessionTimeResult {
    std::string factor{};  ///< between participants, of whom these have `level`; empty: all participants
    std::string level{};
    int n = 0;
    double median_min = 0.0, min_min = 0.0, max_min = 0.0;
};

/// A questionnaire asked again: of the participants who have both scores, later - earlier.
struct ScoreChange : AdjustedTest {
    std::string score;
    std::string a, b;  ///< stages: the later, the earlier
    double mean_a = 0.0, mean_b = 0.0;
};

/// A questionnaire's score by groups. The family: all scores of a stage and pairs of levels of a factor.
struct ScoreGroupResult : GroupTest {
    std::string stage;
    std::string score;
};

/// A system's place in a study, or in all studies together (pooled_studies), by the median.
struct MedianResult {
    std::string measure;
    std::string study;
    int place = 0;  ///< from 1, the highest first; equal medians share their place
    std::string system;
    double median = 0.0;                     ///< of participants' means
    std::optional<double> answers_median{};  ///< of single ratings, as Yoon et al. 2021 give it
    int participants = 0;
    int answers = 0;
};

struct AnalysisResult {
    ResponseTable table;
    std::string answers_hash{};  ///< answersHash() of it
    AnalysisOptions options;
    double alpha = 0.01;
    double level = 0.99;  ///< of intervals; 0: none are computed
    int participants = 0;
    bool synthetic = false;         ///< some answers come from simulated participants
    std::vector<Measure> measures;  ///< accuracy and ratings; preferences stand apart
    std::vector<SystemResult> systems;
    std::vector<SystemResult> not_compared;  ///< ResponseTable::not_compared, in the order of the systems
    std::vector<LevelResult> levels;
    std::vector<OmnibusResult> omnibus;
    std::vector<Comparison> pairwise;
    bool by_ratings = false;                     ///< asked for: the next is filled in
    std::vector<RatingComparison> rating_pairs;  ///< of ratings
    std::vector<AuthorTrialResult>
        author_trials;  ///< of ratings, where the answers carry two trials and more
    /// Likewise: of each participant the mean rating of clips of the one trial less that of the other.
    std::vector<MedianComparison> author_trials_paired;
    std::vector<Comparison> level_tests;
    std::vector<InteractionResult> interactions;
    std::vector<GroupInteractionResult> group_interactions;
    std::vector<PreferenceResult> preferences;
    BradleyTerry bradley_terry;
    std::vector<ScoreResult> scores;  ///< each over all participants, then by factors between them
    std::vector<ScoreChange> score_changes;
    std::vector<ScoreGroupResult> score_groups;
    std::vector<Comparison>
        time_tests;  ///< of participants' median response times, seconds, pairs of systems
    std::vector<BetweenResult> time_groups;  ///< likewise, groups of participants
    std::vector<FieldResult> fields;
    std::vector<SessionTimeResult> session_times;  ///< all first; empty if they are not known
    std::vector<SensitivityResult> sensitivity;
    AnswerCounts headline_answers;
    std::array<AnswerCounts, all_choices.size()> other_answers{};  ///< of all_choices
    std::vector<UnansweredResult> unanswered;  ///< by system; empty where every choice was made
    std::vector<BetweenResult> between;
    std::vector<PreferenceBetweenResult> preferences_between;
    std::vector<ConfusionResult> confusion;  ///< where the balls' positions are known
    std::vector<TargetPlace> target_space;   ///< likewise; of each system by target
    std::vector<ObserverReading> observers;  ///< where the choices' clips are available
    std::vector<DriftResult> drift;          ///< likewise
    ObjectiveComparison objective;           ///< empty without options.objective
    std::vector<PooledResult> pooled;        ///< of ratings
    std::vector<ChanceResult> chance;        ///< where there is a game
    std::vector<TimeResult> times;
    std::vector<OrderResult> order;  ///< where the answers' order is known
    std::vector<ItemResult> items;   ///< by measure, lowest mean first
    std::vector<PresenceRow> presence;
    /// Of several studies (ResponseTable::origins) each by itself, in order: its systems, omnibus, pairwise,
    /// preferences and systems between participants, in families of their own; study_name is the study.
    std::vector<AnalysisResult> by_study;
    std::vector<MedianResult> medians;  ///< likewise: by measure and study, pooled last; highest first
    DataQuality quality;
    std::vector<std::string>
        remarks;  ///< what a reader must know: missing answers, exclusions from a test, ...
};

/// Participants' means are compared, as in the paper; a participant without answers under one of the two
/// conditions is left out of that comparison. Holm's families: all pairs of systems in one measure, all pairs
/// of levels of one factor over the systems in one measure, all pairs in preference, all pairs of groups of
/// one factor, over all and within each system, in one measure, and all pairs of groups of one factor in each
/// pair of systems in preference; of single ratings, all pairs of systems in one measure, and all systems and
/// pairs of authors' trials in one measure.
[[nodiscard]] AnalysisResult analyse(ResponseTable table, const AnalysisOptions& options = {});
/// The tests of analyse() alone, without intervals, bootstraps and descriptions, for who asks very often:
/// fills in alpha, measures, omnibus, pairwise, levels, level_tests, preferences, between and
/// preferences_between from the result's table and options.
void runTests(AnalysisResult& result);
/// A rating on a scale of more than ten steps (0 to 100): medians are given beside its means.
[[nodiscard]] bool hasManySteps(const Measure& measure);
/// No measure of the result is a distance or an angle: single answers are single ratings.
[[nodiscard]] bool hasRatingsOnly(const AnalysisResult& result);

}  // namespace deixis::results
