#include "app/operator/operator_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/text.hpp"

namespace deixis::app {

namespace {

std::string_view wordsFor(studies::PresentedState state) {
    using State = studies::PresentedState;
    switch (state) {
        case State::starting:
            return "";
        case State::instructions:
            return "Reads the instructions";
        case State::consent:
            return "Is asked for consent";
        case State::questionnaire:
            return "Answers questions";
        case State::rest:
            return "Takes a break";
        case State::welcome_back:
            return "Reads the welcome back";
        case State::practice_again:
            return "Reads that there is more practice";
        case State::attention:
            return "Reads a reminder to pay attention";
        case State::closing:
            return "Reads the closing words";
        case State::paused:
            return "Paused";
        case State::waiting:
            return "Waits for the clip";
        case State::playing:
            return "Watches the clip";
        case State::pointing:
            return "Watches the avatar point";
        case State::check:
            return "Is shown a number to enter";
        case State::rating:
            return "Rates the clip";
        case State::rated:
            return "Has rated the clip";
        case State::watching:
            return "Plays and rates the clips";
        case State::comparing:
            return "Plays and compares the clips";
        case State::reasons:
            return "Gives reasons for the preference";
        case State::choosing:
            return "Chooses a ball";
        case State::aiming:
            return "Aims at a ball";
        case State::chosen:
            return "Has chosen a ball";
        case State::feedback:
            return "Is shown the target";
        case State::confidence:
            return "Says how sure the choice was";
        case State::authoring:
            return "Makes gestures in the studio";
        case State::over:
            return "The session is over";
    }
    throw std::logic_error("a state without a description");
}

struct EventWords {
    studies::NoteKind kind;
    std::string_view words;
    bool with_detail;
};
constexpr std::array<EventWords, 15> event_words{{
    {studies::NoteKind::session_start, "Session begun", true},
    {studies::NoteKind::pause, "Paused", true},
    {studies::NoteKind::resume, "Resumed", false},
    {studies::NoteKind::trial_repeated, "Trial started over", false},
    {studies::NoteKind::check_failed, "Attention check failed", false},
    {studies::NoteKind::warned, "Participant warned", false},
    {studies::NoteKind::practice_met, "Practice passed", false},
    {studies::NoteKind::practice_failed, "Practice failed", false},
    {studies::NoteKind::operator_repeat, "Last trial is repeated", true},
    {studies::NoteKind::operator_skip, "Skipped", true},
    {studies::NoteKind::operator_abort, "Aborted", true},
    {studies::NoteKind::operator_note, "Note", true},
    {studies::NoteKind::operator_saw_trial, "Trial shown to you", false},
    {studies::NoteKind::excluded, "Excluded", true},
    {studies::NoteKind::recording_failed, "Answers can no longer be saved", true},
}};

}  // namespace

std::string stateInWords(const studies::PresentedFrame& frame) {
    const std::string_view words = wordsFor(frame.state);
    return frame.in_game ? fmt::format("{} ({})", words, frame.viewer_place) : std::string(words);
}

std::string distanceInWords(double metres) {
    const double centimetres = std::round(metres * 100.0);
    if (centimetres < 100.0) return fmt::format("{:.0f} cm", centimetres);
    return fmt::format("{:.2f} m", metres);
}

std::string elapsedInWords(double seconds) {
    const auto whole = static_cast<long long>(std::floor(std::max(0.0, seconds)));
    const long long hours = whole / 3600;
    const long long minutes = whole / 60 % 60;
    if (hours > 0) return fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60);
    return fmt::format("{}:{:02}", minutes, whole % 60);
}

std::string timeLeftInWords(std::optional<double> seconds) {
    if (!seconds) return "not known yet";
    if (*seconds < 60.0) return "less than a minute";
    const auto minutes = static_cast<long long>(std::round(*seconds / 60.0));
    if (minutes < 60) return fmt::format("about {} min", minutes);
    return fmt::format("about {} h {:02} min", minutes / 60, minutes % 60);
}

std::string bytesInWords(std::uintmax_t bytes) {
    const double gigabytes = static_cast<double>(bytes) / 1e9;
    if (gigabytes < 1.0) return fmt::format("{} MB", bytes / 1'000'000);
    if (gigabytes < 10.0) return fmt::format("{:.1f} GB", std::floor(10.0 * gigabytes) / 10.0);
    return fmt::format("{:.0f} GB", std::floor(gigabytes));
}

std::string eventInWords(const OperatorEvent& event) {
    if (event.detail.starts_with("nothing to ")) return capitalised(event.detail);
    for (const EventWords& known : event_words) {
        if (event.kind != known.kind) continue;
        if (event.detail.empty() || !known.with_detail) return std::string(known.words);
        return fmt::format("{}: {}", known.words, event.detail);
    }
    const std::string_view name = studies::noteKindName(event.kind);
    return event.detail.empty() ? std::string(name) : fmt::format("{}: {}", name, event.detail);
}

}  // namespace deixis::app
