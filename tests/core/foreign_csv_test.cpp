// CSV as spreadsheets and experiment programs write it.
#include "core/foreign_csv.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace deixis;

namespace {

std::vector<std::vector<std::string>> read(const std::string& bytes) {
    const auto csv = readForeignCsv(bytes, "x.csv");
    REQUIRE_MESSAGE(csv, (csv ? "" : csv.error().text()));
    const auto records = parseCsv(csv->text, "x.csv", csv->form);
    REQUIRE_MESSAGE(records, (records ? "" : records.error().text()));
    std::vector<std::vector<std::string>> out;
    for (const CsvRecord& record : *records) out.push_back(record.fields);
    return out;
}

std::string utf16(const std::string& ascii_and_umlaut, bool big) {
    std::string out = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char c :
         ascii_and_umlaut) {  // a question mark stands for the umlaut, an exclamation mark for a clef
        const auto put = [&](unsigned unit) {
            const char high = static_cast<char>(unit >> 8U);
            const char low = static_cast<char>(unit & 0xFFU);
            out += big ? high : low;
            out += big ? low : high;
        };
        if (c == '!') {
            put(0xD834U);
            put(0xDD1EU);
        } else {
            put(c == '?' ? 0xFCU : static_cast<unsigned char>(c));
        }
    }
    return out;
}

using Rows = std::vector<std::vector<std::string>>;

}  // namespace

TEST_SUITE("core/foreign_csv") {
    TEST_CASE("Separators, comments, line ends and letters of other programs make the same table") {
        const Rows rows{{"id", "a,b"}, {"Z\xC3\xBCrich", "1;2"}};
        CHECK(read("id,\"a,b\"\nZ\xC3\xBCrich,1;2\n") == rows);
        CHECK(read("\xEF\xBB\xBFid;a,b\r\nZ\xC3\xBCrich;\"1;2\"\r\n") == rows);
        CHECK(read("id\ta,b\nZ\xC3\xBCrich\t1;2") == rows);
        CHECK(read("id\ta,b\rZ\xC3\xBCrich\t1;2\r") == rows);
        CHECK(read("sep=;\nid;a,b\nZ\xC3\xBCrich;\"1;2\"\n") == rows);
        CHECK(read("# made by a program; with, commas,,,\n\n# twice\nid;a,b\nZ\xC3\xBCrich;\"1;2\"\n") ==
              rows);
        CHECK(read("id;a,b\nZ\xFCrich;\"1;2\"\n") == rows);
        CHECK(read(utf16("id\ta,b\r\nZ?rich\t1;2\r\n", false)) == rows);
        CHECK(read(utf16("id\ta,b\r\nZ?rich\t1;2\r\n", true)) == rows);
        CHECK(read(utf16("x\n!\n", false)) == Rows{{"x"}, {"\xF0\x9D\x84\x9E"}});
        // A comma in quotes is none that parts; only what stands before the columns' names is a comment.
        CHECK(read("\"a,b,c\";d\n#1;2\n") == Rows{{"a,b,c", "d"}, {"#1", "2"}});
        CHECK(readForeignCsv("id\nZ\xFCrich\n", "x.csv")->taken_for_windows_1252 == "\xC3\xBC");
        CHECK(read("\x80,\x93\n") == Rows{{"\xE2\x82\xAC", "\xE2\x80\x9C"}});
    }

    TEST_CASE("What is no text is rejected; lines are counted with the comments") {
        const auto rejected = readForeignCsv("a,b\n1,\x81\n", "x.csv");
        REQUIRE_FALSE(rejected);
        CHECK(rejected.error().where == "x.csv:2");
        CHECK_FALSE(readForeignCsv(std::string("a\0b", 3), "x.csv"));
        CHECK_FALSE(readForeignCsv(std::string("\xFF\xFE\x00\xD8", 4), "x.csv"));
        CHECK_FALSE(readForeignCsv("PK\x03\x04xyz", "x.xlsx"));
        const auto csv = readForeignCsv("# one\n# two\na;b\n1;2;\"x\"y\n", "x.csv");
        const auto records = parseCsv(csv->text, "x.csv", csv->form);
        REQUIRE_FALSE(records);
        CHECK(records.error().where == "x.csv:4");
        CHECK(records.error().message.find("expected a semicolon") != std::string::npos);
    }

    TEST_CASE("A decimal comma stands between digits, once") {
        CHECK(decimalCommaAsPoint("3,5") == "3.5");
        CHECK(decimalCommaAsPoint("-0,25") == "-0.25");
        for (const char* other : {"3.5", "1,234,567", ",5", "5,", "-,5", "1.234,5", "a,5", "", "3"})
            CHECK_FALSE(decimalCommaAsPoint(other));
    }

    TEST_CASE("A guard against formulas is taken off again") {
        for (const char* text : {"=1+1", "-x", "@a", "plain", "'quoted'", ""})
            CHECK(withoutGuard(safeText(text)) == text);
    }
}
