// deixis stats against right answers made by other programs: the cases of tests/results/oracles as files,
// through the whole program, and every number that scripts may rely on.
#include <cmath>

#include "program.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

json oracleCases(const std::string& test) {
    const json file = json::parse(slurp(sourceDir() / ("tests/results/oracles/" + test + ".json")));
    REQUIRE(file["cases"].size() >= 30);
    return file["cases"];
}

/// Columns of cells as a CSV file with a column that is no number before them; shorter ones end in empty
/// cells.
std::string tableOf(const std::vector<json>& columns) {
    std::string out = "who";
    std::size_t rows = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        out += ",c" + std::to_string(c);
        rows = std::max(rows, columns[c].size());
    }
    out += "\r\n";
    for (std::size_t r = 0; r < rows; ++r) {
        out += "\"P, " + std::to_string(r) + "\"";
        for (const json& column : columns) {
            const json cell = r < column.size() ? column[r] : json("");
            out += "," + (cell.is_string() ? cell.get<std::string>() : cell.is_null() ? "" : cell.dump());
        }
        out += "\r\n";
    }
    return out;
}

json answer(const std::string& test, const std::vector<json>& columns, const std::string& options = "") {
    const Scratch scratch;
    spill(scratch / "data.csv", tableOf(columns));
    std::string names;
    for (std::size_t c = 0; c < columns.size(); ++c) names += (c == 0 ? "c" : ",c") + std::to_string(c);
    const auto done =
        program("stats " + test + " " + (scratch / "data.csv") + " --columns " + names + " --json" + options);
    INFO(done.err);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
}

std::string levelOption(const json& expected) {
    return " --level " + expected["level"].dump();
}

/// Null agrees with null only; numbers within `relative`, or `absolute` near 0.
void agree(const json& found, const json& expected, double relative = 1e-9, double absolute = 1e-13) {
    CAPTURE(found.dump());
    CAPTURE(expected.dump());
    REQUIRE(found.is_null() == expected.is_null());
    if (expected.is_null()) return;
    const double right = expected.get<double>();
    CHECK(std::abs(found.get<double>() - right) <= relative * std::abs(right) + absolute);
}

void agreeOn(const std::vector<const char*>& keys, const json& found, const json& expected) {
    for (const char* key : keys) {
        CAPTURE(key);
        REQUIRE(found.contains(key));
        agree(found[key], expected[key]);
    }
}

const std::vector<const char*> interval_keys{"estimate", "lower", "upper", "level"};

}  // namespace

