// What the operator's panel shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/operator/operator_words.hpp"
#include "app/session/operator_feed.hpp"

namespace deixis::app {

struct TrackedDevice {
    std::string name;  ///< short: three stand in a line
    bool tracked = false;
};

struct OperatorView {
    OperatorFeed feed{};  ///< what the session tells

    // What is presented.
    studies::SessionStatus status{};
    std::string doing;  ///< stateInWords()
    bool paused = false;

    // The station.
    std::string device_kind;            ///< "Headset", "Display"
    std::string device;                 ///< "Valve Index, SteamVR 2.5"
    DeviceWords device_state{};         ///< whether somebody uses it
    std::vector<std::string> warnings;  ///< one line each, calm and clear: what is wrong and what helps
    double frames_per_s = 0.0;
    int dropped_frames = 0;              ///< in the session so far
    std::string pointer;                 ///< "Ray from the right", "Mouse"
    std::vector<TrackedDevice> tracked;  ///< empty: nothing is tracked here
    bool has_place = false;              ///< the participant may leave the place, and it can be recentred
    std::optional<double> off_place_m;   ///< none: not known
    double place_tolerance_m = 0.30;     ///< from here on the distance is marked
};

}  // namespace deixis::app
