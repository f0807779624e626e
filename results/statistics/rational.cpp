#include "results/statistics/rational.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "big_rational.hpp"
#include "core/text.hpp"

namespace deixis::results {

namespace {

constexpr int max_exponent = 1000;
constexpr std::size_t max_digits = 1000;
constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();

Int128 magnitude(Int128 value) {
    return value < 0 ? -value : value;
}

Int128 gcd128(Int128 a, Int128 b) {
    while (b != 0) {
        if (a <= largest && b <= largest)
            return std::gcd(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
        a = std::exchange(b, a % b);
    }
    return a;
}

BigInt bigOf(Int128 value) {
    const Int128 size = magnitude(value);
    BigInt out = static_cast<std::uint64_t>(size >> 64);
    out <<= 64;
    out += static_cast<std::uint64_t>(size);
    return value < 0 ? BigInt(-out) : out;
}

/// In lowest terms, small where it fits; the denominator is positive.
Rational reduced(Int128 numerator, Int128 denominator) {
    const Int128 divisor = gcd128(magnitude(numerator), denominator);
    if (divisor > 1) {
        numerator /= divisor;
        denominator /= divisor;
    }
    if (magnitude(numerator) <= largest && denominator <= largest) {
        if (denominator == 1) return Rational(static_cast<std::int64_t>(numerator));
        return {static_cast<std::int64_t>(numerator), static_cast<std::int64_t>(denominator)};
    }
    return Rational::fromBig({bigOf(numerator), bigOf(denominator)});
}

BigInt powerOfTen(int exponent) {
    return boost::multiprecision::pow(BigInt(10), static_cast<unsigned>(exponent));
}

std::int64_t smallPowerOfTen(int exponent) {
    std::int64_t out = 1;
    for (int i = 0; i < exponent; ++i) out *= 10;
    return out;
}

/// A decimal as it stands: digits * 10^exponent, without its sign.
struct Decimal {
    std::string digits;  ///< without leading zeros
    int exponent = 0;
};

tl::unexpected<std::string> notANumber(std::string_view text) {
    return tl::unexpected(
        fmt::format("\"{}\" is not a number; expected a decimal such as -0.125 or 1e-3, a fraction such as "
                    "7/3, or an empty cell for a missing value",
                    text.substr(0, 60)));
}

tl::unexpected<std::string> tooLarge(std::string_view text) {
    return tl::unexpected(
        fmt::format("\"{}\" is too long; at most {} digits and exponents from -{} to {} are read",
                    text.substr(0, 60), max_digits, max_exponent, max_exponent));
}

/// Without sign; `whole` stands in errors.
tl::expected<Decimal, std::string> parseDecimal(std::string_view text, std::string_view whole) {
    Decimal out;
    std::size_t at = 0;
    bool any = false;
    bool point = false;
    for (; at < text.size() && (isDigit(text[at]) || (text[at] == '.' && !point)); ++at) {
        if (text[at] == '.') {
            point = true;
            continue;
        }
        any = true;
        if (!out.digits.empty() || text[at] != '0') out.digits += text[at];
        if (point) --out.exponent;
    }
    if (!any) return notANumber(whole);
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        std::string_view exponent = text.substr(at + 1);
        const bool plus = !exponent.empty() && exponent[0] == '+';
        if (plus) exponent.remove_prefix(1);
        if (exponent.empty() || !(isDigit(exponent[0]) || (exponent[0] == '-' && !plus)))
            return notANumber(whole);
        int power = 0;
        const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
        if (end != exponent.data() + exponent.size()) return notANumber(whole);
        if (error != std::errc() || std::abs(power) > max_exponent) return tooLarge(whole);
        out.exponent += power;
        at = text.size();
    }
    if (at != text.size()) return notANumber(whole);
    if (text.size() > max_digits + 10) return tooLarge(whole);
    return out;
}

}  // namespace

BigInt numeratorOf(const Rational& value) {
    return value.big() != nullptr ? value.big()->numerator : BigInt(value.smallNumerator());
}

BigInt denominatorOf(const Rational& value) {
    return value.big() != nullptr ? value.big()->denominator : BigInt(value.smallDenominator());
}

Rational ratioOf(const BigInt& numerator, const BigInt& denominator) {
    const BigInt divisor = boost::multiprecision::gcd(numerator, denominator);
    BigInt top = numerator / divisor;
    BigInt bottom = denominator / divisor;
    if (bottom < 0) {
        top = -top;
        bottom = -bottom;
    }
    if (boost::multiprecision::abs(top) <= largest && bottom <= largest)
        return {static_cast<std::int64_t>(top), static_cast<std::int64_t>(bottom)};
    return Rational::fromBig({std::move(top), std::move(bottom)});
}

Rational::Rational(std::int64_t whole) : numerator_(whole) {}

Rational::Rational(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t divisor = std::gcd(numerator, denominator);
    numerator_ = (denominator < 0 ? -numerator : numerator) / divisor;
    denominator_ = std::abs(denominator) / divisor;
}

Rational Rational::fromBig(Big value) {
    Rational out;
    out.big_ = std::make_shared<const Big>(std::move(value));
    return out;
}

tl::expected<Rational, std::string> Rational::parse(std::string_view text) {
    const std::string_view whole = trimmed(text);
    std::string_view rest = whole;
    const bool negative = !rest.empty() && rest[0] == '-';
    if (!rest.empty() && (rest[0] == '-' || rest[0] == '+')) rest.remove_prefix(1);
    // Nearly all cells are whole numbers of a few digits.
    std::int64_t quick = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), quick);
    if (error == std::errc() && end == rest.data() + rest.size() && isDigit(rest[0]))
        return Rational(negative ? -quick : quick);

    const std::size_t slash = rest.find('/');
    const auto top = parseDecimal(trimmed(rest.substr(0, slash)), whole);
    if (!top) return tl::unexpected(top.error());
    Decimal bottom{"1", 0};
    if (slash != std::string_view::npos) {
        auto parsed = parseDecimal(trimmed(rest.substr(slash + 1)), whole);
        if (!parsed) return tl::unexpected(parsed.error());
        bottom = std::move(*parsed);
        if (bottom.digits.empty())
            return tl::unexpected(fmt::format("\"{}\" divides by zero", whole.substr(0, 60)));
    }
    if (top->digits.empty()) return Rational();
    const int exponent = top->exponent - bottom.exponent;
    constexpr std::size_t small_digits = 18;
    if (top->digits.size() + static_cast<std::size_t>(std::max(exponent, 0)) <= small_digits &&
        bottom.digits.size() + static_cast<std::size_t>(std::max(-exponent, 0)) <= small_digits) {
        const std::int64_t numerator = std::stoll(top->digits) * smallPowerOfTen(std::max(exponent, 0));
        const std::int64_t denominator = std::stoll(bottom.digits) * smallPowerOfTen(std::max(-exponent, 0));
        return Rational(negative ? -numerator : numerator, denominator);
    }
    const BigInt numerator = BigInt(top->digits) * powerOfTen(std::max(exponent, 0));
    return ratioOf(negative ? BigInt(-numerator) : numerator,
                   BigInt(bottom.digits) * powerOfTen(std::max(-exponent, 0)));
}

