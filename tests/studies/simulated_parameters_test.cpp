// The file of a simulated participant's parameters.
#include <doctest/doctest.h>

#include <filesystem>

#include "core/files.hpp"
#include "paths.hpp"
#include "studies/simulation/simulated_participant.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

const std::filesystem::path shipped_file =
    deixis::tests::sourceDir() / "assets/data/simulated_participant.toml";

/// The error of the shipped file with one thing changed.
std::string changed(const std::string& from, const std::string& to) {
    auto text = readFile(shipped_file);
    REQUIRE(text.has_value());
    REQUIRE(text->find(from) != std::string::npos);
    text->replace(text->find(from), from.size(), to);
    const auto path = std::filesystem::temp_directory_path() / "deixis_simulated_parameters.toml";
    REQUIRE(writeFile(path, *text).has_value());
    const auto read = loadSimulatedParameters(path);
    REQUIRE_FALSE(read.has_value());
    return read.error().text();
}

bool says(const std::string& error, const char* what) {
    return error.find(what) != std::string::npos;
}

}  // namespace

TEST_SUITE("studies/simulated_parameters") {
    TEST_CASE("the parameters that ship are the defaults") {
        const auto read = loadSimulatedParameters(shipped_file);
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        const SimulatedParameters defaults;
        CHECK(read->observer.reading == defaults.observer.reading);
        const auto numbers = [](const SimulatedParameters& p) {
            return std::vector<double>{p.observer.noise_rad,
                                       p.pointing_noise_between,
                                       p.observer.lapse_rate,
                                       p.observer.eye_line_share,
                                       p.observer.visual_weight,
                                       p.elevation_bias_deg,
                                       p.rating_base,
                                       p.rating_profile_weight,
                                       p.rating_participation_weight,
                                       p.rating_steadiness_weight,
                                       p.profile_abrupt,
                                       p.profile_smooth,
                                       p.participation_deg,
                                       p.steady_speed_m_s,
                                       p.unsteady_speed_m_s,
                                       p.rating_bias_between,
                                       p.rating_noise_within,
                                       p.preference_tie_zone,
                                       p.preference_clear_zone,
                                       p.confidence_margin_deg,
                                       p.confidence_noise_within,
                                       p.attention_lapse_rate,
                                       p.questionnaire_bias_between,
                                       p.questionnaire_noise_within,
                                       p.reaction_mean_s,
                                       p.reaction_sd_s,
                                       p.eye_height_m,
                                       p.frame_rate_hz};
        };
        CHECK(numbers(*read) == numbers(defaults));
    }

    TEST_CASE(
        "a parameter file with an unknown ray or key, or a missing one, is rejected with line and key") {
        const std::string ray = changed("ray = \"two-cue\"", "ray = \"nose\"");
        CHECK(says(ray, "pointing.ray"));
        CHECK(says(ray, "nose"));
        CHECK(says(ray, "two-cue, arm-finger, eye-fingertip"));
        CHECK(says(ray, ".toml:9"));
        CHECK(says(changed("lapse_rate", "lapses"), "lapse_rate"));
        CHECK(says(changed("margin_deg", "margin"), "confidence.margin"));
        CHECK(says(changed("[station]", "[stations]"), "station"));
        CHECK_FALSE(loadSimulatedParameters("/no/such/file.toml").has_value());
    }

    TEST_CASE("limits that exclude each other are rejected: smooth below abrupt, clear below no preference") {
        CHECK(says(changed("profile_smooth = 1.4", "profile_smooth = 1.0"), "profile_abrupt"));
        CHECK(says(changed("unsteady_speed_m_s = 0.22", "unsteady_speed_m_s = 0.04"), "steady_speed_m_s"));
        CHECK(says(changed("clear_zone = 1.2", "clear_zone = 0.3"), "tie_zone"));
    }
}
