// What the paper claims, and whether it came out here.
#pragma once

#include <string>
#include <vector>

#include "results/reproduction/reproduction.hpp"

namespace deixis::results {

enum class Verdict : unsigned char { agrees, differs, unknown };

struct Claim {
    std::string section;
    std::string claim;  ///< text, as all below
    std::string paper;  ///< the paper's numbers
    std::string where;  ///< of ours: which grid, which participants
    std::string ours;
    Verdict verdict = Verdict::unknown;
    std::string why{};  ///< where it differs: what is known of the reason
};

/// Each claim once for each grid and each kind of participants, as far as the input has what it takes.
[[nodiscard]] std::vector<Claim> paperClaims(const ReproductionInput& input);

/// Below the lower quartile by more than 1.5 times the distance of the quartiles (Tukey 1977): what a box
/// plot draws as a point of its own.
[[nodiscard]] int lowOutliers(const std::vector<double>& values);

/// How the demonstrations of both hands compare in one measure.
struct HandsCompared {
    std::string measure;
    int n_left = 0, n_right = 0;
    double median_left = 0.0, median_right = 0.0;
    double p = 1.0, p_holm = 1.0;
};
/// Rank-sum tests of accuracy and speed, corrected together; none where a hand has no demonstration.
[[nodiscard]] std::vector<HandsCompared> compareHands(
    const std::vector<DemonstrationFigures>& demonstrations);

}  // namespace deixis::results
