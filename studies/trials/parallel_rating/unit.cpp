// Parallel rating: several movements of one item on one page, each rated beside its play button.
#include <utility>

#include "compare_page.hpp"

namespace deixis::studies {

namespace {

class ParallelTrial : public ComparePage {
  public:
    ParallelTrial(SessionCore& core, const TimelineItem& item)
        : ComparePage(core, item), values_(trial_.stimuli.size()) {}

    void enter(const InputFrame& input, bool moved) override {
        core_.standAlone();
        ComparePage::enter(input, moved);
    }

  private:
    std::vector<std::optional<int>> values_;

    void forgetAnswer() override { values_.assign(values_.size(), std::nullopt); }

    [[nodiscard]] AvatarPoser& poserOf(std::size_t /*i*/) override { return core_.poser; }
    [[nodiscard]] PresentedState openState() const override { return PresentedState::watching; }

    [[nodiscard]] bool complete_enough() const override {
        for (const auto& value : values_)
            if (!value) return false;
        return true;
    }

    [[nodiscard]] Panel board() const override {
        ParallelBoard board;
        board.question = task_.question;
        board.scale = task_.scale;
        for (std::size_t i = 0; i < count(); ++i) {
            board.stimuli.push_back(viewOf(i));
            board.stimuli.back().value = values_[i];
        }
        board.can_confirm = gate_.isOpen();
        if (!gate_.isOpen()) board.hint = core_.words()(allSeen() ? "rate_all" : "play_all");
        return parallelPanel(board, core_.words());
    }

    bool stepBoard(const InputFrame& input, const Aim& met) override {
        bool changed = false;
        if (const auto set = core_.view.drag(input, met, input.select))
            changed = rate(set->id - button_id::first_slider, set->value);
        if (input.select && met.button >= button_id::first_option) {
            const int option = met.button - button_id::first_option;
            changed = rate(option / 100, task_.scale.low + option % 100) || changed;
        }
        const bool pressed = input.select && met.button == button_id::go_on;
        if (pressed && gate_.admitsSelect(input))
            answer(input, selectTime(input), "ray");
        else if (input.confirm && gate_.admitsKey(input))
            answer(input, keyTime(input), "key");
        return changed;
    }

    bool rate(int stimulus, int value) {
        const auto i = static_cast<std::size_t>(stimulus);
        if (stimulus < 0 || i >= count() || !seen(i)) return false;
        const bool changed = values_[i] != value;
        values_[i] = value;
        return changed;
    }

    void answer(const InputFrame& input, double at_s, const char* by) {
        give(input, at_s, by);
        for (std::size_t i = 0; i < count(); ++i)
            draft_.answers.push_back({"rating", static_cast<int>(i), static_cast<double>(*values_[i]), {}});
        showState(PresentedState::rated);
        core_.view.confirmButton(button_id::go_on);
        complete();
    }
};

}  // namespace

extern const UnitDeclaration parallel_rating_unit{makeUnitOf<ParallelTrial>, compareRatings};

}  // namespace deixis::studies
