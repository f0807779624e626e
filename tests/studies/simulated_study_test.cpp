// Whole simulated studies, from file to answers, with the built-in systems.
#include <doctest/doctest.h>

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "simulated_run.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

struct Tally {
    double ratings = 0.0;
    int rated = 0;
    int correct = 0;
    int chosen = 0;

    [[nodiscard]] double naturalness() const { return ratings / rated; }
    [[nodiscard]] double accuracy() const { return static_cast<double>(correct) / chosen; }
};

/// Thirty targets, each shown by the systems in both stages; with fewer to be rated, no game.
std::string thirtyTargets(const std::vector<std::string>& systems, int ratings = 30) {
    std::string text = R"(
[study]
name = "thirty"
title = "Thirty targets"
seed = 5
[targets]
count = 60
height_m = [0.1, 2.1]
arc_deg = [-85.0, 85.0]
radius_m = [1.9, 2.2]
[[distances]]
name = "near"
distance_m = [0.2, 0.4]
distractors = 2
[[layouts]]
name = "across"
viewer_m = [0.0, 3.4]
heading_deg = 180.0
[[layouts]]
name = "side-by-side"
viewer_m = [-0.75, -0.25]
heading_deg = 10.0
[[stages]]
name = "naturalness"
kind = "rating"
items = 30
layouts = ["across"]
question = "How natural?"
scale = {low = 1, high = 5}
[[stages]]
name = "game"
kind = "referential-game"
items = 30
layouts = ["across", "side-by-side"]
distances = ["near"]
question = "Which ball?"
)";
    const std::string items = "items = 30";  // of the ratings, which come first
    text.replace(text.find(items), items.size(), fmt::format("items = {}", ratings));
    if (ratings < 30) text = text.substr(0, text.find("[[stages]]\nname = \"game\""));
    for (const std::string& system : systems)
        text += fmt::format("[[systems]]\nname = \"{0}\"\ngenerator = \"{0}\"\n", system);
    return text;
}

std::map<std::string, Tally> tallies(const Prepared& prepared, const SimulatedParameters& parameters,
                                     int participants) {
    std::map<std::string, Tally> found;
    for (int person = 1; person <= participants; ++person) {
        const Outcome outcome = simulate(prepared, static_cast<std::uint64_t>(person), parameters);
        CHECK(outcome.responses.size() == prepared.plan.trials.size());
        for (const Response& response : outcome.responses) {
            const Trial& trial = prepared.plan.trials[static_cast<std::size_t>(response.trial_index)];
            Tally& tally = found[trial.stimuli.at(0).system];
            if (trial.kind == StageKind::rating) {
                tally.ratings += *response.answers.at(0).value;
                ++tally.rated;
            } else {
                ++tally.chosen;
                tally.correct += response.correct() ? 1 : 0;
            }
        }
    }
    return found;
}

}  // namespace