Rational Rational::fromShortestDecimal(double value) {
    constexpr double largest_whole = 9007199254740992.0;  // 2^53
    if (std::abs(value) < largest_whole && value == std::floor(value))
        return Rational(static_cast<std::int64_t>(value));
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return *parse({text.data(), static_cast<std::size_t>(end - text.data())});
}

Rational Rational::fromBinary(double value) {
    int exponent = 0;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    BigInt numerator = digits;
    BigInt denominator = 1;
    if (exponent > 0)
        numerator <<= exponent;
    else
        denominator <<= -exponent;
    return ratioOf(numerator, denominator);
}

double Rational::toDouble() const {
    constexpr std::int64_t exact = std::int64_t{1} << 53;
    if (big_ == nullptr && std::abs(numerator_) <= exact && denominator_ <= exact)
        return static_cast<double>(numerator_) / static_cast<double>(denominator_);
    const BigInt top = boost::multiprecision::abs(numeratorOf(*this));
    const BigInt bottom = denominatorOf(*this);
    // A quotient of 64 or 65 bits; what is left over only decides roundings that would else be even.
    const int shift = 65 - static_cast<int>(msb(top)) + static_cast<int>(msb(bottom));
    BigInt quotient;
    BigInt rest;
    if (shift >= 0)
        divide_qr(BigInt(top << shift), bottom, quotient, rest);
    else
        divide_qr(top, BigInt(bottom << -shift), quotient, rest);
    bool inexact = rest != 0;
    int down = 0;
    while (msb(quotient) > 63) {
        inexact = inexact || bit_test(quotient, 0);
        quotient >>= 1;
        ++down;
    }
    auto digits = static_cast<std::uint64_t>(quotient);
    if (inexact) digits |= 1U;
    const double size = std::ldexp(static_cast<double>(digits), down - shift);
    return sign() < 0 ? -size : size;
}

