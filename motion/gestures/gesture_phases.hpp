// When within a stretch of a recording a pointing hand sets out, arrives, starts back and is back.
#pragma once

#include <vector>

namespace deixis::motion {

struct GestureFrames {
    int onset = 0;
    int peak = 0;
    int hold = 0;
    int end = 0;
};

/// The phases of a gesture that is out of rest in the frames `leaves` to `comes_back`, by its speed: the hand
/// moves where it is faster than a fifth of its greatest speed on the same way. The slower begin and end of a
/// movement are found from how fast it gets under way, as in a minimum-jerk movement (Flash & Hogan 1985).
/// The hold is the slow stretch about the frame `middle`. Looked for in the frames `from` to `to`; 0 <= from
/// <= leaves <= middle <= comes_back <= to, from < middle < to.
[[nodiscard]] GestureFrames gesturePhases(const std::vector<double>& speed, int from, int leaves, int middle,
                                          int comes_back, int to);

/// The same where the hold, `peak` to `hold`, is known and the hand may not rest before and after it: onset
/// and end are where it last and next all but stops or turns. from < peak <= hold < to.
[[nodiscard]] GestureFrames phasesAroundHold(const std::vector<double>& speed, int from, int peak, int hold,
                                             int to);

}  // namespace deixis::motion
