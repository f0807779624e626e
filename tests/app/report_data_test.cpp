// deixis report on answers that come as CSV, and on several databases.
#include <cmath>
#include <map>

#include "csv_table.hpp"
#include "program.hpp"
#include "rounded_json.hpp"
#include "schema_check.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

/// Twelve participants rate two systems and play a game of two layouts.
std::string answersOf(int first, int last) {
    std::string out = "participant,stage,system,layout,item,correct,rating,rt\n";
    for (int p = first; p <= last; ++p)
        for (const std::string system : {"stiff", "fluent"}) {
            const std::string start = "P" + std::to_string(p) + ",";
            const int better = system == "fluent" ? 1 : 0;
            out += start + "naturalness," + system + ",,T1,," + std::to_string(2 + better + p % 2) + ",1.5\n";
            out += start + "naturalness," + system + ",,T2,," + std::to_string(2 + 2 * better) + ",1.5\n";
            for (const std::string layout : {"across", "side"})
                out += start + "game," + system + "," + layout + ",T1," +
                       std::to_string(p % 3 == 0 && better == 0 ? 0 : 1) + ",,2\n";
        }
    return out;
}

/// The tests of pairs, whichever system of a pair stands first.
std::map<std::string, std::vector<json>> pairsOf(const json& analysis) {
    std::map<std::string, std::vector<json>> out;
    for (const char* kind : {"pairwise", "preferences"})
        for (const json& pair : analysis[kind]) {
            const bool turned = pair["a"].get<std::string>() > pair["b"].get<std::string>();
            const json& mean = pair[kind == std::string("pairwise") ? "mean_difference" : "mean"];
            out[pair.value("measure", "preference") + " " + pair[turned ? "b" : "a"].get<std::string>() +
                " " + pair[turned ? "a" : "b"].get<std::string>()] = {
                pair["n"], pair["p"], pair["p_holm"], std::round((turned ? -1e9 : 1e9) * mean.get<double>()),
                pair.contains("ties") ? pair["ties"] : json()};
        }
    return out;
}

/// Numbers of each system by its name.
std::map<std::string, json> bySystem(const json& rows) {
    std::map<std::string, json> out;
    for (const json& row : rows) out[row.value("measure", "") + row["system"].get<std::string>()] = row;
    return out;
}

}  // namespace