int Rational::sign() const {
    if (big_ != nullptr) return big_->numerator.sign();
    return numerator_ < 0 ? -1 : numerator_ > 0 ? 1 : 0;
}

std::string Rational::text() const {
    const std::string top = numeratorOf(*this).str();
    const BigInt bottom = denominatorOf(*this);
    return bottom == 1 ? top : top + "/" + bottom.str();
}

Rational Rational::operator-() const {
    if (big_ != nullptr) return fromBig({-big_->numerator, big_->denominator});
    Rational out;
    out.numerator_ = -numerator_;
    out.denominator_ = denominator_;
    return out;
}

Rational operator+(const Rational& a, const Rational& b) {
    if (a.big_ == nullptr && b.big_ == nullptr) {
        if (a.denominator_ == b.denominator_)
            return reduced(Int128{a.numerator_} + b.numerator_, a.denominator_);
        // Each product is below 2^126: the sum fits.
        return reduced(Int128{a.numerator_} * b.denominator_ + Int128{b.numerator_} * a.denominator_,
                       Int128{a.denominator_} * b.denominator_);
    }
    return ratioOf(numeratorOf(a) * denominatorOf(b) + numeratorOf(b) * denominatorOf(a),
                   denominatorOf(a) * denominatorOf(b));
}

Rational operator-(const Rational& a, const Rational& b) {
    return a + -b;
}

Rational operator*(const Rational& a, const Rational& b) {
    if (a.big_ == nullptr && b.big_ == nullptr)
        return reduced(Int128{a.numerator_} * b.numerator_, Int128{a.denominator_} * b.denominator_);
    return ratioOf(numeratorOf(a) * numeratorOf(b), denominatorOf(a) * denominatorOf(b));
}

Rational operator/(const Rational& a, const Rational& b) {
    return ratioOf(numeratorOf(a) * denominatorOf(b), denominatorOf(a) * numeratorOf(b));
}

bool operator==(const Rational& a, const Rational& b) {
    if (a.big_ == nullptr && b.big_ == nullptr)
        return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
    return (a <=> b) == 0;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    if (a.big_ == nullptr && b.big_ == nullptr) {
        const Int128 left = Int128{a.numerator_} * b.denominator_;
        const Int128 right = Int128{b.numerator_} * a.denominator_;
        return left < right   ? std::strong_ordering::less
               : left > right ? std::strong_ordering::greater
                              : std::strong_ordering::equal;
    }
    const int order = BigInt(numeratorOf(a) * denominatorOf(b)).compare(numeratorOf(b) * denominatorOf(a));
    return order < 0   ? std::strong_ordering::less
           : order > 0 ? std::strong_ordering::greater
                       : std::strong_ordering::equal;
}

Rational abs(const Rational& value) {
    return value.sign() < 0 ? -value : value;
}

}  // namespace deixis::results
