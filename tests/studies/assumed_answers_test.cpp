// Answers drawn from assumed effects, and the file that assumes them.
#include "studies/simulation/assumed_answers.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "core/files.hpp"
#include "core/random.hpp"
#include "paths.hpp"
#include "studies/plan_fixture.hpp"
#include "studies/study_file/answer_curve.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

const std::filesystem::path shipped_effects =
    deixis::tests::sourceDir() / "assets/data/effects/pointing2023.toml";

/// With the systems of the shipped study.
Study paperStudy() {
    Study study = plan_fixture::pointing();
    const std::map<std::string, std::string> names{{"demonstration-nn", "gt-nn"},
                                                   {"direct", "amp-pfnn-8"},
                                                   {"stiff", "amp-base"},
                                                   {"drifting", "moglow"}};
    for (SystemSource& system : study.systems) system.name = names.at(system.name);
    for (Stage& stage : study.stages)
        for (std::string& system : stage.design.systems) system = names.at(system);
    return study;
}

/// The error of the shipped file with one thing changed.
std::string changedEffects(const std::string& from, const std::string& to) {
    auto text = readFile(shipped_effects);
    REQUIRE(text.has_value());
    REQUIRE(text->find(from) != std::string::npos);
    text->replace(text->find(from), from.size(), to);
    const auto path = std::filesystem::temp_directory_path() / "deixis_assumed_effects.toml";
    REQUIRE(writeFile(path, *text).has_value());
    const auto read = loadAssumedEffects(path, paperStudy());
    REQUIRE_FALSE(read.has_value());
    return read.error().text();
}

bool tells(const std::string& error, const std::string& what) {
    INFO(error);
    return error.find(what) != std::string::npos;
}

std::vector<StudyPlan> plansOf(const Study& study, int participants) {
    std::vector<StudyPlan> out;
    const auto targets = plan_fixture::targetsFor(study, 100);
    for (int number = 1; number <= participants; ++number)
        out.push_back(buildPlan(study, targets, "S1", number, {}).value());
    return out;
}

}  // namespace

