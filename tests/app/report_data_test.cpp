// deixis report on answers that come as CSV, and on several databases.
#include "program.hpp"
#include "text.hpp"

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

        const json out = json::parse(slurp(scratch / "first.json"));
        CHECK(out["schema"]["version"] == 2);
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
        CHECK(contains(slurp(scratch / "first/pairwise.csv"), "rank_biserial"));
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
        CHECK(contains(clash.err, "participant P10 stands in a.csv too"));
        CHECK_FALSE(fs::exists(scratch / "clash.html"));
        const auto nothing = report(scratch / "missing.csv", "missing");
        CHECK(nothing.status == 1);
        CHECK(contains(nothing.err, "missing.csv"));
    }
}