TEST_SUITE("studies/simulated_study") {
    TEST_CASE("it goes through a study of every kind of stage and answers everything once") {
        const Prepared prepared(everyKind());
        for (const bool keyboard : {true, false}) {
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                CAPTURE(keyboard);
                CAPTURE(seed);
                const Outcome outcome = simulate(prepared, seed, {}, keyboard);
                checkWhole(prepared, outcome);
                CHECK(outcome.count(NoteKind::check_failed) <= 2);  // catch trials may be missed
                for (const Response& response : outcome.responses) {
                    const Trial& trial = prepared.plan.trials[static_cast<std::size_t>(response.trial_index)];
                    CAPTURE(trial.stage);
                    if (trial.check && trial.check->kind != CheckKind::catch_trial)
                        CHECK(response.check_passed == true);
                    if (trial.kind == StageKind::parallel_rating)
                        CHECK(response.answers.size() == trial.stimuli.size());
                    if (trial.stage == "before") CHECK_FALSE(response.answers.empty());
                    if (trial.stage == "game" || trial.stage == "quick-game") {
                        REQUIRE(response.answers.size() == 1);
                        CHECK(response.answers[0].question == "confidence");
                    }
                    const std::size_t plays =
                        trial.stage.rfind("rating", 0) == 0 || trial.stage == "page-steps" ? 2 : 1;
                    for (const int times : response.plays) CHECK(times == static_cast<int>(plays));
                }
            }
        }
    }

    TEST_CASE("every question has its answer: words where there is a keyboard") {
        const Prepared prepared(everyKind());
        for (const bool keyboard : {true, false}) {
            std::map<std::string, Answer> about;
            std::vector<std::string> reasons;
            for (const Response& response : simulate(prepared, 2, {}, keyboard).responses)
                for (const Answer& answer : response.answers) {
                    const std::string& stage =
                        prepared.plan.trials[static_cast<std::size_t>(response.trial_index)].stage;
                    if (stage == "before") about[answer.question] = answer;
                    if (stage == "pairs-words" && answer.question == "reasons")
                        reasons.push_back(answer.text);
                }
            CHECK(about.size() == (keyboard ? 7U : 6U));
            CHECK(about.count("words") == (keyboard ? 1U : 0U));
            CHECK(*about["age"].value >= 18.0);
            CHECK(*about["age"].value <= 99.0);
            CHECK(std::abs(*about["height"].value) <= 2.5);
            for (const std::string& words : reasons) CHECK(words == "simulated answer");
            if (!keyboard) CHECK(reasons.empty());
        }
    }

    TEST_CASE("who lapses in attention fails the checks by a number") {
        const Prepared prepared(everyKind());
        SimulatedParameters inattentive;
        inattentive.attention_lapse_rate = 1.0;
        int failed = 0;
        int warned = 0;
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Outcome outcome = simulate(prepared, seed, inattentive);
            CHECK(outcome.session == SessionOutcome::finished);
            failed += outcome.count(NoteKind::check_failed);
            warned += outcome.count(NoteKind::warned);
        }
        CHECK(failed >= 3);
        CHECK(warned >= 1);
    }

    TEST_CASE("paused again and again it goes on each time, and still answers everything once") {
        const Prepared prepared(everyKind());
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            CAPTURE(seed);
            Random chance(seed);
            int pauses = 0;
            const auto pause = [&](InputFrame& input) {
                input.pause = chance.below(300) == 0;
                input.pause_reason = PauseReason::escape;
                if (input.pause) ++pauses;
            };
            SimulatedStation station({}, prepared.avatar, seed);
            Outcome outcome;
            sit(prepared, prepared.plan, station, true, {}, outcome, pause);
            CHECK(outcome.session == SessionOutcome::finished);
            CHECK(pauses > 20);
            std::map<int, bool> answered;
            for (const Response& response : outcome.responses) {
                CHECK(answered.count(response.trial_index) == 0);
                answered[response.trial_index] = true;
            }
            for (const int left : trialsLeft(prepared.study, prepared.plan, answered)) {
                const Trial& trial = prepared.plan.trials[static_cast<std::size_t>(left)];
                CHECK(prepared.study.findStage(trial.stage)->session == 2);
            }
        }
    }

    TEST_CASE("the same seed gives the same answers at the same times, another seed others") {
        const Prepared prepared(everyKind());
        const auto told = [&prepared](std::uint64_t seed) {
            std::string text;
            for (const Response& response : simulate(prepared, seed).responses) {
                text += fmt::format("{} {} {:.17g}", response.trial_index, response.chosenPlace(),
                                    response.answered.time_s);
                for (const Answer& answer : response.answers)
                    text +=
                        fmt::format(" {} {} {}", answer.question, answer.value.value_or(-99.0), answer.text);
                text += "\n";
            }
            return text;
        };
        const std::string first = told(11);
        CHECK(first == told(11));
        CHECK(first != told(12));
    }

    TEST_CASE("it does not know the answer: with another ball as the target it chooses the same places") {
        const Prepared prepared(written(thirtyTargets({"direct"})));
        StudyPlan other = prepared.plan;
        for (Trial& trial : other.trials) {
            if (trial.kind != StageKind::game) continue;
            std::swap(trial.target, trial.distractors[0]);
            for (int& ball : trial.ball_order) ball = ball == 0 ? 1 : ball == 1 ? 0 : ball;
        }
        int correct = 0;
        int correct_other = 0;
        for (std::uint64_t seed = 1; seed <= 2; ++seed) {
            const Outcome here = simulate(prepared, seed);
            const Outcome there = simulate(prepared, other, seed);
            REQUIRE(here.responses.size() == there.responses.size());
            for (std::size_t i = 0; i < here.responses.size(); ++i) {
                CHECK(here.responses[i].chosenPlace() == there.responses[i].chosenPlace());
                CHECK(here.responses[i].answered.time_s == there.responses[i].answered.time_s);
                correct += here.responses[i].correct() ? 1 : 0;
                correct_other += there.responses[i].correct() ? 1 : 0;
            }
        }
        CHECK(correct > 5 * correct_other);
    }

    TEST_CASE(
        "over 30 targets drifting is the least accurate, and the nearest demonstration less than direct") {
        const Prepared prepared(written(thirtyTargets(motion::generatorNames())));
        auto found = tallies(prepared, {}, 3);
        REQUIRE(found.size() == 5);
        CHECK(found["drifting"].accuracy() < found["demonstration-nn"].accuracy() - 0.1);
        CHECK(found["demonstration-nn"].accuracy() < found["gp"].accuracy());
        CHECK(found["demonstration-nn"].accuracy() < found["direct"].accuracy());
        CHECK(found["demonstration-nn"].accuracy() < found["stiff"].accuracy());
    }

    // What docs/systems.md says of how each moves, whatever weight a cue is given.
    TEST_CASE("who minds one cue only finds the systems that lack it") {
        const Prepared prepared(written(thirtyTargets(motion::generatorNames(), 10)));
        const auto ratings = [&prepared](double SimulatedParameters::*cue) {
            SimulatedParameters minds;
            minds.rating_base = 1.0;
            minds.rating_profile_weight = minds.rating_participation_weight = minds.rating_steadiness_weight =
                0.0;
            minds.rating_bias_between = minds.rating_noise_within = 0.0;
            minds.*cue = 4.0;
            std::map<std::string, double> out;
            for (const auto& [system, tally] : tallies(prepared, minds, 1)) out[system] = tally.naturalness();
            return out;
        };
        auto profile = ratings(&SimulatedParameters::rating_profile_weight);
        auto participation = ratings(&SimulatedParameters::rating_participation_weight);
        auto steadiness = ratings(&SimulatedParameters::rating_steadiness_weight);
        for (const std::string human_like : {"demonstration-nn", "direct"}) {
            CAPTURE(human_like);
            CHECK(profile["stiff"] < profile[human_like] - 1.0);  // a steady speed against minimum jerk
            CHECK(participation["stiff"] < participation[human_like] - 1.0);
            CHECK(steadiness["drifting"] < steadiness[human_like] - 1.0);
        }
        CHECK(participation["stiff"] == 1.0);  // nothing but the arm moves
        CHECK(steadiness["drifting"] < steadiness["stiff"] - 1.0);
    }

    TEST_CASE("without noise it finds every target of a system that points exactly") {
        SimulatedParameters exact;
        exact.observer.noise_rad = 0.0;
        exact.observer.lapse_rate = 0.0;
        const Prepared prepared(written(thirtyTargets({"stiff"})));
        CHECK(tallies(prepared, exact, 1)["stiff"].accuracy() == 1.0);
    }

    TEST_CASE("it goes through every study that ships") {
        for (const auto& entry : std::filesystem::directory_iterator(source_tree / "assets/data/studies")) {
            if (entry.path().extension() != ".toml") continue;
            // Its systems are made from weights; that of the stand-ins is the same otherwise.
            if (entry.path().stem() == "pointing2023") continue;
            CAPTURE(entry.path().filename().string());
            const Study study = loadedStudy(entry.path());
            if (!study.targets.from_projects.empty()) continue;  // its clips are spoken: tests/app
            for (const int number : {1, 2}) {
                CAPTURE(number);
                const Prepared prepared(study, number);
                checkWhole(prepared, simulate(prepared, static_cast<std::uint64_t>(number), {}, number == 1));
            }
        }
    }
}
