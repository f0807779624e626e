// The paper's results (Deichler, Wang, Alexanderson & Beskow 2023) and ours side by side, on one page: what
// the paper claims, whether it came out here too, and every number behind that. What is compared was computed
// before, by `deixis evaluate`, `report` and `clips measure`; scripts/reproduce.sh runs all of them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

/// One objective evaluation, of one grid of test points.
struct GridFigures {
    struct System {
        std::string system;
        int missing = 0;  ///< clips without accuracy
        std::optional<double> mean{}, sd{}, median{}, error_deg{};
        std::optional<double> eye_error_deg{};  ///< of the line from the eyes through the fingertip
        std::optional<double> density_rho{}, density_p{};
        std::vector<double> accuracies{};  ///< Equation 2 of each clip that has one
    };
    std::string grid;  ///< as it was named
    std::string file;
    int points = 0;
    int training_targets = 0;
    std::vector<System> systems;
};

/// The study as one kind of participant answered it.
struct StudyFigures {
    struct Score {
        std::string system, measure;
        double mean = 0.0;
        std::optional<double> lower{}, upper{};  ///< of the mean's interval
    };
    struct Layout {
        std::string system, layout;  ///< "all": of all systems
        double mean = 0.0, sd = 0.0;
    };
    struct Pair {
        std::string measure, a, b;
        bool significant = false;
    };
    std::string participants_kind;  ///< as it was named: of simulated participants, how they read an arm
    std::string file;
    int participants = 0;
    bool synthetic = false;
    double alpha = 0.0;
    std::vector<Score> scores{};
    std::vector<Layout> layouts{};  ///< of the game
    std::vector<Pair> pairs{};      ///< of systems
    int layout_tests = 0;           ///< of the game: of systems, between layouts
    int layouts_that_differ = 0;    ///< of those, significant
};

/// Shares of games that an observer who makes no error gets right (`deixis evaluate --study`).
struct CeilingFigures {
    struct Reading {
        std::string system, observer;
        double without_error = 0.0;
    };
    std::string file;
    std::vector<Reading> readings;
    std::optional<double> nearest_target_share{};  ///< who picks the ball nearest to GT-nn's own target
};

/// One demonstration, as measured.
struct DemonstrationFigures {
    bool left = false;            ///< by the left hand
    double equation_2 = 0.0;      ///< highest in the hold
    double peak_speed_m_s = 0.0;  ///< of the wrist
};

/// What a file of weights says of itself.
struct TrainedSystem {
    std::string system;
    long long numbers = 0;     ///< that were learned
    long long bytes = 0;       ///< of the file
    std::string rewarded{};    ///< the task of a policy, such as "forearm"; empty of others
    std::string trained_by{};  ///< program and commit
    // Of held-out targets, as far as the file says it:
    std::optional<double> reward{};      ///< Equation 2, or the same of what was rewarded
    std::optional<double> jerk_ratio{};  ///< over the demonstrations'
    std::optional<double> at_rest{};     ///< share of clips that end so
    std::optional<double> arm_error_m{};
};

struct ReproductionInput {
    std::vector<GridFigures> grids;
    std::vector<StudyFigures> studies;
    std::optional<CeilingFigures> ceiling{};
    std::vector<DemonstrationFigures> demonstrations{};
    std::vector<TrainedSystem> trained{};
    std::string targets_svg{};       ///< training and test targets; may be empty
    std::vector<std::string> pages;  ///< files with more, as the page links to them
    std::string program;
};

[[nodiscard]] Result<GridFigures> readGridFigures(const std::string& grid, const std::filesystem::path& file);
[[nodiscard]] Result<StudyFigures> readStudyFigures(const std::string& kind,
                                                    const std::filesystem::path& file);
[[nodiscard]] Result<CeilingFigures> readCeilingFigures(const std::filesystem::path& file);
/// The table that `deixis clips measure --csv` prints.
[[nodiscard]] Result<std::vector<DemonstrationFigures>> readDemonstrationFigures(
    const std::filesystem::path& file);

/// HTML, self-contained, well-formed XML, too.
[[nodiscard]] std::string renderReproduction(const ReproductionInput& input);

}  // namespace deixis::results
