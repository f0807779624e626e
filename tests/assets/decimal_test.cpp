#include "assets/joints/decimal.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <string>

#include "core/random.hpp"

using namespace deixis;

namespace {

/// The number at the start of the text, at its end and in the midst of more: each as std::from_chars reads
/// it.
void checkSame(const std::string& text) {
    for (const char* after :
         {"", " ", "\n", " 12345678901234567890 and more", "e", ".", "x123456789012345678901"}) {
        const std::string whole = text + after;
        const char* end = whole.data() + whole.size();
        double expected = 0.0;
        const auto [stop, problem] = std::from_chars(whole.data(), end, expected);
        double found = 0.0;
        const char* found_stop = assets::readDecimal(whole.data(), end, found);
        INFO(whole);
        if (problem != std::errc{}) {
            CHECK(found_stop == nullptr);
            continue;
        }
        CHECK(found_stop == stop);
        CHECK(std::bit_cast<std::uint64_t>(found) == std::bit_cast<std::uint64_t>(expected));
    }
}

}  // namespace

TEST_SUITE("assets/decimal") {
    TEST_CASE("Numbers of every shape are read to the bit as by std::from_chars") {
        for (const char* text : {"0",
                                 "-0",
                                 "0.0",
                                 "-0.000000",
                                 "1",
                                 "-1",
                                 "12345678",
                                 "1234567",
                                 "123456789",
                                 "0.1",
                                 ".5",
                                 "-.5",
                                 "5.",
                                 "-5.",
                                 ".",
                                 "-",
                                 "",
                                 "--1",
                                 "+1",
                                 "1e5",
                                 "1.5e-7",
                                 "1E+3",
                                 "1e999",
                                 "1e-400",
                                 "nan",
                                 "inf",
                                 "-inf",
                                 "0x10",
                                 "1,5",
                                 "0.12345678",
                                 "0.123456789",
                                 "1234567.12345678",
                                 "9999999.99999999",
                                 "0.30000000000000004",
                                 "179.99999999999997",
                                 "4.9e-324",
                                 "1.7976931348623157e308",
                                 "00001.5",
                                 "0000000000000000000000001.5",
                                 "9007199254740993",
                                 "3.14159265358979323846"})
            checkSame(text);
    }

    TEST_CASE("A hundred thousand numbers as motion files hold them are the same to the bit") {
        Random random(5);
        int different = 0;
        for (int i = 0; i < 100000; ++i) {
            const double value = 400.0 * random.uniform() - 200.0;
            const int digits = static_cast<int>(random.below(18));
            const std::string text =
                random.below(4) == 0 ? fmt::format("{}", value) : fmt::format("{:.{}f}", value, digits);
            const std::string line = text + " 0.125 -17.25 44.000000";
            double expected = 0.0;
            double found = 0.0;
            const auto stop = std::from_chars(line.data(), line.data() + line.size(), expected).ptr;
            const char* found_stop = assets::readDecimal(line.data(), line.data() + line.size(), found);
            different += found_stop == stop &&
                                 std::bit_cast<std::uint64_t>(found) == std::bit_cast<std::uint64_t>(expected)
                             ? 0
                             : 1;
        }
        CHECK(different == 0);
    }
}
