// Pages to read: instructions, breaks, what is said on coming back, before further practice and at the end.
#include <fmt/core.h>

#include "minimum_time.hpp"
#include "session_unit.hpp"

namespace deixis::studies {

namespace {

class PageUnit : public Unit {
  public:
    PageUnit(SessionCore& core, const TimelineItem& item)
        : Unit(core), page_(item.page), status_(item.status), minimum_(item.page.minimum_s) {}

    void enter(const InputFrame& input, bool /*moved*/) override {
        core_.standAlone();
        if (page_.kind == PageKind::rest) core_.note(NoteKind::break_start);
        if (page_.kind == PageKind::attention) core_.note(NoteKind::warned);
        resume(input, 0.0);
    }

    void resume(const InputFrame& input, double /*away_s*/) override {
        core_.view.show(pageState(page_.kind));
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        minimum_.start(core_.now.time_s);
        shown_left_ = minimum_.left(core_.now.time_s);
        core_.openPanel(board(), input, messagePose);
        core_.view.admitRestingRay();
        tellLeft();
    }

    void step(const InputFrame& input) override {
        const int left = minimum_.left(core_.now.time_s);
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
            core_.note(NoteKind::break_end);
        else if (page_.kind != PageKind::closing && page_.kind != PageKind::attention)
            core_.note(NoteKind::instructions_read, page_.name);
    }

    [[nodiscard]] bool wantsPointer() const override { return true; }

  private:
    TimelinePage page_;
    SessionStatus status_;
    MinimumTime minimum_;
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
        core_.view.frame.status = status_.with(shown_left_ > 0 ? fmt::format("{} s", shown_left_) : "");
    }
};

}  // namespace

std::unique_ptr<Unit> makePage(SessionCore& core, const TimelineItem& item) {
    return std::make_unique<PageUnit>(core, item);
}

extern const UnitDeclaration instructions_unit{makePage};
extern const UnitDeclaration rest_unit{makePage};

}  // namespace deixis::studies
