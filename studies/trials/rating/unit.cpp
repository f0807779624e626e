// A single movement, rated on a scale.
#include "clip_trial.hpp"
#include "scale_answer.hpp"

namespace deixis::studies {

namespace {

class RatingTrial : public ClipTrial {
  public:
    RatingTrial(SessionCore& core, const TimelineItem& item)
        : ClipTrial(core, item), scale_(core, task_.question, task_.scale) {}

    [[nodiscard]] bool stepDone(const InputFrame& /*input*/, double since_s) override {
        return draft_.status == ResponseStatus::skipped || since_s >= confirm_s;
    }

    void resumeDone(const InputFrame& /*input*/) override { showState(PresentedState::rated); }

  private:
    ScaleAnswer scale_;

    void forgetAnswer() override { scale_.forget(); }

    void openAnswer(const InputFrame& input) override {
        showState(PresentedState::rating);
        scale_.open(input, replayButton(), lecternPose);
        core_.view.aim(input.pointer, input.stage_from_head, false);
    }

    void stepAnswer(const InputFrame& input) override {
        const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
        const bool selected = select(input);
        if (selected && met.button == button_id::replay) {
            replay();
            return;
        }
        const auto given = scale_.step(input, met, gate_, selected);
        if (!given) return;
        give(input, given->at_s, given->by);
        draft_.answers.push_back({"rating", 0, static_cast<double>(given->value), {}});
        showState(PresentedState::rated);
        scale_.confirm(given->value);
        complete();
    }
};

}  // namespace

extern const UnitDeclaration rating_unit{makeUnitOf<RatingTrial>, compareRatings};

}  // namespace deixis::studies
