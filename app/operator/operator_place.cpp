#include "operator_place.hpp"

#include <algorithm>
#include <utility>

namespace deixis::app {

namespace {

long long overlap(const ScreenRect& a, const ScreenRect& b) {
    const int across = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    const int down = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    return across > 0 && down > 0 ? static_cast<long long>(across) * down : 0;
}

long long area(const ScreenRect& rect) {
    return static_cast<long long>(rect.width) * rect.height;
}

bool holds(const ScreenRect& room, WindowSize min) {
    return room.width >= min.width && room.height >= min.height;
}

// In the middle of the room.
ScreenRect within(const ScreenRect& room, WindowSize wanted) {
    const int width = std::min(wanted.width, room.width);
    const int height = std::min(wanted.height, room.height);
    return {room.x + (room.width - width) / 2, room.y + (room.height - height) / 2, width, height};
}

// The wider of the strips at the window's sides, as far as they lie on the monitor.
ScreenRect beside(const ScreenRect& window, const ScreenRect& monitor) {
    const int right = std::max(window.x + window.width, monitor.x);
    const int left = std::min(window.x, monitor.x + monitor.width);
    const ScreenRect after{right, monitor.y, monitor.x + monitor.width - right, monitor.height};
    const ScreenRect before{monitor.x, monitor.y, left - monitor.x, monitor.height};
    return after.width >= before.width ? after : before;
}

// Against the window, level with its head.
ScreenRect against(const ScreenRect& window, const ScreenRect& room, WindowSize wanted) {
    const int width = std::min(wanted.width, room.width);
    const int height = std::min(wanted.height, room.height);
    const int x = room.x >= window.x + window.width ? room.x : room.x + room.width - width;
    return {x, std::clamp(window.y, room.y, room.y + room.height - height), width, height};
}

}  // namespace

std::optional<PlacesOfWindows> placesOfWindows(const ScreenRect& participant,
                                               const std::vector<ScreenRect>& monitors, WindowSize wanted,
                                               WindowSize min, bool may_move) {
    if (monitors.empty()) return std::nullopt;
    const ScreenRect own =
        *std::max_element(monitors.begin(), monitors.end(), [&](const ScreenRect& a, const ScreenRect& b) {
            return overlap(a, participant) < overlap(b, participant);
        });
    std::optional<ScreenRect> other;
    for (const ScreenRect& monitor : monitors) {
        if (overlap(monitor, own) > 0 || overlap(monitor, participant) > 0 || !holds(monitor, min)) continue;
        if (!other || area(monitor) > area(*other)) other = monitor;
    }
    if (other) return PlacesOfWindows{participant, within(*other, wanted)};
    const auto besideOf = [&](const ScreenRect& window) -> std::optional<PlacesOfWindows> {
        const ScreenRect room = beside(window, own);
        if (!holds(room, min)) return std::nullopt;
        return PlacesOfWindows{window, against(window, room, wanted)};
    };
    ScreenRect aside = participant;
    aside.x = own.x;
    const auto as_it_stands = besideOf(participant);
    if (!may_move) return as_it_stands;
    const auto moved = besideOf(aside);
    if (!moved) return as_it_stands;
    return as_it_stands && as_it_stands->operators.width >= wanted.width ? as_it_stands : moved;
}

}  // namespace deixis::app
