// Numbers that are the same but for their last bits.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace deixis::tests {

/// With each number told to twelve digits: sums over people who stand in another order differ behind them.
inline nlohmann::json rounded(nlohmann::json one) {
    if (one.is_structured())
        for (auto& part : one) part = rounded(part);
    if (!one.is_number_float()) return one;
    char digits[40];
    std::snprintf(digits, sizeof digits, "%.12g", one.get<double>());
    return std::string(digits);
}

}  // namespace deixis::tests
