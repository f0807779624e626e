// The routes by which a page takes part in a session of a study.
#pragma once

#include <memory>
#include <vector>

#include "server/http/route.hpp"
#include "server/session/session_desk.hpp"

namespace deixis::server {

/// They keep the desk.
[[nodiscard]] std::vector<Route> sessionRoutes(const std::shared_ptr<SessionDesk>& desk);

}  // namespace deixis::server
