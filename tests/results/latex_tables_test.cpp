// The tables for LaTeX: balanced, of even rows, without raw keys; compiled where there is a LaTeX.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "skipping.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

using Files = std::vector<std::pair<std::string, std::string>>;

/// Names with every sign that LaTeX takes for its own, and long ones.
Files tablesOfOddStudy() {
    const fixtures::Folder folder;
    const std::string odd = "[x] 50% & a_b #1 {y} $z$ ~^\\<|>";
    auto study = fixtures::study({odd, "*star", "a-system-with-a-very-long-name", "plain"});
    study.by_ratings = true;
    fixtures::fill(folder / "a.sqlite", study, 12, 6, true, {0.86, 0.95, 0.83, 0.46}, {4.0, 3.6, 2.6, 2.9},
                   fixtures::everything);
    ResponseTable table = loadResponses(folder / "a.sqlite").value();
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        table.rows[i].author_trial = 1 + static_cast<int>(i / 4 % 2);
    return analysisTables(analyse(table), TableFormat::latex);
}

int count(const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

/// The text without a backslash and the sign that it escapes. (A regular expression goes as deep as the text
/// is long.)
std::string withoutEscapes(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\\' && i + 1 < text.size() &&
            std::string("%&$#_{}").find(text[i + 1]) != std::string::npos)
            ++i;
        else
            out += text[i];
    return out;
}

/// "lrr" of "\begin{tabular}{lrr}" or "\begin{longtable}{lrr}", the first there is.
std::string columnsOf(const std::string& text) {
    for (const std::string begin : {"\\begin{tabular}{", "\\begin{longtable}{"})
        if (const auto at = text.find(begin); at != std::string::npos) {
            const auto from = at + begin.size();
            return text.substr(from, text.find('}', from) - from);
        }
    return "";
}

/// Of what is no comment and not escaped.
void checkTable(const std::string& name, const std::string& text) {
    CAPTURE(name);
    for (const char* environment : {"table", "tabular", "longtable"})
        CHECK(count(text, fmt::format("\\begin{{{}}}", environment)) ==
              count(text, fmt::format("\\end{{{}}}", environment)));
    CHECK(count(text, "\\begin{tabular}{}") + count(text, "\\begin{longtable}{}") == 0);
    const std::string bare = withoutEscapes(text);
    CHECK(count(bare, "{") == count(bare, "}"));
    CHECK(count(bare, "$") % 2 == 0);
    const std::string columns = columnsOf(bare);
    REQUIRE_FALSE(columns.empty());
    REQUIRE(columns.find_first_not_of("lr") == std::string::npos);
    std::istringstream lines(text);
    int rows = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::string plain = withoutEscapes(line);
        CHECK_FALSE(plain.starts_with("["));
        CHECK_FALSE(plain.starts_with("*"));
        if (!plain.ends_with(" \\\\") || plain.starts_with("\\label") || plain.starts_with("\\multicolumn"))
            continue;
        CHECK(count(plain, "&") + 1 == static_cast<int>(columns.size()));
        ++rows;
    }
    CHECK(rows > 1);
    // Neither keys of this program nor whole sums with decimals.
    for (const char* key : {"with\\_left\\_out", "without\\_doubtful", "answered\\_only", "sd\\_trials"})
        CHECK_FALSE(contains(text, key));
}

}  // namespace

TEST_SUITE("results/latex_tables") {
    TEST_CASE("Every table is balanced and its rows are even, whatever systems are called") {
        const Files tables = tablesOfOddStudy();
        bool places = false;
        for (const auto& [name, text] : tables) {
            checkTable(name, text);
            places = places || name == "target_space.tex";
        }
        CHECK(places);
        CHECK(tables.size() > 10);
        for (const std::string wanted :
             {"pairwise_ratings.tex", "author_trials.tex", "author_trials_by_participants.tex"})
            CHECK_MESSAGE(std::any_of(tables.begin(), tables.end(),
                                      [&](const auto& one) { return one.first == wanted; }),
                          wanted);
    }

    TEST_CASE("Sums of ranks are whole or halves, a range is one cell, a measure a line above its rows") {
        // Differences 1, 2, 3, 4 and 5, 5: midranks 5.5; W+ 21 of all.
        std::string text = "participant,system,measure,rating\n";
        for (const auto& [p, up] :
             std::vector<std::pair<int, int>>{{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, -5}})
            text += fmt::format("P{0},a,ease,{1}\nP{0},b,ease,10\n", p, 10 + up);
        for (const auto& [name, table] : analysisTables(fixtures::analyseText(text), TableFormat::latex))
            if (name == "pairwise.tex") {
                CHECK(contains(table, "{l}{\\emph{ease}} \\\\\n"));
                CHECK(contains(table, "a & b & 6 & 0 & 15.5 & "));
                CHECK(contains(table, ", "));
                CHECK_FALSE(contains(table, "hodges"));
            }
    }

    TEST_CASE("pdflatex takes all of them, and no line runs over") {
        if (std::system("command -v pdflatex >/dev/null 2>&1") != 0) {
            deixis::tests::tellSkipped("no pdflatex here: the tables are not compiled");
            return;
        }
        const fixtures::Folder folder;
        std::string document =
            "\\documentclass{article}\n\\usepackage[T1]{fontenc}\n\\usepackage{booktabs,longtable,graphicx}\n"
            "\\begin{document}\n";
        for (const auto& [name, text] : tablesOfOddStudy()) document += text + "\\clearpage\n";
        REQUIRE(writeFile(folder / "all.tex", document + "\\end{document}\n"));
        const std::string at = (folder / "").string();
        CHECK(std::system(fmt::format("cd '{}' && pdflatex -interaction=nonstopmode -halt-on-error all.tex "
                                      ">out.txt 2>&1",
                                      at)
                              .c_str()) == 0);
        const std::string out = readFile(folder / "out.txt").value();
        CHECK_FALSE(contains(out, "Overfull \\hbox"));
        CHECK_FALSE(contains(out, "Float too large"));
    }
}
