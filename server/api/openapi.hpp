// The OpenAPI document, made from what the routes declare.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "server/http/route.hpp"

namespace deixis::server {

/// OpenAPI 3.1. A refusal by any status can be the answer of every route.
[[nodiscard]] nlohmann::ordered_json openApiDocument(const std::vector<Route>& routes,
                                                     const std::string& version);

}  // namespace deixis::server
