// A session told line by line while it runs.
#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "core/pose.hpp"
#include "program.hpp"
#include "schema_check.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

using Json = nlohmann::json;

std::vector<Json> lines(const std::string& file) {
    std::vector<Json> out;
    std::istringstream in(slurp(file));
    for (std::string line; std::getline(in, line);) out.push_back(Json::parse(line));
    return out;
}

Vec3 vector(const Json& numbers) {
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

/// "choosing" of "choosing-across".
std::string step(const std::string& state) {
    for (const char* layout : {"-across", "-side-by-side"})
        if (state.ends_with(layout)) return state.substr(0, state.size() - std::string(layout).size());
    return state;
}

std::string layout(const std::string& state) {
    return state == step(state) ? "" : state.substr(step(state).size() + 1);
}

/// Which states may follow which within a trial, by their names.
const std::map<std::string, std::set<std::string>> follows{
    {"waiting", {"playing"}}, {"playing", {"pointing"}},          {"pointing", {"rating", "choosing"}},
    {"rating", {"rated"}},    {"choosing", {"aiming", "chosen"}}, {"aiming", {"choosing", "chosen"}},
};

}  // namespace

TEST_SUITE("app/trace") {
    TEST_CASE("a traced session tells the course of every trial, and where what is aimed at stands") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string trace = scratch / "trace.jsonl";
        const std::string database = scratch / "s.sqlite";
        spill(trace, "{\"earlier\": true}\n");
        const auto run =
            program("run pointing2023-stand-ins --station simulated --participant P01 --db " + database +
                    " --trace " + trace + " --size 320x180 --screenshot break=" + (scratch / "break.png") +
                    " over=" + (scratch / "over.png"));
        INFO(run.err);
        REQUIRE(run.status == 0);
        for (const char* picture : {"break.png", "over.png"}) {
            const std::string png = slurp(scratch / picture);
            REQUIRE(png.size() > 1000);
            CHECK(png.substr(12, 12) == std::string("IHDR\0\0\x01\x40\0\0\0\xb4", 12));  // 320 by 180
        }
        auto told = lines(trace);
        REQUIRE(told.size() > 100);
        CHECK(told.front().contains("earlier"));  // lines are added
        told.erase(told.begin());
        const std::string whole = slurp(trace);
        spill(scratch / "lines.jsonl", whole.substr(whole.find('\n') + 1));
        CHECK(schemaProblems("trace", scratch / "lines.jsonl") == "");
        CHECK(told.front()["state"] == "instructions");
        CHECK(told.back()["state"] == "over");

        std::map<int, std::string> answered;  // trial -> the state that ended it
        std::map<int, int> chosen;            // trial -> place
        int hovered_buttons = 0;
        int hovered_balls = 0;
        for (std::size_t i = 0; i < told.size(); ++i) {
            const Json& line = told[i];
            INFO(line.dump());
            const std::string state = line["state"];
            if (state == "questionnaire") break;  // what follows shows no clip
            const int trial = line["trial"];
            const bool in_trial =
                step(state) == "rated" || step(state) == "chosen" || follows.contains(step(state));
            CHECK((trial >= 0) == in_trial);
            CHECK(line["notes"].is_array());
            CHECK(line["head"].size() == 7);
            CHECK(line["stage_from_viewer"].size() == 7);
            CHECK(line["balls"].size() == (layout(state).empty() ? 0U : 3U));
            if (!layout(state).empty()) CHECK(line["place"] == layout(state));
            if (i > 0) {
                const std::string before = told[i - 1]["state"];
                CHECK(line["time_s"].get<double>() >= told[i - 1]["time_s"].get<double>());
                CHECK(line["frame"].get<int>() > told[i - 1]["frame"].get<int>());
                if (before != state && trial >= 0 && told[i - 1]["trial"] == trial) {
                    CHECK(follows.at(step(before)).contains(step(state)));
                    CHECK(layout(before) == layout(state));
                }
                if (trial >= 0 && told[i - 1]["trial"] != trial) CHECK(step(state) == "waiting");
            }
            if (step(state) == "rated" || step(state) == "chosen") answered[trial] = state;
            for (std::size_t place = 0; place < line["balls"].size(); ++place) {
                const Json& ball = line["balls"][place];
                if (ball["look"] == "chosen") chosen[trial] = static_cast<int>(place);
                if (ball["look"] != "hovered") continue;
                ++hovered_balls;
                const Ray ray{vector(line["ray"]["origin"]), vector(line["ray"]["direction"])};
                CHECK(distanceToSphere(ray, vector(ball["centre"]), ball["radius_m"]) > 0.0);
            }
            for (const Json& button : line["buttons"]) {
                if (button["hovered"] != true || line["ray"].is_null()) continue;
                ++hovered_buttons;
                const Vec3 end = vector(line["ray"]["origin"]) +
                                 vector(line["ray"]["direction"]) * line["ray"]["length_m"].get<double>();
                CHECK(glm::distance(end, vector(button["centre"])) < 0.35);
            }
        }
        CHECK(hovered_balls >= 40);
        CHECK(hovered_buttons >= 20);
        CHECK(answered.size() == 64);  // 60 and 4 of practice
        SQLite::Database db(database, SQLite::OPEN_READONLY);
        SQLite::Statement row(
            db, "select trial_index, chosen_place from responses_flat where kind <> 'questionnaire'");
        int rows = 0;
        while (row.executeStep()) {
            ++rows;
            const int trial = row.getColumn(0).getInt();
            CHECK(step(answered.at(trial)) == (row.getColumn(1).isNull() ? "rated" : "chosen"));
            if (!row.getColumn(1).isNull()) CHECK(chosen.at(trial) == row.getColumn(1).getInt());
        }
        CHECK(rows == 64);
    }

    TEST_CASE("a trace that cannot be written is rejected before anything is kept") {
        const Scratch scratch;
        const std::string file = scratch / "nowhere/trace.jsonl";
        CHECK_FAILS_SAYING(program("run pointing2023-stand-ins --station simulated --participant P01 --db " +
                                   (scratch / "s.sqlite") + " --trace " + file),
                           "trace.jsonl", "cannot be opened");
        SQLite::Database db(scratch / "s.sqlite", SQLite::OPEN_READONLY);
        CHECK(db.execAndGet("select count(*) from participants").getInt() == 0);
    }

    TEST_CASE("a storage delay that is no number is rejected") {
        const Scratch scratch;
        for (const char* bad : {"slow", "-1", "0.2s", "nan"})
            CHECK_FAILS_SAYING(
                program("run pointing2023-stand-ins --station simulated --db " + (scratch / "s.sqlite"),
                        std::string("env DEIXIS_STORAGE_DELAY_S=") + bad),
                "DEIXIS_STORAGE_DELAY_S", bad);
    }
}
