// Power from the command line.
#include <map>

#include "program.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

const std::string shipped_effect_file = (sourceDir() / "assets/data/effects/pointing2023.toml").string();

}  // namespace

TEST_SUITE("app/power") {
    TEST_CASE(
        "The power of the study that ships is told as text, JSON and CSV, alike for any number of threads.") {
        const Scratch scratch;
        const auto run = [&](const std::string& name, const std::string& more) {
            return program(
                "power pointing2023 --effect pointing2023 --participants 10,24 --studies 60 --goal 0.8 "
                "--json " +
                (scratch / (name + ".json")) + " --csv " + (scratch / (name + ".csv")) + more);
        };
        const auto one = run("one", " --threads 1");
        INFO(one.err);
        REQUIRE(one.status == 0);
        CHECK(one.err.empty());  // no progress where stderr is no terminal
        CHECK(one.out.find("no evidence about people") != std::string::npos);
        CHECK(one.out.find("accuracy: pairs of systems (6 tests)") != std::string::npos);
        REQUIRE(run("two", " --threads 3").status == 0);
        CHECK(slurp(scratch / "one.json") == slurp(scratch / "two.json"));
        CHECK(slurp(scratch / "one.csv") == slurp(scratch / "two.csv"));
        REQUIRE(run("other", " --seed 2").status == 0);
        CHECK(slurp(scratch / "one.json") != slurp(scratch / "other.json"));

        const json power = json::parse(slurp(scratch / "one.json"));
        CHECK(power["contrasts"].size() == 16);  // 6 pairs in each of 2 measures, 4 systems by layout
        for (const auto& contrast : power["contrasts"]) {
            REQUIRE(contrast["power"].size() == 2);
            for (const auto& at : contrast["power"]) {
                CHECK(at["studies"] == at["a_higher"].get<int>() + at["b_higher"].get<int>());
                CHECK(at["estimate"].get<double>() == doctest::Approx(at["studies"].get<double>() / 60.0));
                CHECK(at["lower"] <= at["estimate"]);
                CHECK(at["upper"] >= at["estimate"]);
            }
            const bool plain = contrast["measure"] == "accuracy" && contrast["a"] == "moglow" &&
                               contrast["b"] == "amp-pfnn-8";
            if (plain) CHECK(contrast["participants_for_goal"] == 24);
            // Layouts are assumed not to differ.
            if (!contrast["system"].is_null()) CHECK(contrast["participants_for_goal"].is_null());
        }
    }

    TEST_CASE("Simulated studies with the paper's 39 participants and its means show the paper's pattern.") {
        // Deichler et al. 2023, 3.1: all pairs differ at 0.01 after Holm's correction but GT-nn and AMP-base
        // in accuracy; the layouts differ for no system. The paper prints no spreads: these are small enough
        // for the smallest difference that it found, 0.32 steps of naturalness.
        const Scratch scratch;
        std::string effects = slurp(shipped_effect_file);
        const auto set = [&](const std::string& from, const std::string& to) {
            const auto at = effects.find(from);
            REQUIRE(at != std::string::npos);
            effects.replace(at, from.size(), to);
        };
        const auto ratings = effects.find("[rating.naturalness]");
        REQUIRE(ratings != std::string::npos);
        std::string of_ratings = effects.substr(ratings);
        effects.resize(ratings);
        std::swap(effects, of_ratings);
        set("participant_system_sd = 0.5", "participant_system_sd = 0.1");
        set("noise_sd = 0.8", "noise_sd = 0.5");
        spill(scratch / "effects.toml", of_ratings + effects);
        const auto done = program("power pointing2023 --participants 39 --studies 100 --effect " +
                                  (scratch / "effects.toml") + " --json " + (scratch / "power.json"));
        INFO(done.err);
        REQUIRE(done.status == 0);
        const std::map<std::string, std::map<std::string, double>> printed{
            {"accuracy", {{"gt-nn", 0.856}, {"amp-pfnn-8", 0.955}, {"amp-base", 0.830}, {"moglow", 0.459}}},
            {"naturalness", {{"gt-nn", 4.01}, {"amp-pfnn-8", 3.57}, {"amp-base", 2.93}, {"moglow", 2.61}}}};
        const json power = json::parse(slurp(scratch / "power.json"));
        int pairs = 0;
        for (const auto& contrast : power["contrasts"]) {
            CAPTURE(contrast.dump());
            const auto& found = contrast["power"][0];
            if (!contrast["system"].is_null()) {
                CHECK(found["studies"] <= 5);  // layouts
                continue;
            }
            ++pairs;
            const auto& means = printed.at(contrast["measure"]);
            const bool a_higher = means.at(contrast["a"]) > means.at(contrast["b"]);
            if (contrast["measure"] == "accuracy" && contrast["a"] == "gt-nn" && contrast["b"] == "amp-base")
                CHECK(found["studies"] < 50);
            else
                CHECK(found[a_higher ? "a_higher" : "b_higher"] >= 80);
        }
        CHECK(pairs == 12);
    }

    TEST_CASE("Effects estimated from a database are written to a file that gives the same power.") {
        const Scratch scratch{WithSharedStimuli{}};
        REQUIRE(
            program("simulate pointing2023-stand-ins --participants 12 --db " + (scratch / "pilot.sqlite"))
                .status == 0);
        const std::string rest = " --participants 12 --studies 40 --json ";
        const auto from = program("power pointing2023-stand-ins --from " + (scratch / "pilot.sqlite") + rest +
                                  (scratch / "from.json") + " --save-effects " + (scratch / "effects.toml"));
        INFO(from.err);
        REQUIRE(from.status == 0);
        CHECK(from.out.find("estimated from 12 participants") != std::string::npos);
        CHECK(from.out.find("simulated participants are among them") != std::string::npos);
        const auto again = program("power pointing2023-stand-ins --effect " + (scratch / "effects.toml") +
                                   rest + (scratch / "again.json"));
        INFO(again.err);
        REQUIRE(again.status == 0);
        CHECK(slurp(scratch / "from.json") == slurp(scratch / "again.json"));
        CHECK(from.out.find("lapse_rate is left at 0") != std::string::npos);

        REQUIRE(
            program("simulate genea-pairwise --participants 14 --db " + (scratch / "pairs.sqlite")).status ==
            0);
        const auto pairs =
            program("power genea-pairwise --from " + (scratch / "pairs.sqlite") +
                    " --participants 14 --studies 40 --save-effects " + (scratch / "pairs.toml"));
        INFO(pairs.err);
        REQUIRE(pairs.status == 0);
        CHECK(pairs.out.find("preference: noise_sd is set to 1") != std::string::npos);
        CHECK(pairs.out.find("preference: pairs of systems (6 tests)") != std::string::npos);
        CHECK(slurp(scratch / "pairs.toml").find("[preference.systems]") != std::string::npos);
        const auto same = program("power genea-pairwise --effect " + (scratch / "pairs.toml") +
                                  " --participants 14 --studies 40");
        REQUIRE(same.status == 0);
        CHECK(pairs.out.ends_with(same.out));
    }

    TEST_CASE("Groups of a pilot are estimated and tested, and a level that the study lacks is named.") {
        const Scratch scratch{WithSharedStimuli{}};
        REQUIRE(program("simulate distractor-distance --participants 8 --db " + (scratch / "pilot.sqlite"))
                    .status == 0);
        const std::string rest = " --participants 8 --studies 20 --json ";
        const auto from = program("power distractor-distance --from " + (scratch / "pilot.sqlite") + rest +
                                  (scratch / "from.json") + " --save-effects " + (scratch / "effects.toml"));
        INFO(from.err);
        REQUIRE(from.status == 0);
        CHECK(from.out.find("accuracy: training (5 tests)") != std::string::npos);
        const std::string effects = slurp(scratch / "effects.toml");
        CHECK(effects.find("[accuracy.groups.training]") != std::string::npos);
        REQUIRE(program("power distractor-distance --effect " + (scratch / "effects.toml") + rest +
                        (scratch / "again.json"))
                    .status == 0);
        CHECK(slurp(scratch / "from.json") == slurp(scratch / "again.json"));
        spill(scratch / "effects.toml", replaced(effects, "no-feedback", "never"));
        CHECK_FAILS_SAYING(program("power distractor-distance --effect " + (scratch / "effects.toml")),
                           "accuracy.groups.training.never: unknown key", "feedback, no-feedback");
    }

    TEST_CASE("What is wrong with the effects or the options is told in one line.") {
        const Scratch scratch;
        spill(scratch / "effects.toml",
              replaced(slurp(shipped_effect_file), "amp-base = 0.830", "amp-bas = 0.830"));
        CHECK_FAILS_SAYING(program("power pointing2023 --effect " + (scratch / "effects.toml")),
                           "effects.toml:16: accuracy.systems.amp-bas", "Did you mean amp-base?");
        CHECK_FAILS_SAYING(program("power pointing2023 --effect nosuch"), "effects/nosuch.toml");
        CHECK_FAILS_SAYING(program("power pointing2023 --from " + (scratch / "nosuch.sqlite")),
                           "nosuch.sqlite");
        CHECK(program("power pointing2023").status == 2);
        CHECK(program("power pointing2023 --effect pointing2023 --search").status == 2);
        CHECK(program("power pointing2023 --effect pointing2023 --participants 1").status == 2);
    }
}
