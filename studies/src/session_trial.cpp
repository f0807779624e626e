#include <fmt/core.h>

#include <stdexcept>
#include <utility>

#include "session_state.hpp"

namespace deixis::studies {

namespace {

constexpr double orient_s = 0.6;    ///< added to the pause before a trial where the participant was moved
constexpr double confirm_s = 0.35;  ///< how long the answer given is shown

/// When an answer was given: keys are read with the frame, a press of select may be known more exactly.
double keyTime(const InputFrame& input) {
    return input.input_time_s.value_or(input.time_s);
}

double selectTime(const InputFrame& input) {
    return input.select_time_s.value_or(keyTime(input));
}

}  // namespace

void SessionRunner::State::enterTrial(bool moved) {
    const motion::Clip& clip = clips.clip(trial());
    if (clip.frames.empty() || clip.frames.front().joints.size() != avatar.joints.size())
        throw std::invalid_argument(
            fmt::format("the clip of system '{}' for target '{}' has not the avatar's joints", trial().system,
                        trial().target_id));
    playback.load(clip);
    view.closePanel();
    for (std::size_t place = 0; game() && place < trial().ball_order.size(); ++place)
        view.frame.balls.push_back(
            {trial().ball(static_cast<int>(place)), study.targets.ball_diameter_m / 2.0});
    pauses = 0;
    replays = 0;
    early_select = false;
    startLeadIn(study.inter_trial_s + (moved ? orient_s : 0.0));
}

void SessionRunner::State::startLeadIn(double length_s) {
    phase = Phase::lead_in;
    playback.start(length_s, now.time_s);
    showState("waiting");
    answer_open = false;
    answer_shown = false;
    paused_s = 0.0;
    view.closePanel();
    view.lookAtBalls(BallLook::waiting);
}

void SessionRunner::State::stepLeadIn() {
    if (!playback.leadIn(now.time_s)) return;
    phase = Phase::playing;
    showState("playing");
    stepPlaying();
}

void SessionRunner::State::stepPlaying() {
    const bool was_halfway = playback.halfway();
    if (playback.play(now.time_s, view.frame.number)) view.frame.key_moment = true;
    if (playback.halfway() && !was_halfway) showState("pointing");
}

void SessionRunner::State::openAnswer(const InputFrame& input) {
    answer_open = true;
    answer_shown = false;
    aiming = false;
    answer_frame = view.frame.number;
    showState(game() ? "choosing" : "rating");
    std::optional<ButtonSpec> replay;
    if (replays < (game() ? study.game.max_replays : study.rating.max_replays))
        replay = ButtonSpec{"Show again", button_id::replay};
    if (!game())
        openPanel(ratingPanel(study.rating.question, study.rating.labels, button_id::first_rating, replay),
                  input, lecternPose);
    else if (replay)
        openPanel(questionPanel(study.game.question, *replay), input, deskPose);
    else
        view.closePanel();
    view.aim(input.pointer, input.stage_from_head, game());
}

void SessionRunner::State::stepAnswering(const InputFrame& input) {
    if (!answer_open) {
        openAnswer(input);
        return;
    }
    const Aim met = view.aim(input.pointer, input.stage_from_head, game());
    if (game() && (met.ball >= 0) != aiming) {
        aiming = met.ball >= 0;
        showState(aiming ? "aiming" : "choosing");
    }
    if (!answer_shown) return;
    // What was pressed before the open answer could be seen is no answer to it.
    const double select_s = selectTime(input);
    const bool select = input.select && select_s >= answer_shown_s;
    if (input.select && !select)
        noteAt(momentAt(select_s), "early_select",
               fmt::format("{:.3f} s before the answer was open", answer_shown_s - select_s));
    const int steps = static_cast<int>(study.rating.labels.size());
    if (select && met.button == button_id::replay) {
        ++replays;
        note("replay");
        startLeadIn(study.inter_trial_s);
    } else if (select && met.button >= button_id::first_rating) {
        answer(input, select_s, "ray", met.button - button_id::first_rating + 1, -1);
    } else if (select && met.ball >= 0) {
        answer(input, select_s, "ray", 0, met.ball);
    } else if (!game() && input.digit && *input.digit >= 1 && *input.digit <= steps &&
               keyTime(input) >= answer_shown_s) {
        answer(input, keyTime(input), "key", *input.digit, -1);
    }
}

void SessionRunner::State::noteEarlySelect(const InputFrame& input) {
    const bool before_answer =
        phase == Phase::lead_in || phase == Phase::playing || (phase == Phase::answering && !answer_shown);
    if (!input.select || !before_answer || early_select) return;
    early_select = true;
    noteAt(momentAt(selectTime(input)), "early_select", view.frame.state);
}

void SessionRunner::State::answer(const InputFrame& input, double given_s, const char* by, int rating,
                                  int place) {
    const bool correct = place >= 0 && place == trial().targetPlace();
    if (trial().practice) {
        note("practice_answer", rating > 0
                                    ? fmt::format("rating {}", rating)
                                    : fmt::format("place {}, {}", place, correct ? "correct" : "wrong"));
    } else {
        Response response;
        response.trial_index = trial().index;
        response.rating = rating;
        response.chosen_place = place;
        response.correct = correct;
        response.onset = playback.onset();
        response.motion_end = playback.motionEnd();
        response.answered = momentAt(given_s);
        response.response_time_s = given_s - playback.motionEnd().time_s - paused_s;
        response.paused_s = paused_s;
        response.replays = replays;
        response.pauses = pauses;
        response.input = by;
        response.stage_from_head = input.stage_from_head;
        response.pointer = input.pointer;
        events.push_back(std::move(response));
        ++done;
    }
    phase = Phase::confirmed;
    showState(game() ? "chosen" : "rated");
    confirmed_since_s = now.time_s;
    view.frame.key_moment = true;
    view.frame.ray.reset();
    view.lookAtBalls(BallLook::selectable, place, BallLook::chosen);
    view.confirmButton(rating > 0 ? button_id::first_rating + rating - 1 : 0);
}

void SessionRunner::State::stepConfirmed(const InputFrame& input) {
    if (now.time_s - confirmed_since_s >= confirm_s && input.answers_kept) leave(input);
}

}  // namespace deixis::studies
