// Decimal numbers in text, read quickly: the same as std::from_chars, to the last bit.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <system_error>

namespace deixis::assets {

namespace decimal_detail {

/// How many of the eight characters, from the first on, are digits.
inline unsigned leadingDigits(std::uint64_t characters) {
    const std::uint64_t others =
        ((characters + 0x4646464646464646U) | (characters - 0x3030303030303030U)) & 0x8080808080808080U;
    return others == 0 ? 8U : static_cast<unsigned>(std::countr_zero(others)) / 8U;
}

/// The number that the first `count` (1 to 8) characters are, all digits. Pairs, fours and eights of digits
/// are joined in one word.
inline std::uint64_t valueOf(std::uint64_t characters, unsigned count) {
    std::uint64_t digits = (characters - 0x3030303030303030U) << (64U - 8U * count);
    digits = digits * 10U + (digits >> 8U);
    constexpr std::uint64_t mask = 0x000000FF000000FFU;
    return (((digits & mask) * 0x000F424000000064U) + (((digits >> 16U) & mask) * 0x0000271000000001U)) >>
           32U;
}

constexpr std::array<std::uint64_t, 9> powers_of_ten{1,      10,      100,      1000,     10000,
                                                     100000, 1000000, 10000000, 100000000};

}  // namespace decimal_detail

/// Reads the number at `begin` as std::from_chars does and returns where it ends; null if there is none or
/// it is beyond a double's range. Up to 15 digits without exponent, which is nearly every number in motion
/// data, go the short way: digits and power of ten are doubles without error, so that their quotient is the
/// nearest double (Clinger 1990, "How to read floating point numbers accurately").
inline const char* readDecimal(const char* begin, const char* end, double& value) {
    using namespace decimal_detail;
    constexpr std::ptrdiff_t looked_at = 1 + 7 + 1 + 8 + 8;  // sign, whole part, point, fraction, some more
    if constexpr (std::endian::native == std::endian::little) {
        if (end - begin >= looked_at) {
            const char* at = begin;
            const bool negative = *at == '-';
            if (negative) ++at;
            std::uint64_t characters = 0;
            std::memcpy(&characters, at, 8);
            const unsigned whole_digits = leadingDigits(characters);
            if (whole_digits > 0 && whole_digits < 8) {
                std::uint64_t digits = valueOf(characters, whole_digits);
                at += whole_digits;
                unsigned fraction_digits = 0;
                if (*at == '.') {
                    std::memcpy(&characters, at + 1, 8);
                    fraction_digits = leadingDigits(characters);
                    if (fraction_digits > 0) {
                        digits =
                            digits * powers_of_ten[fraction_digits] + valueOf(characters, fraction_digits);
                        at += 1 + fraction_digits;
                    }
                }
                // A point without digits, a ninth digit and an exponent go the long way.
                if (*at != '.' && *at != 'e' && *at != 'E' && !(*at >= '0' && *at <= '9')) {
                    const double magnitude =
                        static_cast<double>(digits) / static_cast<double>(powers_of_ten[fraction_digits]);
                    value = negative ? -magnitude : magnitude;
                    return at;
                }
            }
        }
    }
    const auto [stop, problem] = std::from_chars(begin, end, value);
    return problem == std::errc{} ? stop : nullptr;
}

}  // namespace deixis::assets
