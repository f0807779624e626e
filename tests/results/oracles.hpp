// Right answers made by other programs: tests/results/oracles, and the scripts there.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "results/statistics/rational.hpp"

#include "paths.hpp"

namespace deixis::tests {

inline nlohmann::json oracles(const std::string& name) {
    std::ifstream in(deixis::tests::sourceDir() / ("tests/results/oracles/" + name + ".json"));
    auto cases = nlohmann::json::parse(in)["cases"];
    REQUIRE(!cases.empty());
    return cases;
}

/// Cells as they stand in a file; empty ones are left out.
inline std::vector<results::Rational> rationals(const nlohmann::json& cells) {
    std::vector<results::Rational> out;
    for (const auto& cell : cells)
        if (const auto text = cell.get<std::string>(); !text.empty())
            out.push_back(results::Rational::parse(text).value());
    return out;
}

/// Differences of the pairs of cells of which none is missing.
inline std::vector<results::Rational> differences(const nlohmann::json& a, const nlohmann::json& b) {
    std::vector<results::Rational> out;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const auto x = a[i].get<std::string>();
        const auto y = b[i].get<std::string>();
        if (x.empty() || y.empty()) continue;
        out.push_back(results::Rational::parse(x).value() - results::Rational::parse(y).value());
    }
    return out;
}

inline std::vector<results::Rational> wholes(const std::vector<int>& values) {
    std::vector<results::Rational> out;
    for (const int value : values) out.emplace_back(value);
    return out;
}

/// `expected` is a number, or JSON: null there is for what is undefined.
template <typename Expected>
bool close(const std::optional<double>& found, const Expected& expected, double relative) {
    if constexpr (std::is_same_v<Expected, nlohmann::json>) {
        if (!found.has_value() || expected.is_null()) return !found.has_value() && expected.is_null();
        return close(found, expected.template get<double>(), relative);
    } else {
        return found.has_value() && std::abs(*found - expected) <= relative * std::abs(expected);
    }
}

/// Of at least 30 cases each: p by the normal approximation, and exact p where SciPy has one, without ties.
/// test(case) gives a result of rankSumTest() or signedRankTest().
template <typename Test>
void checkAgainstScipy(const std::string& name, const Test& test) {
    int exact = 0;
    int normal = 0;
    for (const auto& expected : oracles(name)) {
        if (!expected.contains("scipy")) continue;
        CAPTURE(expected["name"].get<std::string>());
        const auto& scipy = expected["scipy"];
        const auto found = test(expected);
        CHECK(close(found.normal_p_two_sided, scipy["normal_p"], 1e-12));
        ++normal;
        if (!scipy.contains("less")) continue;
        CHECK(close(found.p_two_sided, scipy["two-sided"], 1e-12));
        CHECK(close(found.p_greater, scipy["greater"], 1e-12));
        CHECK(close(found.p_less, scipy["less"], 1e-12));
        ++exact;
    }
    CHECK(exact >= 30);
    CHECK(normal >= 30);
}

}  // namespace deixis::tests
