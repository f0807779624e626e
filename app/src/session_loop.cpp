#include "session_loop.hpp"

namespace deixis::app {

studies::Moment runSession(studies::SessionRunner& session, studies::Station& station,
                           const Recorder& record) {
    studies::Moment last{};
    while (!session.finished() && !session.quit()) {
        const studies::InputFrame input = station.beginFrame();
        last = {input.time_s, input.utc_s};
        const studies::SessionStep step = session.step(input);
        for (const auto& event : step.events) record(event);
        const studies::FrameReport report = station.present(step.frame);
        for (const auto& event : session.shown(report)) record(event);
    }
    return last;
}

}  // namespace deixis::app
