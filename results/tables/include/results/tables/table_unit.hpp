// What the numbers of a table are computed over: each table of the pages, CSV and LaTeX names it in these
// words.
#pragma once

namespace deixis::results {

struct TableUnit {
    const char* words;  ///< empty: no numbers of people or clips
};

namespace units {
inline constexpr TableUnit none{""};
inline constexpr TableUnit participants{"participants"};
inline constexpr TableUnit means{"participants' means"};
inline constexpr TableUnit means_and_choices{"participants' means; counts: choices"};
inline constexpr TableUnit means_beside_ratings{"participants' means; medians of ratings: ratings"};
inline constexpr TableUnit differences{"participants' differences of means"};
inline constexpr TableUnit preferences{"participants' mean preferences; counts: single preferences"};
inline constexpr TableUnit median_times{"participants' median times"};
inline constexpr TableUnit scores{"participants' scores"};
inline constexpr TableUnit answers{"single answers"};
inline constexpr TableUnit ratings{"ratings"};
inline constexpr TableUnit choices{"choices"};
inline constexpr TableUnit single_preferences{"single preferences; intervals: participants"};
inline constexpr TableUnit checks{"attention checks"};
inline constexpr TableUnit stations{"stations"};
inline constexpr TableUnit trials{"trials of the game"};
inline constexpr TableUnit clips{"clips"};
inline constexpr TableUnit targets{"targets"};
}  // namespace units

}  // namespace deixis::results
