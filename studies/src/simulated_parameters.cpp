#include <array>
#include <string_view>

#include "core/files.hpp"
#include "motion/pointing.hpp"
#include "studies/simulated_participant.hpp"
#include "toml_table.hpp"

namespace deixis::studies {

namespace {

constexpr std::array<std::string_view, 4> sections{"pointing", "rating", "reaction", "station"};
constexpr std::array<std::string_view, 4> pointing_keys{"ray", "noise_deg", "noise_between", "lapse_rate"};
constexpr std::array<std::string_view, 11> rating_keys{
    "base",           "profile_weight",    "participation_weight", "steadiness_weight",  "profile_abrupt",
    "profile_smooth", "participation_deg", "steady_speed_m_s",     "unsteady_speed_m_s", "bias_between",
    "noise_within"};
constexpr std::array<std::string_view, 2> reaction_keys{"mean_s", "sd_s"};
constexpr std::array<std::string_view, 2> station_keys{"eye_height_m", "frame_rate_hz"};

void readPointing(TomlTable table, SimulatedParameters& read) {
    read.pointing_ray = table.text("ray");
    if (const auto kind = motion::pointingRayFromName(read.pointing_ray); !kind)
        table.problem("ray", kind.error().message, kind.error().mend);
    read.pointing_noise_deg = table.number("noise_deg", 0.0, 60.0);
    read.pointing_noise_between = table.number("noise_between", 0.0, 2.0);
    read.lapse_rate = table.number("lapse_rate", 0.0, 1.0);
}

void readRating(TomlTable table, SimulatedParameters& read) {
    read.rating_base = table.number("base", -10.0, 10.0);
    read.rating_profile_weight = table.number("profile_weight", -10.0, 10.0);
    read.rating_participation_weight = table.number("participation_weight", -10.0, 10.0);
    read.rating_steadiness_weight = table.number("steadiness_weight", -10.0, 10.0);
    read.profile_abrupt = table.number("profile_abrupt", 1.0, 10.0);
    read.profile_smooth = table.number("profile_smooth", 1.0, 10.0);
    if (read.profile_smooth <= read.profile_abrupt)
        table.problem("profile_smooth", "not greater than profile_abrupt; expected a greater number");
    read.participation_deg = table.number("participation_deg", 0.01, 180.0);
    read.steady_speed_m_s = table.number("steady_speed_m_s", 0.0, 10.0);
    read.unsteady_speed_m_s = table.number("unsteady_speed_m_s", 0.0, 10.0);
    if (read.unsteady_speed_m_s <= read.steady_speed_m_s)
        table.problem("unsteady_speed_m_s", "not greater than steady_speed_m_s; expected a greater number");
    read.rating_bias_between = table.number("bias_between", 0.0, 10.0);
    read.rating_noise_within = table.number("noise_within", 0.0, 10.0);
}

}  // namespace

Result<SimulatedParameters> loadSimulatedParameters(const std::filesystem::path& path) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto file = parseToml(path.string(), *bytes);
    if (!file) return tl::unexpected(file.error());
    TomlProblems problems{path.string()};
    TomlTable root(&*file, "", sections, problems);
    SimulatedParameters read;
    readPointing({root.section("pointing", true), "pointing", pointing_keys, problems}, read);
    readRating({root.section("rating", true), "rating", rating_keys, problems}, read);
    TomlTable reaction(root.section("reaction", true), "reaction", reaction_keys, problems);
    read.reaction_mean_s = reaction.number("mean_s", 0.01, 60.0);
    read.reaction_sd_s = reaction.number("sd_s", 0.0, 60.0);
    TomlTable station(root.section("station", true), "station", station_keys, problems);
    read.eye_height_m = station.number("eye_height_m", 0.5, 2.5);
    read.frame_rate_hz = station.number("frame_rate_hz", 5.0, 500.0);
    if (problems.first) return tl::unexpected(*problems.first);
    return read;
}

}  // namespace deixis::studies
