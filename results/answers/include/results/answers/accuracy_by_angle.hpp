// Correct choices by the angle between the target and the nearest distractor.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// Of one system in one band of angles.
struct AngleResult {
    std::string eyes;    ///< "avatar", or the layout from whose place the participant looked
    std::string system;  ///< or "all"
    double from_deg = 0.0;
    std::optional<double> below_deg{};  ///< none: the last band has no end
    int right = 0;
    int choices = 0;
};

/// Of the choices whose trials kept the angles, in bands of 3 degrees up to 12: as the avatar's eyes saw it
/// over all layouts, then as the participant's did from each; all systems together first. Bands in which
/// nobody chose are there with 0 choices; eyes without any choice are not.
[[nodiscard]] std::vector<AngleResult> accuracyByAngle(const ResponseTable& table);

/// "3-6", "12+".
[[nodiscard]] std::string angleBandText(const AngleResult& band);

}  // namespace deixis::results
