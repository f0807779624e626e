// Tables of answers as other programs write them, preferences, and what may be doubted.
#include <doctest/doctest.h>

#include <algorithm>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "results/answers/long_table.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

Result<ResponseTable> readForeign(const std::string& text, const LongTableOptions& options = {}) {
    const fixtures::Folder folder;
    REQUIRE(writeFile(folder / "answers.csv", text).has_value());
    return loadAnswers(folder / "answers.csv", options);
}

ResponseTable foreignTable(const std::string& text, const LongTableOptions& options = {}) {
    auto table = readForeign(text, options);
    REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().text()));
    return *table;
}

std::string foreignError(const std::string& text, const LongTableOptions& options = {}) {
    const auto table = readForeign(text, options);
    REQUIRE_FALSE(table.has_value());
    return table.error().text();
}

int notesWith(const ResponseTable& table, const std::string& part) {
    return static_cast<int>(std::count_if(table.notes.begin(), table.notes.end(),
                                          [&](const std::string& note) { return contains(note, part); }));
}

/// Five participants: b clearly better than a, three times slightly, once neither; a stands left in half.
const std::string pairs =
    "participant,measure,system,other_system,rating,order\n"
    "P1,preference,a,b,2,0\nP2,preference,b,a,-1,0\nP3,preference,a,b,1,0\nP4,preference,b,a,-1,0\n"
    "P5,preference,a,b,0,0\n";

}  // namespace

