#include "app/program/option_value.hpp"

#include <algorithm>
#include <string_view>

namespace deixis::app {

namespace {

std::vector<std::string> listed(std::string_view words) {
    std::vector<std::string> out;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find(','), words.size());
        out.emplace_back(words.substr(0, end));
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return out;
}

}  // namespace

OptionValue optionValue(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t colon = std::min(type.find(':'), type.size());
    OptionValue out{type.substr(0, colon)};
    if (out.name == "FLOAT" || out.name == "INT" || out.name == "UINT") out.name = "NUMBER";
    const std::string rule = colon < type.size() ? type.substr(colon + 1) : "";
    if (rule.starts_with('{')) {
        out.choices = listed(std::string_view(rule).substr(1, rule.find('}') - 1));
    } else if (const auto range = rule.find(" in ["); range != std::string::npos) {
        const std::string ends = rule.substr(range + 5, rule.find(']') - range - 5);
        const auto dash = ends.find(" - ");
        out.limits = ends.substr(0, dash) + " to " + ends.substr(dash + 3);
    } else if (rule == "POSITIVE") {
        out.limits = "above 0";
    } else if (rule == "NONNEGATIVE") {
        out.limits = "from 0 on";
    }
    return out;
}

}  // namespace deixis::app
