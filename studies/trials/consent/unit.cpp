// The consent: a page that is answered.
#include "minimum_time.hpp"
#include "session_unit.hpp"

namespace deixis::studies {

namespace {

/// Agreeing and declining are both pressed with the ray: no key gives consent by accident. Declining ends the
/// session for good, so that it is asked once more.
class ConsentUnit : public TrialUnit {
  public:
    ConsentUnit(SessionCore& core, const TimelineItem& item)
        : TrialUnit(core, item), minimum_(stage_.minimum_s) {}

    void enter(const InputFrame& input, bool /*moved*/) override {
        core_.standAlone();
        open(input);
    }

    void resume(const InputFrame& input, double away_s) override {
        draft_.paused_s += away_s;
        ++draft_.pauses;
        open(input);
    }

    void step(const InputFrame& input) override {
        const int left = minimum_.left(core_.now.time_s);
        if (left != shown_left_) {
            shown_left_ = left;
            if (!declining_) core_.view.updatePanel(board());
        }
        const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
        if (!core_.settled() || !onset_known_ || !input.select) return;
        if (met.button == button_id::decline || met.button == button_id::back) {
            declining_ = met.button == button_id::decline;
            core_.openPanel(declining_ ? core_.endConfirmation(core_.words()("declined_text")) : board(),
                            input, messagePose);
            return;
        }
        const bool agrees = met.button == button_id::agree && left == 0;
        if (!agrees && met.button != button_id::end_for_good) return;
        give(input, selectTime(input), "ray");
        draft_.answers.push_back({"consent", -1, agrees ? 1.0 : 0.0, {}});
        core_.view.confirmButton(met.button);
        complete();
    }

    void shown(std::uint64_t frame, const Moment& at) override {
        if (onset_known_ || frame < opened_) return;
        draft_.onset = draft_.motion_end = at;
        onset_known_ = true;
    }

    bool skip(const InputFrame& /*input*/, const std::string& /*reason*/) override { return false; }
    [[nodiscard]] bool wantsPointer() const override { return !done_; }

  private:
    MinimumTime minimum_;
    int shown_left_ = 0;
    std::uint64_t opened_ = 0;
    bool declining_ = false;  ///< it is asked once more

    void open(const InputFrame& input) {
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        core_.view.show(PresentedState::consent);
        minimum_.start(core_.now.time_s);
        shown_left_ = minimum_.left(core_.now.time_s);
        opened_ = core_.view.frame.number;
        declining_ = false;
        core_.openPanel(board(), input, messagePose);
    }

    [[nodiscard]] Panel board() const {
        const LanguageTable& words = core_.words();
        const auto [title, body] = titledText(stage_.text, words("consent_title"));
        std::string emphasis = stage_.emphasis;
        if (shown_left_ > 0)
            emphasis +=
                (emphasis.empty() ? "" : "\n") + words.seconds("page_seconds", "page_second", shown_left_);
        return messagePanel(title, body, emphasis,
                            {{words("agree"), button_id::agree, ButtonRole::go_on, shown_left_ == 0},
                             {words("decline"), button_id::decline, ButtonRole::leave}},
                            -1.0, core_.hint);
    }
};

}  // namespace

extern const UnitDeclaration consent_unit{makeUnitOf<ConsentUnit>};

}  // namespace deixis::studies
