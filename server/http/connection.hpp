// A client's connection, in the clear or by TLS. One thread at a time uses it.
#pragma once

#include <openssl/ssl.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "listening.hpp"

namespace deixis::server {

using Clock = std::chrono::steady_clock;

struct TlsFree {
    void operator()(SSL_CTX* context) const { SSL_CTX_free(context); }
    void operator()(SSL* session) const { SSL_free(session); }
};
using TlsContext = std::unique_ptr<SSL_CTX, TlsFree>;

/// TLS 1.2 or 1.3 with that certificate. Errors name the file.
[[nodiscard]] Result<TlsContext> loadTls(const std::filesystem::path& certificate,
                                         const std::filesystem::path& key);

/// Until when a transfer may go on; a server that stops has less patience, but `at_least` so much.
struct Patience {
    Clock::time_point until;
    Clock::time_point at_least;
    const std::atomic<Clock::rep>& stop_at;  ///< since the clock's epoch

    [[nodiscard]] std::chrono::milliseconds left() const;
};

class Connection {
  public:
    /// `tls` may be none; else it outlives the connection.
    Connection(Descriptor socket, SSL_CTX* tls);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    enum class Next { read, write, enough, closed };
    /// Without waiting: takes what has come into received(), up to `enough` bytes there; says what to wait
    /// for.
    Next receive(std::size_t enough);
    /// What has come and was not taken by read() yet.
    [[nodiscard]] std::string_view received() const { return std::string_view(received_).substr(taken_); }
    void forgetReceived();
    [[nodiscard]] int socket() const { return socket_.number(); }

    /// Waits for some bytes; 0: closed, negative: too late or broken.
    long read(char* to, std::size_t size, const Patience& patience);
    /// All of it, or false.
    bool write(std::string_view bytes, const Patience& patience);
    /// Without waiting; what does not fit is lost.
    void writeAtOnce(std::string_view bytes);
    /// Nothing more will be written; the client may still send.
    void endWriting();

  private:
    [[nodiscard]] bool waitFor(Next next, const Patience& patience) const;
    long receiveSome(char* to, std::size_t size, Next& next);
    long sendSome(std::string_view bytes, Next& next);
    Next after(int result);

    Descriptor socket_;
    std::unique_ptr<SSL, TlsFree> tls_;
    bool broken_ = false;
    std::string received_;
    std::size_t taken_ = 0;
};

}  // namespace deixis::server
