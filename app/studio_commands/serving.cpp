#include "serving.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <utility>

#include "app/program/version.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/data/unit_gestures.hpp"
#include "interruption.hpp"
#include "server/api/studio_api.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

/// "0.1.0" of "deixis 0.1.0 (commit ...)".
std::string versionNumber() {
    const std::string version = programVersion();
    const std::size_t from = version.find(' ') + 1;
    return version.substr(from, version.find(' ', from) - from);
}

Result<server::StudioParts> studioParts(const StudioOptions& options) {
    auto library = assets::loadUnitGestures(assets::dataFile("unit_gestures.toml"));
    if (!library) return tl::unexpected(library.error());
    server::StudioParts parts;
    parts.version = versionNumber();
    for (const auto& [name, value] : buildProperties())
        if (name == "commit") parts.commit = value;
    parts.library = std::move(*library);
    auto model = gestureModel(options);
    if (!model) return tl::unexpected(model.error());
    parts.model = std::move(*model);  // without it gestures are by rules
    auto voices = studioVoices(options);
    if (!voices) return tl::unexpected(voices.error());
    parts.voices = std::move(*voices);
    auto folder = openFolder(options);
    if (!folder) return tl::unexpected(folder.error());
    parts.folder = std::move(*folder);
    return parts;
}

}  // namespace

bool addPage(server::ServerSettings& settings) {
    std::error_code code;
    const fs::path page = assets::dataFile("studio");
    if (!fs::is_directory(page, code)) return false;
    settings.pages = page;
    settings.page_files["/avatar.glb"] = assets::dataFile("avatar.glb");
    return true;
}

Result<void> serve(server::ServerSettings settings, const StudioOptions& options,
                   const std::function<void(const std::string& address)>& listening) {
    auto parts = studioParts(options);
    if (!parts) return tl::unexpected(parts.error());
    auto avatar = studioAvatar(options);
    if (!avatar) return tl::unexpected(avatar.error());
    if (*avatar) {
        settings.page_contents["/avatar.glb"] = std::move((*avatar)->glb);
        parts->avatar = std::move((*avatar)->drawn);
    }
    const Interruption interruption;
    const auto server = server::HttpServer::start(settings, server::studioRoutes(std::move(*parts)));
    if (!server) return tl::unexpected(server.error());
    const std::string address =
        (*server)->address() + (settings.token.empty() ? "" : "?token=" + settings.token);
    fmt::print("{}\n", address);
    std::fflush(stdout);
    if (listening) listening(address);
    interruption.wait();
    (*server)->stop();
    return {};
}

}  // namespace deixis::app
