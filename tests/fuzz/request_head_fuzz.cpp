// Any bytes as the head of a request: refused, or lines that every reader takes for the same.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "request_head.hpp"

using namespace deixis;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto end = server::headEnd(bytes);
    if (!end) return 0;
    const std::string_view head = bytes.substr(0, *end);
    if (!head.ends_with("\r\n\r\n")) std::abort();
    if (const auto problem = server::headProblem(head, {})) {
        if (problem->message.empty() || problem->status < 400) std::abort();
        return 0;
    }
    const auto count = [&](char c) { return std::count(head.begin(), head.end(), c); };
    if (count('\r') != count('\n') || count('\0') != 0) std::abort();
    for (std::size_t at = head.find('\n'); at != std::string_view::npos; at = head.find('\n', at + 1))
        if (head[at - 1] != '\r') std::abort();
    if (head.find(" /") > head.find("\r\n")) std::abort();
    return 0;
}
