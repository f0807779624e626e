// Pages to read: instructions, breaks, what is said on coming back, before further practice and at the end;
// and the consent, which is a page that is answered.
#include <fmt/core.h>

#include <cmath>

#include "session_unit.hpp"

namespace deixis::studies {

namespace {

/// How long a page must be looked at before it can be left.
class LeastTime {
  public:
    explicit LeastTime(double minimum_s) : minimum_s_(minimum_s) {}
    void start(double now_s) {
        if (!since_s_) since_s_ = now_s;
    }
    /// Whole seconds left, rounded up; 0: the page can be left.
    [[nodiscard]] int left(double now_s) const {
        return std::max(0, static_cast<int>(std::ceil(minimum_s_ - (now_s - *since_s_) - 1e-9)));
    }

  private:
    double minimum_s_;
    std::optional<double> since_s_{};
};

class PageUnit : public Unit {
  public:
    PageUnit(SessionCore& core, const CourseItem& item)
        : Unit(core), page_(item.page), status_(item.status), least_(item.page.minimum_s) {}

    void enter(const InputFrame& input, bool /*moved*/) override {
        core_.standAlone();
        if (page_.kind == PageKind::rest) core_.note("break_start");
        if (page_.kind == PageKind::attention) core_.note("warned");
        resume(input, 0.0);
    }

    void resume(const InputFrame& input, double /*away_s*/) override {
        core_.view.show(pageState(page_.kind));
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        least_.start(core_.now.time_s);
        shown_left_ = least_.left(core_.now.time_s);
        core_.openPanel(board(), input, messagePose);
        core_.view.admitRestingRay();
        tellLeft();
    }

    void step(const InputFrame& input) override {
        const int left = least_.left(core_.now.time_s);
        if (left != shown_left_) {
            shown_left_ = left;
            core_.view.updatePanel(board());
            tellLeft();
        }
        const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
        if (!core_.settled() || left > 0) return;
        if (!input.confirm && !(input.select && met.button == button_id::go_on)) return;
        done_ = true;
        if (page_.kind == PageKind::rest)
            core_.note("break_end");
        else if (page_.kind != PageKind::closing && page_.kind != PageKind::attention)
            core_.note("instructions_read", page_.name);
    }

    [[nodiscard]] bool wantsPointer() const override { return true; }

  private:
    CoursePage page_;
    std::string status_;
    LeastTime least_;
    int shown_left_ = 0;

    [[nodiscard]] Panel board() const {
        std::string emphasis = page_.emphasis;
        if (shown_left_ > 0) {
            const bool rest = page_.kind == PageKind::rest;
            emphasis += (emphasis.empty() ? "" : "\n") +
                        core_.words().seconds(rest ? "break_seconds" : "page_seconds",
                                              rest ? "break_second" : "page_second", shown_left_);
        }
        return messagePanel(page_.title, page_.body, emphasis,
                            {{page_.button, button_id::go_on, ButtonRole::go_on, shown_left_ == 0}},
                            core_.share_done, tellsHow() ? core_.hint : "");
    }

    /// Where somebody begins or comes back.
    [[nodiscard]] bool tellsHow() const {
        return page_.kind == PageKind::instructions || page_.kind == PageKind::welcome_back;
    }

    void tellLeft() {
        core_.view.frame.status = status_ + (shown_left_ > 0 ? fmt::format(", {} s", shown_left_) : "");
    }
};

/// Agreeing and declining are both pressed with the ray: no key gives consent by accident. Declining ends the
/// session for good, so that it is asked once more.
class ConsentUnit : public TrialUnit {
  public:
    ConsentUnit(SessionCore& core, const CourseItem& item)
        : TrialUnit(core, item), least_(stage_.minimum_s) {}

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
        const int left = least_.left(core_.now.time_s);
        if (left != shown_left_) {
            shown_left_ = left;
            if (!declining_) core_.view.updatePanel(board());
        }
        const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
        if (!core_.settled() || !onset_known_ || !input.select) return;
        if (met.button == button_id::decline || met.button == button_id::back) {
            declining_ = met.button == button_id::decline;
            core_.openPanel(declining_ ? core_.endQuestion(core_.words()("declined_text")) : board(), input,
                            messagePose);
            return;
        }
        const bool agrees = met.button == button_id::agree && left == 0;
        if (!agrees && met.button != button_id::end_for_good) return;
        give(input, selectTime(input), "ray");
        draft_.answers.push_back({"consent", -1, agrees ? 1.0 : 0.0, {}});
        draft_.correct = false;
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
    LeastTime least_;
    int shown_left_ = 0;
    std::uint64_t opened_ = 0;
    bool declining_ = false;  ///< it is asked once more

    void open(const InputFrame& input) {
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        core_.view.show(PresentedState::consent);
        least_.start(core_.now.time_s);
        shown_left_ = least_.left(core_.now.time_s);
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

std::unique_ptr<Unit> makePage(SessionCore& core, const CourseItem& item) {
    return std::make_unique<PageUnit>(core, item);
}

std::unique_ptr<Unit> makeConsent(SessionCore& core, const CourseItem& item) {
    return std::make_unique<ConsentUnit>(core, item);
}

}  // namespace deixis::studies
