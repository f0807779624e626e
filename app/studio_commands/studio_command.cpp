// deixis studio: the studio in a browser, on this machine.
#include <memory>
#include <string>

#include "app/program/command_help.hpp"
#include "app/studio/browser.hpp"
#include "app/studio_commands/studio_commands.hpp"
#include "serving.hpp"

namespace deixis::app {

namespace {

struct StudioArguments {
    int port = usual_port;
    bool no_browser = false;
    StudioOptions studio{};
};

Result<void> studio(const StudioArguments& options) {
    server::ServerSettings settings;
    settings.port = options.port;
    settings.token = server::newToken();
    if (const auto page = addPage(settings); !page) return page;
    return serve(settings, options.studio, options.no_browser ? nullptr : openInBrowser);
}

}  // namespace

void addStudioCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<StudioArguments>();
    Parser command =
        cli.addCommand("studio", "Open the studio in the browser: gestures to speech, made by hand and rule");
    describe(
        command,
        {.writes =
             "the studio's address to standard output; the page keeps its work in the browser and in DIR, "
             "and downloads files. Ctrl-C ends it.",
         .example = "deixis studio",
         .page = "docs/studio.md"});
    command
        .addOption("--port", options->port,
                   "Port; the browser keeps the work of each port apart. 0: a free one")
        .check(Range(0, 65535))
        .showDefault();
    command.addFlag("--no-browser", options->no_browser, "Open none; print the address alone");
    addStudioOptions(command, options->studio);
    command.callback([options, &chosen] { chosen = [options] { return studio(*options); }; });
}

}  // namespace deixis::app
