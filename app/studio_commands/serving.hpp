// Serving the studio until somebody ends the program.
#pragma once

#include <functional>
#include <string>

#include "app/studio/studio_parts.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// Listens, prints the address with its token, and answers until Ctrl-C or SIGTERM; what runs then is
/// finished. `listening`, where there is one, is told the address.
[[nodiscard]] Result<void> serve(server::ServerSettings settings, const StudioOptions& options,
                                 const std::function<void(const std::string& address)>& listening);

}  // namespace deixis::app
