#include "listening.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

namespace deixis::server {

namespace {

struct SocketAddress {
    sockaddr_storage storage{};
    socklen_t size = 0;
    [[nodiscard]] const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&storage); }
    [[nodiscard]] sockaddr* get() { return reinterpret_cast<sockaddr*>(&storage); }
};

std::optional<SocketAddress> socketAddress(const std::string& address, int port) {
    SocketAddress out;
    sockaddr_in v4{};
    if (::inet_pton(AF_INET, address.c_str(), &v4.sin_addr) == 1) {
        v4.sin_family = AF_INET;
        v4.sin_port = htons(static_cast<std::uint16_t>(port));
        std::memcpy(&out.storage, &v4, sizeof v4);
        out.size = sizeof v4;
        return out;
    }
    sockaddr_in6 v6{};
    if (::inet_pton(AF_INET6, address.c_str(), &v6.sin6_addr) == 1) {
        v6.sin6_family = AF_INET6;
        v6.sin6_port = htons(static_cast<std::uint16_t>(port));
        std::memcpy(&out.storage, &v6, sizeof v6);
        out.size = sizeof v6;
        return out;
    }
    return std::nullopt;
}

std::optional<SocketAddress> ownEnd(int socket) {
    SocketAddress out;
    out.size = sizeof out.storage;
    if (::getsockname(socket, out.get(), &out.size) != 0) return std::nullopt;
    return out;
}

int portOf(const SocketAddress& address) {
    // Both families have the port in the same place.
    sockaddr_in v4{};
    std::memcpy(&v4, &address.storage, sizeof v4);
    return ntohs(v4.sin_port);
}

}  // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

bool isNumericAddress(const std::string& address) {
    return socketAddress(address, 0).has_value();
}

bool isLoopback(const std::string& address) {
    in_addr v4{};
    if (::inet_pton(AF_INET, address.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 24U) == 127U;
    in6_addr v6{};
    return ::inet_pton(AF_INET6, address.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

std::string inUrl(const std::string& address) {
    return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

std::string localAddress(int socket) {
    const auto own = ownEnd(socket);
    if (!own) return {};
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (own->storage.ss_family == AF_INET) {
        sockaddr_in v4{};
        std::memcpy(&v4, &own->storage, sizeof v4);
        ::inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
    } else {
        sockaddr_in6 v6{};
        std::memcpy(&v6, &own->storage, sizeof v6);
        if (IN6_IS_ADDR_V4MAPPED(&v6.sin6_addr))
            ::inet_ntop(AF_INET, &v6.sin6_addr.s6_addr[12], text.data(), text.size());
        else
            ::inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
    }
    return text.data();
}

Result<Listening> listenOn(const std::string& address, int port) {
    const std::string where = fmt::format("{}:{}", inUrl(address), port);
    const auto failed = [&](const char* what) {
        if (errno == EADDRINUSE)
            return fail(where, "another program listens on this port",
                        "Name another one, or 0 for a free one");
        return fail(where, fmt::format("{}: {}", what, std::system_category().message(errno)));
    };
    auto wanted = socketAddress(address, port);
    if (!wanted) return fail(where, "is no address");
    Descriptor socket(::socket(wanted->storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.valid()) return failed("no socket");
    const int on = 1;
    // So that a port can be used again at once. Not SO_REUSEPORT, by which two programs could share one.
    ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    if (::bind(socket.number(), wanted->get(), wanted->size) != 0) return failed("cannot be listened on");
    constexpr int waiting_to_be_taken = 128;
    if (::listen(socket.number(), waiting_to_be_taken) != 0) return failed("cannot be listened on");
    const auto own = ownEnd(socket.number());
    if (!own) return failed("has no port");
    return Listening{std::move(socket), portOf(*own)};
}

}  // namespace deixis::server
