#include "studies/station/note_kind.hpp"

#include <array>
#include <cstddef>

namespace deixis::studies {

namespace {

struct NamedKind {
    NoteKind kind;
    std::string_view name;
};

constexpr std::array kinds{
    NamedKind{NoteKind::session_start, "session_start"},
    NamedKind{NoteKind::stage_start, "stage_start"},
    NamedKind{NoteKind::instructions_read, "instructions_read"},
    NamedKind{NoteKind::break_start, "break_start"},
    NamedKind{NoteKind::break_end, "break_end"},
    NamedKind{NoteKind::finished, "finished"},
    NamedKind{NoteKind::quit, "quit"},
    NamedKind{NoteKind::stimulus_onset, "stimulus_onset"},
    NamedKind{NoteKind::motion_end, "motion_end"},
    NamedKind{NoteKind::replay, "replay"},
    NamedKind{NoteKind::check_failed, "check_failed"},
    NamedKind{NoteKind::warned, "warned"},
    NamedKind{NoteKind::feedback, "feedback"},
    NamedKind{NoteKind::early_select, "early_select"},
    NamedKind{NoteKind::edit, "edit"},
    NamedKind{NoteKind::practice_met, "practice_met"},
    NamedKind{NoteKind::practice_failed, "practice_failed"},
    NamedKind{NoteKind::pause, "pause"},
    NamedKind{NoteKind::resume, "resume"},
    NamedKind{NoteKind::trial_repeated, "trial_repeated"},
    NamedKind{NoteKind::off_place, "off_place"},
    NamedKind{NoteKind::back_on_place, "back_on_place"},
    NamedKind{NoteKind::pointer_lost, "pointer_lost"},
    NamedKind{NoteKind::pointer_found, "pointer_found"},
    NamedKind{NoteKind::recording_failed, "recording_failed"},
    NamedKind{NoteKind::operator_repeat, "operator_repeat"},
    NamedKind{NoteKind::operator_skip, "operator_skip"},
    NamedKind{NoteKind::operator_abort, "operator_abort"},
    NamedKind{NoteKind::operator_note, "operator_note"},
    NamedKind{NoteKind::operator_saw_trial, "operator_saw_trial"},
    NamedKind{NoteKind::excluded, "excluded"},
    NamedKind{NoteKind::xr_state, "xr_state"},
    NamedKind{NoteKind::recentre, "recentre"},
    NamedKind{NoteKind::placement, "placement"},
    NamedKind{NoteKind::input_profile, "input_profile"},
    NamedKind{NoteKind::pointing_hand, "pointing_hand"},
    NamedKind{NoteKind::ipd, "ipd"},
    NamedKind{NoteKind::refresh_rate, "refresh_rate"},
    NamedKind{NoteKind::missing_characters, "missing_characters"},
    NamedKind{NoteKind::sound, "sound"},
};

constexpr bool everyKindInOrder() {
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i].kind != static_cast<NoteKind>(i)) return false;
    return kinds.back().kind == NoteKind::sound;
}
static_assert(everyKindInOrder(), "every kind stands in the table, at its place");

}  // namespace

std::string_view noteKindName(NoteKind kind) {
    return kinds.at(static_cast<std::size_t>(kind)).name;
}

}  // namespace deixis::studies
