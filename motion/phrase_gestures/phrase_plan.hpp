// What a phrase's strokes are: one gesture of the library, and beats in its posture.
#pragma once

#include <vector>

#include "motion/unit_gestures/gesture_timeline.hpp"
#include "phrases.hpp"

namespace deixis::motion {

/// What stays the same in a speech.
struct PhraseHabits {
    Side own_hand = Side::right;  ///< that the speaker writes with
    double size = 1.0;
    Vec3 place{};  ///< where it likes to gesture, against the library's place; arm lengths
};
[[nodiscard]] PhraseHabits habitsOf(const PhraseSpeaker& speaker, Random& random);

/// A gesture in time and what it goes with.
struct PhraseGesture {
    PlacedGesture placed;
    GestureClass gesture_class = GestureClass::beat;
    Anchor anchor;
    bool by_word = false;
};

/// Places the gestures of all phrases.
class PhrasePlanner {
  public:
    PhrasePlanner(const Utterance& utterance, const GestureLibrary& library, const PhraseSpeaker& speaker,
                  Random random)
        : utterance_(utterance),
          library_(library),
          speaker_(speaker),
          random_(random),
          habits_(habitsOf(speaker, random_)) {}

    [[nodiscard]] std::vector<PhraseGesture> plan(const std::vector<SpokenPhrase>& phrases);

  private:
    struct Choice {
        UnitGesture gesture;     ///< by the hand that makes it, in its size and place
        std::size_t anchor = 0;  ///< index in the phrase
        bool by_word = false;
    };

    void addPhrase(const SpokenPhrase& phrase);
    [[nodiscard]] Choice choose(const SpokenPhrase& phrase);
    [[nodiscard]] const UnitGesture* ofWord(const SpokenPhrase& phrase, std::size_t anchor, Side& hand);
    [[nodiscard]] const UnitGesture* drawn(std::initializer_list<std::string_view> ids);
    [[nodiscard]] Side phraseHand();
    [[nodiscard]] Side pointingHand();
    [[nodiscard]] UnitGesture made(const UnitGesture& gesture, Side hand);
    [[nodiscard]] double beatApex(const Anchor& anchor);
    [[nodiscard]] double apexOf(GestureClass gesture_class, const Anchor& anchor, bool ends_phrase);
    void place(const Choice& choice, const SpokenPhrase& phrase);
    void placeBeat(const Anchor& anchor, const SpokenPhrase& phrase);

    const Utterance& utterance_;
    const GestureLibrary& library_;
    const PhraseSpeaker& speaker_;
    Random random_;
    PhraseHabits habits_;
    std::vector<PhraseGesture> gestures_;
    std::array<std::optional<ChannelValues>, 2> posture_{};  ///< of the hands that gesture in this phrase
    double free_from_s_ = 0.0;                               ///< the last stroke is over
};

}  // namespace deixis::motion