TEST_SUITE("studies/assumed_answers") {
    TEST_CASE("The file that ships reads, and what is written of it reads back as the same.") {
        const Study study = paperStudy();
        const auto read = loadAssumedEffects(shipped_effects, study);
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        CHECK(read->accuracy->systems.at("amp-pfnn-8") == 0.955);
        CHECK(read->ratings.at("naturalness").noise_sd == 0.8);
        const auto path = std::filesystem::temp_directory_path() / "deixis_effects_again.toml";
        REQUIRE(writeFile(path, assumedEffectsToml(*read)).has_value());
        const auto again = loadAssumedEffects(path, study);
        REQUIRE(again.has_value());
        CHECK(assumedEffectsToml(*again) == assumedEffectsToml(*read));
    }

    TEST_CASE("Errors of the file name file, line and key, what was found and what was expected.") {
        const std::string missing = changedEffects("item_sd = 0.5 ", "itemsd = 0.5 ");
        CHECK(tells(missing, "deixis_assumed_effects.toml:10: accuracy.itemsd"));
        CHECK(tells(missing, "Did you mean item_sd?"));
        CHECK(tells(
            changedEffects("amp-pfnn-8 = 0.955", "amp-pfnn-8 = 0.999"),
            ":15: accuracy.systems.amp-pfnn-8: found 0.999, expected a share of correct choices above"));
        CHECK(tells(changedEffects("amp-pfnn-8 = 3.57", "amp-pfnn-8 = 5"),
                    "rating.naturalness.systems.amp-pfnn-8: found 5, expected a mean above 1 and below 5"));
        CHECK(tells(changedEffects("amp-base = 2.93", ""), "rating.naturalness.systems.amp-base: missing"));
        CHECK(tells(changedEffects("noise_sd = 0.8", "noise_sd = 0"), "expected a number from 0.01"));
        CHECK(tells(changedEffects("[rating.naturalness]", "[rating.liking]"), "rating.liking: unknown key"));
        CHECK(tells(changedEffects("[accuracy] ", "[preference]\n[accuracy] "),
                    "no preference where the study compares no pairs"));
    }

    TEST_CASE("The mean answers of many studies are those assumed, at either end of the scale too.") {
        const Study study = paperStudy();
        auto effects = loadAssumedEffects(shipped_effects, study).value();
        effects.ratings["naturalness"].systems["amp-pfnn-8"] = 4.8;
        effects.accuracy->layouts = {{"across", 0.4}, {"side-by-side", -0.6}};
        const auto plans = plansOf(study, 30);
        const AssumedAnswers answers(study, effects, plans);
        std::map<std::pair<std::size_t, std::string>, std::vector<double>> means;  // of each study
        std::vector<double> values(answers.planned().size());
        constexpr int studies = 300;
        for (int k = 0; k < studies; ++k) {
            answers.draw(deriveSeed(99, std::to_string(k)), values);
            std::map<std::pair<std::size_t, std::string>, std::pair<double, int>> sums;
            for (std::size_t i = 0; i < values.size(); ++i) {
                const PlannedAnswer& one = answers.planned()[i];
                auto& [sum, n] = sums[{one.measure, one.trial->stimuli[0].system}];
                sum += values[i];
                ++n;
            }
            for (const auto& [key, sum] : sums) means[key].push_back(sum.first / sum.second);
        }
        REQUIRE(means.size() == 8);
        for (const auto& [key, of_studies] : means) {
            double sum = 0.0, squares = 0.0;
            for (const double mean : of_studies) {
                sum += mean;
                squares += mean * mean;
            }
            const double mean = sum / studies;
            const double se = std::sqrt((squares / studies - mean * mean) / studies);
            const double expected = key.first == 0 ? effects.accuracy->systems.at(key.second)
                                                   : effects.ratings["naturalness"].systems.at(key.second);
            const std::string& system = key.second;
            INFO(system << ": " << mean << " with standard error " << se);
            CHECK(std::abs(mean - expected) < 4.0 * se);
        }
    }

    TEST_CASE("A smaller study is the beginning of a larger one of the same seed.") {
        const Study study = paperStudy();
        const auto effects = loadAssumedEffects(shipped_effects, study).value();
        const auto few = plansOf(study, 3);
        const auto many = plansOf(study, 6);
        const AssumedAnswers of_few(study, effects, few);
        const AssumedAnswers of_many(study, effects, many);
        std::vector<double> a(of_few.planned().size()), b(of_many.planned().size());
        REQUIRE(a.size() == 180);  // 3 x (20 ratings and 40 choices); practice is not among them
        of_few.draw(5, a);
        of_many.draw(5, b);
        CHECK(std::equal(a.begin(), a.end(), b.begin()));
        of_many.draw(6, b);
        CHECK_FALSE(std::equal(a.begin(), a.end(), b.begin()));
    }

    TEST_CASE("A curve's means, variances and covariances are those of numbers drawn behind it.") {
        Random random(17);
        for (const AnswerCurve& curve : {AnswerCurve::choice(0.1, 3), AnswerCurve::scale(1, 5)}) {
            const double location = curve.high() > 1.0 ? 3.8 : 0.9, sd = 1.1, shared = 0.7;
            const double rest = std::sqrt(sd * sd - shared * shared);
            const auto answer = [&](double behind) {
                if (curve.high() > 1.0) return curve.step(behind);
                return random.uniform() < curve.chance(behind) ? 1.0 : 0.0;
            };
            constexpr int draws = 200'000;
            double sum = 0.0, squares = 0.0, products = 0.0;
            for (int i = 0; i < draws; ++i) {
                const double both = location + shared * random.normal();
                const double a = answer(both + rest * random.normal());
                const double b = answer(both + rest * random.normal());
                sum += a;
                squares += a * a;
                products += a * b;
            }
            const double mean = sum / draws;
            CHECK(curve.mean(location, sd) == doctest::Approx(mean).epsilon(0.01));
            CHECK(curve.variance(location, sd) ==
                  doctest::Approx(squares / draws - mean * mean).epsilon(0.02));
            CHECK(curve.covariance(location, sd, shared) ==
                  doctest::Approx(products / draws - mean * mean).epsilon(0.08));
            const double shifts[] = {0.5, -0.5};
            const double at = curve.location(0.8 * curve.high(), sd, shifts).value();
            CHECK(0.5 * (curve.mean(at + 0.5, sd) + curve.mean(at - 0.5, sd)) ==
                  doctest::Approx(0.8 * curve.high()));
            CHECK_FALSE(curve.location(curve.high(), sd, shifts).has_value());
        }
    }
}
