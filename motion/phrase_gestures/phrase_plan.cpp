#include "phrase_plan.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "motion/unit_gestures/gesture_variation.hpp"
#include "phrase_words.hpp"

namespace deixis::motion {

namespace {

constexpr std::array<Channel, 2> hands{Channel::right_hand, Channel::left_hand};

Side other(Side side) {
    return side == Side::right ? Side::left : Side::right;
}

double exponential(Random& random, double mean) {
    return -mean * std::log(1.0 - random.uniform());
}

/// Arm lengths; the timeline asks for places within the arm's reach.
void keepWithinReach(ChannelValues& hand) {
    constexpr double farthest = 0.97;
    const double reach = std::hypot(hand[0], hand[1], hand[2]);
    if (reach > farthest)
        for (std::size_t v = 0; v < 3; ++v) hand[v] *= farthest / reach;
}

}  // namespace

PhraseHabits habitsOf(const PhraseSpeaker& speaker, Random& random) {
    PhraseHabits habits;
    habits.own_hand = random.uniform() < speaker.right_handed ? Side::right : Side::left;
    habits.size = std::clamp(random.normal(speaker.size, speaker.size_sd), 0.6, 1.1);
    constexpr double place_sd = 0.025;
    for (int i = 0; i < 3; ++i) habits.place[i] = random.normal(0.0, place_sd);
    return habits;
}

std::vector<PhraseGesture> PhrasePlanner::plan(const std::vector<SpokenPhrase>& phrases) {
    for (const SpokenPhrase& phrase : phrases)
        if (!phrase.anchors.empty()) addPhrase(phrase);
    return std::move(gestures_);
}

void PhrasePlanner::addPhrase(const SpokenPhrase& phrase) {
    const Choice choice = choose(phrase);
    posture_ = {};
    for (std::size_t h = 0; h < hands.size(); ++h)
        for (const UnitKey& key : choice.gesture.keys)
            if (key.phase != GesturePhase::retraction && key.channels[indexOf(hands[h])])
                posture_[h] = key.channels[indexOf(hands[h])];
    // A head that shakes leaves the hands free.
    constexpr ChannelValues open_hand{0.08, -0.5, 0.52, 10.0};
    if (!posture_[0] && !posture_[1]) posture_[habits_.own_hand == Side::right ? 0 : 1] = open_hand;
    for (std::size_t a = 0; a < phrase.anchors.size(); ++a)
        if (a == choice.anchor)
            place(choice, phrase);
        else
            placeBeat(phrase.anchors[a], phrase);
}

PhrasePlanner::Choice PhrasePlanner::choose(const SpokenPhrase& phrase) {
    Choice choice;
    // The strongest word first: a phrase has one gesture.
    std::vector<std::size_t> order(phrase.anchors.size());
    for (std::size_t a = 0; a < order.size(); ++a) order[a] = a;
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return phrase.anchors[a].strength > phrase.anchors[b].strength;
    });
    for (const std::size_t a : order) {
        Side hand = phraseHand();
        if (const UnitGesture* gesture = ofWord(phrase, a, hand)) return {made(*gesture, hand), a, true};
    }
    const bool idea = random_.uniform() < speaker_.metaphoric;
    const bool both = random_.uniform() < speaker_.both_hands;
    const UnitGesture* gesture = idea && both ? drawn({"present", "present", "together", "embrace"})
                                 : idea       ? drawn({"offer", "offer", "offer", "continue"})
                                 : both       ? drawn({"beat_both"})
                                        : drawn({"beat_soft", "beat_outward", "beat_precision", "beat_chop"});
    const Side hand = phraseHand();
    choice.anchor = idea ? order.front() : 0;
    if (gesture) choice.gesture = made(*gesture, hand);
    return choice;
}

/// A gesture for the anchor's word or a neighbour of it that no other anchor has; null for none.
const UnitGesture* PhrasePlanner::ofWord(const SpokenPhrase& phrase, std::size_t anchor, Side& hand) {
    const auto word = static_cast<std::size_t>(phrase.anchors[anchor].word);
    for (const std::size_t w : {word, word + 1, word - 1}) {
        if (w < phrase.first_word || w >= phrase.end_word) continue;
        const WordGestures* found = gesturesOf(lowerCase(utterance_.words[w].text));
        if (!found || random_.uniform() >= found->chance * speaker_.heeds_words) continue;
        double share = random_.uniform();
        std::string_view id = found->gestures.back().gesture;
        for (const auto& [gesture, its_share] : found->gestures) {
            if (share < its_share) {
                id = gesture;
                break;
            }
            share -= its_share;
        }
        if (id == to_left || id == to_right) {
            hand = pointingHand();
            const bool own_side = (id == to_left) == (hand == Side::left);
            return findGesture(library_, own_side ? "point_right" : "point_left");
        }
        const UnitGesture* gesture = findGesture(library_, id);
        if (gesture && gesture->gesture_class == GestureClass::deictic) hand = pointingHand();
        return gesture;
    }
    return nullptr;
}

const UnitGesture* PhrasePlanner::drawn(std::initializer_list<std::string_view> ids) {
    return findGesture(library_, ids.begin()[random_.below(ids.size())]);
}

Side PhrasePlanner::phraseHand() {
    return random_.uniform() < speaker_.phrases_by_own_hand ? habits_.own_hand : other(habits_.own_hand);
}
Side PhrasePlanner::pointingHand() {
    return random_.uniform() < speaker_.pointing_by_own_hand ? habits_.own_hand : other(habits_.own_hand);
}

