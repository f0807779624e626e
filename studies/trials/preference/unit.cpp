// A pair: two avatars side by side, which is better, and where a study asks for it, why.
#include <utility>

#include "compare_page.hpp"
#include "question_form.hpp"

namespace deixis::studies {

namespace {

constexpr int preferences = 5;  ///< clearly left (-2) .. clearly right (2)

class PairwiseTrial : public ComparePage {
  public:
    PairwiseTrial(SessionCore& core, const TimelineItem& item) : ComparePage(core, item) {
        const bool asks = task_.reasons && (core.keyboard || task_.reasons->kind != QuestionKind::text);
        if (asks) reasons_.emplace(core, std::vector<const Question*>{&*task_.reasons}, FormSetting{});
    }

    void enter(const InputFrame& input, bool moved) override {
        core_.standAsPair();
        ComparePage::enter(input, moved);
    }

  private:
    std::optional<int> preference_{};
    std::optional<QuestionForm> reasons_{};
    bool asking_ = false;  ///< for the reasons

    /// The preference was given when the reasons are asked for.
    void forgetAnswer() override {
        if (reasons_) reasons_->forget();
    }

    [[nodiscard]] AvatarPoser& poserOf(std::size_t i) override {
        return i == 0 ? core_.poser : core_.right_poser;
    }
    [[nodiscard]] PresentedState openState() const override { return PresentedState::comparing; }
    [[nodiscard]] bool beyondBoard() const override { return asking_; }
    [[nodiscard]] bool showsPage() const override { return asking_; }

    [[nodiscard]] Panel board() const override {
        PairwiseBoard board;
        board.question = task_.question;
        board.left = viewOf(0);
        board.right = viewOf(1);
        board.can_answer = gate_.isOpen();
        board.preference = preference_;
        if (!allSeen()) board.hint = core_.words()("play_both");
        return pairwisePanel(board, core_.words());
    }

    bool stepBoard(const InputFrame& input, const Aim& met) override {
        const int place = met.button - button_id::first_rating;
        if (input.select && place >= 0 && place < preferences && gate_.admitsSelect(input))
            prefer(input, place, selectTime(input), "ray");
        else if (input.digit && *input.digit >= 1 && *input.digit <= preferences && gate_.admitsKey(input))
            prefer(input, *input.digit - 1, keyTime(input), "key");
        return false;
    }

    void prefer(const InputFrame& input, int place, double at_s, const char* by) {
        preference_ = place - 2;
        give(input, at_s, by);
        draft_.answers.push_back({"preference", -1, static_cast<double>(*preference_), {}});
        if (reasons_ && *preference_ != 0) {
            asking_ = true;
            openReasons(input);
            return;
        }
        showState(PresentedState::rated);
        core_.view.confirmButton(button_id::first_rating + place);
        complete();
    }

    void openReasons(const InputFrame& input) {
        showState(PresentedState::reasons);
        reasons_->open(input);
    }

    void stepBeyond(const InputFrame& input) override {
        if (!reasons_->step(input)) return;
        for (Answer& answer : reasons_->answers()) {
            answer.question = "reasons";
            draft_.answers.push_back(std::move(answer));
        }
        showState(PresentedState::rated);
        core_.view.confirmButton(button_id::go_on);
        complete();
    }

    void resumeBeyond(const InputFrame& input) override { openReasons(input); }
};

/// The movements may have changed sides.
CheckResult comparePreference(const TrialAnswer& first, const TrialAnswer& now, double tolerance) {
    const bool swapped = now.trial.stimuli != first.trial.stimuli;
    const double before = first.value("preference").value_or(0.0);
    return compareNumbers(swapped ? -before : before, now.value("preference").value_or(0.0), tolerance);
}

}  // namespace

extern const UnitDeclaration pairwise_unit{makeUnitOf<PairwiseTrial>, comparePreference};

}  // namespace deixis::studies
