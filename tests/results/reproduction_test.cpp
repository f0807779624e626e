// The paper's results beside ours: what agrees is worked out by hand, the rank-sum tests are R's.
#include "results/reproduction/reproduction.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "page_text.hpp"
#include "paths.hpp"
#include "specifications.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::pageText;
using nlohmann::json;

namespace {

GridFigures::System measured(const char* system, double mean, double rho,
                             std::vector<double> accuracies = {}) {
    GridFigures::System out;
    out.system = system;
    out.mean = mean;
    out.density_rho = rho;
    out.accuracies = std::move(accuracies);
    return out;
}

/// All as the paper has it, with nine points.
GridFigures asInThePaper() {
    // Of the one cluster's two are outliers: R's quantiles are .6 and .615, so that the fence is at .5775.
    const std::vector<double> two_outliers{0.62, 0.61, 0.6, 0.615, 0.612, 0.4, 0.607, 0.618, 0.55};
    std::vector<double> one_outlier = two_outliers, none = two_outliers;
    one_outlier[5] = none[5] = none[8] = none[2] = 0.61;
    return {
        "test grid",
        "grid.json",
        9,
        104,
        {measured("gt-nn", 0.5, -0.1), measured("moglow", 0.46, 0.7), measured("amp-no-runtime", 0.56, 0.0),
         measured("amp-base", 0.59, -0.12), measured("amp-pfnn-1", 0.6, 0.1, two_outliers),
         measured("amp-pfnn-3", 0.61, -0.15, one_outlier), measured("amp-pfnn-8", 0.62, 0.02, none)}};
}

StudyFigures peopleAsInThePaper() {
    StudyFigures out{.participants_kind = "people", .file = "study.json", .participants = 39, .alpha = 0.01};
    for (const auto& [system, accuracy, naturalness] : {std::tuple{"gt-nn", 0.85, 4.0},
                                                        {"moglow", 0.45, 2.6},
                                                        {"amp-base", 0.83, 2.9},
                                                        {"amp-pfnn-8", 0.95, 3.5}}) {
        out.scores.push_back({system, "accuracy", accuracy, accuracy - 0.05, accuracy + 0.05});
        out.scores.push_back({system, "naturalness", naturalness, {}, {}});
    }
    const std::vector<std::string> systems{"amp-base", "amp-pfnn-8", "gt-nn", "moglow"};
    for (const char* measure : {"accuracy", "naturalness"})
        for (std::size_t a = 0; a < systems.size(); ++a)
            for (std::size_t b = a + 1; b < systems.size(); ++b)
                out.pairs.push_back({measure, systems[b], systems[a], true});
    out.pairs[1].significant = false;  // amp-base and gt-nn in accuracy
    out.layout_tests = 4;
    return out;
}

std::string textOf(const ReproductionInput& input) {
    const std::string page = renderReproduction(input);
    return pageText(page.substr(page.find("<h1"), page.rfind("<script")));
}

}  // namespace

