// Answers that come as a CSV file, and several files together.
#include "results/answers/long_table.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

ResponseTable readLong(const std::string& text) {
    const fixtures::Folder folder;
    REQUIRE(writeFile(folder / "answers.csv", text).has_value());
    const auto table = loadAnswers(folder / "answers.csv");
    REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().text()));
    return *table;
}

std::string longTableError(const std::string& text) {
    const fixtures::Folder folder;
    REQUIRE(writeFile(folder / "answers.csv", text).has_value());
    const auto table = loadAnswers(folder / "answers.csv");
    REQUIRE_FALSE(table.has_value());
    return table.error().text();
}

bool anyNote(const ResponseTable& table, const std::string& part) {
    return std::any_of(table.notes.begin(), table.notes.end(),
                       [&](const std::string& note) { return contains(note, part); });
}

}  // namespace

TEST_SUITE("results/long_table") {
    TEST_CASE("Choices and ratings are read with what is known of them") {
        const auto table = readLong(
            "Participant,stage,system,layout,order,item,correct,rating,rt,attention,mood\r\n"
            "P2,game,b,across,2,T1,1,,3.5,,happy\r\n"
            "P1,rate,a,across,1,T1,,4,,,\r\n"
            "P1,game,a,side,0,\"T,2\",false,,1.25,0,\r\n"
            "P1,game,a,side,3,T3,1,,1,passed,\r\n"
            "P1,game,a,side,4,T3,1,,1,failed,\r\n"
            "P1,game,a,side,5,T3,NA,,,,\r\n");
        CHECK(table.systems == std::vector<std::string>{"b", "a"});
        CHECK(table.layouts == std::vector<std::string>{"across", "side"});
        CHECK(table.planned_participants == 2);
        REQUIRE(table.rows.size() == 3);
        CHECK(table.rows[0].participant == "P1");
        CHECK(table.rows[0].measure == "accuracy");
        CHECK(table.rows[0].value == 0.0);
        CHECK(table.rows[0].target_id == "T,2");
        CHECK(table.rows[0].response_time_s == 1.25);
        CHECK(table.rows[1].measure == "rate");
        CHECK(table.rows[1].value == 4.0);
        CHECK(table.rows[2].trial == 2);
        REQUIRE(table.measures.size() == 2);
        CHECK(table.measures[0].name == "accuracy");
        CHECK(table.measures[0].planned == 2);
        CHECK(table.measures[1].low == 4.0);
        REQUIRE(table.checks.size() == 1);
        CHECK(table.checks[0].passed == 1);
        CHECK(table.checks[0].failed == 1);
        CHECK(anyNote(table, "not read: mood"));
        CHECK(anyNote(table, "1 lines have no answer"));
    }

    TEST_CASE("Responses are right or wrong in a stage that has nothing else, else ratings; it is said") {
        const auto table = readLong(
            "participant,stage,system,response\nP1,game,a,1\nP1,game,b,0\nP1,mos,a,1\nP1,mos,b,5\nP1,mos,b,"
            "\n");
        REQUIRE(table.measures.size() == 2);
        CHECK(table.measures[0].name == "accuracy");
        CHECK(table.measures[1].name == "mos");
        CHECK(table.measures[1].kind == MeasureKind::rating);
        CHECK(table.measures[1].planned == 3);
        CHECK(table.rows.size() == 4);
        CHECK(anyNote(table, "Every response in \"game\" is 0 or 1"));
    }

    TEST_CASE("What cannot be read is told with its line and column") {
        CHECK(contains(longTableError("participant,rating\nP1,3\n"), "no column \"system\""));
        CHECK(contains(longTableError("participant,system,score\nP1,a,3\n"),
                       "none of the columns \"correct\""));
        CHECK(contains(longTableError("participant,system,rating\nP1,a,3\nP1,,3\n"),
                       ":3: column \"system\": is empty"));
        CHECK(contains(longTableError("participant,system,rating\nP1,a,good\n"),
                       ":2: column \"rating\": found \"good\", expected a number"));
        CHECK(contains(longTableError("participant,system,correct\nP1,a,2\n"), "expected 0 or 1"));
        CHECK(contains(longTableError("participant,system,rating\nP1,a\n"), "has 2 fields"));
        CHECK(contains(longTableError("participant,system,rating,rating\nP1,a,1,2\n"),
                       "several columns \"rating\""));
        CHECK(contains(longTableError("participant,system,rating\n"), "has no answers"));
        CHECK(contains(longTableError("participant,system,rating,rt\nP1,a,1,-2\n"), "seconds, from 0 up"));
        CHECK(contains(longTableError("participant,system,rating\nP1,a,inf\n"), "expected a number"));
    }

    TEST_CASE("Whole numbers may be written as decimals; who is excluded is told where nobody is left") {
        const auto table = readLong("participant,system,correct\nP1,a,1.0\nP1,b,0.0\nP1,b,\n");
        REQUIRE(table.rows.size() == 2);
        CHECK(table.rows[0].value == 1.0);
        CHECK(table.rows[1].value == 0.0);
        CHECK(contains(longTableError("participant,system,rating,excluded\nP1,a,3,late\n"),
                       "everybody who answered is excluded"));
        CHECK(contains(longTableError("participant,system,rating\nP1,a,1e300\n"), "from -1e12 to 1e12"));
    }

    TEST_CASE("A long file is read in parts as it is read whole") {
        // From two times 4 MiB on; a quoted field keeps a file from being cut.
        std::string lines;
        for (int i = 0; i < 9000; ++i)
            lines += fmt::format(
                "P{:03},s{},{},{},{},{},{},{}\n", (i * 7919) % 450, i % 3, i % 2 == 0 ? "across" : "side",
                i % 449, i % 5 == 0 ? "" : std::to_string(i % 2), i % 100 == 99 ? "" : std::to_string(i % 11),
                (i * 7919) % 450 == 44 ? "late" : "", std::string(1000, 'x'));
        const std::string head = "participant,system,layout,order,correct,rating,excluded,remark\n";
        const auto in_parts = readLong(head + lines);
        const auto whole =
            readLong("participant,system,layout,order,correct,rating,excluded,\"remark\"\n" + lines);
        REQUIRE(lines.size() > (std::size_t{8} << 20U));
        REQUIRE(in_parts.rows.size() == whole.rows.size());
        CHECK(answersHash(in_parts) == answersHash(whole));
        CHECK(in_parts.systems == whole.systems);
        CHECK(in_parts.layouts == whole.layouts);
        CHECK(in_parts.left_out_rows.size() == whole.left_out_rows.size());
        CHECK(in_parts.left_out.size() == 1);
        CHECK(in_parts.notes == whole.notes);
        CHECK(in_parts.planned_participants == whole.planned_participants);
        CHECK(in_parts.planned_participants == 449);
        REQUIRE(in_parts.measures.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(in_parts.measures[i].planned == whole.measures[i].planned);
            CHECK(in_parts.measures[i].high == whole.measures[i].high);
        }
        CHECK(contains(longTableError(head + lines + "P1,s1,side,1,2,,,\n"),
                       ":9002: column \"correct\": found \"2\""));
        CHECK(contains(longTableError(head + lines + "P000,s1,side,1,1,,late,\n"),
                       ":9002: column \"excluded\": found \"late\", but \"no\" in an earlier line"));
    }

    TEST_CASE("Several files are one study; a participant who stands in two is told") {
        const std::string head = "participant,system,rating\n";
        const auto a = readLong(head + "P1,a,1\nP1,b,2\n");
        const auto b = readLong(head + "P2,a,3\nP2,c,4\n");
        const auto both = joinTables({a, b});
        REQUIRE(both.has_value());
        CHECK(both->systems == std::vector<std::string>{"a", "b", "c"});
        CHECK(both->rows.size() == 4);
        CHECK(both->measures.size() == 1);
        CHECK(both->measures[0].high == 4.0);
        CHECK(both->planned_participants == 2);
        const auto clash = joinTables({a, b, a});
        REQUIRE_FALSE(clash.has_value());
        CHECK(contains(clash.error().text(), "participant P1 is also in"));
        auto other = b;
        other.study_hash = "f00";
        CHECK(contains(joinTables({a, other}).error().text(), "Only databases of the same study file"));
        CHECK(answersHash(*both) == answersHash(*joinTables({b, a})));
        CHECK(answersHash(a) != answersHash(b));
    }

    TEST_CASE("The table of answers is read again as what it was written from") {
        const auto table = readLong(
            "participant,stage,system,layout,item,order,correct,rating,rt\nP1,g,a,across,T1,0,1,,0.1\n"
            "P1,g,b,across,T1,1,0,,2\nP1,naturalness,a,,T2,2,,0.1,\nP2,naturalness,b,,T2,3,,-7.25,\n");
        const auto first = analyse(table);
        std::string answers;
        for (const auto& [name, bytes] : analysisTables(first, TableFormat::csv))
            if (name == "answers.csv") answers = bytes;
        const auto again = readLong(answers);
        REQUIRE(again.rows.size() == table.rows.size());
        CHECK(answersHash(again) == answersHash(table));
        const auto second = analyse(again);
        for (std::size_t i = 0; i < first.pairwise.size(); ++i)
            CHECK(first.pairwise[i].test.p_two_sided == second.pairwise[i].test.p_two_sided);
    }

    TEST_CASE("LaTeX is safe against what people typed") {
        const auto table = readLong("participant,system,rating\nP1,\"a_1 & {b} \\ 100%\",1\nP2,c,2\n");
        for (const auto& [name, bytes] : analysisTables(analyse(table), TableFormat::latex)) {
            CHECK(contains(bytes, "\\begin{tabular}"));
            if (name == "means.tex") CHECK(contains(bytes, "a\\_1 \\& \\{b\\} \\textbackslash{} 100\\%"));
        }
    }
}
