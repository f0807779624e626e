// Which participants a study leaves out of its headline results, as declared before it is run.
#pragma once

#include <optional>

namespace deixis::studies {

/// Participants for whom any of these holds; none given: nobody is left out by a rule. Judged only where a
/// participant has at least `min_answers` answers of the kind.
struct LeaveOutRule {
    static constexpr int min_answers = 10;

    std::optional<double>
        same_rating_share{};                 ///< one rating in at least this share of a measure's; [0.51, 1]
    std::optional<double> one_side_share{};  ///< of a pair the same side in at least this share; [0.51, 1]
    std::optional<double> median_time_below_s{};  ///< the median of the response times lies below; above 0

    [[nodiscard]] bool declared() const { return same_rating_share || one_side_share || median_time_below_s; }
};

}  // namespace deixis::studies
