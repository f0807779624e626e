// A whole simulated study, its report, and what must be the same twice.
#include <SQLiteCpp/SQLiteCpp.h>

#include <map>

#include "program.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

std::string answers(const std::string& database) {
    return shell(
               "sqlite3 -readonly " + database +
               " 'select participant, trial_index, value, chosen_place, correct, round(response_time_s, 6) "
               "from "
               "responses_flat where not practice and system is not null order by participant, trial_index'")
        .out;
}

}  // namespace

TEST_SUITE("app/simulate") {
    TEST_CASE(
        "39 simulated participants give 2,340 answers and a report that ranks the systems as they were "
        "made") {
        const Scratch scratch;
        const auto run =
            program("simulate pointing2023 --participants 39 --db " + (scratch / "study.sqlite"));
        INFO(run.err);
        REQUIRE(run.status == 0);
        CHECK(run.out.find("2574 trials and pages answered") != std::string::npos);  // 39 x 66

        const auto report = program("report " + (scratch / "study.sqlite") + " -o " +
                                    (scratch / "report.html") + " --json " + (scratch / "analysis.json"));
        INFO(report.err);
        REQUIRE(report.status == 0);
        const json analysis = json::parse(slurp(scratch / "analysis.json"));
        REQUIRE(analysis["systems"].size() == 4);
        std::map<std::string, double> accuracy;
        std::map<std::string, double> naturalness;
        for (const auto& system : analysis["systems"]) {
            accuracy[system["system"]] = system["accuracy"]["mean"];
            naturalness[system["system"]] = system["naturalness"]["mean"];
            // 39 x 10 choices and 39 x 5 ratings for each system, as in the paper.
            CHECK(system["accuracy"]["n"] == 390);
            CHECK(system["naturalness"]["n"] == 195);
            // Single choices are right or wrong: their SD is fixed by their mean (n - 1 in the denominator).
            const double p = accuracy[system["system"]];
            CHECK(system["accuracy"]["sd_trials"].get<double>() ==
                  doctest::Approx(std::sqrt(p * (1 - p) * 390.0 / 389.0)).epsilon(1e-6));
        }
        CHECK(naturalness["stiff"] < naturalness["direct"]);
        CHECK(naturalness["stiff"] < naturalness["demonstration-nn"]);
        CHECK(accuracy["drifting"] < accuracy["demonstration-nn"]);
        CHECK(accuracy["drifting"] < accuracy["direct"]);
        CHECK(accuracy["drifting"] < accuracy["stiff"]);
        CHECK(accuracy["direct"] > accuracy["demonstration-nn"]);

        CHECK(analysis["pairwise"].size() == 12);
        for (const auto& pair : analysis["pairwise"]) {
            CHECK(pair["n"] == 39);
            const double ranks = pair["w_plus"].get<double>() + pair["w_minus"].get<double>();
            const double used = 39.0 - pair["n_zero"].get<double>();
            CHECK(ranks == doctest::Approx(used * (used + 1) / 2));
            CHECK(pair["p_holm"].get<double>() >= pair["p"].get<double>());
            CHECK(pair["significant"].get<bool>() == (pair["p_holm"].get<double>() < 0.01));
        }
        // Layouts are balanced: 5 and 5 of each participant's 10 choices for each system.
        for (const auto& layout : analysis["layouts"])
            CHECK(layout["n"] == (layout["system"] == "all" ? 780 : 195));

        const std::string page = slurp(scratch / "report.html");
        CHECK(page.find("imulated") != std::string::npos);
        // Nothing is loaded from elsewhere; that what draws the figures asks for nothing is seen in
        // tests/browser.
        const std::string before_libraries = page.substr(0, page.find("<script>"));
        CHECK(before_libraries.size() < page.size());
        for (const char* loading : {" src=", " href=", "url(", "@import", "<link"})
            CHECK(before_libraries.find(loading) == std::string::npos);
    }

    TEST_CASE("the same study gives the same answers, report and numbers again") {
        const Scratch scratch;
        for (const std::string name : {"a", "b"}) {
            REQUIRE(
                program("simulate pointing2023 --participants 3 --db " + (scratch / (name + "/study.sqlite")))
                    .status == 0);
            REQUIRE(program("report " + (scratch / (name + "/study.sqlite")) + " -o " +
                            (scratch / (name + "/report.html")) + " --json " +
                            (scratch / (name + "/analysis.json")))
                        .status == 0);
        }
        const std::string first = answers(scratch / "a/study.sqlite");
        CHECK(std::count(first.begin(), first.end(), '\n') == 180);
        CHECK(first == answers(scratch / "b/study.sqlite"));
        CHECK(slurp(scratch / "a/analysis.json") == slurp(scratch / "b/analysis.json"));
        CHECK(slurp(scratch / "a/report.html") == slurp(scratch / "b/report.html"));
    }

    TEST_CASE("a simulation never touches a database that is there") {
        const Scratch scratch;
        spill(scratch / "study.sqlite", "precious");
        CHECK_FAILS_SAYING(
            program("simulate pointing2023 --participants 1 --db " + (scratch / "study.sqlite")),
            "study.sqlite", "exists already");
        CHECK(slurp(scratch / "study.sqlite") == "precious");
    }
}
