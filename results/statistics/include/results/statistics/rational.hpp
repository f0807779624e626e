// Exact fractions for cells and scores, so that differences that are equal on paper are equal.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace deixis::results {

/// A fraction in lowest terms, of any size. Numerators and denominators below 2^63 lie inline and are fast;
/// larger ones lie on the heap, shared between copies.
class Rational {
  public:
    Rational() = default;                                        // 0
    explicit Rational(std::int64_t whole);                       ///< not of the smallest int64
    Rational(std::int64_t numerator, std::int64_t denominator);  ///< the denominator is not 0

    /// Reads "12", "-0.125", ".5", "1e-3", "7/3" or "1.5/2" with spaces around; nothing else. Exponents and
    /// lengths go up to 1000. The error says what is wrong, without the place.
    [[nodiscard]] static tl::expected<Rational, std::string> parse(std::string_view text);
    /// The shortest decimal that reads back as `value`: 0.1 becomes 1/10. `value` is finite.
    [[nodiscard]] static Rational fromShortestDecimal(double value);
    /// Exactly the binary value: 0.1 becomes 3602879701896397/2^55. `value` is finite.
    [[nodiscard]] static Rational fromBinary(double value);

    [[nodiscard]] double toDouble() const;   ///< the nearest double; infinite if there is none
    [[nodiscard]] int sign() const;          ///< -1, 0 or 1
    [[nodiscard]] std::string text() const;  ///< "7/3" or "2"

    [[nodiscard]] Rational operator-() const;
    friend Rational operator+(const Rational& a, const Rational& b);
    friend Rational operator-(const Rational& a, const Rational& b);
    friend Rational operator*(const Rational& a, const Rational& b);
    friend Rational operator/(const Rational& a, const Rational& b);  ///< b is not 0
    Rational& operator+=(const Rational& b) { return *this = *this + b; }
    friend bool operator==(const Rational& a, const Rational& b);
    friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

    struct Big;  ///< of the implementation
    [[nodiscard]] const Big* big() const { return big_.get(); }
    [[nodiscard]] std::int64_t smallNumerator() const { return numerator_; }      ///< where big() is null
    [[nodiscard]] std::int64_t smallDenominator() const { return denominator_; }  ///< likewise
    [[nodiscard]] static Rational fromBig(Big value);

  private:
    std::int64_t numerator_ = 0;
    std::int64_t denominator_ = 1;
    std::shared_ptr<const Big> big_{};
};

[[nodiscard]] Rational abs(const Rational& value);

}  // namespace deixis::results