TEST_SUITE("results/reproduction") {
    TEST_CASE("what is as in the paper agrees, and what is not does not") {
        ReproductionInput input;
        input.grids = {asInThePaper()};
        input.studies = {peopleAsInThePaper()};
        const std::string same = textOf(input);
        CAPTURE(same);
        CHECK(contains(same, "looked at 10 times"));
        CHECK(contains(same, "10 came out here, too"));
        CHECK_FALSE(contains(same, "Differs"));
        CHECK_FALSE(contains(same, "Why not."));
        CHECK(contains(same, "amp-pfnn-8 0.62 > amp-base 0.59 > amp-no-runtime 0.56 > moglow 0.46"));
        CHECK(contains(same, "Agrees, test grid: 1: 2, 3: 1, 8: 0 of 9 points"));
        CHECK(contains(same, "Agrees, people: 5 of 6 at 0.01; not gt-nn / amp-base"));
        CHECK_FALSE(contains(same, "simulated"));

        const auto differs = [&](const char* line) {
            const std::string text = textOf(input);
            CAPTURE(text);
            CHECK(contains(text, std::string("Differs, ") + line));
            CHECK(contains(text, "9 came out here, too"));
            CHECK(contains(text, "Why not."));
        };
        SUBCASE("two systems the other way round") {
            input.grids[0].systems[2].mean = 0.45;
            differs("test grid: amp-pfnn-8 0.620 > amp-base 0.590 > moglow 0.460 > amp-no-runtime 0.450");
        }
        SUBCASE("equal is no order") {
            input.grids[0].systems[2].mean = 0.46;
            differs("test grid: amp-pfnn-8 0.620 > amp-base 0.590 > amp-no-runtime 0.460 > moglow 0.460");
        }
        SUBCASE("a correlation that is strong") {
            input.grids[0].systems[3].density_rho = -0.3;
            differs("test grid: moglow 0.70, others at most 0.30");
        }
        SUBCASE("another pair that does not differ") {
            input.studies[0].pairs[1].significant = true;
            input.studies[0].pairs[2].significant = false;
            differs("people: 5 of 6 at 0.01; not moglow / amp-base");
        }
        SUBCASE("layouts that differ") {
            input.studies[0].layouts_that_differ = 1;
            differs("people: 1 of 4 at 0.01");
        }
    }

    TEST_CASE("what cannot be looked at is no claim that failed") {
        ReproductionInput input;
        input.grids = {{"few", "few.json", 9, 104, {measured("amp-base", 0.5, 0.0)}}};
        const std::string text = textOf(input);
        CHECK(contains(text, "looked at 0 times"));
        CHECK_FALSE(contains(text, "Differs"));
    }

    TEST_CASE("hands are compared as by R's wilcox.test and p.adjust") {
        // wilcox.test(l, r, exact = TRUE): p .1014 and .1375; p.adjust(p, "holm"): .2028 both
        ReproductionInput input;
        input.grids = {asInThePaper()};
        const double left[][2]{{0.541, 1.5}, {0.55, 1.72},  {0.539, 1.41},
                               {0.56, 1.66}, {0.532, 1.58}, {0.547, 1.49}};
        const double right[][2]{{0.552, 1.61}, {0.561, 1.7}, {0.538, 1.52}, {0.57, 1.75},
                                {0.558, 1.68}, {0.549, 1.8}, {0.566, 1.55}};
        for (const auto& one : left) input.demonstrations.push_back({true, one[0], one[1]});
        for (const auto& one : right) input.demonstrations.push_back({false, one[0], one[1]});
        const std::string text = textOf(input);
        CAPTURE(text);
        CHECK(contains(text, "Accuracy (Eq. 2)|6|7|0.544|0.558|0.101|0.203|"));
        CHECK(contains(text, "Peak speed of the hand (m/s)|6|7|1.540|1.680|0.138|0.203|"));
        CHECK(contains(text, "Agrees, demonstrations: accuracy (Eq. 2): p = 0.203"));
    }

    TEST_CASE("the page is well-formed, and its figures have the paper's means and ours") {
        ReproductionInput input;
        input.grids = {asInThePaper()};
        input.studies = {peopleAsInThePaper()};
        input.studies[0].participants_kind = "two-cue <simulated>";
        input.studies[0].synthetic = true;
        input.trained = {{.system = "moglow", .numbers = 2'000'000, .bytes = 4'000'000, .arm_error_m = 0.14},
                         {.system = "amp-pfnn-8",
                          .numbers = 400'000,
                          .bytes = 800'000,
                          .rewarded = "forearm",
                          .reward = 0.6,
                          .jerk_ratio = 1.1,
                          .at_rest = 0.99,
                          .arm_error_m = 0.085}};
        input.pages = {"grid.html"};
        const std::string page = renderReproduction(input);
        CHECK(deixis::tests::XmlDocument(page).count("//h:h2") == 5);
        CHECK(contains(pageText(page), "all participants are simulated"));
        CHECK(contains(pageText(page),
                       "Agrees, weights: moglow 2.0 million numbers, the largest policies 0.40 million"));
        const auto drawn = deixis::tests::specificationsOf(page);
        REQUIRE(drawn.contains("grid-1"));
        REQUIRE(drawn.contains("study-accuracy"));
        int paper = 0;
        for (const json& one : deixis::tests::valuesWith(drawn.at("grid-1"), "tip"))
            paper += contains(one["tip"].get<std::string>(), " in the paper: mean 0.") ? 1 : 0;
        CHECK(paper == 4);  // the paper prints four means
        CHECK(deixis::tests::valuesWith(drawn.at("study-accuracy"), "low").size() >= 4);
        REQUIRE(drawn.contains("imitation"));
        const auto points = deixis::tests::valuesWith(drawn.at("imitation"), "name");
        REQUIRE(points.size() >= 2);
        CHECK(points[1]["x"] == 8.5);
        CHECK(points[1]["y"] == 0.62);
        CHECK(contains(pageText(page), "amp-pfnn-8|400000|800000|forearm|0.600|1.10|99.0"));
    }

    TEST_CASE("the paper's means are those that power assumes") {
        ReproductionInput input;
        input.studies = {peopleAsInThePaper()};
        const std::string page = textOf(input);
        std::istringstream effects(
            deixis::readFile(deixis::tests::sourceDir() / "assets/data/effects/pointing2023.toml").value());
        std::string line, section;
        int means = 0;
        while (std::getline(effects, line)) {
            if (line.starts_with('[')) section = line.substr(0, line.find(']'));
            const std::size_t equals = line.find(" = ");
            if (!section.ends_with(".systems") || equals == std::string::npos) continue;
            const double mean = std::stod(line.substr(equals + 3));
            const std::string cell = section == "[accuracy.systems"
                                         ? fmt::format("{:.1f}\u00a0%", 100.0 * mean)
                                         : fmt::format("{:.2f}", mean);
            CHECK_MESSAGE(contains(page, line.substr(0, equals) + "|" + cell + "|"), line);
            ++means;
        }
        CHECK(means == 8);
    }

    TEST_CASE("files of another kind are rejected by name") {
        const fixtures::Folder folder;
        const auto file = folder / "some.json";
        REQUIRE(writeFile(file, R"({"format": "something"})"));
        const auto grid = readGridFigures("g", file);
        REQUIRE_FALSE(grid);
        CHECK(contains(grid.error().text(), "some.json: is no objective evaluation"));
        CHECK(contains(grid.error().text(), "deixis evaluate"));
        const auto study = readStudyFigures("s", file);
        REQUIRE_FALSE(study);
        CHECK(contains(study.error().text(), "deixis report"));
        REQUIRE(writeFile(file, R"({"format": "deixis-evaluation", "targets": [], "training": {"targets": []},
                                    "systems": [{"system": 7}]})"));
        const auto damaged = readGridFigures("g", file);
        REQUIRE_FALSE(damaged);
        CHECK(contains(damaged.error().text(), "is damaged"));
        CHECK_FALSE(readGridFigures("g", folder / "none.json"));
        REQUIRE(writeFile(file, "clip,hand\na,left\n"));
        const auto table = readDemonstrationFigures(file);
        REQUIRE_FALSE(table);
        CHECK(contains(table.error().text(), "max_reward"));
        REQUIRE(writeFile(file, "hand,max_reward,peak_speed_m_s\nleft,high,1\n"));
        const auto number = readDemonstrationFigures(file);
        REQUIRE_FALSE(number);
        CHECK(contains(number.error().text(), "some.json:2"));
    }
}
