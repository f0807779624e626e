// A frame of the game, to draw.
#pragma once

#include "app/window/frame_scene.hpp"
#include "inputs.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::bench {

/// The avatar across from the viewer, three balls, and the ray on one of them.
inline studies::PresentedFrame gameFrame() {
    Participant participant;
    participant.toAnswer();
    while (participant.frame.balls.empty() || participant.frame.viewer_place != "across") {
        participant.answerSomehow(0);
        participant.toAnswer();
    }
    participant.step(participant.pointing(participant.frame.balls.front().centre, false));
    return participant.frame;
}

/// The frame as a standing viewer sees it.
inline renderer::Scene sceneOf(const studies::PresentedFrame& frame) {
    Pose stage_from_eye = frame.stage_from_viewer;
    stage_from_eye.position.y += 1.65;
    return app::sceneFromFrame(frame, stage_from_eye);
}

}  // namespace deixis::bench
