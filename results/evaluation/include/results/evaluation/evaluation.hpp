// The objective evaluation of Deichler et al. (2023), section 3.2: accuracy of clips by system, its
// correlation with the density of the training targets, and their clusters. Pure: clips are measured before
// (motion/pointing_accuracy.hpp). docs/evaluation.md says what is computed.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "motion/pointing/accuracy.hpp"
#include "motion/pointing/rays.hpp"
#include "results/answers/observers.hpp"
#include "results/statistics/density.hpp"
#include "results/statistics/mean_shift.hpp"
#include "results/statistics/signed_rank.hpp"
#include "results/statistics/spearman.hpp"

namespace deixis::results {

/// Steps of the profiles.
inline constexpr double profile_step_s = 0.05;
inline constexpr double profile_from_s = -1.5;
inline constexpr double profile_to_s = 3.0;

/// A clip as measured.
struct MeasuredClip {
    std::string system;
    std::string clip;  ///< file, as its manifest names it
    std::string target_id;
    Vec3 target{0.0};  ///< metres
    motion::Side hand = motion::Side::right;
    std::optional<int> pointing_frame{};  ///< the peak; none: no hand makes a gesture
    bool phases_given = true;             ///< false: hand and phases were found (motion::detectPhases)
    bool placed = false;                  ///< the target is given from the figure, which was placed so
    bool away = false;                    ///< the figure does not stand at the target's origin
    std::optional<motion::PointingAccuracy> accuracy{};  ///< none: the hand was never slow enough
    motion::PointingProfile profile{};
    /// By PointingRay, the angle between ray and target in the frame of the accuracy, or else of pointing;
    /// none if the figure lacks a joint of it.
    std::array<std::optional<double>, motion::all_pointing_rays.size()> ray_errors_deg{};
    studies::ArmLines lines{};  ///< over the hold
};

/// The games of a study, for whose targets clips may have been made.
struct StudyGames {
    std::string name;
    struct Place {
        std::string layout;
        Vec3 observer_eye{0.0};
    };
    std::vector<Place> places;  ///< in a headset
    struct Game {
        std::string target_id;
        std::vector<Vec3> balls{};  ///< the target first
    };
    std::vector<Game> games;  ///< of each target and distance band
    Vec3 pointer_eye{0.0};    ///< of the avatar at ease
};

struct InputFile {
    std::string path;
    std::string sha256;
};

struct EvaluationInput {
    std::vector<MeasuredClip> clips;            ///< systems in the order in which they first stand here
    int without_target = 0;                     ///< rows of the manifests that point at nothing
    std::set<std::string> synthetic_systems{};  ///< made by formulas, or learned from such
    motion::AccuracyRule rule{};
    std::vector<Vec3> training;
    std::string training_source;  ///< for people
    bool training_synthetic = false;
    std::variant<BandwidthRule, std::vector<double>> bandwidth = BandwidthRule::normal_reference;
    std::optional<double> mean_shift_bandwidth{};              ///< none: estimated
    std::optional<StudyGames> study{};                         ///< none: no game is looked at
    std::string program;                                       ///< name and version
    std::vector<std::pair<std::string, std::string>> build{};  ///< of the program: name, value
    std::vector<InputFile> files{};
    std::string motion_digest{};  ///< SHA-256 over elbow and hand positions of all clips
};

/// Mean and standard deviation (n - 1) over clips at one step of time.
struct ProfilePoint {
    double time_s = 0.0;
    int n = 0;
    double reward_mean = 0.0;
    double reward_sd = 0.0;
    double speed_mean = 0.0;
    double speed_sd = 0.0;
};

/// Steps that at least half of the clips of that hand have, and no fewer than one.
struct HandProfile {
    int clips = 0;
    std::vector<ProfilePoint> points{};
};

struct SystemEvaluation {
    std::string system;
    bool synthetic = false;
    std::vector<const MeasuredClip*> clips{};  ///< all of them; they belong to Evaluation::input
    std::vector<double> rewards{};             ///< of those with an accuracy, in order
    std::vector<double> errors_deg{};
    std::vector<double> densities{};  ///< at the same clips' targets
    int missing = 0;                  ///< clips without an accuracy
    int left_hand = 0;
    int phases_found = 0;
    int placed = 0;
    int away = 0;
    SpearmanTest correlation{};  ///< of accuracy with density
    HandProfile left{};
    HandProfile right{};
    std::vector<std::optional<double>>
        cluster_means{};  ///< mean accuracy at the targets nearest to each cluster
};

/// A place that clips were made for.
struct TestPoint {
    std::string target_id;
    Vec3 target{0.0};
    double density = 0.0;  ///< 1/m^3
    int cluster = 0;       ///< that of the nearest training target
};

struct TargetCluster {
    Vec3 centre{0.0};
    int training_targets = 0;
    int test_points = 0;
};

/// Accuracy of two systems over the targets at which both have one; where a system has several clips for a
/// target, their mean counts.
struct SystemComparison {
    std::size_t a = 0;                 ///< of Evaluation::systems
    std::size_t b = 0;                 ///< comes after a
    double mean_difference = 0.0;      ///< of accuracy, a - b; this and the next two: 0 without targets
    double sd = 0.0;                   ///< of the differences, n - 1; 0 of one target
    double mean_difference_deg = 0.0;  ///< of the error, a - b
    /// Of the differences of accuracy, to 1e-9: what is nearer together counts as equal, so that the last
    /// bits of another machine's arithmetic change no rank. n_pairs is how many targets there are.
    SignedRankTest test{};
    std::vector<double> differences{};  ///< of accuracy, one for each target
    std::optional<double> p_holm{};     ///< over all pairs that share targets; none if there are none
};

struct Evaluation {
    EvaluationInput input;
    std::vector<SystemEvaluation> systems;
    std::vector<TestPoint> points;  ///< each place once, in the order of the clips
    std::vector<double> bandwidths;
    std::string bandwidth_rule;  ///< its name, or "given"
    double mean_shift_bandwidth = 0.0;
    bool mean_shift_estimated = false;
    std::vector<TargetCluster> clusters;
    std::vector<std::string> remarks;           ///< what a reader must know
    std::vector<ObserverReading> observers;     ///< of the study's games; empty without a study
    std::optional<NearestCeiling> nearest{};    ///< likewise
    std::vector<SystemComparison> comparisons;  ///< every pair: first with second, first with third, ...

    Evaluation() = default;
    // Systems point into the input's clips.
    Evaluation(const Evaluation&) = delete;
    Evaluation& operator=(const Evaluation&) = delete;
    Evaluation(Evaluation&&) = default;
    Evaluation& operator=(Evaluation&&) = default;
    ~Evaluation() = default;
};

/// Fails if there are no clips, or no density or clusters can be had from the training targets.
[[nodiscard]] Result<Evaluation> evaluate(EvaluationInput input);

/// A whole, self-contained HTML page (also well-formed XML), without outside file or date: the same
/// evaluation gives the same bytes.
[[nodiscard]] std::string renderEvaluation(const Evaluation& evaluation);
/// One JSON object, "format": "deixis-evaluation", "version": 2; documented in docs/evaluation.md.
[[nodiscard]] std::string evaluationJson(const Evaluation& evaluation);
/// File names and contents: clips.csv, systems.csv, comparisons.csv, profiles.csv, targets.csv, clusters.csv,
/// rays.csv; of a study's games observers.csv.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> evaluationTables(const Evaluation& evaluation);

}  // namespace deixis::results
