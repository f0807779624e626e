// deixis serve: the studio's server.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "app/program/command_help.hpp"
#include "app/studio_commands/studio_commands.hpp"
#include "serving.hpp"

namespace deixis::app {

namespace {

struct ServeArguments {
    int port = usual_port;
    std::string token;
    bool no_token = false;
    std::string address{"127.0.0.1"};
    std::vector<std::string> hosts;
    std::string certificate;
    std::string key;
    bool behind_proxy = false;
    StudioOptions studio{};
};

/// By the server's member.
std::string optionOf(const std::string& member) {
    if (member == "certificate") return "--cert";
    if (member == "hosts") return "--host";
    return "--" + member;
}

server::ServerSettings settingsOf(const ServeArguments& options) {
    server::ServerSettings settings;
    settings.address = options.address;
    settings.port = options.port;
    settings.token = options.no_token ? "" : options.token.empty() ? server::newToken() : options.token;
    settings.hosts = options.hosts;
    settings.certificate = options.certificate;
    settings.key = options.key;
    settings.behind_proxy = options.behind_proxy;
    if (const auto allowed = server::checkSettings(settings); !allowed)
        rejectUsage(optionOf(allowed.error().where),
                    Error{"", allowed.error().message, allowed.error().hint}.text());
    static_cast<void>(addPage(settings));  // a build without the page serves programs alone
    return settings;
}

}  // namespace

void addServeCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<ServeArguments>();
    Parser command = cli.addCommand("serve", "Serve the studio's routes to programs and browsers");
    describe(
        command,
        {.writes = "the address with its token to standard output when it listens, and what is added to DIR. "
                   "Ctrl-C ends it.",
         .example = "deixis serve --port 8765\ndeixis serve --port 0 --token my-own-token",
         .page = "docs/studio.md"});
    command.addOption("--port", options->port, "Port to listen on; 0: a free one")
        .check(Range(0, 65535))
        .showDefault();
    Option token = command.addOption("--token", options->token, "Token that every request must carry")
                       .valueName("TOKEN")
                       .showDefault("a new one of 128 random bits");
    command.addFlag("--no-token", options->no_token, "Ask for none; on the loopback only").excludes(token);
    command
        .addOption("--address", options->address, "Address to listen on; others than the loopback need TLS")
        .valueName("ADDRESS")
        .showDefault();
    command.addOption("--host", options->hosts, "Name by which it is reached, besides its address")
        .valueName("NAME")
        .oneValueEachTime();
    Option certificate =
        command.addOption("--cert", options->certificate, "Certificate with its chain (PEM), for TLS")
            .valueName("FILE");
    command.addOption("--key", options->key, "Its key (PEM)").valueName("FILE").needs(certificate);
    command.addFlag("--behind-proxy", options->behind_proxy, "A proxy that speaks TLS stands before it");
    addStudioOptions(command, options->studio);
    command.callback([options, &chosen] {
        chosen = [options, settings = settingsOf(*options)] { return serve(settings, options->studio, {}); };
    });
}

}  // namespace deixis::app
