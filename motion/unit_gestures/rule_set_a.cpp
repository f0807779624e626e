#include "motion/unit_gestures/rule_set_a.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "core/text.hpp"
#include "motion/unit_gestures/gesture_variation.hpp"

namespace deixis::motion {

namespace {

/// A moment at which a stroke may be made: an accent, or a word without one.
struct Candidate {
    double time_s = 0.0;
    int word = 0;
    std::optional<int> accent{};
    double strength = 0.0;
};

/// A gesture that is chosen, and to what it goes.
struct Planned {
    PlacedGesture placed;
    SpeechStroke stroke;
};

std::vector<Candidate> candidatesOf(const Utterance& utterance) {
    std::vector<Candidate> out;
    std::vector<bool> accented(utterance.words.size(), false);
    for (std::size_t a = 0; a < utterance.accents.size(); ++a) {
        const Accent& accent = utterance.accents[a];
        if (accent.word < 0 || static_cast<std::size_t>(accent.word) >= utterance.words.size()) continue;
        accented[static_cast<std::size_t>(accent.word)] = true;
        out.push_back(
            {0.5 * (accent.start_s + accent.end_s), accent.word, static_cast<int>(a), accent.strength});
    }
    for (std::size_t w = 0; w < utterance.words.size(); ++w)
        if (!accented[w]) {
            const SpokenWord& word = utterance.words[w];
            out.push_back({0.5 * (word.start_s + word.end_s), static_cast<int>(w), std::nullopt, 0.0});
        }
    std::stable_sort(out.begin(), out.end(),
                     [](const Candidate& a, const Candidate& b) { return a.time_s < b.time_s; });
    return out;
}

double firstPosture_s(const UnitGesture& gesture) {
    for (const UnitKey& key : gesture.keys)
        if (key.channels[0] || key.channels[1]) return key.time_s;
    return gesture.strokeBegin_s();
}

class PlannerA {
  public:
    PlannerA(const Utterance& utterance, const GestureLibrary& library, std::uint64_t seed,
             const WordRules& rules, const RuleSetA& numbers)
        : utterance_(utterance),
          rules_(rules),
          library_(library),
          numbers_(numbers),
          random_(seed, "rule set A"),
          nods_(seed, "nods of rule set A") {
        for (const UnitGesture& gesture : library)
            if (handsOf(gesture) != Hands::none)
                by_class_[static_cast<std::size_t>(gesture.gesture_class)].push_back(&gesture);
        // Where in its share each class begins is chance, so that short speeches differ.
        for (double& made : made_) made = random_.uniform(-0.5, 0.5);
        lag_ = random_.normal();
    }

    std::vector<Planned> plan() {
        double phrase_end_s = -1e9;
        double before_s = 0.0;
        for (const Candidate& candidate : candidatesOf(utterance_)) {
            const SpokenWord& word = wordOf(candidate);
            if (word.start_s - phrase_end_s >= numbers_.phrase_pause_s)
                hand_ = random_.uniform() < numbers_.published.right_hand ? Side::right : Side::left;
            phrase_end_s = std::max(phrase_end_s, word.end_s);
            fallDue(candidate.time_s - before_s);
            before_s = candidate.time_s;
            if (isHesitation(word.text)) continue;
            double& due = candidate.accent ? due_with_accent_ : due_without_;
            if (isDue(candidate, due)) {
                driftLag();
                if (auto planned = choose(candidate)) {
                    due -= 1.0;
                    plan_.push_back(std::move(*planned));
                    continue;
                }
            }
            if (candidate.accent) maybeNod(candidate);
        }
        return std::move(plan_);
    }

  private:
    [[nodiscard]] const SpokenWord& wordOf(const Candidate& candidate) const {
        return utterance_.words[static_cast<std::size_t>(candidate.word)];
    }

    /// What is not made in time is forgotten by and by: no burst follows a pause.
    void fallDue(double time_s) {
        constexpr double most_due = 2.0;
        const double strokes = numbers_.published.strokes_per_minute / 60.0 * time_s;
        const double share = numbers_.published.with_accent;
        due_with_accent_ =
            std::min(due_with_accent_ + numbers_.asked_with_accent * share * strokes, most_due);
        due_without_ = std::min(due_without_ + numbers_.asked_without * (1.0 - share) * strokes, most_due);
    }

    /// Strong accents are taken sooner than they are due, weak ones later.
    bool isDue(const Candidate& candidate, double due) {
        const double eager = candidate.accent ? 0.6 * (candidate.strength - 0.5) : 0.0;
        return due + eager + random_.uniform(-0.3, 0.3) > 0.5;
    }