/// Of the library's gesture this speaker's own: by its hand, in its size and place.
UnitGesture PhrasePlanner::made(const UnitGesture& gesture, Side hand) {
    constexpr double place_sd = 0.02;
    double size = habits_.size;
    Vec3 move = habits_.place;
    for (int i = 0; i < 3; ++i) move[i] += random_.normal(0.0, place_sd);
    if (gesture.gesture_class == GestureClass::metaphoric) move.y -= speaker_.metaphoric_lower;
    if (gesture.gesture_class == GestureClass::deictic) size *= speaker_.deictic_wider;
    const UnitGesture own = varied(gesture, size, move);
    return hand == Side::right ? own : mirrored(own);
}

double PhrasePlanner::beatApex(const Anchor& anchor) {
    if (random_.uniform() < speaker_.beat_on_syllable)
        return anchor.start_s + random_.uniform(0.1, 0.9) * (anchor.end_s - anchor.start_s);
    return anchor.end_s + exponential(random_, speaker_.beat_delay_s);
}

double PhrasePlanner::apexOf(GestureClass gesture_class, const Anchor& anchor, bool ends_phrase) {
    if (gesture_class == GestureClass::beat) return beatApex(anchor);
    if (gesture_class == GestureClass::deictic)
        return random_.normal(ends_phrase ? anchor.middle_s() : anchor.end_s, speaker_.pointing_offset_sd_s);
    const double offset_s = random_.normal(speaker_.apex_offset_s, speaker_.apex_offset_sd_s);
    return anchor.middle_s() +
           std::clamp(offset_s, -speaker_.most_apex_offset_s, speaker_.most_apex_offset_s);
}

void PhrasePlanner::place(const Choice& choice, const SpokenPhrase& phrase) {
    if (choice.gesture.keys.empty()) return placeBeat(phrase.anchors[choice.anchor], phrase);
    const Anchor& anchor = phrase.anchors[choice.anchor];
    const GestureClass gesture_class = choice.gesture.gesture_class;
    const bool ends_phrase = static_cast<std::size_t>(anchor.word) + 1 == phrase.end_word;
    // Quicker where there is little time since the last stroke; later where there is none.
    constexpr double rise_s = 0.22, quickest = 2.2;
    const double stroke_s = choice.gesture.apex_s() - choice.gesture.strokeBegin_s();
    double apex_s = apexOf(gesture_class, anchor, ends_phrase);
    apex_s = std::max(apex_s, free_from_s_ + rise_s + stroke_s / quickest);
    const double speed =
        std::clamp(stroke_s / (apex_s - free_from_s_ - rise_s), random_.uniform(1.0, 1.4), quickest);
    PhraseGesture out;
    out.placed = {choice.gesture, apex_s, speed,
                  std::max(0.0, phrase.end_s - apex_s) + exponential(random_, speaker_.hold_s)};
    out.gesture_class = gesture_class;
    out.anchor = anchor;
    out.by_word = choice.by_word;
    free_from_s_ = apex_s + (choice.gesture.strokeEnd_s() - choice.gesture.apex_s()) / speed;
    gestures_.push_back(std::move(out));
}

/// The hands rise a little and fall, as far as the accent is strong, in the phrase's posture.
void PhrasePlanner::placeBeat(const Anchor& anchor, const SpokenPhrase& phrase) {
    constexpr double slow_s = 0.22, quick_s = 0.16, back_s = 0.6;
    const double apex_s = std::max(beatApex(anchor), free_from_s_ + 2.0 * quick_s);
    const double rise_s = std::clamp(0.5 * (apex_s - free_from_s_), quick_s, slow_s), fall_s = rise_s;
    const double depth = (0.06 + 0.10 * anchor.strength) * random_.uniform(0.75, 1.25);  // arm lengths
    const double outwards = random_.normal(0.0, 0.3) * depth;
    UnitGesture beat;
    beat.id = held_beat;
    beat.keys.resize(4);
    beat.keys[1].time_s = rise_s;
    beat.keys[2].time_s = rise_s + fall_s;
    beat.keys[2].phase = GesturePhase::stroke;
    beat.keys[3].time_s = rise_s + fall_s + back_s;
    beat.keys[3].phase = GesturePhase::retraction;
    for (std::size_t h = 0; h < hands.size(); ++h) {
        if (!posture_[h]) continue;
        ChannelValues up = *posture_[h], down = up;
        up[0] -= outwards, up[1] += 0.7 * depth, up[2] -= 0.2 * depth;
        down[0] += outwards, down[1] -= 0.5 * depth, down[2] += 0.3 * depth;
        keepWithinReach(up);
        keepWithinReach(down);
        beat.keys[1].channels[indexOf(hands[h])] = up;
        beat.keys[2].channels[indexOf(hands[h])] = down;
    }
    constexpr double nods = 0.35;  // of beats: a choice
    if (random_.uniform() < nods)
        beat.keys[2].channels[indexOf(Channel::head)] = ChannelValues{0.0, 7.0 * anchor.strength, 0.0, 0.0};
    PhraseGesture out;
    out.placed = {beat, apex_s, 1.0,
                  std::max(0.0, phrase.end_s - apex_s) + exponential(random_, speaker_.hold_s)};
    out.anchor = anchor;
    free_from_s_ = apex_s;
    gestures_.push_back(std::move(out));
}

}  // namespace deixis::motion
