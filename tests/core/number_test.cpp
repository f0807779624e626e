#include "core/number.hpp"

#include <doctest/doctest.h>

using namespace deixis;

TEST_SUITE("core/number") {
    TEST_CASE("a number is finite, decimal and the whole of the text") {
        CHECK(finiteNumber("0.5") == 0.5);
        CHECK(finiteNumber("-2") == -2.0);
        CHECK(finiteNumber("1e-3") == 0.001);
        CHECK(wholeNumber("-12") == -12);
        CHECK(naturalNumber("18446744073709551615") == 18446744073709551615ULL);
        for (const char* text : {"", " ", "nan", "-nan", "NaN", "inf", "-inf", "infinity", "1e400", "1x",
                                 "1 ", " 1", "+1", "0x10", "1,5", "one", "1e", "--1"}) {
            CAPTURE(text);
            CHECK_FALSE(finiteNumber(text).has_value());
            CHECK_FALSE(wholeNumber(text).has_value());
            CHECK_FALSE(naturalNumber(text).has_value());
        }
        for (const char* text : {"1.5", "1e3", "99999999999999999999"}) {
            CAPTURE(text);
            CHECK(finiteNumber(text).has_value());
            CHECK_FALSE(wholeNumber(text).has_value());
            CHECK_FALSE(naturalNumber(text).has_value());
        }
        CHECK_FALSE(naturalNumber("-1").has_value());
    }
}
