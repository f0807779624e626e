// Serving the studio until somebody ends the program.
#pragma once

#include <functional>
#include <string>

#include "core/error.hpp"
#include "server/http/http_server.hpp"
#include "studio_options.hpp"

namespace deixis::app {

inline constexpr int usual_port = 8765;

/// The studio's page and the avatar, where this build has the page; whether it has.
bool addPage(server::ServerSettings& settings);

/// Listens, prints the address with its token, and answers until Ctrl-C or SIGTERM; what runs then is
/// finished. `listening`, where there is one, is told the address.
[[nodiscard]] Result<void> serve(server::ServerSettings settings, const StudioOptions& options,
                                 const std::function<void(const std::string& address)>& listening);

}  // namespace deixis::app
