#include <array>
#include <string_view>

#include "studies/observers/observer.hpp"
#include "studies/simulation/simulated_participant.hpp"
#include "studies/texts/study_texts.hpp"
#include "studies/texts/toml_table.hpp"

namespace deixis::studies {

namespace {

constexpr std::array<std::string_view, 8> sections{"pointing",  "rating",        "preference", "confidence",
                                                   "attention", "questionnaire", "reaction",   "station"};
constexpr std::array<std::string_view, 7> pointing_keys{
    "ray",           "noise_deg",         "noise_between", "lapse_rate", "eye_line_share",
    "visual_weight", "elevation_bias_deg"};
constexpr std::array<std::string_view, 11> rating_keys{
    "base",           "profile_weight",    "participation_weight", "steadiness_weight",  "profile_abrupt",
    "profile_smooth", "participation_deg", "steady_speed_m_s",     "unsteady_speed_m_s", "bias_between",
    "noise_within"};
constexpr std::array<std::string_view, 2> preference_keys{"tie_zone", "clear_zone"};
constexpr std::array<std::string_view, 2> confidence_keys{"margin_deg", "noise_within"};
constexpr std::array<std::string_view, 1> attention_keys{"lapse_rate"};
constexpr std::array<std::string_view, 2> questionnaire_keys{"bias_between", "noise_within"};
constexpr std::array<std::string_view, 2> reaction_keys{"mean_s", "sd_s"};
constexpr std::array<std::string_view, 2> station_keys{"eye_height_m", "frame_rate_hz"};

void readPointing(TomlTable table, SimulatedParameters& read) {
    if (const auto reading = readingFromName(table.note("ray")); reading)
        read.observer.reading = *reading;
    else
        table.problem("ray", reading.error().message, reading.error().hint);
    read.observer.noise_rad = radiansFromDegrees(table.number("noise_deg", 0.0, 60.0));
    read.pointing_noise_between = table.number("noise_between", 0.0, 2.0);
    read.observer.lapse_rate = table.number("lapse_rate", 0.0, 1.0);
    read.observer.eye_line_share = table.number("eye_line_share", 0.0, 1.0);
    read.observer.visual_weight = table.number("visual_weight", 0.0, 1.0);
    read.elevation_bias_deg = table.number("elevation_bias_deg", -45.0, 45.0);
}

void readRating(TomlTable table, SimulatedParameters& read) {
    read.rating_base = table.number("base", -10.0, 10.0);
    read.rating_profile_weight = table.number("profile_weight", -10.0, 10.0);
    read.rating_participation_weight = table.number("participation_weight", -10.0, 10.0);
    read.rating_steadiness_weight = table.number("steadiness_weight", -10.0, 10.0);
    read.profile_abrupt = table.number("profile_abrupt", 1.0, 10.0);
    read.profile_smooth = table.number("profile_smooth", 1.0, 10.0);
    if (read.profile_smooth <= read.profile_abrupt)
        table.problem("profile_smooth", "not greater than profile_abrupt; expected a larger number");
    read.participation_deg = table.number("participation_deg", 0.01, 180.0);
    read.steady_speed_m_s = table.number("steady_speed_m_s", 0.0, 10.0);
    read.unsteady_speed_m_s = table.number("unsteady_speed_m_s", 0.0, 10.0);
    if (read.unsteady_speed_m_s <= read.steady_speed_m_s)
        table.problem("unsteady_speed_m_s", "not greater than steady_speed_m_s; expected a larger number");
    read.rating_bias_between = table.number("bias_between", 0.0, 10.0);
    read.rating_noise_within = table.number("noise_within", 0.0, 10.0);
}

void readPreference(TomlTable table, SimulatedParameters& read) {
    read.preference_tie_zone = table.number("tie_zone", 0.0, 10.0);
    read.preference_clear_zone = table.number("clear_zone", 0.0, 10.0);
    if (read.preference_clear_zone < read.preference_tie_zone)
        table.problem("clear_zone", "less than tie_zone; expected the same or a larger number");
}

void readOtherAnswers(TomlTable& root, SimulatedParameters& read) {
    TomlTable confidence = root.below("confidence", root.section("confidence", true), confidence_keys);
    read.confidence_margin_deg = confidence.number("margin_deg", 0.01, 180.0);
    read.confidence_noise_within = confidence.number("noise_within", 0.0, 10.0);
    TomlTable attention = root.below("attention", root.section("attention", true), attention_keys);
    read.attention_lapse_rate = attention.number("lapse_rate", 0.0, 1.0);
    TomlTable questionnaire =
        root.below("questionnaire", root.section("questionnaire", true), questionnaire_keys);
    read.questionnaire_bias_between = questionnaire.number("bias_between", 0.0, 2.0);
    read.questionnaire_noise_within = questionnaire.number("noise_within", 0.0, 2.0);
    TomlTable reaction = root.below("reaction", root.section("reaction", true), reaction_keys);
    read.reaction_mean_s = reaction.number("mean_s", 0.01, 60.0);
    read.reaction_sd_s = reaction.number("sd_s", 0.0, 60.0);
    TomlTable station = root.below("station", root.section("station", true), station_keys);
    read.eye_height_m = station.number("eye_height_m", 0.5, 2.5);
    read.frame_rate_hz = station.number("frame_rate_hz", 5.0, 500.0);
}

}  // namespace

Result<SimulatedParameters> loadSimulatedParameters(const std::filesystem::path& path) {
    const auto file = readToml(path);
    if (!file) return tl::unexpected(file.error());
    Problems problems(path.string());
    TextBook no_texts(problems);
    TomlTable root(&*file, "", sections, problems, no_texts);
    SimulatedParameters read;
    readPointing(root.below("pointing", root.section("pointing", true), pointing_keys), read);
    readRating(root.below("rating", root.section("rating", true), rating_keys), read);
    readPreference(root.below("preference", root.section("preference", true), preference_keys), read);
    readOtherAnswers(root, read);
    if (!problems.none()) return tl::unexpected(problems.sorted().front());
    return read;
}

}  // namespace deixis::studies
