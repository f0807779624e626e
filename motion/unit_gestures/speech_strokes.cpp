#include "motion/unit_gestures/speech_strokes.hpp"

#include <cmath>

namespace deixis::motion {

namespace {

double shareOf(double part, double whole) {
    return whole > 0.0 ? part / whole : 0.0;
}

}  // namespace

Hands handsOf(const UnitGesture& gesture) {
    const bool right = gesture.uses(Channel::right_hand), left = gesture.uses(Channel::left_hand);
    if (right && left) return Hands::both;
    if (right) return Hands::right;
    return left ? Hands::left : Hands::none;
}

StrokeStatistics strokeStatistics(std::span<const Utterance> utterances,
                                  std::span<const std::vector<SpeechStroke>> strokes) {
    StrokeStatistics out;
    double minutes = 0.0, accented = 0.0, beats = 0.0, on_syllable = 0.0, right = 0.0, left = 0.0;
    double sum_s = 0.0, squares = 0.0;
    for (std::size_t u = 0; u < utterances.size(); ++u) {
        minutes += utterances[u].duration_s / 60.0;
        for (const SpeechStroke& stroke : strokes[u]) {
            if (stroke.hands == Hands::none) continue;
            ++out.strokes;
            out.classes[static_cast<std::size_t>(stroke.gesture_class)] += 1.0;
            right += stroke.hands == Hands::right;
            left += stroke.hands == Hands::left;
            if (!stroke.accent) continue;
            const Accent& accent = utterances[u].accents[static_cast<std::size_t>(*stroke.accent)];
            const double after_s = stroke.apex_s - 0.5 * (accent.start_s + accent.end_s);
            accented += 1.0;
            sum_s += after_s;
            squares += after_s * after_s;
            if (stroke.gesture_class != GestureClass::beat) continue;
            beats += 1.0;
            on_syllable += stroke.apex_s >= accent.start_s && stroke.apex_s <= accent.end_s;
        }
    }
    const double count = out.strokes;
    out.strokes_per_minute = shareOf(count, minutes);
    out.with_accent = shareOf(accented, count);
    out.beats_on_syllable = shareOf(on_syllable, beats);
    out.apex_mean_s = shareOf(sum_s, accented);
    out.apex_sd_s = std::sqrt(std::max(0.0, shareOf(squares, accented) - out.apex_mean_s * out.apex_mean_s));
    out.right_hand = shareOf(right, right + left);
    for (double& share : out.classes) share = shareOf(share, count);
    return out;
}

}  // namespace deixis::motion
