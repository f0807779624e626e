// What every request passes before a route sees it, around cpp-httplib: the token, Host and Origin, limits of
// size and time, strict JSON; and the page's files. Nothing is logged.
//
// A connection has a thread only while a whole request is worked on: one thread reads the heads of all
// requests, however slowly they come, and a few others answer. Linux and other POSIX systems.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "server/http/route.hpp"

namespace deixis::server {

struct ServerLimits {
    std::size_t threads = 8;  ///< requests worked on at the same time
    std::size_t connections =
        256;  ///< that wait for their next request; above, the one that waits longest is closed
    std::size_t head_bytes = 16 * 1024;  ///< request line and headers
    std::size_t header_lines = 64;
    std::size_t target_bytes = 2048;  ///< path and query
    std::chrono::milliseconds head_time{
        10000};  ///< from a head's first byte, and from connecting, to its last
    std::chrono::milliseconds idle_time{30000};  ///< between requests
    /// For a body, and for an answer: this and as long as `bytes_a_second` takes.
    std::chrono::milliseconds transfer_time{10000};
    std::size_t bytes_a_second = 32 * 1024;
    std::chrono::milliseconds stopping_time{
        3000};  ///< for transfers that are under way when the server stops
};

struct ServerSettings {
    std::string address = "127.0.0.1";  ///< IPv4 or IPv6
    int port = 0;                       ///< 0: a free one
    /// 1 to 256 letters a-z, A-Z, 0-9 and "-._~"; at least 16 on other addresses than the loopback. Empty:
    /// none is asked for, on the loopback only.
    std::string token;
    /// Names by which it is reached, besides its address and, on the loopback, localhost.
    std::vector<std::string> hosts{};
    std::filesystem::path certificate{};  ///< PEM, with its chain; empty: no TLS
    std::filesystem::path key{};          ///< PEM, without a password
    /// A proxy that speaks TLS stands before it: other addresses are allowed without TLS, any port in Host,
    /// and Origin may be of either scheme.
    bool behind_proxy = false;
    std::filesystem::path pages{};  ///< a folder whose files are served from / on; empty: none
    /// Other files that the page loads, by their path: "/avatar.glb".
    std::map<std::string, std::filesystem::path> page_files{};
    /// The same, of bytes that are no file; they stand in place of a file of the same path.
    std::map<std::string, std::string> page_contents{};
    ServerLimits limits{};
};

/// 128 bits of the system's random source as 32 hexadecimal digits.
[[nodiscard]] std::string newToken();

/// Whether these settings are allowed; the error's `where` is the member.
[[nodiscard]] Result<void> checkSettings(const ServerSettings& settings);

class HttpServer {
  public:
    /// Listens when it returns. Errors: checkSettings', a port in use, certificates and pages that cannot be
    /// read.
    [[nodiscard]] static Result<std::unique_ptr<HttpServer>> start(const ServerSettings& settings,
                                                                   std::vector<Route> routes);
    virtual ~HttpServer() = default;

    [[nodiscard]] virtual int port() const = 0;
    /// "http://127.0.0.1:8080/", without the token. Of a server of all addresses the first of its names, or
    /// the loopback's.
    [[nodiscard]] virtual std::string address() const = 0;
    /// Takes no more requests, and returns when those that run are answered. The destructor does it, too.
    virtual void stop() = 0;
};

}  // namespace deixis::server
