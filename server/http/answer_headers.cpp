#include "answer_headers.hpp"

#include <fmt/format.h>

namespace deixis::server {

const std::vector<std::pair<std::string, std::string>>& headersOfAll() {
    static const std::vector<std::pair<std::string, std::string>> headers{
        {"Content-Security-Policy",
         "default-src 'self'; img-src 'self' blob: data:; media-src 'self' blob:; worker-src 'self' blob:; "
         "connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; form-action 'self'"},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
    };
    return headers;
}

std::string wholeAnswer(const Refusal& refusal) {
    const std::string body = bodyOf(refusal);
    std::string out = fmt::format("HTTP/1.1 {} Refused\r\n", refusal.status);
    for (const auto& [name, value] : headersOfAll()) out += fmt::format("{}: {}\r\n", name, value);
    out += fmt::format(
        "Cache-Control: no-store\r\nContent-Type: application/json\r\nContent-Length: {}\r\nConnection: "
        "close\r\n\r\n",
        body.size());
    return out + body;
}

}  // namespace deixis::server
