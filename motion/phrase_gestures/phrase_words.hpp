// Which words this speaker gestures, and by which unit gestures.
#pragma once

#include <string_view>
#include <vector>

namespace deixis::motion {

struct GestureShare {
    std::string_view gesture;  ///< id in the library; to_left and to_right are by the hand that points there
    double share = 0.0;
};
struct WordGestures {
    double chance = 0.0;  ///< that a phrase is gestured by this word, where there is no better one
    std::vector<GestureShare> gestures;
};

inline constexpr std::string_view to_left = "to_left";
inline constexpr std::string_view to_right = "to_right";

/// Null for words that are not gestured. Small letters.
[[nodiscard]] const WordGestures* gesturesOf(std::string_view word);

}  // namespace deixis::motion
