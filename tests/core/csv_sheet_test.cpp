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
              "f.csv:4: found 1 fields, expected 2 as in the header");
        const auto sheet = parseCsvSheet("a,b\n1,inf\n", "f.csv");
        REQUIRE(sheet.has_value());
        CHECK(sheet->column("c", "Add it").error().text() ==
              "f.csv:1: the column 'c' is missing from the header. Add it");
        CHECK(sheet->number(sheet->rows[0], 1).error().text() ==
              "f.csv:2: b: found 'inf', expected a finite number");
        CHECK(sheet->number(sheet->rows[0], 0, "at most 0.5", 0.5).error().text() ==
              "f.csv:2: a: found '1', expected at most 0.5");
    }
}
