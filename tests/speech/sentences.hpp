// Twenty sentences with numbers, names and abbreviations among them.
#pragma once

namespace deixis::tests {

inline constexpr const char* twenty_sentences[]{
    "The quick brown fox jumps over the lazy dog.",
    "I would like you to put the red ball over there, next to the window.",
    "Please call me tomorrow morning before nine o'clock.",
    "We found an enormous difference between the two groups.",
    "This table is very long and that one is quite short.",
    "In 1999 Dr. Smith paid $250 for the house in St. Louis.",
    "She turned around slowly and looked up at the mountain.",
    "There are three reasons why this cannot work.",
    "Do you really believe that he did it alone?",
    "The meeting has been moved from Tuesday to Thursday.",
    "First we measure the distance, then we draw a line from here to there.",
    "My brother's well-known recipe needs about 12 eggs!",
    "What a beautiful morning; let us go outside.",
    "He lifted the heavy box and carried it to the kitchen.",
    "Nobody knows exactly how many people came to the concert.",
    "The deixis of a gesture depends on where the speaker stands.",
    "Sixty percent of all strokes were made by the right hand.",
    "It was a tiny little bird, with a bright yellow head.",
    "You can see the whole city from the top of this tower.",
    "Thank you very much for your attention.",
};

}  // namespace deixis::tests
