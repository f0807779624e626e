// The studio's server, as commands and stations start it: what its routes work with, and its page.
#pragma once

#include <string>

#include "app/studio/studio_options.hpp"
#include "core/error.hpp"
#include "server/http/http_server.hpp"

namespace deixis::app {

inline constexpr int usual_port = 8765;

/// But for a folder: nothing is kept on the disk.
[[nodiscard]] Result<server::StudioParts> studioParts(const StudioOptions& options);

/// The studio's page and the avatar. Error: this build has no page; a server without it is for programs
/// alone.
[[nodiscard]] Result<void> addPage(server::ServerSettings& settings);

/// With the token.
[[nodiscard]] std::string addressToOpen(const server::HttpServer& server,
                                        const server::ServerSettings& settings);

}  // namespace deixis::app
