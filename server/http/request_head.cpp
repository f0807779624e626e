#include "request_head.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace deixis::server {

namespace {

/// RFC 9110, 5.6.2.
bool isTokenLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

bool isHeader(std::string_view line) {
    const std::size_t colon = line.find(':');
    return colon != std::string_view::npos && colon > 0 &&
           std::all_of(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(colon), isTokenLetter);
}

bool isOdd(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20U && c != '\t') || byte == 0x7FU;
}

/// "METHOD /TARGET HTTP/1.1", or 1.0.
bool isRequestLine(std::string_view line) {
    const std::size_t first = line.find(' ');
    const std::size_t last = line.rfind(' ');
    if (first == std::string_view::npos || first == last) return false;
    const std::string_view method = line.substr(0, first);
    const std::string_view target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    return !method.empty() && std::all_of(method.begin(), method.end(), isTokenLetter) &&
           target.starts_with('/') && target.find(' ') == std::string_view::npos &&
           (version == "HTTP/1.1" || version == "HTTP/1.0");
}

Refusal malformed(const char* what) {
    return {400, fmt::format("the request is no HTTP: {}", what)};
}

}  // namespace

std::optional<std::size_t> headEnd(std::string_view received) {
    const std::size_t at = received.find("\r\n\r\n");
    if (at == std::string_view::npos) return std::nullopt;
    return at + 4;
}

std::optional<Refusal> headProblem(std::string_view head, const ServerLimits& limits) {
    std::size_t headers = 0;
    bool first = true;
    // The last two bytes end the empty line.
    head.remove_suffix(2);
    while (!head.empty()) {
        const std::size_t end = head.find("\r\n");
        const std::string_view line = head.substr(0, end);
        head.remove_prefix(end + 2);
        if (std::any_of(line.begin(), line.end(), isOdd)) return malformed("a control character in its head");
        if (first) {
            first = false;
            if (line.size() > limits.target_bytes)
                return Refusal{414, fmt::format("the address is longer than {} bytes", limits.target_bytes)};
            if (!isRequestLine(line)) return malformed("its first line is none");
            continue;
        }
        if (!isHeader(line)) return malformed("a header without a name");
        if (++headers > limits.header_lines)
            return Refusal{431, fmt::format("more than {} headers", limits.header_lines)};
    }
    return std::nullopt;
}

}  // namespace deixis::server
