// The headers that every answer has, and answers that are written without cpp-httplib.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "server/http/route.hpp"

namespace deixis::server {

/// The page may load from its own server only, and no other page may show or read it.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& headersOfAll();

/// A whole answer of HTTP/1.1, after which the connection ends.
[[nodiscard]] std::string wholeAnswer(const Refusal& refusal);

}  // namespace deixis::server
