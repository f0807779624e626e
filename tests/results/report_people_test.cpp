// Participants, sessions, questionnaires before and after, and response times.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "results/analysis/analysis.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using nlohmann::json;

namespace {

/// Eight people, two systems; the first four are of group "u". Everybody is 0.5 s slower under "b", and the
/// SSQ rises by 1, 2, ... 8.
ResponseTable people() {
    ResponseTable out;
    out.systems = {"a", "b"};
    out.measures = {{"ease", MeasureKind::rating, 1.0, 5.0, 0, 16}};
    out.between = {{"training", {"u", "v"}}};
    out.repeated_questionnaires = {{"before", "after"}};
    for (int p = 1; p <= 8; ++p) {
        const std::string id = "P" + std::to_string(p);
        out.groups[id]["training"] = p <= 4 ? "u" : "v";
        for (const char* system : {"a", "b"}) {
            ResponseRow row;
            row.participant = id;
            row.measure = "ease";
            row.system = system;
            row.value = 3.0;
            row.response_time_s = 1.0 + p + (row.system == "b" ? 0.5 : 0.0);
            out.rows.push_back(row);
        }
        out.scores.push_back({id, "before", "total", 10.0});
        out.scores.push_back({id, "after", "total", 10.0 + p});
        out.fields.push_back({id, "age", 20.0 + p, ""});
        out.fields.push_back({id, "gender", std::nullopt, p % 3 == 0 ? "m" : "f"});
        out.session_minutes[id] = 10.0 * p;
    }
    return out;
}

}  // namespace

TEST_SUITE("results/report_people") {
    TEST_CASE("Age, choices and session times are reported, by group too") {
        const AnalysisResult result = analyse(people());
        const json out = json::parse(analysisJson(result));
        CHECK(out["participant_fields"][0]["median"] == 24.5);
        CHECK(out["participant_fields"][0]["min"] == 21.0);
        CHECK(out["participant_fields"][0]["max"] == 28.0);
        CHECK(out["participant_fields"][1]["options"] == json({{"f", 6}, {"m", 2}}));
        CHECK(out["session_times"][0]["median_min"] == 45.0);
        CHECK(out["session_times"][1]["level"] == "u");
        CHECK(out["session_times"][1]["median_min"] == 25.0);
        CHECK(out["session_times"][2]["max_min"] == 80.0);
        const std::string page = renderReport(result);
        const tests::XmlDocument document(page);
        const auto fact = [&](const std::string& name) {
            return document.texts("//h:dt[.='" + name + "']/following-sibling::h:dd[1]");
        };
        CHECK(fact("Age") == std::vector<std::string>{"median 24.5 (21 to 28), n = 8"});
        CHECK(fact("Gender") == std::vector<std::string>{"f 6, m 2"});
        CHECK(contains(page,
                       "median 45.0 (10.0 to 80.0) minutes, n = 8; training u: median 25.0 (10.0 to 40.0)"));
    }

    TEST_CASE("A questionnaire after is compared with before, and scores and times by system and group") {
        const AnalysisResult result = analyse(people());
        // All of eight differences are positive: 2 / 2^8. Of 70 ways to part eight into two fours one is the
        // highest, one the lowest.
        REQUIRE(result.score_changes.size() == 1);
        CHECK(result.score_changes[0].test.p_two_sided == doctest::Approx(2.0 / 256.0));
        CHECK(result.score_changes[0].mean_a == 14.5);
        CHECK(result.score_changes[0].mean_b == 10.0);
        REQUIRE(result.score_groups.size() == 2);
        CHECK(*result.score_groups[0].test.p_two_sided == doctest::Approx(1.0));  // before: all alike
        CHECK(*result.score_groups[1].test.p_two_sided == doctest::Approx(2.0 / 70.0));
        REQUIRE(result.time_tests.size() == 1);
        CHECK(result.time_tests[0].mean_difference == -0.5);
        CHECK(result.time_tests[0].test.p_two_sided == doctest::Approx(2.0 / 256.0));
        REQUIRE(result.time_groups.size() == 1);
        CHECK(*result.time_groups[0].test.p_two_sided == doctest::Approx(2.0 / 70.0));
        const std::string page = renderReport(result);
        CHECK(contains(page, "Repeated scores"));
        CHECK(contains(page, "Response times of each pair of systems"));
        CHECK(contains(page, "Response times of groups"));
    }

    TEST_CASE("Who failed a check and counts is a limitation on the page") {
        ResponseTable table = people();
        table.failed_checks = {"P3"};
        CHECK(contains(renderReport(analyse(table)),
                       "1 participant failed an attention check and is not excluded"));
        CHECK_FALSE(contains(renderReport(analyse(people())), "failed an attention check and"));
    }
}
