#include "app/session/session_loop.hpp"

namespace deixis::app {

studies::Moment runSession(studies::SessionRunner& session, studies::Station& station, Recorder& recorder) {
    studies::Moment last{};
    while (session.outcome() == studies::SessionOutcome::running) {
        studies::InputFrame input = station.beginFrame();
        input.answers_kept = recorder.answersKept();
        input.recording_failed = !recorder.failure().empty();
        last = {input.time_s, input.utc_s};
        const studies::SessionStep step = session.step(input);
        for (const auto& event : step.events) recorder.record(event);
        const studies::FrameReport report = station.present(step.frame);
        recorder.presented(input, step.frame);
        if (report.tracking) recorder.sample(*report.tracking, session.trialUnderWay());
        for (const auto& event : session.shown(report)) recorder.record(event);
    }
    for (const auto& note : station.close())
        recorder.record(
            studies::Note{note.kind, -1, {note.time_s, last.utc_s + note.time_s - last.time_s}, note.detail});
    return last;
}

}  // namespace deixis::app
