#include "serving.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "app/studio/interruption.hpp"
#include "server/api/studio_api.hpp"

namespace deixis::app {

Result<void> serve(server::ServerSettings settings, const StudioOptions& options,
                   const std::function<void(const std::string& address)>& listening) {
    auto parts = studioParts(options);
    if (!parts) return tl::unexpected(parts.error());
    auto folder = openFolder(options);
    if (!folder) return tl::unexpected(folder.error());
    parts->folder = std::move(*folder);
    auto avatar = studioAvatar(options);
    if (!avatar) return tl::unexpected(avatar.error());
    if (*avatar) {
        settings.page_contents["/avatar.glb"] = std::move((*avatar)->glb);
        parts->avatar = std::move((*avatar)->drawn);
    }
    const Interruption interruption;
    const auto server = server::HttpServer::start(settings, server::studioRoutes(std::move(*parts)));
    if (!server) return tl::unexpected(server.error());
    const std::string address = addressToOpen(**server, settings);
    fmt::print("{}\n", address);
    std::fflush(stdout);
    if (listening) listening(address);
    interruption.wait();
    (*server)->stop();
    return {};
}

}  // namespace deixis::app
