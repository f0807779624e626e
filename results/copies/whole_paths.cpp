#include <regex>

#include "results/copies/anonymous_copy.hpp"

namespace deixis::results {

std::string withoutWholePaths(std::string_view text) {
    static const std::regex path(R"((["'])(?:/|~/|[A-Za-z]:[/\\])[^"'\n]*[/\\]([^"'\n/\\]*)(["']))");
    return std::regex_replace(std::string(text), path, "$1$2$3");
}

}  // namespace deixis::results
