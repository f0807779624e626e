#include "core/number.hpp"

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>

namespace deixis {

namespace {

template <typename Number>
std::optional<Number> whole(std::string_view text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

}  // namespace

std::optional<double> finiteNumber(std::string_view text) {
    // Emscripten's library has no std::from_chars of numbers with a point.
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> wholeNumber(std::string_view text) {
    return whole<std::int64_t>(text);
}

std::optional<std::uint64_t> naturalNumber(std::string_view text) {
    return whole<std::uint64_t>(text);
}

}  // namespace deixis