TEST_SUITE("results/long_table_foreign") {
    TEST_CASE("Preferences come from pairs; positive is for the other system, whichever stood left") {
        const AnalysisResult result = fixtures::analyseText(pairs);
        REQUIRE(result.preferences.size() == 1);
        const PreferenceResult& pair = result.preferences.front();
        CHECK(pair.a == "a");
        CHECK(pair.prefers_a == 0);
        CHECK(pair.ties == 1);
        CHECK(pair.prefers_b == 4);
        CHECK(pair.mean == -1.0);               // (2 + 1 + 1 + 1 + 0) / 5, for b
        CHECK(pair.test.p_two_sided == 0.125);  // 2 / 2^4: all four differences on one side
        CHECK(result.pairwise.empty());

        // Its own table of answers gives the same again.
        const AnalysisResult again = fixtures::analyseText(fixtures::csvOf(result, "answers.csv"));
        REQUIRE(again.preferences.size() == 1);
        CHECK(again.preferences.front().prefers_b == 4);
        CHECK(again.preferences.front().mean == -1.0);
        CHECK(answersHash(again.table) == answersHash(result.table));

        CHECK(contains(foreignError(pairs + "P6,preference,a,b,3,0\n"), "from -2 (clearly for \"system\")"));
        CHECK(contains(foreignError(pairs + "P6,preference,a,a,1,0\n"), "expected another one than in"));
        CHECK(contains(foreignError(pairs + "P6,ease,a,b,1,0\n"), "found preferences in \"ease\""));
        CHECK(contains(foreignError(pairs + "P6,preference,a,,1,0\n"),
                       "is a rating here and a preference elsewhere"));
    }

    TEST_CASE("A rating that is called preference is a rating") {
        const AnalysisResult result = fixtures::analyseText(
            "participant,system,measure,rating\nP1,a,preference,2\nP1,b,preference,7\nP2,a,preference,1\n"
            "P2,b,preference,4\n");
        CHECK(result.preferences.empty());
        REQUIRE(result.pairwise.size() == 1);
        CHECK(result.pairwise.front().measure == "preference");
        CHECK(result.pairwise.front().mean_difference == -4.0);
        CHECK(contains(foreignError("participant,system,measure,rating\nP1,a,accuracy,2\n"),
                       "a rating is called \"accuracy\""));
    }

    TEST_CASE("Columns are mapped, and what is missing is told with the columns and the separator found") {
        const std::string text =
            "# PsychoPy\nsubject;cond;slider.response;slider.rt\nA;x;3,5;1200\nA;y;4,0;900\n";
        const auto table = foreignTable(text, {{},
                                               {},
                                               {{"participant", "subject"},
                                                {"system", "cond"},
                                                {"rating", "slider.response"},
                                                {"rt_ms", "slider.rt"}}});
        REQUIRE(table.rows.size() == 2);
        CHECK(table.rows[0].value == 3.5);
        CHECK(table.rows[0].response_time_s == 1.2);
        CHECK(notesWith(table, "Commas in numbers are read as decimal points, as in \"3,5\" in line 3") == 1);
        const std::string error = foreignError(text);
        CHECK(contains(error, "has no column \"participant\""));
        CHECK(contains(error, "separated by a semicolon: subject, cond, slider.response, slider.rt"));
        CHECK(contains(error, "--column participant=NAME"));
        CHECK(contains(foreignError(text, {{}, {}, {{"participant", "id"}}}), "there is no such column"));
        CHECK(contains(foreignError(text, {{}, {}, {{"person", "subject"}}}),
                       "which is not a column that is read"));
        CHECK(contains(foreignError("participant;system;rating;rt\nA;x;3,5;1.5\n"),
                       "a decimal comma (\"3,5\" in line 2) and with a decimal point (\"1.5\" in line 2)"));
        CHECK(foreignTable("participant,system,rating,rt_s\nA,x,3,1.5\n").rows[0].response_time_s == 1.5);
        // The mapped column stands for the one that has the name.
        CHECK(foreignTable("participant,code,system,rating\nS,Q1,x,3\n", {{}, {}, {{"participant", "code"}}})
                  .rows[0]
                  .participant == "Q1");
    }

    TEST_CASE("A declared scale is the scale, and nothing lies beyond it") {
        const std::string text = "participant,system,measure,rating\nP1,a,ease,2\nP1,b,ease,4\n";
        const auto table = foreignTable(text, {{}, {}, {}, {{"ease", {1.0, 7.0}}}});
        CHECK(table.measures.front().low == 1.0);
        CHECK(table.measures.front().high == 7.0);
        CHECK(contains(foreignError(text + "P1,b,ease,999\n", {{}, {}, {}, {{"ease", {1.0, 7.0}}}}),
                       ":4: column \"rating\": found \"999\", beyond the scale of ease (1 to 7)"));
        CHECK(contains(foreignError(text, {{}, {}, {}, {{"easy", {1.0, 7.0}}}}), "Its ratings: ease"));
        // Scales that stand in the file keep a measure apart, as a study's do.
        const std::string head = "participant,system,measure,rating,scale_low,scale_high\n";
        const auto one = foreignTable(head + "P1,a,ease,2,1,5\nP1,b,ease,3,1,5\n");
        CHECK(one.measures.size() == 1);
        CHECK(one.measures.front().name == "ease");
        CHECK(one.measures.front().high == 5.0);
        CHECK(one.rows[0].measure == "ease");
        const auto two = foreignTable(head + "P1,a,ease,2,1,5\nP1,b,ease,3,1,10\n");
        REQUIRE(two.measures.size() == 2);
        CHECK(two.measures[0].name == "ease (1 to 5)");
        CHECK(two.measures[1].high == 10.0);
    }

    TEST_CASE("Doubts are told and change nothing; a plain table has none") {
        std::string text = "participant,system,item,rating,rt\n";
        for (const char* who : {"P01", "P02"})
            for (int i = 1; i <= 5; ++i)
                text += std::string(who) + ",a,T" + std::to_string(i) + "," + std::to_string(i) + ",2\n";
        CHECK(foreignTable(text).notes.empty());
        const auto doubtful = [&](const std::string& lines, const std::string& note) {
            const auto table = foreignTable(text + lines);
            CHECK_MESSAGE(notesWith(table, note) == 1, note);
            CHECK(table.notes.size() == 1);
            CHECK(table.rows.size() ==
                  10 + static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')));
        };
        doubtful("P1,a,T1,3,2\n",
                 "Participants that differ only in case, spaces or zeros count as different: "
                 "\"P01\" and \"P1\"");
        doubtful("P02,a,T9,999,2\n", "1 answer of rating is 999, far from the others (1 to 5)");
        doubtful("P02,a,T9,-1,2\nP02,a,T8,-1,2\n", "2 answers of rating are -1");
        doubtful("P02,a,T3,1,2\n", "1 answer has the same participant");
        CHECK(foreignTable(text + "P02,b,T3,1,2\n").notes.empty());
        CHECK(notesWith(foreignTable("participant,system,rating,rt\nP,a,1,1500\nP,a,2,2000\n"),
                        "rt_ms=NAME") == 1);
        const auto checks = foreignTable("participant,system,rating,failed_attention\nP,a,1,0\nQ,a,2,1\n");
        CHECK(notesWith(checks, "--column excluded=failed_attention") == 1);
        CHECK(notesWith(foreignTable("participant,system,rating\nJ\xFCrgen,a,1\n"), "Windows-1252") == 1);
        CHECK(notesWith(foreignTable("participant,system,rating\nJ\xC3\x83\xC2\xBCrgen,a,1\n"),
                        "and saved") == 1);
        // Without an item or a place among the trials, answers may be alike.
        CHECK(foreignTable("participant,system,rating\nP,a,1\nP,a,1\nP,a,3\n").notes.empty());
        // On a scale that has them, such numbers are answers.
        CHECK(foreignTable("participant,system,rating\nP,a,-1\nP,a,0\nP,a,1\n").notes.empty());
        CHECK(foreignTable("participant,system,rating\nP,a,0\nP,a,99\nP,a,100\n").notes.empty());
    }

    TEST_CASE("Names that spreadsheets would take for formulas or cut at commas are written and read again") {
        const auto result = fixtures::analyseText(
            "participant,system,rating,\"=a, b\"\nP1,-x,1,\"+1,\"\nP1,y,2,q\nP2,-x,3,q\nP2,y,4,\"+1,\"\n",
            {{}, {"=a, b"}});
        const std::string answers = fixtures::csvOf(result, "answers.csv");
        CHECK(tests::CsvTable(answers).header.back() == "'=a, b");
        const fixtures::Folder folder;
        const auto again = foreignTable(answers, {{}, {"=a, b"}});
        REQUIRE(again.within.size() == 1);
        CHECK(again.within[0].name == "=a, b");
        CHECK(again.systems == std::vector<std::string>{"-x", "y"});
        CHECK(again.rows[0].within[0] == "+1,");
        CHECK(answersHash(again) == answersHash(result.table));
    }
}
