// Free placement by the real program: from the plan to the report's errors over the target space.
#include <cmath>

#include "csv_table.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis::tests;

TEST_SUITE("app/free_placement") {
    TEST_CASE("placements are simulated, analysed with their unit, mapped over the targets, and replayed") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string db = scratch / "study.sqlite";
        const auto simulated = program("simulate free-placement --participants 6 --db " + db);
        INFO(simulated.err);
        REQUIRE(simulated.status == 0);
        const auto report = program("report " + db + " -o " + (scratch / "r.html") + " --json " +
                                    (scratch / "r.json") + " --csv " + (scratch / "tables"));
        INFO(report.err);
        REQUIRE(report.status == 0);

        // Distances anew by SQLite, from where the ball was put and where the target stands.
        const auto anew = [&](const std::string& of_what) {
            return shell("sqlite3 -readonly " + db + " \"SELECT " + of_what +
                         " FROM (SELECT r.id, t.target_id, s.system, 100 * sqrt(pow(x.value - t.target_x_m, "
                         "2) + "
                         "pow(y.value - t.target_y_m, 2) + pow(z.value - t.target_z_m, 2)) AS off, a.value "
                         "AS kept "
                         "FROM responses AS r JOIN trials AS t USING (participant, trial_index) "
                         "JOIN trial_stimuli AS s USING (participant, trial_index) "
                         "JOIN response_values AS x ON x.response = r.id AND x.name = 'placed_x_m' "
                         "JOIN response_values AS y ON y.response = r.id AND y.name = 'placed_y_m' "
                         "JOIN response_values AS z ON z.response = r.id AND z.name = 'placed_z_m' "
                         "JOIN answers AS a ON a.response = r.id AND a.question = 'distance' "
                         "WHERE r.superseded IS NULL AND s.scored)\"")
                .out;
        };
        CHECK(std::stoi(anew("count(*)")) == 6 * 24);
        CHECK(std::stod(anew("max(abs(off - kept))")) < 0.006);  // kept to 0.01 cm

        const CsvTable means(slurp(scratch / "tables/means.csv"));
        const CsvTable space(slurp(scratch / "tables/measured_space.csv"));
        int answers = 0;
        double sum = 0.0;
        for (const auto& row : space.having({{"measure", "placement distance"}, {"system", "all"}})) {
            CHECK(row.at("measured_in") == "cm");
            answers += std::stoi(row.at("n"));
            sum += std::stoi(row.at("n")) * std::stod(row.at("mean"));
        }
        CHECK(answers == 6 * 24);
        CHECK(sum / answers == doctest::Approx(std::stod(anew("avg(off)"))).epsilon(1e-4));
        CHECK(means.find({{"measure", "placement distance"}}).size() == 4);
        CHECK(means.find({{"measure", "placement angle"}}).size() == 4);

        const std::string page = slurp(scratch / "r.html");
        CHECK(contains(page, "Errors over the target space"));
        const auto replay = program("replay " + db + " --participant S001 --choices");
        INFO(replay.err);
        CHECK(replay.status == 0);
    }
}
