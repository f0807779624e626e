// A model of speech gestures in numbers and pictures: table 1 and figure 3 of Yoon et al. (2021), for people
// to read. How the numbers come about is learning/gesture_scores' matter.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/utterance.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::results {

/// A row of table 1; lower is better everywhere. What a model does not take controls for is not there.
struct GestureModelScores {
    std::string model;  ///< "proposed", "baseline", "mean pose"
    double fgd_no_controls = 0.0;
    std::optional<double> fgd_pose_controls{};
    std::optional<double> fgd_style_controls{};
    std::optional<double> pcs{};
    std::optional<double> scs{};
    std::optional<double> posed_off_deg{};  ///< mean angle from the directions that were asked for
    std::optional<double> exact_off_deg{};  ///< the largest with the option exact
};

/// Speeches on which models were tried out.
struct GestureTestSet {
    std::string name;  ///< "rules A, unseen sentences"
    bool synthetic = true;
    int speeches = 0;
    double minutes = 0.0;
    int parts = 0;  ///< of 30 frames
    std::vector<GestureModelScores> models;
};

/// Frames from `first` to before `last`.
struct MarkedFrames {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// A motion of the shown speech, and what was asked for.
struct GestureStrip {
    std::string title;
    motion::UpperBodyMotion motion;
    std::vector<MarkedFrames> posed{};
    std::vector<MarkedFrames> styled{};
};

struct GestureEvaluationPage {
    std::vector<std::pair<std::string, std::string>> facts;  ///< of the model's file: names and texts
    std::vector<GestureTestSet> sets;
    bool trained_on_synthetic = true;
    Utterance utterance{};           ///< of the shown speech
    std::vector<double> loudness{};  ///< of its sound from begin to end, 0 to 1
    std::vector<GestureStrip> strips{};
};

/// The published table 1.
[[nodiscard]] const std::vector<GestureModelScores>& publishedGestureScores();

/// For a terminal: a table for each set, with the published numbers beside it.
[[nodiscard]] std::string gestureScoresText(const std::vector<GestureTestSet>& sets);
[[nodiscard]] std::string gestureScoresCsv(const std::vector<GestureTestSet>& sets);
[[nodiscard]] std::string gestureScoresJson(const GestureEvaluationPage& page);
[[nodiscard]] std::string gestureEvaluationHtml(const GestureEvaluationPage& page);

}  // namespace deixis::results
