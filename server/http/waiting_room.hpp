// Connections whose next request has not come as a whole head yet: one thread takes new ones and reads them
// all, so that slow clients cost no thread. Whole heads wait in a queue for those who answer.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "connection.hpp"
#include "server/http/http_server.hpp"

namespace deixis::server {

class WaitingRoom {
  public:
    /// `tls` may be none.
    WaitingRoom(Descriptor listener, TlsContext tls, const ServerLimits& limits);

    /// Until stop(); in a thread of its own.
    void run();
    /// No new connections; those that wait are closed; take() still gives what is in the queue.
    void stop();
    [[nodiscard]] bool stopping() const;

    /// A connection whose next head has come, the first that is in the queue; none when stopping and none is
    /// left.
    [[nodiscard]] std::unique_ptr<Connection> take();

    enum class After { next_request, farewell };
    /// After its answer. Farewell: what the client still sends is thrown away for a while, since closing at
    /// once could take the answer from it.
    void giveBack(std::unique_ptr<Connection> connection, After after);

  private:
    struct Guest {
        std::unique_ptr<Connection> connection;
        Clock::time_point since;     ///< of the head's first byte, or of its coming
        Clock::time_point deadline;  ///< is closed then
        Connection::Next next = Connection::Next::read;
        bool leaving = false;
        bool looked_at = false;  ///< before something more comes
        std::size_t thrown_away = 0;
    };

    void admit(std::unique_ptr<Connection> connection, After after);
    void acceptAll();
    void closeLongestWaiting();
    void takeReturned();
    /// Whether the guest stays.
    bool attend(Guest& guest);
    bool attendLeaving(Guest& guest) const;
    void queue(std::unique_ptr<Connection> connection);
    void refuse(Guest& guest, const Refusal& refusal) const;
    void wake() const;

    Descriptor listener_;
    TlsContext tls_;
    ServerLimits limits_;
    Descriptor wake_;
    std::vector<Guest> guests_;  ///< of the thread that runs

    mutable std::mutex mutex_;
    std::condition_variable came_;
    std::deque<std::unique_ptr<Connection>> ready_;
    std::vector<std::pair<std::unique_ptr<Connection>, After>> returned_;
    bool stopping_ = false;
};

}  // namespace deixis::server
