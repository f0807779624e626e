// Systems of an evaluation against each other, by answers that NumPy and SciPy gave.
#include <doctest/doctest.h>

#include <fmt/format.h>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "oracles.hpp"
#include "results/evaluation/evaluation.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using namespace deixis::tests;

namespace {

Evaluation evaluatedClips(const nlohmann::json& clips) {
    EvaluationInput input;
    for (const auto& clip : clips) {
        MeasuredClip& made = input.clips.emplace_back();
        made.system = clip["system"].get<std::string>();
        made.target_id = "G" + std::to_string(input.clips.size());  // places pair the clips, not names
        made.target = {clip["target"][0], clip["target"][1], clip["target"][2]};
        if (!clip["accuracy"].is_null())
            made.accuracy = motion::PointingAccuracy{clip["accuracy"].get<double>(),
                                                     radiansFromDegrees(clip["error_deg"].get<double>()), 3};
    }
    input.training = {{1.0, 1.0, 2.0}, {1.2, 1.3, 2.1}, {-1.0, 0.8, 1.9}, {-1.3, 1.1, 2.2}};
    input.mean_shift_bandwidth = 1.0;
    auto evaluation = evaluate(std::move(input));
    REQUIRE_MESSAGE(evaluation, evaluation.error().text());
    return std::move(*evaluation);
}

}  // namespace

TEST_SUITE("results/evaluation_pairs") {
    TEST_CASE("Differences between systems over the same targets, their tests and Holm's are SciPy's") {
        for (const auto& example : oracles("evaluation_pairs")) {
            const auto name = example["name"].get<std::string>();
            CAPTURE(name);
            const Evaluation evaluation = evaluatedClips(example["clips"]);
            const auto json = nlohmann::json::parse(evaluationJson(evaluation));
            const auto table = parseCsv(evaluationTables(evaluation)[2].second, "comparisons.csv").value();
            const auto& pairs = example["pairs"];
            REQUIRE(evaluation.comparisons.size() == pairs.size());
            REQUIRE(json["comparisons"].size() == pairs.size());
            REQUIRE(table.size() == pairs.size() + 1);
            const auto& columns = table.front().fields;
            for (std::size_t i = 0; i < pairs.size(); ++i) {
                CAPTURE(i);
                const auto& found = json["comparisons"][i];
                CHECK(found["a"] == pairs[i]["a"]);
                CHECK(found["b"] == pairs[i]["b"]);
                CHECK(found["targets"] == pairs[i]["n"]);
                const std::vector<std::pair<std::string, std::string>> names{
                    {"mean_difference", "mean_difference"},
                    {"sd", "sd"},
                    {"mean_difference_deg", "mean_difference_deg"},
                    {"typical_difference", "estimate"},
                    {"w_plus", "w_plus"},
                    {"p", "p"},
                    {"p_holm", "p_holm"}};
                for (const auto& name_pair : names) {
                    const std::string& here = name_pair.first;
                    const auto& there = pairs[i][name_pair.second];
                    INFO(here << ": found " << found[here].dump() << ", SciPy " << there.dump());
                    const std::optional<double> number =
                        found[here].is_null() ? std::optional<double>() : found[here].get<double>();
                    CHECK(close(number, there, 1e-9));
                    const auto at = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), here) -
                                                             columns.begin());
                    REQUIRE(at < columns.size());
                    const std::string& cell = table[i + 1].fields[at];
                    CHECK(cell.empty() == found[here].is_null());
                    if (!cell.empty()) CHECK(std::stod(cell) == found[here].get<double>());
                }
            }
        }
    }

    TEST_CASE("The page has a table of the pairs, and none of a single system") {
        const auto example = oracles("evaluation_pairs")[1];
        const std::string page = renderEvaluation(evaluatedClips(example["clips"]));
        const deixis::tests::XmlDocument document(page);
        CHECK(document.count("//h:h2[.='Systems compared']") == 1);
        const auto& right = example["pairs"][0];
        REQUIRE(right["b"] == "b");
        const auto cells = document.texts("//h:tr[h:th='a \u2013 b']/*");
        REQUIRE(cells.size() >= 7);
        CHECK(cells[1] == right["n"].dump());
        CHECK(cells[2] == fmt::format("{:.3f}", right["mean_difference"].get<double>()));
        CHECK(cells[3] == fmt::format("{:.3f}", right["sd"].get<double>()));
        CHECK(cells[4] == fmt::format("{:.1f}", right["mean_difference_deg"].get<double>()));
        CHECK(cells[cells.size() - 2] == fmt::format("{:.3f}", right["p"].get<double>()));
        CHECK(cells.back() == fmt::format("{:.3f}", right["p_holm"].get<double>()));
        // No target in common.
        const auto none = document.texts("//h:tr[h:th='a \u2013 elsewhere']/*");
        REQUIRE(none.size() == cells.size());
        CHECK(none[1] == "0");
        CHECK(none[2] == "\u2013");
        nlohmann::json alone = nlohmann::json::array();
        for (const auto& clip : example["clips"])
            if (clip["system"] == "a") alone.push_back(clip);
        const Evaluation one = evaluatedClips(alone);
        CHECK(one.comparisons.empty());
        CHECK_FALSE(contains(renderEvaluation(one), "Systems compared"));
    }
}
