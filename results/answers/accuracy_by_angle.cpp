#include "results/answers/accuracy_by_angle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace deixis::results {

namespace {

constexpr std::array<double, 5> bands_deg{0.0, 3.0, 6.0, 9.0, 12.0};  // where they begin

std::size_t bandOf(double angle_deg) {
    const auto above = std::upper_bound(bands_deg.begin(), bands_deg.end(), angle_deg);
    return static_cast<std::size_t>(above - bands_deg.begin()) - 1;
}

std::optional<double> angleFor(const ChoiceRow& choice, const std::string& eyes) {
    if (eyes.empty()) return choice.avatar_angle_deg;
    return choice.layout == eyes ? choice.participant_angle_deg : std::nullopt;
}

}  // namespace

std::vector<AngleResult> accuracyByAngle(const ResponseTable& table) {
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), table.systems.begin(), table.systems.end());
    std::vector<std::string> all_eyes{""};  // the avatar's
    all_eyes.insert(all_eyes.end(), table.layouts.begin(), table.layouts.end());
    std::vector<AngleResult> out;
    for (const std::string& eyes : all_eyes) {
        std::vector<AngleResult> of_eyes;
        for (const std::string& system : systems)
            for (std::size_t band = 0; band < bands_deg.size(); ++band) {
                AngleResult& one = of_eyes.emplace_back();
                one.eyes = eyes.empty() ? "avatar" : eyes;
                one.system = system;
                one.from_deg = bands_deg[band];
                if (band + 1 < bands_deg.size()) one.below_deg = bands_deg[band + 1];
            }
        int known = 0;
        for (const ChoiceRow& choice : table.choices) {
            const std::optional<double> angle_deg = angleFor(choice, eyes);
            if (!angle_deg) continue;
            ++known;
            for (std::size_t i = 0; i < systems.size(); ++i) {
                if (i > 0 && systems[i] != choice.system) continue;
                AngleResult& one = of_eyes[i * bands_deg.size() + bandOf(*angle_deg)];
                ++one.choices;
                one.right += choice.chosen_place == choice.target_place ? 1 : 0;
            }
        }
        if (known > 0) out.insert(out.end(), of_eyes.begin(), of_eyes.end());
    }
    return out;
}

std::string angleBandText(const AngleResult& band) {
    return band.below_deg ? fmt::format("{:g}-{:g}", band.from_deg, *band.below_deg)
                          : fmt::format("{:g}+", band.from_deg);
}

}  // namespace deixis::results
