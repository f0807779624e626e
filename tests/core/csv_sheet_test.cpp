#include "core/csv_sheet.hpp"

#include <doctest/doctest.h>

using namespace deixis;

TEST_SUITE("core/csv_sheet") {
    TEST_CASE("Columns are found by name and cells read as numbers") {
        const auto sheet = parseCsvSheet("\xEF\xBB\xBFid,\"x\"\n\"a\nb\",-2.5\n", "f.csv");
        REQUIRE(sheet.has_value());
        REQUIRE(sheet->rows.size() == 1);
        CHECK(sheet->rows[0].fields[sheet->find("id").value()] == "a\nb");
        CHECK(sheet->number(sheet->rows[0], sheet->column("x").value()).value() == -2.5);
        CHECK(parseCsvSheet("", "f.csv")->header.fields.empty());
    }

    TEST_CASE("What is missing or no number is named with file, line and column") {
        CHECK(parseCsvSheet("a,b\n1,2\n\n3\n", "f.csv").error().text() ==
              "f.csv:4: found 1 field, expected 2 as in the header");
        const auto sheet = parseCsvSheet("a,b\n1,inf\n", "f.csv");
        REQUIRE(sheet.has_value());
        CHECK(sheet->column("c", "Add it").error().text() ==
              "f.csv:1: the column 'c' is missing from the header. Add it");
        CHECK(sheet->number(sheet->rows[0], 1).error().text() ==
              "f.csv:2: b: found 'inf', expected a finite number");
        CHECK(sheet->number(sheet->rows[0], 0, "at most 0.5", 0.5).error().text() ==
              "f.csv:2: a: found '1', expected at most 0.5");
        CHECK(parseCsvSheet("a,b,a\n", "f.csv")->column("a").error().text() ==
              "f.csv:1: the column 'a' is in the header more than once");
    }

    TEST_CASE("Names stand without the blanks around them, whatever parts them") {
        const auto sheet = parseCsvSheet("# made by hand\n a ;\"b c\" \n1; 2\n", "f.csv", {';', true, true});
        REQUIRE(sheet.has_value());
        CHECK(sheet->header.fields == std::vector<std::string>{"a", "b c"});
        CHECK(sheet->place(sheet->rows[0], 1) == "f.csv:3: b c");
        CHECK(sheet->rows[0].fields[1] == "2");
        CHECK(parseCsvSheet(" a ,b\n 1 ,2\n", "f.csv")->rows[0].fields[0] == " 1 ");
    }

    TEST_CASE("Rows are read one by one behind the header") {
        CsvReader reader("\n a  b\t c \r\n \t\n1 \"2 3\"\t4\r\n5\n", "f.txt", {' ', false, true});
        const auto sheet = readCsvHeader(reader, "f.txt");
        REQUIRE(sheet.has_value());
        CHECK(sheet->header.line == 2);
        CHECK(sheet->header.fields == std::vector<std::string>{"a", "b", "c"});
        CsvRecord row;
        REQUIRE(reader.next(row).value());
        CHECK(row.fields == std::vector<std::string>{"1", "2 3", "4"});
        CHECK(sheet->checkWidth(row).has_value());
        REQUIRE(reader.next(row).value());
        CHECK(sheet->checkWidth(row).error().text() == "f.txt:5: found 1 field, expected 3 as in the header");
        CHECK_FALSE(reader.next(row).value());
        CsvReader tabs("a\tb\t\n \t\t\n\t1\t2\n", "f.tsv", {'\t', false, true});
        REQUIRE(readCsvHeader(tabs, "f.tsv")->header.fields == std::vector<std::string>{"a", "b", ""});
        REQUIRE(tabs.next(row).value());
        CHECK(row.fields == std::vector<std::string>{"", "1", "2"});  // a tab first stands for an empty field
    }
}