    std::optional<Planned> choose(const Candidate& candidate) {
        const std::string word = lowerCase(wordOf(candidate).text);
        if (const WordRule* rule = ruleFor(rules_, word);
            rule != nullptr && random_.uniform() < numbers_.rule_used) {
            const std::string& id = rule->gestures[random_.below(rule->gestures.size())];
            if (auto planned = byWord(candidate, gestureOfRule(library_, id), rule->sided)) return planned;
        }
        const GestureClass wanted = classFor(word);
        if (wanted != GestureClass::beat) {
            if (auto planned = byAccent(candidate, habitOf(word, wanted))) return planned;
            constexpr int others = 3;  // a shorter one may do
            for (int i = 0; i < others; ++i)
                if (auto planned = byAccent(candidate, anyOf(wanted))) return planned;
        }
        if (wanted != GestureClass::beat && beatsAhead() > 1.0) return std::nullopt;
        return byAccent(candidate, beatFor(candidate));
    }

    [[nodiscard]] double beatsAhead() const {
        constexpr auto beat = static_cast<std::size_t>(GestureClass::beat);
        double total = 0.0;
        for (const double made : made_) total += made;
        return made_[beat] - numbers_.published.classes[beat] * total;
    }

    /// By how much each class is behind its share.
    GestureClass classFor(const std::string& word) {
        if (isPlainWord(word)) return GestureClass::beat;
        double total = 1.0;
        for (const double made : made_) total += made;
        std::array<double, gesture_class_count> behind{};
        double sum = 0.0;
        for (std::size_t c = 0; c < gesture_class_count; ++c) {
            if (by_class_[c].empty()) continue;
            behind[c] = std::max(0.0, numbers_.published.classes[c] * total - made_[c]);
            sum += behind[c];
        }
        double draw = random_.uniform(0.0, sum);
        for (std::size_t c = 0; c < gesture_class_count; ++c) {
            if (behind[c] > draw) return static_cast<GestureClass>(c);
            draw -= behind[c];
        }
        return GestureClass::beat;
    }

    const UnitGesture& habitOf(const std::string& word, GestureClass gesture_class) {
        const auto& all = by_class_[static_cast<std::size_t>(gesture_class)];
        if (random_.uniform() >= numbers_.habit_used) return anyOf(gesture_class);
        return *all[deriveSeed(0, word) % all.size()];
    }

    const UnitGesture& anyOf(GestureClass gesture_class) {
        const auto& all = by_class_[static_cast<std::size_t>(gesture_class)];
        return *all[random_.below(all.size())];
    }

    /// A strong accent gets one of the later, firmer beats of the library; a weak one its first.
    const UnitGesture& beatFor(const Candidate& candidate) {
        const auto& all = by_class_[static_cast<std::size_t>(GestureClass::beat)];
        const double firm = std::clamp(candidate.strength + random_.normal(0.0, 0.3), 0.0, 0.999);
        return *all[static_cast<std::size_t>(firm * static_cast<double>(all.size()))];
    }

    std::optional<Planned> byWord(const Candidate& candidate, const UnitGesture& gesture, bool sided) {
        const SpokenWord& word = wordOf(candidate);
        // From the stroke's begin to its end the gesture lies about the word's middle; the apex is within.
        const double middle_s = 0.5 * (gesture.strokeBegin_s() + gesture.strokeEnd_s());
        const auto apex_of = [&](double speed) {
            return 0.5 * (word.start_s + word.end_s) + (gesture.apex_s() - middle_s) / speed;
        };
        const auto speed = speedFor(gesture, apex_of);
        if (!speed) return std::nullopt;
        Planned planned = made(candidate, gesture, sided, apex_of(*speed), *speed);
        planned.stroke.by_word_rule = true;
        return planned;
    }

    std::optional<Planned> byAccent(const Candidate& candidate, const UnitGesture& gesture) {
        const bool beat = gesture.gesture_class == GestureClass::beat;
        const double apex_s = beat ? beatApex(candidate) : candidate.time_s + offset();
        const auto speed = speedFor(gesture, [&](double) { return apex_s; });
        if (!speed) return std::nullopt;
        return made(candidate, gesture, false, apex_s, *speed);
    }

    /// At which there is time for a gesture after the last one; none if there is not.
    template <typename ApexOfSpeed>
    std::optional<double> speedFor(const UnitGesture& gesture, const ApexOfSpeed& apex_of) {
        // From another posture to the first of this gesture the timeline needs so much, at any speed.
        const double wished = random_.uniform(numbers_.slowest, numbers_.fastest);
        const double given_s = apex_of(wished) - busy_until_s_ - numbers_.timeline.min_preparation_s - 1e-3;
        const double needed_s = gesture.apex_s() - firstPosture_s(gesture);
        if (given_s <= 0.0 || needed_s / given_s > numbers_.hurried) return std::nullopt;
        return std::max(wished, needed_s / given_s);
    }

