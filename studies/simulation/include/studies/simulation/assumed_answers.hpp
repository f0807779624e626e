// Answers to real plans, drawn from assumed effects: nothing is watched, no ray is read. For power
// analyses; they are no evidence about people. The model is described in docs/power.md.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "studies/design/plan.hpp"
#include "studies/study_file/answer_curve.hpp"
#include "studies/study_file/assumed_effects.hpp"

namespace deixis::studies {

/// One answer that a plan asks for and the analysis counts.
struct PlannedAnswer {
    std::size_t participant = 0;  ///< place among the plans
    std::size_t measure = 0;      ///< of AssumedAnswers::measures()
    const Trial* trial = nullptr;
    std::size_t stimulus = 0;  ///< of the trial; of a pair 0, the left one
};

class AssumedParticipant;

/// Draws whole studies.
class AssumedAnswers {
  public:
    /// The plans must outlive it, and assume what `effects` were read for.
    AssumedAnswers(const Study& study, const AssumedEffects& effects, std::span<const StudyPlan> plans);

    /// Those of which something is assumed, in the study's order.
    [[nodiscard]] const std::vector<StudyMeasure>& measures() const { return measures_; }
    /// By participant, then in the order of the trials; a choice before its confidence.
    [[nodiscard]] const std::vector<PlannedAnswer>& planned() const { return planned_; }

    /// The values of planned(), up to `values.size()`. The first answers are the same however many are asked
    /// for: a smaller study is the beginning of a larger one of the same seed.
    void draw(std::uint64_t seed, std::span<double> values) const;

  private:
    /// What stands behind the answers of one measure.
    struct Model {
        AnswerKind kind = AnswerKind::rating;
        std::vector<double> locations;  ///< by system; of a preference the strengths
        GroupShifts groups{};
        AssumedSpread spread{};
        double noise_sd = 0.0;
        double lapse_rate = 0.0;
        double tie_zone = 0.0, clear_zone = 0.0;
    };
    /// The same answer as in planned_, ready to be drawn.
    struct Draw {
        std::size_t participant, measure, system, other_system, item;
        double shift;
        AnswerCurve curve;
    };

    void addModel(const Study& study, const StudyMeasure& measure, const AssumedEffects& effects);
    [[nodiscard]] double drawOne(const Draw& draw, AssumedParticipant& participant,
                                 const std::vector<double>& items) const;

    std::vector<StudyMeasure> measures_;
    std::vector<Model> models_;
    std::vector<PlannedAnswer> planned_;
    std::vector<Draw> draws_;
    std::size_t systems_ = 0;
    std::size_t items_ = 0;
};

}  // namespace deixis::studies
