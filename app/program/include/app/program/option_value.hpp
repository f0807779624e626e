// What kind of value an option takes, derived from CLI11's description of its type: for help, manual page
// and completion alike.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace deixis::app {

struct OptionValue {
    std::string name;                    ///< such as FILE, TEXT or NUMBER
    std::vector<std::string> choices{};  ///< all that it may be; empty: anything
    std::string limits{};                ///< of a number: "1 to 9999", "above 0"; empty: none
};

/// CLI11 writes "TEXT:{front,left}", "INT:INT in [1 - 9999]" and "FLOAT:POSITIVE".
[[nodiscard]] OptionValue optionValue(const CLI::Option& option);

}  // namespace deixis::app
