// deixis report on several studies: the program from the simulated sessions to the page.
#include "csv_table.hpp"
#include "schema_check.hpp"
#include "text.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

/// A study's answers: each of the participants rates two systems twice, b by `more` above a.
std::string studyAnswers(int participants, double more, const std::string& measure = "naturalness") {
    std::string out = "participant,system,item,author_trial,measure,rating\n";
    for (int p = 1; p <= participants; ++p)
        for (int item = 1; item <= 2; ++item) {
            const std::string start = "P" + std::to_string(p) + ",";
            const std::string end =
                ",T" + std::to_string(item) + "," + std::to_string(item) + "," + measure + ",";
            out += start + "a" + end + std::to_string(30 + 3 * p + item) + "\n";
            out += start + "b" + end + std::to_string(30 + 3 * p + item + more + p % 3) + "\n";
        }
    return out;
}

}  // namespace

TEST_SUITE("app/report_studies") {
    TEST_CASE("Both scenarios of Yoon et al., simulated, are one report, in any order; rejections say why") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string relaxed = scratch / "relaxed.sqlite";
        const std::string rushed = scratch / "rushed.sqlite";
        const std::string fixture = slurp(sourceDir() / "tests/studies/fixtures/parallel_rating.toml");
        const auto scenario = [&](const std::string& name, const std::string& items) {
            spill(scratch / (name + ".toml"),
                  replaced(replaced(fixture, "\"parallel-rating\"\ntitle", "\"" + name + "\"\ntitle"),
                           "items = 12", "items = " + items));
            return program("simulate " + (scratch / (name + ".toml")) + " --participants " +
                           (items == "12" ? "4 --db " + relaxed : "3 --db " + rushed));
        };
        REQUIRE(scenario("sgtoolkit2021", "12").status == 0);
        REQUIRE(scenario("sgtoolkit2021-rushed", "8").status == 0);
        const std::string before = slurp(relaxed) + slurp(rushed);
        const auto report = [&](const std::string& data, const std::string& name) {
            return program("report " + data + " -o " + (scratch / (name + ".html")) + " --json " +
                           (scratch / (name + ".json")) + " --csv " + (scratch / (name + "-csv")));
        };
        const auto done = report(relaxed + " " + rushed, "one");
        INFO(done.err);
        REQUIRE(done.status == 0);
        REQUIRE(report(rushed + " " + relaxed + " --by study", "two").status == 0);
        CHECK(slurp(relaxed) + slurp(rushed) == before);
        CHECK(schemaProblems("analysis", scratch / "one.json") == "");
        const json out = json::parse(slurp(scratch / "one.json"));
        json asked = json::parse(slurp(scratch / "two.json"));
        CHECK(contains(out["remarks"].dump(), "as with --by study"));
        CHECK_FALSE(contains(asked["remarks"].dump(), "as with --by study"));
        asked["remarks"] = out["remarks"];
        CHECK(asked == out);
        CHECK(slurp(scratch / "one-csv/study_pairwise.csv") == slurp(scratch / "two-csv/study_pairwise.csv"));

        CHECK(out["participants"] == 7);
        REQUIRE(out["by_study"].size() == 2);
        const json& second = out["by_study"][1];
        CHECK(second["study"] == "sgtoolkit2021-rushed");
        CHECK(second["data"][0]["file"] == "rushed.sqlite");
        CHECK(second["data"][0]["simulated"] == 3);
        CHECK(second["data"][0]["people"] == 0);
        CHECK(second["data"][0]["schema_version"] == 6);
        REQUIRE(report(rushed, "alone").status == 0);
        const json alone = json::parse(slurp(scratch / "alone.json"));
        CHECK(second["systems"] == alone["systems"]);
        CHECK(second["omnibus"] == alone["omnibus"]);
        CHECK(second["data"][0]["answers_hash"] == alone["data"]["answers_hash"]);
        for (std::size_t i = 0; i < 6; ++i) {
            CHECK(second["pairwise"][i]["p_holm"] == alone["pairwise"][i]["p_holm"]);
            CHECK(out["pairwise"][i]["n"] == 7);
            // The unit that both studies ask for: pairs of ratings, of each study and of both.
            const json& ratings = second["pairwise_ratings"][i];
            CHECK(ratings["n"] == alone["pairwise_ratings"][i]["n"]);
            CHECK(ratings["p_holm"] == alone["pairwise_ratings"][i]["p_holm"]);
            CHECK(ratings["family"] != out["pairwise_ratings"][i]["family"]);
            CHECK(out["pairwise_ratings"][i]["n"].get<int>() ==
                  ratings["n"].get<int>() + out["by_study"][0]["pairwise_ratings"][i]["n"].get<int>());
        }
        CHECK(contains(slurp(scratch / "one.html"), "Simulated participants:"));

        const auto twice = report(relaxed + " " + relaxed, "twice");
        CHECK(twice.status == 1);
        CHECK(contains(twice.err, "is named twice"));
        const auto same = report(relaxed + " --by study", "same");
        CHECK(same.status == 1);
        CHECK(contains(same.err, "all data are from one study, sgtoolkit2021: there is nothing to compare"));
        REQUIRE(
            program("simulate genea-pairwise --participants 2 --db " + (scratch / "pairs.sqlite")).status ==
            0);
        const auto other = report(relaxed + " " + (scratch / "pairs.sqlite"), "other");
        CHECK(other.status == 1);
        CHECK(contains(other.err, "The two have no measure in common: "));
        CHECK_FALSE(fs::exists(scratch / "other.html"));
        CHECK(report(relaxed + " " + (scratch / "none.sqlite"), "none").status == 1);
        CHECK(report(relaxed + " " + rushed + " --by file", "by").status == 2);
    }

    TEST_CASE("Each CSV file is a study with --by study, on a scale that is said; R finds the same numbers") {
        const Scratch scratch;
        spill(scratch / "calm.csv", studyAnswers(6, 4));
        spill(scratch / "hurry.csv", studyAnswers(7, -1));
        const std::string both = (scratch / "calm.csv") + " " + (scratch / "hurry.csv");
        const std::string files = " -o " + (scratch / "r.html") + " --json " + (scratch / "r.json");
        const auto unsaid = program("report " + both + " --by study" + files);
        CHECK(unsaid.status == 1);
        CHECK(contains(unsaid.err, "--scale naturalness=34..54"));
        const auto done =
            program("report " + both + " --by study --unit ratings --scale naturalness=0..100 --r " +
                    (scratch / "r") + files);
        INFO(done.err);
        REQUIRE(done.status == 0);
        const json out = json::parse(slurp(scratch / "r.json"));
        CHECK(out["by_study"][0]["study"] == "calm");
        CHECK(out["by_study"][0]["pairwise"][0]["p"] == 2.0 / 64.0);  // all six alike
        CHECK(out["by_study"][0]["pairwise"][0]["mean_difference"] == -5.0);
        CHECK(out["by_study"][0]["pairwise_ratings"][0]["n"] == 12);
        CHECK(out["pairwise_ratings"][0]["n"] == 26);
        CHECK(out["by_study"][1]["author_trials"][0]["n_a"] == 7);
        CHECK(out["author_trials"][0]["n_a"] == 13);
        CHECK(out["study_medians"][0]["system"] == "b");
        CHECK(out["study"]["hash"] == "");
        // As one study, as ever, the two are the same people twice.
        CHECK(contains(program("report " + both + files).err, "participant P1 is also in calm.csv"));
        spill(scratch / "other.csv", studyAnswers(6, 4, "warmth"));
        const auto apart = program("report " + (scratch / "calm.csv") + " " + (scratch / "other.csv") +
                                   " --by study" + files);
        CHECK(apart.status == 1);
        CHECK(contains(apart.err, "\"naturalness\", which calm (calm.csv) has"));
        if (shell("Rscript --version").status != 0) {
            tellSkipped("Rscript is not here");
            return;
        }
        const auto computed = shell("Rscript " + (scratch / "r/analysis.R"));
        CHECK_MESSAGE(computed.status == 0, computed.out, computed.err);
        const CsvTable compared(slurp(scratch / "r/comparison.csv"));
        const std::vector<std::array<const char*, 3>> cells{
            {"study_pairwise", "2", "p_holm"},
            {"study_pairwise_ratings", "2", "p_holm"},
            {"study_author_trials", "4", "p_holm"},
            {"study_author_trials_by_participants", "4", "p_holm"},
            {"study_medians", "6", "median_of_ratings"}};
        for (const auto& one : cells)
            CHECK_MESSAGE(compared.has({{"table", one[0]}, {"row", one[1]}, {"column", one[2]}}), one[0]);
    }
}