TEST_SUITE("app/report_data") {
    TEST_CASE("a table from anywhere becomes a page, JSON, CSV and LaTeX; the same bytes each time") {
        const Scratch scratch;
        spill(scratch / "lab.csv", answersOf(10, 21));
        const auto run = [&](const std::string& name, const std::string& options) {
            return program("report " + (scratch / "lab.csv") + " -o " + (scratch / (name + ".html")) +
                           " --json " + (scratch / (name + ".json")) + " --csv " + (scratch / name) +
                           " --latex " + (scratch / name) + options);
        };
        const auto done = run("first", "");
        INFO(done.err);
        REQUIRE(done.status == 0);
        REQUIRE(run("second", "").status == 0);
        for (const char* file : {".html", ".json", "/pairwise.csv", "/pairwise.tex", "/answers.csv"})
            CHECK(slurp(scratch / ("first" + std::string(file))) ==
                  slurp(scratch / ("second" + std::string(file))));

        CHECK(schemaProblems("analysis", scratch / "first.json") == "");
        const json out = json::parse(slurp(scratch / "first.json"));
        CHECK(out["schema"]["version"] == 5);
        CHECK(out["participants"] == 12);
        CHECK(out["data"]["files"] == "lab.csv");
        CHECK(out["alpha"] == 0.01);
        const json& naturalness = out["pairwise"][1];
        CHECK(naturalness["measure"] == "naturalness");
        CHECK(naturalness["n_positive"] == 0);
        CHECK(naturalness["n_negative"] == 12);
        CHECK(naturalness["p"] == 2.0 / 4096.0);  // one of 2^12 patterns of signs, twice
        CHECK(naturalness["hodges_lehmann"]["estimate"] == -1.5);
        CHECK(out["omnibus"][1]["chi2"] == 12.0);  // everybody ranks the two alike
        CHECK(out["omnibus"][1]["kendalls_w"] == 1.0);
        CHECK(out["pairwise"][0]["n_zero"] == 8);
        const CsvTable pairwise(slurp(scratch / "first/pairwise.csv"));
        CHECK(pairwise.cell(1, "rank_biserial") == "-1");  // all signs alike
        CHECK(contains(slurp(scratch / "first.html"), "Pratt"));

        REQUIRE(run("loose", " --alpha 0.2 --level 0.9 --seed 5").status == 0);
        const json loose = json::parse(slurp(scratch / "loose.json"));
        CHECK(loose["alpha"] == 0.2);
        CHECK(loose["settings"]["seed"] == 5);
        CHECK(loose["pairwise"][1]["hodges_lehmann"]["level"].get<double>() >= 0.9);
    }

    TEST_CASE("several files are one study; what does not belong together writes nothing") {
        const Scratch scratch;
        spill(scratch / "a.csv", answersOf(10, 15));
        spill(scratch / "b.csv", answersOf(16, 21));
        spill(scratch / "all.csv", answersOf(10, 21));
        const auto report = [&](const std::string& data, const std::string& name) {
            return program("report " + data + " -o " + (scratch / (name + ".html")) + " --json " +
                           (scratch / (name + ".json")));
        };
        REQUIRE(report((scratch / "a.csv") + " " + (scratch / "b.csv"), "two").status == 0);
        REQUIRE(report(scratch / "all.csv", "one").status == 0);
        json two = json::parse(slurp(scratch / "two.json"));
        json one = json::parse(slurp(scratch / "one.json"));
        CHECK(two["data"]["answers_hash"] == one["data"]["answers_hash"]);
        CHECK(two["pairwise"] == one["pairwise"]);
        const auto clash = report((scratch / "a.csv") + " " + (scratch / "all.csv"), "clash");
        CHECK(clash.status == 1);
        CHECK(contains(clash.err, "participant P10 is also in a.csv"));
        CHECK_FALSE(fs::exists(scratch / "clash.html"));
        const auto nothing = report(scratch / "missing.csv", "missing");
        CHECK(nothing.status == 1);
        CHECK(contains(nothing.err, "missing.csv"));
    }

    TEST_CASE("exclusions, groups and further factors come from columns; an empty file is told to be one") {
        const Scratch scratch;
        std::string text = "participant,system,rating,excluded,marked,group,style\n";
        // Eight rate x above y by 1 to 8, the ninth (excluded) far below.
        for (int p = 1; p <= 9; ++p)
            for (const std::string style : {"calm", "lively"}) {
                const std::string who = "P" + std::to_string(p) + ",";
                const std::string end = std::string(p == 9 ? ",asleep" : ",") + ",," +
                                        (p % 2 == 0 ? "even," : "odd,") + style + "\n";
                text += who + "x," + std::to_string(p == 9 ? 0 : 50 + p) + end;
                text += who + "y," + std::to_string(50) + end;
            }
        spill(scratch / "lab.csv", text);
        const auto done = program("report " + (scratch / "lab.csv") + " -o " + (scratch / "a.html") +
                                  " --json " + (scratch / "a.json") + " --csv " + (scratch / "a") +
                                  " --between group --within style --alpha 0.01");
        INFO(done.err);
        REQUIRE(done.status == 0);
        const json out = json::parse(slurp(scratch / "a.json"));
        CHECK(out["schema"]["version"] == 5);
        const json& pair = out["sensitivity"]["pairs"][0];
        CHECK(pair["headline"]["p_holm"] == 2.0 / 256.0);        // all of 8 differences positive
        CHECK(pair["with_left_out"]["p_holm"] == 66.0 / 512.0);  // rank 9 negative: 33 of 512 patterns, twice
        // The normal approximation: z = (36 - 18 - 1/2) / sqrt(51) = 2.45, p = 0.014.
        CHECK(pair["changes"] == json{"normal", "with_left_out"});
        // Odd: x at 51, 53, 55, 57; even: 52, 54, 56, 58: U = 6 of 16, in y all are equal.
        CHECK(out["between"][1]["system"] == "x");
        CHECK(out["between"][1]["a"] == "odd");
        CHECK(out["between"][1]["u"] == 6.0);
        CHECK(out["between"][1]["cliffs_delta"] == -0.25);
        CHECK(out["between"][2]["p"] == 1.0);
        CHECK(out["factor_tests"].size() == 2);
        CHECK(out["left_out"][0]["reason"] == "asleep");
        CHECK(CsvTable(slurp(scratch / "a/sensitivity.csv")).has({{"choice", "with_left_out"}}));
        CHECK(contains(slurp(scratch / "a.html"), "Groups of participants"));

        spill(scratch / "empty.csv", "");
        const auto empty = program("report " + (scratch / "empty.csv") + " -o " + (scratch / "b.html"));
        CHECK(empty.status == 1);
        CHECK(contains(empty.err, "empty.csv: the file is empty (0 bytes)"));
        CHECK_FALSE(fs::exists(scratch / "b.html"));
    }

    TEST_CASE("answers that are all equal, or a single one, are told without a highest and a lowest") {
        const Scratch scratch;
        const auto page = [&](const std::string& lines) {
            spill(scratch / "lab.csv", "participant,system,rating\n" + lines);
            const auto done = program("report " + (scratch / "lab.csv") + " -o " + (scratch / "page.html"));
            INFO(done.err);
            REQUIRE(done.status == 0);
            return slurp(scratch / "page.html");
        };
        const std::string equal = page("P1,x,0.1\nP1,x,0.3\nP1,y,0.2\nP2,y,0.2\nP2,x,0.3\nP2,x,0.1\n");
        CHECK(contains(equal, "All systems had the same mean rating (0.20)."));
        CHECK_FALSE(contains(equal, "had the highest"));
        const std::string single = page("P1,x,3\n");
        CHECK(XmlDocument(single).count("//*[.='1 participant \u00b7 1 answer analysed \u00b7 1 system']") >
              0);
        CHECK_FALSE(contains(single, "had the"));
    }

    TEST_CASE("what export writes, and the report's own table of answers, give the database's numbers") {
        const Scratch scratch;
        for (const std::string study : {"genea-pairwise", "pointing2023-stand-ins"}) {
            const std::string database = scratch / (study + ".sqlite");
            REQUIRE(program("simulate " + study + " --participants 3 --db " + database + " --stimuli " +
                            sharedStimuli())
                        .status == 0);
            const auto analysis = [&](const std::string& data, const std::string& name) {
                const auto done =
                    program("report " + data + " --without-clips -o " + (scratch / "r.html") + " --json " +
                            (scratch / name) + " --csv " + (scratch / (study + "-csv")));
                INFO(done.err);
                REQUIRE(done.status == 0);
                return json::parse(slurp(scratch / name));
            };
            const json of_database = analysis(database, "a.json");
            REQUIRE(program("export " + database + " --anonymise -o " + (scratch / study)).status == 0);
            fs::copy_file(scratch / (study + "-csv/answers.csv"), scratch / (study + ".csv"));
            const json of_answers = analysis(scratch / (study + ".csv"), "b.json");
            const json of_export = analysis(scratch / (study + "/responses.csv"), "c.json");
            CHECK(pairsOf(of_database).size() >= 6);
            for (const json* other : {&of_answers, &of_export}) {
                CHECK(pairsOf(*other) == pairsOf(of_database));
                for (const char* key : {"chance", "response_times"})
                    CHECK(bySystem((*other)[key]) == bySystem(of_database[key]));
                CHECK((*other)["measures"] == of_database["measures"]);
                CHECK(rounded((*other)["order"]) == rounded(of_database["order"]));
                CHECK((*other)["synthetic"] == true);
            }
            CHECK(of_export["checks"] == of_database["checks"]);
        }
        const CsvTable asked(slurp(scratch / "genea-pairwise/questions.csv"));
        CHECK(asked.has({{"kind", "pairwise"},
                         {"question", "preference"},
                         {"answer", "scale"},
                         {"wording", "Which of the two movements looks more natural?"},
                         {"low", "-2"},
                         {"high", "2"},
                         {"option", "-2"},
                         {"option_text", "Clearly left"}}));
        CHECK(asked.has({{"option", "other"}, {"option_text", "something else"}}));
        const CsvTable responses(slurp(scratch / "genea-pairwise/responses.csv"));
        for (std::size_t row = 0; row < responses.rows.size(); ++row)
            CHECK_FALSE(responses.cell(row, "field_age").empty());
    }
}
