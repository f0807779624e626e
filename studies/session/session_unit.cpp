#include "session_unit.hpp"

#include <fmt/core.h>

#include <utility>

#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

TrialUnit::TrialUnit(SessionCore& core, const TimelineItem& item)
    : Unit(core), trial_(*item.trial), stage_(*item.stage), task_(taskOf(core.study, *item.stage)) {
    draft_.trial_index = trial_.index;
    draft_.plays.assign(trial_.stimuli.size(), 0);
}

void TrialUnit::showState(PresentedState state) {
    core_.view.show(state, declarationOf(trial_.kind).placed);
}

bool TrialUnit::checked(int i) const {
    return trial_.check && trial_.check->kind == CheckKind::number && trial_.check->stimulus == i;
}

void TrialUnit::showSign(const InputFrame& input, bool on_right) {
    const std::string number = fmt::format("{}", trial_.check->expected);
    core_.view.showSign(core_.words()("attention_number"), number, core_.avatarHead(on_right).position,
                        core_.eyes(input));
}

void TrialUnit::give(const InputFrame& input, double given_s, const char* by) {
    draft_.answered = core_.momentAt(given_s);
    if (!onset_known_) draft_.onset = draft_.motion_end = draft_.answered;
    draft_.response_time_s = given_s - draft_.motion_end.time_s - draft_.paused_s;
    draft_.input = by;
    draft_.stage_from_head = input.stage_from_head;
    draft_.pointer = input.pointer;
}

void TrialUnit::complete() {
    response_ = draft_;
    done_ = true;
}

bool TrialUnit::skip(const InputFrame& input, const std::string& reason) {
    give(input, core_.now.time_s, "");
    draft_.status = ResponseStatus::skipped;
    draft_.reason = reason;
    draft_.answers.clear();
    draft_.values.clear();
    if (draft_.onset.time_s > draft_.motion_end.time_s) draft_.motion_end = draft_.answered;
    draft_.response_time_s = draft_.answered.time_s - draft_.motion_end.time_s - draft_.paused_s;
    core_.view.closePanel();
    core_.view.closeSign();
    core_.view.lookAtBalls(BallLook::waiting);
    complete();
    return true;
}

#define DEIXIS_KIND(name) extern const UnitDeclaration name##_unit;
DEIXIS_STAGE_KINDS(DEIXIS_KIND)
#undef DEIXIS_KIND

const UnitDeclaration& unitOf(StageKind kind) {
#define DEIXIS_KIND(name) &name##_unit,
    constexpr const UnitDeclaration* units[] = {DEIXIS_STAGE_KINDS(DEIXIS_KIND)};
#undef DEIXIS_KIND
    return *units[static_cast<std::size_t>(kind)];
}

std::unique_ptr<Unit> makeUnit(SessionCore& core, const TimelineItem& item) {
    return item.trial == nullptr ? makePage(core, item) : unitOf(item.trial->kind).make(core, item);
}

}  // namespace deixis::studies
