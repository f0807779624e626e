#include "studies/simulation/observed_gesture.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "simulated_observer.hpp"

namespace deixis::studies {

std::optional<ObservedGesture> observeGesture(const motion::Clip& clip, const Reading& reading) {
    GestureObserver observer(clip.skeleton, reading);
    for (int frame = 0; frame < clip.frameCount(); ++frame)
        observer.see(motion::worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(frame)]),
                     frame * clip.frame_time_s);
    const SeenGesture seen = observer.gesture();
    for (const ArmLines* lines : {&seen.lines, &seen.at_first, &seen.at_last})
        for (const Ray& line : {lines->eye_line, lines->arm_line, lines->line})
            if (!(std::abs(glm::length(line.direction) - 1.0) < 1e-6)) return std::nullopt;
    return ObservedGesture{seen.lines, seen.at_first, seen.at_last};
}

}  // namespace deixis::studies
