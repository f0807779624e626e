// Right choices against the angle to the nearest distractor.
#include "results/answers/accuracy_by_angle.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "page_text.hpp"
#include "results/copies/data_export.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::pageText;

namespace {

ChoiceRow angledChoice(const char* system, const char* layout, bool right, double avatar_deg,
                       double participant_deg) {
    ChoiceRow out{"A", system, "T1", {{0, 1, 1}, {1, 1, 1}}, 0, right ? 0 : 1, 0.0, 2.0};
    out.layout = layout;
    out.avatar_angle_deg = avatar_deg;
    out.participant_angle_deg = participant_deg;
    return out;
}

const AngleResult* angleBandOf(const std::vector<AngleResult>& rows, const char* eyes, const char* system,
                               double from_deg) {
    for (const AngleResult& row : rows)
        if (row.eyes == eyes && row.system == system && row.from_deg == from_deg) return &row;
    return nullptr;
}

}  // namespace

TEST_SUITE("results/accuracy_by_angle") {
    TEST_CASE("Choices are counted by band, eyes and system, worked by hand") {
        ResponseTable table;
        table.systems = {"x", "y"};
        table.layouts = {"across", "beside", "nowhere"};
        table.choices = {
            angledChoice("x", "across", true, 1.4, 2.99), angledChoice("x", "across", false, 2.99, 3.0),
            angledChoice("y", "across", true, 3.0, 11.99), angledChoice("x", "beside", true, 12.0, 40.0),
            angledChoice("y", "beside", false, 1.0, 8.0)};
        // From before the angles were kept.
        table.choices.push_back({"A", "x", "T1", {{0, 1, 1}, {1, 1, 1}}, 0, 0, 0.0, 2.0});
        const std::vector<AngleResult> rows = accuracyByAngle(table);
        REQUIRE(rows.size() == 3 * 3 * 5);  // nowhere has nobody
        const auto check = [&](const char* eyes, const char* system, double from_deg, int right,
                               int choices) {
            const AngleResult* row = angleBandOf(rows, eyes, system, from_deg);
            REQUIRE(row != nullptr);
            CHECK(row->right == right);
            CHECK(row->choices == choices);
        };
        check("avatar", "all", 0.0, 1, 3);
        check("avatar", "x", 0.0, 1, 2);
        check("avatar", "y", 3.0, 1, 1);
        check("avatar", "all", 6.0, 0, 0);
        check("avatar", "x", 12.0, 1, 1);
        check("across", "all", 0.0, 1, 1);
        check("across", "x", 3.0, 0, 1);
        check("across", "y", 9.0, 1, 1);
        check("beside", "y", 6.0, 0, 1);
        check("beside", "x", 12.0, 1, 1);
        CHECK(angleBandText(rows[0]) == "0-3");
        CHECK(angleBandText(rows[4]) == "12+");
        CHECK(angleBandOf(rows, "nowhere", "all", 0.0) == nullptr);

        const AnalysisResult result = analyse(table);
        const auto out = nlohmann::json::parse(analysisJson(result));
        CHECK(out["accuracy_by_angle"][0] == nlohmann::json{{"eyes", "avatar"},
                                                            {"system", "all"},
                                                            {"from_deg", 0.0},
                                                            {"below_deg", 3.0},
                                                            {"right", 1},
                                                            {"choices", 3}});
        CHECK(out["accuracy_by_angle"][4]["below_deg"].is_null());
        CHECK(tests::CsvTable(fixtures::csvOf(result, "angles.csv"))
                  .has({{"eyes", "avatar"},
                        {"system", "x"},
                        {"from_deg", "0"},
                        {"below_deg", "3"},
                        {"right", "1"},
                        {"choices", "2"}}));
        const std::string page = renderReport(result);
        CHECK(contains(pageText(page), "33\u00a0% (1 of 3)|"));
        CHECK(contains(page, "as seen by the participant, beside"));
    }

    TEST_CASE(
        "Angles and a clip's author are kept with trial and answer; a headset has its own place's angles") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        for (const auto kind : {studies::StationKind::headset, studies::StationKind::desktop}) {
            const std::string station(studies::stationKindName(kind));
            CAPTURE(station);
            auto plan = fixtures::plan(study, "P01", 1);  // a practice, a rating, two choices
            plan.trials[2].angles = studies::BallAngles{{7.5, 4.25}, {3.5, 9.0}, {12.5, 2.25}};
            auto clips = fixtures::clips(plan);
            clips[plan.trials[2].stimuli.front()].author = "A07";
            clips[plan.trials[2].stimuli.front()].trial = 2;
            {
                Store store = fixtures::open((folder / "") / (station + ".sqlite"));
                fixtures::store(store, study, plan);
                auto session = fixtures::session("P01", false);
                session.station.kind = kind;
                store.beginSession(session);
                for (const std::size_t trial : {2, 3})
                    store.record(fixtures::answer(plan.trials[trial], 1), study, plan, clips);
            }
            const auto table = loadResponses((folder / "") / (station + ".sqlite"));
            REQUIRE(table);
            REQUIRE(table->choices.size() == 2);
            CHECK(table->choices[0].avatar_angle_deg == 4.25);
            CHECK(table->choices[0].participant_angle_deg == (station == "headset" ? 3.5 : 2.25));
            CHECK(table->choices[0].layout == "across");
            CHECK_FALSE(table->choices[1].avatar_angle_deg.has_value());
            CHECK_FALSE(table->choices[1].participant_angle_deg.has_value());
            REQUIRE(exportCsv((folder / "") / (station + ".sqlite"), (folder / "") / station, {}));
            const tests::CsvTable trials(readFile((folder / "") / (station + "/trials.csv")).value());
            CHECK(
                nlohmann::json::parse(trials.cell(2, "angles")) ==
                nlohmann::json{{"avatar", {7.5, 4.25}}, {"headset", {3.5, 9.0}}, {"desktop", {12.5, 2.25}}});
            CHECK(trials.cell(2, "min_angle_avatar_deg") == "4.25");
            CHECK(trials.cell(2, "min_angle_headset_deg") == "3.5");
            CHECK(trials.cell(2, "min_angle_desktop_deg") == "2.25");
            const tests::CsvTable responses(readFile((folder / "") / (station + "/responses.csv")).value());
            CHECK(responses.has({{"clip", "0"}, {"author", "A07"}, {"author_trial", "2"}}));
        }
    }
}
