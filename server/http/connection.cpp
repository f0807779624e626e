#include "connection.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/err.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>

namespace deixis::server {

namespace {

/// So soon is it noticed that the server stops.
constexpr long slice_ms = 200;

/// The newest of OpenSSL's errors; none stay behind.
std::string tlsProblem() {
    const unsigned long code = ERR_peek_last_error();
    ERR_clear_error();
    const char* text = code == 0 ? nullptr : ERR_reason_error_string(code);
    return text == nullptr ? "cannot be used" : text;
}

/// A key with a password is an error: nobody is asked at a terminal.
int noPassword(char*, int, int, void*) {
    return 0;
}

}  // namespace

Result<TlsContext> loadTls(const std::filesystem::path& certificate, const std::filesystem::path& key) {
    TlsContext context(SSL_CTX_new(TLS_server_method()));
    if (!context) return fail("TLS", tlsProblem());
    SSL_CTX_set_min_proto_version(context.get(), TLS1_2_VERSION);
    SSL_CTX_set_options(context.get(), SSL_OP_NO_RENEGOTIATION | SSL_OP_NO_COMPRESSION);
    SSL_CTX_set_mode(context.get(), SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
    SSL_CTX_set_default_passwd_cb(context.get(), noPassword);
    if (SSL_CTX_use_certificate_chain_file(context.get(), certificate.c_str()) != 1)
        return fail(certificate.string(), "no certificate could be read: " + tlsProblem(),
                    "A PEM file is expected");
    if (SSL_CTX_use_PrivateKey_file(context.get(), key.c_str(), SSL_FILETYPE_PEM) != 1)
        return fail(key.string(), "no key of this certificate could be read: " + tlsProblem(),
                    "A PEM file without a password is expected");
    return context;
}

std::chrono::milliseconds Patience::left() const {
    const Clock::time_point stop{Clock::duration(stop_at.load())};
    return std::chrono::ceil<std::chrono::milliseconds>(std::min(until, std::max(stop, at_least)) -
                                                        Clock::now());
}

Connection::Connection(Descriptor socket, SSL_CTX* tls) : socket_(std::move(socket)) {
    const int on = 1;
    ::setsockopt(socket_.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (tls == nullptr) return;
    tls_.reset(SSL_new(tls));
    if (!tls_ || SSL_set_fd(tls_.get(), socket_.number()) != 1) {
        broken_ = true;
        return;
    }
    SSL_set_accept_state(tls_.get());
}

Connection::~Connection() {
    endWriting();
}

/// What a call of OpenSSL that did nothing waits for.
Connection::Next Connection::after(int result) {
    switch (SSL_get_error(tls_.get(), result)) {
        case SSL_ERROR_WANT_READ:
            return Next::read;
        case SSL_ERROR_WANT_WRITE:
            return Next::write;
        case SSL_ERROR_ZERO_RETURN:
            return Next::closed;
        default:
            broken_ = true;
            ERR_clear_error();
            return Next::closed;
    }
}

/// The number of bytes; 0 and what to do next where there are none.
long Connection::receiveSome(char* to, std::size_t size, Next& next) {
    if (broken_) {
        next = Next::closed;
        return 0;
    }
    if (tls_) {
        ERR_clear_error();
        const int count = SSL_read(tls_.get(), to, static_cast<int>(std::min<std::size_t>(size, INT_MAX)));
        if (count > 0) return count;
        next = after(count);
        return 0;
    }
    for (;;) {
        const ssize_t count = ::recv(socket_.number(), to, size, 0);
        if (count > 0) return count;
        if (count < 0 && errno == EINTR) continue;
        next = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) ? Next::read : Next::closed;
        return 0;
    }
}

long Connection::sendSome(std::string_view bytes, Next& next) {
    if (broken_) {
        next = Next::closed;
        return 0;
    }
    if (tls_) {
        ERR_clear_error();
        const int count = SSL_write(tls_.get(), bytes.data(),
                                    static_cast<int>(std::min<std::size_t>(bytes.size(), INT_MAX)));
        if (count > 0) return count;
        next = after(count);
        return 0;
    }
    for (;;) {
        const ssize_t count = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (count > 0) return count;
        if (count < 0 && errno == EINTR) continue;
        next = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK) ? Next::write : Next::closed;
        return 0;
    }
}

Connection::Next Connection::receive(std::size_t enough) {
    std::array<char, 4096> some{};
    while (received().size() < enough) {
        Next next = Next::read;
        const long count = receiveSome(some.data(), std::min(some.size(), enough - received().size()), next);
        if (count == 0) return next;
        received_.append(some.data(), static_cast<std::size_t>(count));
    }
    return Next::enough;
}

void Connection::forgetReceived() {
    received_.clear();
    taken_ = 0;
}

bool Connection::waitFor(Next next, const Patience& patience) const {
    for (;;) {
        const auto left = patience.left().count();
        if (left <= 0) return false;
        pollfd one{socket_.number(), static_cast<short>(next == Next::write ? POLLOUT : POLLIN), 0};
        const int ready = ::poll(&one, 1, static_cast<int>(std::min<long>(left, slice_ms)));
        if (ready > 0) return true;
        if (ready < 0 && errno != EINTR) return false;
    }
}

long Connection::read(char* to, std::size_t size, const Patience& patience) {
    if (!received().empty()) {
        const std::size_t count = std::min(size, received().size());
        std::memcpy(to, received().data(), count);
        taken_ += count;
        if (received().empty()) forgetReceived();
        return static_cast<long>(count);
    }
    for (;;) {
        Next next = Next::read;
        const long count = receiveSome(to, size, next);
        if (count > 0) return count;
        if (next == Next::closed) return 0;
        if (!waitFor(next, patience)) return -1;
    }
}

bool Connection::write(std::string_view bytes, const Patience& patience) {
    while (!bytes.empty()) {
        Next next = Next::write;
        const long count = sendSome(bytes, next);
        bytes.remove_prefix(static_cast<std::size_t>(count));
        if (count == 0 && (next == Next::closed || !waitFor(next, patience))) return false;
    }
    return true;
}

void Connection::writeAtOnce(std::string_view bytes) {
    Next next = Next::write;
    (void)sendSome(bytes, next);
}

void Connection::endWriting() {
    if (tls_ && !broken_ && SSL_is_init_finished(tls_.get()) == 1) {
        ERR_clear_error();
        (void)SSL_shutdown(tls_.get());
    }
    ::shutdown(socket_.number(), SHUT_WR);
}

}  // namespace deixis::server
