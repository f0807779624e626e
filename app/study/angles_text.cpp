#include "app/study/angles_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/order_statistics.hpp"
#include "studies/design/angles.hpp"
#include "studies/design/visibility.hpp"

namespace deixis::app {

namespace {

constexpr double near_deg = 3.0;  // ours: the noise of the simulated participant's reading

std::string line(const std::string& who, const std::vector<double>& min_deg) {
    const auto near =
        std::count_if(min_deg.begin(), min_deg.end(), [](double angle_deg) { return angle_deg < near_deg; });
    return fmt::format("  {}: {:.1f}, median {:.1f}; under {:g} in {} of {}\n", who,
                       *std::min_element(min_deg.begin(), min_deg.end()), median(min_deg), near_deg, near,
                       min_deg.size());
}

}  // namespace

std::string anglesText(const StudySetup& setup) {
    const studies::Study& study = setup.study;
    const std::vector<studies::Viewpoint> places = studies::viewpoints(study);
    std::vector<double> by_avatar;
    std::vector<std::vector<double>> by_place(places.size());
    const auto smallest = [](const std::vector<double>& angles_deg) {
        return *std::min_element(angles_deg.begin(), angles_deg.end());
    };
    for (const auto& item : setup.targets) {
        if (!item.placed || places.empty()) continue;
        for (const auto& distractors : item.distractors)
            for (std::size_t i = 0; i < places.size(); ++i) {
                const auto angles =
                    ballAngles(study, *study.findLayout(places[i].layout), item.target, distractors);
                by_place[i].push_back(smallest(angles.of(places[i].standing)));
                if (i == 0) by_avatar.push_back(smallest(angles.avatar_deg));
            }
    }
    if (by_avatar.empty()) return {};
    std::string out =
        "angles: between the target and the nearest distractor, in degrees; the smallest of all sets of "
        "balls\n" +
        line("as seen by the avatar", by_avatar);
    for (std::size_t i = 0; i < places.size(); ++i)
        out += line(fmt::format("{}, {}", places[i].layout, studies::standingName(places[i].standing)),
                    by_place[i]);
    return out;
}

}  // namespace deixis::app
