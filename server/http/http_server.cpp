#include "server/http/http_server.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "admission.hpp"
#include "answering.hpp"
#include "connection.hpp"
#include "listening.hpp"
#include "page_files.hpp"
#include "secrets.hpp"
#include "waiting_room.hpp"

namespace deixis::server {

namespace {

/// Where a browser on this machine, or one that knows the server's name, reaches it.
std::string nameOf(const ServerSettings& settings) {
    const bool all = settings.address == "0.0.0.0" || settings.address == "::";
    if (!all) return inUrl(settings.address);
    return settings.hosts.empty() ? "127.0.0.1" : settings.hosts.front();
}

class RunningServer : public HttpServer {
  public:
    RunningServer(const ServerSettings& settings, Listening listening, TlsContext tls,
                  std::vector<Route> routes, PageFiles pages)
        : limits_(settings.limits),
          port_(listening.port),
          address_(fmt::format("{}://{}:{}/", tls ? "https" : "http", nameOf(settings), listening.port)),
          admission_(settings, listening.port, std::move(routes), std::move(pages)),
          waiting_(std::move(listening.socket), std::move(tls), limits_) {
        threads_.emplace_back([this] { waiting_.run(); });
        for (std::size_t i = 0; i < std::max<std::size_t>(1, limits_.threads); ++i)
            threads_.emplace_back([this] { answerAll(); });
    }
    ~RunningServer() override { stop(); }
    RunningServer(const RunningServer&) = delete;
    RunningServer& operator=(const RunningServer&) = delete;

    [[nodiscard]] int port() const override { return port_; }
    [[nodiscard]] std::string address() const override { return address_; }
    void stop() override {
        stop_at_ = (Clock::now() + limits_.stopping_time).time_since_epoch().count();
        waiting_.stop();
        for (std::thread& thread : threads_)
            if (thread.joinable()) thread.join();
    }

  private:
    void answerAll() {
        Answering answering(admission_, limits_, stop_at_);
        while (auto connection = waiting_.take()) {
            bool goes_on = false;
            try {
                goes_on = answering.answer(*connection, waiting_.stopping());
            } catch (const std::exception&) {
                continue;  // not even memory to say so: the connection is closed
            }
            waiting_.giveBack(std::move(connection),
                              goes_on ? WaitingRoom::After::next_request : WaitingRoom::After::farewell);
        }
    }

    ServerLimits limits_;
    int port_;
    std::string address_;
    std::atomic<Clock::rep> stop_at_{Clock::time_point::max().time_since_epoch().count()};
    Admission admission_;
    WaitingRoom waiting_;
    std::vector<std::thread> threads_;
};

}  // namespace

Result<void> checkSettings(const ServerSettings& settings) {
    constexpr std::size_t long_enough = 16;
    const bool loopback = isLoopback(settings.address);
    if (!isNumericAddress(settings.address))
        return fail("address",
                    fmt::format("found '{}', expected an address in numbers, such as 127.0.0.1 or ::1",
                                settings.address));
    if (settings.port < 0 || settings.port > 65535)
        return fail("port", fmt::format("found {}, expected 0 to 65535", settings.port));
    if (settings.certificate.empty() != settings.key.empty())
        return fail(settings.key.empty() ? "key" : "certificate", "is missing",
                    "TLS takes a certificate and its key");
    if (!settings.token.empty() && !canBeToken(settings.token))
        return fail("token", "expected 1 to 256 letters of a-z, A-Z, 0-9 and -._~");
    const bool open = !loopback || settings.behind_proxy;
    if (!loopback && settings.certificate.empty() && !settings.behind_proxy)
        return fail("address",
                    fmt::format("{} can be reached from other machines, which needs TLS", settings.address),
                    "Name a certificate and its key, or say that a proxy with TLS stands before it");
    if (open && settings.token.size() < long_enough)
        return fail("token",
                    fmt::format("expected at least {} letters where other machines can ask", long_enough));
    for (const std::string& host : settings.hosts)
        if (host.empty() || host.find_first_of("/: ") != std::string::npos)
            return fail("hosts", fmt::format("found '{}', expected a name such as studio.example.org", host));
    return {};
}

Result<std::unique_ptr<HttpServer>> HttpServer::start(const ServerSettings& settings,
                                                      std::vector<Route> routes) {
    if (const auto allowed = checkSettings(settings); !allowed) return tl::unexpected(allowed.error());
    TlsContext tls;
    if (!settings.certificate.empty()) {
        auto loaded = loadTls(settings.certificate, settings.key);
        if (!loaded) return tl::unexpected(loaded.error());
        tls = std::move(*loaded);
    }
    auto pages = loadPageFiles(settings.pages, settings.page_files, settings.page_contents);
    if (!pages) return tl::unexpected(pages.error());
    auto listening = listenOn(settings.address, settings.port);
    if (!listening) return tl::unexpected(listening.error());
    return std::make_unique<RunningServer>(settings, std::move(*listening), std::move(tls), std::move(routes),
                                           std::move(*pages));
}

}  // namespace deixis::server
