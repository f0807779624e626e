// The head of a request as bytes, before anything reads it as HTTP.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "server/http/http_server.hpp"
#include "server/http/route.hpp"

namespace deixis::server {

/// Where the head ends (behind its empty line); none: it has not all come.
[[nodiscard]] std::optional<std::size_t> headEnd(std::string_view received);

/// What is wrong with a whole head: a first line that is no request for a path here, lines that do not end by
/// CR LF, other control characters, a header without a name right before its colon (RFC 9112, 5.1), or more
/// than the limits allow. A lenient reader behind a strict proxy would see other requests than the proxy
/// does.
[[nodiscard]] std::optional<Refusal> headProblem(std::string_view head, const ServerLimits& limits);

}  // namespace deixis::server