    /// On the syllable, or later, as the lag says.
    double beatApex(const Candidate& candidate) {
        if (!candidate.accent) return candidate.time_s;
        const Accent& accent = utterance_.accents[static_cast<std::size_t>(*candidate.accent)];
        const double share = 0.5 * (1.0 + std::erf(lag_ / std::sqrt(2.0)));  // even from 0 to 1
        const double on_syllable = numbers_.drawn_on_syllable;
        if (share < on_syllable)
            return accent.start_s + share / on_syllable * (accent.end_s - accent.start_s);
        return accent.end_s + numbers_.late_mean_s * (share - on_syllable) / (1.0 - on_syllable) * 2.0;
    }

    double offset() const {
        constexpr double most_sd = 2.2;
        return numbers_.apex_mean_s + numbers_.apex_sd_s * std::clamp(lag_, -most_sd, most_sd);
    }

    /// How far the hands are behind the speech or before it, in SD: a drift, so that strokes keep their
    /// order.
    void driftLag() {
        const double kept = numbers_.lag_kept;
        lag_ = kept * lag_ + std::sqrt(1.0 - kept * kept) * random_.normal();
    }

    Planned made(const Candidate& candidate, const UnitGesture& gesture, bool sided, double apex_s,
                 double speed) {
        const double hold_s = random_.uniform(numbers_.shortest_hold_s, numbers_.longest_hold_s);
        const bool other = random_.uniform() < numbers_.other_hand;
        UnitGesture own = variation(gesture);
        const Side side = other ? opposite(hand_) : hand_;
        if (!sided && side == Side::left) own = mirrored(own);
        busy_until_s_ = apex_s + (gesture.strokeEnd_s() - gesture.apex_s()) / speed;
        if (handsOf(own) != Hands::none) made_[static_cast<std::size_t>(gesture.gesture_class)] += 1.0;
        Planned planned;
        planned.stroke.gesture = gesture.id;
        planned.stroke.gesture_class = gesture.gesture_class;
        planned.stroke.hands = handsOf(own);
        planned.stroke.word = candidate.word;
        planned.stroke.accent = candidate.accent;
        planned.placed = {std::move(own), apex_s, speed, hold_s};
        return planned;
    }

    UnitGesture variation(const UnitGesture& gesture) {
        const double size = std::clamp(random_.normal(1.0, numbers_.size_sd), 0.8, 1.2);
        const double up_and_down = random_.normal(0.0, numbers_.place_sd);
        const double ahead = random_.normal(0.0, numbers_.place_sd);
        const bool lower = gesture.gesture_class == GestureClass::metaphoric;
        const bool wider = gesture.gesture_class == GestureClass::deictic;
        return varied(gesture, wider ? size * numbers_.deictic_size : size,
                      Vec3(0.0, up_and_down - (lower ? numbers_.metaphoric_lower : 0.0), ahead));
    }

    void maybeNod(const Candidate& candidate) {
        if (nods_.uniform() >= numbers_.nod) return;
        const double depth_deg = nods_.uniform(numbers_.shallowest_nod_deg, numbers_.deepest_nod_deg);
        Planned planned;
        planned.placed = {smallNod(depth_deg), candidate.time_s, 1.0, 0.0};
        planned.stroke = {"small_nod", GestureClass::beat, Hands::none,      0.0,  0.0,
                          0.0,         candidate.word,     candidate.accent, false};
        plan_.push_back(std::move(planned));
    }

    const Utterance& utterance_;
    const WordRules& rules_;
    const GestureLibrary& library_;
    const RuleSetA& numbers_;
    Random random_, nods_;
    std::array<std::vector<const UnitGesture*>, gesture_class_count> by_class_;
    std::array<double, gesture_class_count> made_{};
    double due_with_accent_ = 0.5, due_without_ = 0.0;
    double busy_until_s_ = 0.0;
    double lag_ = 0.0;
    Side hand_ = Side::right;
    std::vector<Planned> plan_;
};

}  // namespace

GesturedSpeech gesturesByRuleSetA(const Utterance& utterance, const GestureLibrary& library,
                                  std::uint64_t seed, const WordRules& rules, const RuleSetA& numbers) {
    const std::vector<Planned> plan = PlannerA(utterance, library, seed, rules, numbers).plan();
    std::vector<PlacedGesture> placed;
    for (const Planned& planned : plan) placed.push_back(planned.placed);
    const GestureTimeline timeline = timelineOf(placed, utterance.duration_s, numbers.timeline);
    GesturedSpeech out;
    out.motion = motionOf(timeline.track, utterance.duration_s, seed, numbers.idle);
    for (const MadeGesture& made : timeline.made) {
        SpeechStroke stroke = plan[made.index].stroke;
        stroke.begin_s = made.begin_s;
        stroke.stroke_s = made.stroke_s;
        stroke.apex_s = made.apex_s;
        out.strokes.push_back(std::move(stroke));
    }
    return out;
}

}  // namespace deixis::motion
