// Observers fitted to a database from the command line.
#include "program.hpp"

using namespace deixis::tests;
using nlohmann::json;

TEST_SUITE("app/fit") {
    TEST_CASE("The noise, lapses and weights of simulated participants come back, for another simulation.") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string shipped = slurp(sourceDir() / "assets/data/simulated_participant.toml");
        spill(scratch / "known.toml",
              replaced(replaced(replaced(replaced(shipped, "noise_deg = 3.0", "noise_deg = 4.0"),
                                         "noise_between = 0.25", "noise_between = 0.0"),
                                "lapse_rate = 0.02", "lapse_rate = 0.1"),
                       "eye_line_share = 0.5", "eye_line_share = 0.7"));
        REQUIRE(program("simulate pointing2023-stand-ins --participants 12 --db " +
                        (scratch / "study.sqlite") + " --parameters " + (scratch / "known.toml"))
                    .status == 0);
        const auto fit = program("fit " + (scratch / "study.sqlite") + " -o " + (scratch / "observer.toml") +
                                 " --json " + (scratch / "fit.json") + " --level 0.99");
        INFO(fit.err);
        REQUIRE(fit.status == 0);
        CHECK(fit.out.find("no evidence about people") != std::string::npos);
        const json fitted = json::parse(slurp(scratch / "fit.json"));
        REQUIRE(fitted["participants"].size() == 12);
        CHECK(fitted["pooled"]["choices"] == 480);
        CHECK(fitted["choices_not_seen"] == 0);
        const auto holds = [](const json& parameter, double value) {
            return (parameter["lower"].is_null() || parameter["lower"] <= value) &&
                   (parameter["upper"].is_null() || parameter["upper"] >= value);
        };
        INFO(fit.out);
        CHECK(holds(fitted["pooled"]["noise_deg"], 4.0));
        CHECK(holds(fitted["pooled"]["lapse_rate"], 0.1));
        CHECK(holds(fitted["pooled"]["eye_line_share"], 0.7));
        CHECK(holds(fitted["pooled"]["visual_weight"], 0.5));
        CHECK(fitted["pooled"]["eye_line_share"]["lower"] > 0.3);
        CHECK_FALSE(fitted["participants"][0].contains("eye_line_share"));
        CHECK(fitted["population"]["noise_between"] < 0.4);

        const std::string observer = slurp(scratch / "observer.toml");
        CHECK(observer.find("fitted by deixis fit to " + (scratch / "study.sqlite")) != std::string::npos);
        CHECK(observer.find("noise_deg = " + fitted["population"]["noise_deg"].dump()) != std::string::npos);
        CHECK(observer.find("eye_line_share = " + fitted["pooled"]["eye_line_share"]["value"].dump()) !=
              std::string::npos);
        CHECK(program("fit " + (scratch / "study.sqlite") + " --ray arm-finger --json " +
                      (scratch / "arm.json"))
                  .status == 0);
        CHECK(json::parse(slurp(scratch / "arm.json"))["pooled"]["aic"] > fitted["pooled"]["aic"]);
        CHECK(program("simulate pointing2023-stand-ins --participants 1 --db " + (scratch / "again.sqlite") +
                      " --parameters " + (scratch / "observer.toml"))
                  .status == 0);
    }

    TEST_CASE("A database without choices, and a ray that is none, are rejected.") {
        const Scratch scratch{WithSharedStimuli{}};
        REQUIRE(
            program("simulate genea-pairwise --participants 1 --db " + (scratch / "pairs.sqlite")).status ==
            0);
        CHECK_FAILS_SAYING(program("fit " + (scratch / "pairs.sqlite")), "pairs.sqlite",
                           "no choices of a referential game");
        CHECK_FAILS_SAYING(program("fit " + (scratch / "pairs.sqlite") + " --ray nose"), "--ray", "nose");
    }
}
