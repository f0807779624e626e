#include "app/studio/studio_parts.hpp"

#include <filesystem>
#include <utility>

#include "app/program/version.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/data/unit_gestures.hpp"

namespace deixis::app {

namespace {

/// "0.1.0" of "deixis 0.1.0 (commit ...)".
std::string versionNumber() {
    const std::string version = programVersion();
    const std::size_t from = version.find(' ') + 1;
    return version.substr(from, version.find(' ', from) - from);
}

}  // namespace

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
    return parts;
}

Result<void> addPage(server::ServerSettings& settings) {
    std::error_code code;
    const std::filesystem::path page = assets::dataFile("studio");
    if (!std::filesystem::is_directory(page, code))
        return fail("studio", "this build has no page",
                    "Build it where npm can fetch what the page is made of (docs/studio.md)");
    settings.pages = page;
    settings.page_files["/avatar.glb"] = assets::dataFile("avatar.glb");
    return {};
}

std::string addressToOpen(const server::HttpServer& server, const server::ServerSettings& settings) {
    return server.address() + (settings.token.empty() ? "" : "?token=" + settings.token);
}

}  // namespace deixis::app
