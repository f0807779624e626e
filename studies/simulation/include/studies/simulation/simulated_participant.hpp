// A simulated participant. It sees what a person would see, the presented frame, and never the plan or the
// answer. Its answers test pipelines and power; they are no evidence about people.
// docs/simulated-participant.md describes how it decides.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"
#include "studies/observers/observer.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

/// Parameters, from a TOML file (assets/data/simulated_participant.toml documents each and has the same
/// values). SDs are over participants ("between") or over trials ("within"). All are assumptions.
struct SimulatedParameters {
    ObserverModel observer{};              ///< how it reads an arm; its noise is the mean over participants
    double pointing_noise_between = 0.25;  ///< relative SD of that noise over participants
    double elevation_bias_deg = 0.0;       ///< by which every line is read too high

    // The rating: base + weights x how much of each quality was seen (0..1), on a scale from 1 to 5.
    double rating_base = 0.8;
    double rating_profile_weight = 0.9;  ///< the hand speeds up and slows down instead of starting abruptly
    double rating_participation_weight = 0.95;  ///< head and trunk take part
    double rating_steadiness_weight = 1.6;      ///< the hand is still while it points
    double profile_abrupt = 1.1;                ///< peak over mean speed of the raise that gives quality 0
    double profile_smooth = 1.4;                ///< and quality 1
    double participation_deg = 6.0;             ///< turn of head and trunk that gives quality 0.63
    double steady_speed_m_s = 0.04;    ///< mean speed of the fingertip in the hold that gives quality 1
    double unsteady_speed_m_s = 0.22;  ///< and quality 0
    double rating_bias_between = 0.4;  ///< SD over participants, steps of that scale
    double rating_noise_within = 0.6;  ///< SD over movements, steps of that scale

    // A preference: from the difference of two such judgements, in steps of that scale.
    double preference_tie_zone = 0.4;    ///< no larger: no preference
    double preference_clear_zone = 1.2;  ///< no larger: a slight one, beyond: a clear one

    // Confidence in a choice of the game: from 1 to 5, by how much nearer the ray the chosen ball was than
    // the next.
    double confidence_margin_deg = 5.0;    ///< that gives 63 % of it
    double confidence_noise_within = 0.5;  ///< SD over trials, steps of that scale

    double attention_lapse_rate = 0.0;  ///< chance of overlooking the number of an attention check

    // Questionnaires: around the middle of each scale, in shares of its range.
    double questionnaire_bias_between = 0.15;  ///< SD over participants
    double questionnaire_noise_within = 0.15;  ///< SD over questions

    double reaction_mean_s = 0.9;  ///< lognormal
    double reaction_sd_s = 0.25;
    double eye_height_m = 1.65;
    double frame_rate_hz = 30.0;  ///< of the virtual display
};

/// Errors name file, line and key.
[[nodiscard]] Result<SimulatedParameters> loadSimulatedParameters(const std::filesystem::path& path);

/// Watches frames, decides, and gives back what its hands do. Pure: time comes with the frames.
class SimulatedParticipant {
  public:
    /// `avatar` names the joints of the presented avatar (as a person would know a hand when seeing one) and
    /// must outlive the participant. Throws std::invalid_argument on an avatar without arms or head. Without
    /// a `keyboard` it leaves fields for words empty, and enters numbers by their pads.
    SimulatedParticipant(const SimulatedParameters& parameters, const motion::Skeleton& avatar,
                         std::uint64_t seed, bool keyboard = true);
    ~SimulatedParticipant();
    SimulatedParticipant(SimulatedParticipant&&) noexcept;

    void see(const PresentedFrame& frame, double time_s);
    /// What it does by `time_s`, the time of the frame that begins now.
    [[nodiscard]] InputFrame act(double time_s);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The station around it: virtual time at a steady frame rate, no waiting, nothing drawn. A viewer may be
/// attached that is given every frame, to draw it (the pilot without a display) or to take pictures. A
/// session that gets nowhere is ended: where the same trial or page stays for patience_s, failure() says what
/// was waited for.
class SimulatedStation : public Station {
  public:
    /// `keyboard`: whether the participant has one, as the session must be told too.
    SimulatedStation(const SimulatedParameters& parameters, const motion::Skeleton& avatar,
                     std::uint64_t seed, bool keyboard = true);
    [[nodiscard]] StationInfo info() const override;
    [[nodiscard]] InputFrame beginFrame() override;
    FrameReport present(const PresentedFrame& frame) override;
    [[nodiscard]] std::optional<Error> failure() const override { return failure_; }

    static constexpr double patience_s = 1800.0;  ///< of virtual time

    /// Called with each presented frame and the participant's input before the frame counts as shown.
    using Viewer = std::function<void(const PresentedFrame&, const InputFrame&)>;
    void attachViewer(std::string details, Viewer viewer);

  private:
    SimulatedParticipant participant_;
    double frame_rate_hz_;
    std::uint64_t frames_ = 0;
    InputFrame input_{};
    std::string details_;
    std::string observer_;  ///< how it reads an arm, for the record
    Viewer viewer_;
    std::string under_way_{};  ///< the stage and trial, or page, seen last, and
    double since_s_ = 0.0;     ///< since when
    std::optional<Error> failure_{};

    void watchProgress(const PresentedFrame& frame);
};

}  // namespace deixis::studies
