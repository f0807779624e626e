#include "studies/station/presented_state.hpp"

#include <array>
#include <cstddef>

#include "studies/station/station.hpp"

namespace deixis::studies {

namespace {

struct StateTraits {
    PresentedState state;
    std::string_view name;
    bool full_page = false;
};

constexpr std::array<StateTraits, 26> states{{
    {PresentedState::starting, ""},
    {PresentedState::instructions, "instructions", true},
    {PresentedState::consent, "consent", true},
    {PresentedState::questionnaire, "questionnaire", true},
    {PresentedState::rest, "break", true},
    {PresentedState::welcome_back, "welcome-back", true},
    {PresentedState::practice_again, "practice-again", true},
    {PresentedState::attention, "attention", true},
    {PresentedState::closing, "closing", true},
    {PresentedState::paused, "paused", true},
    {PresentedState::waiting, "waiting"},
    {PresentedState::playing, "playing"},
    {PresentedState::pointing, "pointing"},
    {PresentedState::check, "check"},
    {PresentedState::rating, "rating"},
    {PresentedState::rated, "rated"},
    {PresentedState::watching, "watching"},
    {PresentedState::comparing, "comparing"},
    {PresentedState::reasons, "reasons", true},
    {PresentedState::choosing, "choosing"},
    {PresentedState::aiming, "aiming"},
    {PresentedState::chosen, "chosen"},
    {PresentedState::feedback, "feedback"},
    {PresentedState::confidence, "confidence"},
    {PresentedState::authoring, "authoring"},
    {PresentedState::over, "over"},
}};

const StateTraits& traitsOf(PresentedState state) {
    return states.at(static_cast<std::size_t>(state));
}

constexpr bool inOrder() {
    for (std::size_t i = 0; i < states.size(); ++i)
        if (states[i].state != static_cast<PresentedState>(i)) return false;
    return states.back().state == PresentedState::over;
}
static_assert(inOrder(), "every state stands in the table, at its place");

}  // namespace

std::string_view presentedStateName(PresentedState state) {
    return traitsOf(state).name;
}

std::string presentedStateName(const PresentedFrame& frame) {
    std::string name(presentedStateName(frame.state));
    return frame.in_game ? name + "-" + frame.viewer_place : name;
}

bool isFullPage(PresentedState state) {
    return traitsOf(state).full_page;
}

}  // namespace deixis::studies
