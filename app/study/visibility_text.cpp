#include "app/study/visibility_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "motion/humanoid/reference_humanoid.hpp"
#include "studies/design/targets.hpp"
#include "studies/design/visibility.hpp"

namespace deixis::app {

namespace {

constexpr std::size_t max_listed = 8;

// Which sets of balls are not all seen from one viewpoint: by their item and, of several bands, the band.
std::vector<std::string> hiddenSets(const StudySetup& setup, const studies::Viewpoint& viewpoint,
                                    const studies::StandingAvatar& avatar) {
    const auto& study = setup.study;
    std::vector<std::string> hidden;
    for (const auto& item : setup.targets)
        for (std::size_t band = 0; item.placed && band < study.distances.size(); ++band) {
            if (studies::seenOf(study, item, band, {viewpoint}, avatar).front().clear()) continue;
            hidden.push_back(study.distances.size() > 1
                                 ? fmt::format("{} {}", item.id, study.distances[band].name)
                                 : item.id);
        }
    return hidden;
}

}  // namespace

std::string visibilityText(const StudySetup& setup, const assets::Avatar& avatar) {
    const auto& study = setup.study;
    const std::vector<studies::Viewpoint> from = studies::viewpoints(study);
    if (from.empty() || study.distances.empty()) return {};
    const studies::StandingAvatar body(avatar.skeleton, motion::relaxedPose(avatar.skeleton));
    const auto placed = static_cast<std::size_t>(std::count_if(setup.targets.begin(), setup.targets.end(),
                                                               [](const auto& item) { return item.placed; }));
    const std::size_t sets = placed * study.distances.size();
    std::string out = fmt::format(
        "visibility: \"{}\"; sets of balls of which at least {:.0f} % of each is visible, past the avatar at "
        "rest and pointing\n",
        study.targets.clear_view ? "clear" : "any", 100.0 * studies::min_visible_share);
    for (const auto& viewpoint : from) {
        std::vector<std::string> hidden = hiddenSets(setup, viewpoint, body);
        const std::size_t count = hidden.size();
        if (count > max_listed) hidden.resize(max_listed);
        out += fmt::format("  {}, {}: {} of {}", viewpoint.layout, studies::standingName(viewpoint.standing),
                           sets - count, sets);
        if (count > 0)
            out += fmt::format("; not {}{}", fmt::join(hidden, ", "),
                               count > max_listed ? fmt::format(" and {} more", count - max_listed) : "");
        out += "\n";
    }
    const auto drawn = studies::redrawn(study, setup.targets);
    if (!drawn || !study.targets.clear_view) return out;
    const auto count = [&](studies::Redrawn what) { return std::count(drawn->begin(), drawn->end(), what); };
    return out +
           fmt::format("  redrawn, unlike the bare rule's: {} targets, and the distractors of {} others\n",
                       count(studies::Redrawn::target), count(studies::Redrawn::distractors));
}

}  // namespace deixis::app
