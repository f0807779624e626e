// The socket that a server listens on.
#pragma once

#include <string>
#include <utility>

#include "core/error.hpp"

namespace deixis::server {

/// A file descriptor, closed at its end.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor();

    [[nodiscard]] int number() const { return number_; }
    [[nodiscard]] bool valid() const { return number_ >= 0; }

  private:
    int number_ = -1;
};

/// Numeric addresses only: names could be several addresses.
[[nodiscard]] bool isNumericAddress(const std::string& address);
/// 127.0.0.0/8 and ::1.
[[nodiscard]] bool isLoopback(const std::string& address);
/// As it stands in a URL: IPv6 in brackets.
[[nodiscard]] std::string inUrl(const std::string& address);
/// The same of a socket's own end, without brackets: "192.0.2.1"; IPv4 within IPv6 as IPv4.
[[nodiscard]] std::string localAddress(int socket);

struct Listening {
    Descriptor socket;
    int port = 0;
};

/// Port 0: a free one. The error says which address and port.
[[nodiscard]] Result<Listening> listenOn(const std::string& address, int port);

}  // namespace deixis::server
