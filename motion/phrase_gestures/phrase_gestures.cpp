#include "motion/phrase_gestures/phrase_gestures.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>

#include "phrase_plan.hpp"

namespace deixis::motion {

namespace {

std::optional<int> accentDuring(const Utterance& utterance, double begin_s, double end_s) {
    for (std::size_t a = 0; a < utterance.accents.size(); ++a)
        if (utterance.accents[a].start_s < end_s && utterance.accents[a].end_s > begin_s)
            return static_cast<int>(a);
    return {};
}

/// The strokes of a gesture that was made: the first is on its anchor, others are where they fall.
void listStrokes(const Utterance& utterance, const PhraseGesture& planned, const MadeGesture& made,
                 std::vector<SpeechStroke>& out) {
    const auto& [gesture, apex_s, speed, hold_s] = planned.placed;
    const double own_apex_s = gesture.apex_s();
    SpeechStroke stroke;
    stroke.gesture = gesture.id;
    stroke.gesture_class = planned.gesture_class;
    stroke.hands = handsOf(gesture);
    stroke.begin_s = made.begin_s;
    stroke.stroke_s = made.stroke_s;
    stroke.apex_s = apex_s;
    stroke.word = planned.anchor.word;
    if (planned.anchor.accent >= 0) stroke.accent = planned.anchor.accent;
    if (!stroke.accent) stroke.accent = accentDuring(utterance, stroke.stroke_s, stroke.apex_s);
    stroke.by_word_rule = planned.by_word;
    out.push_back(stroke);
    for (const UnitKey& key : gesture.keys) {
        if (key.phase != GesturePhase::stroke || key.through || key.time_s <= own_apex_s) continue;
        stroke.begin_s = stroke.stroke_s = stroke.apex_s;
        stroke.apex_s = apex_s + (key.time_s - own_apex_s) / speed;
        stroke.accent = accentDuring(utterance, stroke.stroke_s, stroke.apex_s);
        out.push_back(stroke);
    }
}

/// When the wrists are faster than that for the first time.
std::optional<double> tooFastAt(const UpperBodyMotion& motion, double most_m_s) {
    constexpr std::array wrists{UpperJoint::right_wrist, UpperJoint::left_wrist};
    for (std::size_t f = 1; f < motion.frames.size(); ++f) {
        const UpperBodyJoints before = jointsOf(motion.frames[f - 1]), now = jointsOf(motion.frames[f]);
        for (const UpperJoint wrist : wrists) {
            const auto place = static_cast<std::size_t>(wrist);
            if (glm::length(now[place] - before[place]) * upper_body_fps > most_m_s)
                return static_cast<double>(f) * upper_body_frame_time_s;
        }
    }
    return {};
}

}  // namespace

GesturedSpeech gestureByPhrases(const Utterance& utterance, const GestureLibrary& library, std::uint64_t seed,
                                const PhraseSpeaker& speaker) {
    Random random(seed, "phrases");
    const auto phrases = plannedPhrases(utterance, speaker, random);
    auto planned = PhrasePlanner(utterance, library, speaker, Random(seed, "phrase gestures")).plan(phrases);
    TimelineOptions options;
    options.max_hand_speed_m_s = speaker.max_hand_speed_m_s;
    options.min_preparation_s = 0.15;
    options.retraction_s = 0.8;  // this speaker is in no hurry to rest: both are choices
    options.min_rest_s = 0.9;
    IdleOptions idle;
    idle.trunk_deg = 1.1;  // and sways more: a choice
    GesturedSpeech out;
    for (;;) {
        std::vector<PlacedGesture> placed;
        for (const PhraseGesture& one : planned) placed.push_back(one.placed);
        const GestureTimeline timeline = timelineOf(placed, utterance.duration_s, options);
        out.motion = motionOf(timeline.track, utterance.duration_s, deriveSeed(seed, "phrase idle"), idle);
        const auto too_fast_s = tooFastAt(out.motion, speaker.most_wrist_speed_m_s);
        const auto culprit =
            std::find_if(timeline.made.rbegin(), timeline.made.rend(),
                         [&](const auto& made) { return too_fast_s && made.begin_s < *too_fast_s; });
        if (culprit != timeline.made.rend()) {
            planned.erase(planned.begin() + static_cast<std::ptrdiff_t>(culprit->index));
            continue;
        }
        for (const MadeGesture& made : timeline.made)
            listStrokes(utterance, planned[made.index], made, out.strokes);
        break;
    }
    std::ranges::stable_sort(out.strokes, {}, &SpeechStroke::apex_s);
    return out;
}

}  // namespace deixis::motion
