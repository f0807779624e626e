// A client that sends any bytes to a server on the loopback.
#pragma once

#include <arpa/inet.h>
#include <doctest/doctest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace deixis::tests {

/// A connection on which any bytes can be sent.
class RawClient {
  public:
    explicit RawClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        REQUIRE(::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    }
    ~RawClient() { ::close(socket_); }
    RawClient(const RawClient&) = delete;
    RawClient& operator=(const RawClient&) = delete;

    /// Whether all of it could be sent.
    bool send(std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (sent <= 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        }
        return true;
    }
    void endSending() { ::shutdown(socket_, SHUT_WR); }

    /// What comes until the server closes or nothing comes for so long.
    std::string receiveAll(std::chrono::milliseconds quiet = std::chrono::milliseconds(3000)) {
        std::string out;
        closed_ = false;
        for (char some[4096];;) {
            pollfd one{socket_, POLLIN, 0};
            if (::poll(&one, 1, static_cast<int>(quiet.count())) <= 0) return out;
            const ssize_t count = ::recv(socket_, some, sizeof some, 0);
            if (count <= 0) {
                closed_ = true;
                return out;
            }
            out.append(some, static_cast<std::size_t>(count));
        }
    }
    /// Whether the last receiveAll() ended by the server's closing.
    [[nodiscard]] bool closed() const { return closed_; }

  private:
    int socket_;
    bool closed_ = false;
};

[[nodiscard]] inline int statusOf(const std::string& answer) {
    return answer.starts_with("HTTP/1.1 ") ? std::atoi(answer.c_str() + 9) : 0;
}

}  // namespace deixis::tests