TEST_SUITE("app/stats_oracles") {
    TEST_CASE("signed-rank prints what the enumeration, R and SciPy say") {
        for (const json& expected : oracleCases("signed_rank")) {
            CAPTURE(expected["name"].get<std::string>());
            const json found = answer("signed-rank", {expected["a"], expected["b"]}, levelOption(expected));
            agreeOn({"n_pairs", "n_missing", "n_zero", "n_positive", "n_negative", "ties", "w_plus",
                     "w_minus", "p_two_sided", "p_greater", "p_less", "rank_biserial", "paired_superiority"},
                    found, expected);
            agreeOn(interval_keys, found["hodges_lehmann"], expected["hodges_lehmann"]);
            agree(found["pratt"]["w_plus"], expected["pratt_w_plus"]);
            agree(found["pratt"]["p_two_sided"], expected["pratt_p_two_sided"]);
            CHECK(found["z"] == found["normal"]["z"]);
            if (expected.contains("scipy"))
                agree(found["normal"]["p_two_sided"], expected["scipy"]["normal_p"]);
            const bool all_zero = expected["n_zero"] == expected["n_pairs"];
            CHECK(found["z"].is_null() == all_zero);
            CHECK(found["method"] == (all_zero                ? "no differences"
                                      : expected["ties"] == 0 ? "exact"
                                                              : "exact with ties"));
        }
    }

    TEST_CASE("rank-sum prints what the enumeration, R and SciPy say") {
        for (const json& expected : oracleCases("rank_sum")) {
            CAPTURE(expected["name"].get<std::string>());
            const json found = answer("rank-sum", {expected["a"], expected["b"]}, levelOption(expected));
            if (!expected.contains("u")) {
                for (const char* key : {"u", "p_two_sided", "p_greater", "p_less", "a12", "cliffs_delta"})
                    CHECK(found[key].is_null());
                CHECK(found["method"] == "undefined");
                CHECK(found.contains("note"));
                continue;
            }
            agreeOn({"u", "a12", "cliffs_delta"}, found, expected);
            agreeOn(interval_keys, found["hodges_lehmann"], expected["hodges_lehmann"]);
            if (expected.contains("p_less"))
                agreeOn({"p_two_sided", "p_greater", "p_less"}, found, expected);
            else
                agree(found["p_less"], expected["r"]["less"]);
            if (expected.contains("scipy"))
                agree(found["normal"]["p_two_sided"], expected["scipy"]["normal_p"]);
        }
    }

    TEST_CASE("friedman prints what R says") {
        for (const json& expected : oracleCases("friedman")) {
            CAPTURE(expected["name"].get<std::string>());
            const json& r = expected["r"];
            if (!r.contains("chi2")) continue;
            std::vector<json> columns(expected["rows"][0].size());
            for (const json& row : expected["rows"])
                for (std::size_t c = 0; c < row.size(); ++c) columns[c].push_back(row[c]);
            const json found = answer("friedman", columns);
            CHECK(found["df"] == r["df"]);
            if (!r["chi2"].is_number()) {
                for (const char* key : {"chi2", "p", "kendalls_w"}) CHECK(found[key].is_null());
                CHECK(found.contains("note"));
                continue;
            }
            agreeOn({"chi2", "p"}, found, r);
            agree(found["kendalls_w"], r["w"]);
            const json& f = found["iman_davenport"];
            CHECK(f["df1"] == r["df"]);
            CHECK(f["df2"] == r["df"].get<int>() * (found["n"].get<int>() - 1));
            if (f["f"].is_null()) {
                CHECK(!r["f"].is_number());
                CHECK(found.contains("note"));
                continue;
            }
            agree(f["f"], r["f"]);
            agree(f["p"], r["f_p"], 1e-8);
        }
    }

    TEST_CASE("shapiro, spearman and holm print what R, SciPy and the enumeration say") {
        for (const json& expected : oracleCases("shapiro")) {
            const json found = answer("shapiro", {expected["x"]});
            agree(found["w"], expected["r"]["w"]);
            agree(found["p"], expected["r"]["p"], 1e-6, 1e-12);
        }
        for (const json& expected : oracleCases("spearman")) {
            CAPTURE(expected["name"].get<std::string>());
            const json found = answer("spearman", {expected["x"], expected["y"]});
            agree(found["rho"], expected.contains("rho") ? expected["rho"] : json());
            if (!expected.contains("rho")) CHECK(found["p"].is_null());
            if (expected.contains("p")) agree(found["p"], expected["p"]);
            if (expected.contains("rho"))
                CHECK(found["method"] == (expected["x"].size() <= 9 ? "exact" : "t"));
        }
        for (const json& expected : oracleCases("holm")) {
            const json found = answer("holm", {expected["p"]});
            REQUIRE(found["adjusted"].size() == expected["adjusted"].size());
            for (std::size_t i = 0; i < found["adjusted"].size(); ++i)
                agree(found["adjusted"][i], expected["adjusted"][i], 1e-14);
        }
    }

    TEST_CASE("describe and proportion print what R says") {
        for (const json& expected : oracleCases("describe")) {
            const json found = answer("describe", {expected["x"]});
            const json& r = expected["r"];
            agreeOn({"mean", "min", "max", "mad"}, found, r);
            const char* const quantiles[] = {"q05", "q25", "median", "q75", "q95"};
            for (std::size_t q = 0; q < 5; ++q) agree(found[quantiles[q]], r["q"][q], 1e-12);
            if (expected["x"].size() > 1)
                agree(found["sd"], r["sd"], 1e-9, 1e-12);
            else
                CHECK(found["sd"].is_null());
        }
        for (const json& expected : oracleCases("proportion")) {
            const int n = expected["n"];
            if (n > 10000) continue;
            json cells = json::array();
            for (int i = 0; i < n; ++i) cells.push_back(i < expected["successes"].get<int>() ? "1" : "0");
            const json found = answer("proportion", {cells},
                                      " --chance " + expected["chance"].dump() + levelOption(expected));
            CHECK(found["successes"] == expected["successes"]);
            CHECK(found["n"] == n);
            agree(found["estimate"], expected["successes"].get<double>() / n);
            agreeOn({"lower", "upper", "p_chance"}, found, expected["r"]);
        }
    }
}
