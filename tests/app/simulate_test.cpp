// A whole simulated study, its report, and what must be the same twice.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "program.hpp"
#include "text.hpp"

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

/// As in the paper's text, without the zero: ".94".
std::string share(double value) {
    char text[8];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text + 1;
}

}  // namespace

TEST_SUITE("app/simulate") {
    TEST_CASE(
        "whom a study's rule concerns is left out of the headline, named, and counted in the other table") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string folder = (sourceDir() / "assets/data/studies/").string();
        spill(scratch / "pairs.toml",
              slurp(folder + "genea-pairwise.toml") + "\n[analysis.leave_out]\none_side_share = 0.56\n");
        const std::string db = scratch / "study.sqlite";
        const auto simulated =
            program("simulate " + (scratch / "pairs.toml") + " --participants 12 --db " + db);
        INFO(simulated.err);
        REQUIRE(simulated.status == 0);
        const auto report =
            program("report " + db + " -o " + (scratch / "r.html") + " --json " + (scratch / "r.json"));
        INFO(report.err);
        REQUIRE(report.status == 0);
        CHECK(contains(slurp(scratch / "r.html"), "is synthetic: rules or formulas made it"));
        // Counted by SQLite.
        const std::string who =
            shell("sqlite3 -readonly " + db +
                  " \"SELECT group_concat(p) FROM (SELECT r.participant AS p, sum(a.value < 0) AS l, "
                  "sum(a.value > 0) "
                  "AS g FROM responses r JOIN answers a ON a.response = r.id JOIN trial_stimuli s ON "
                  "s.participant = "
                  "r.participant AND s.trial_index = r.trial_index AND s.position = 0 WHERE s.scored AND "
                  "a.question = "
                  "'preference' GROUP BY 1 HAVING max(l, g) >= 0.56 * (l + g) ORDER BY 1)\"")
                .out;
        const nlohmann::json out = nlohmann::json::parse(slurp(scratch / "r.json"));
        std::string left;
        for (const auto& one : out["left_out"]) {
            left += (left.empty() ? "" : ",") + one["participant"].get<std::string>();
            CHECK(one["why"] == "excluded");
            CHECK(contains(one["reason"].get<std::string>(), "by the study's rule: preferred the "));
        }
        CHECK(left + "\n" == who);
        const int n = static_cast<int>(out["left_out"].size());
        REQUIRE(n > 0);
        REQUIRE(n < 12);
        CHECK(out["participants"] == 12 - n);
        CHECK(out["study"]["planned_participants"] == 12 - n);
        CHECK(out["measures"][0]["planned"] == 30 * (12 - n));
        CHECK(out["data"]["answers"] == 30 * (12 - n));
        const nlohmann::json& sensitivity = out["sensitivity"];
        CHECK(sensitivity["with_left_out"]["participants"] == 12);
        CHECK(contains(slurp(scratch / "r.html"), "the same side in at least 56\u00a0% of the pairs"));
        // Nothing of it is in the database: nobody is excluded there.
        CHECK(shell("sqlite3 -readonly " + db +
                    " \"SELECT count(*) FROM participants WHERE status <> 'active'\"")
                  .out == "0\n");
    }

    TEST_CASE(
        "39 simulated participants give 2,340 answers and a report that ranks the systems as they were "
        "made") {
        const Scratch scratch;
        const auto run =
            program("simulate pointing2023-stand-ins --participants 39 --db " + (scratch / "study.sqlite"));
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
        // The page that sets them beside the paper's Table 1.
        const std::string documented = slurp(sourceDir() / "docs/simulated-participant.md");
        for (const auto& layout : analysis["layouts"]) {
            if (layout["system"] == "all") continue;
            const auto read = std::find_if(
                analysis["observers"].begin(), analysis["observers"].end(), [&](const json& one) {
                    return one["system"] == layout["system"] && one["layout"] == layout["layout"];
                });
            REQUIRE(read != analysis["observers"].end());
            std::string row = "| " + layout["system"].get<std::string>() + " | " +
                              layout["layout"].get<std::string>() + " | " + share(layout["mean"]) + " |";
            for (const char* observer : {"two-cue", "arm-finger", "eye-fingertip"})
                row += " " + share((*read)["observers"][observer]["accuracy"]) + " |";
            CHECK_MESSAGE(contains(documented, row), row);
        }

        const std::string page = slurp(scratch / "report.html");
        CHECK(page.find("imulated") != std::string::npos);
        // Nothing is loaded from elsewhere; that what draws the figures asks for nothing is seen in
        // tests/browser.
        const std::string before_libraries = page.substr(0, page.find("<script>"));
        CHECK(before_libraries.size() < page.size());
        for (const char* loading : {" src=", "url(", "@import", "<link"})
            CHECK(before_libraries.find(loading) == std::string::npos);
        for (auto link = before_libraries.find(" href="); link != std::string::npos;
             link = before_libraries.find(" href=", link + 1))
            CHECK(before_libraries.substr(link, 8) == " href=\"#");  // a place in the page itself
    }

    TEST_CASE("the same study gives the same answers, report and numbers again") {
        const Scratch scratch;
        for (const std::string name : {"a", "b"}) {
            REQUIRE(program("simulate pointing2023-stand-ins --participants 3 --db " +
                            (scratch / (name + "/study.sqlite")))
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
            program("simulate pointing2023-stand-ins --participants 1 --db " + (scratch / "study.sqlite")),
            "study.sqlite", "exists already");
        CHECK(slurp(scratch / "study.sqlite") == "precious");
    }
}
