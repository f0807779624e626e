// One of the threads that answer: it reads a request from a connection whose head has come, calls its route,
// and writes the answer. cpp-httplib reads and writes HTTP; what is allowed is decided before it reads a
// body.
#pragma once

#include <httplib.h>

#include <atomic>
#include <memory>
#include <string>

#include "admission.hpp"
#include "compression.hpp"
#include "connection.hpp"
#include "server/http/http_server.hpp"

namespace deixis::server {

class Answering : private httplib::Server {
  public:
    /// Both are kept by reference. `stop_at`: see Patience.
    Answering(const Admission& admission, const ServerLimits& limits, const std::atomic<Clock::rep>& stop_at);

    /// Whether the connection can go on with another request; `last`: it shall not.
    bool answer(Connection& connection, bool last);

  private:
    void writeReply(const httplib::Request& request, httplib::Response& response, Reply reply) const;
    void writeRefusal(httplib::Response& response, const Refusal& refusal) const;
    void signIn(httplib::Response& response) const;
    void writePage(const httplib::Request& request, httplib::Response& response) const;
    void callRoute(const httplib::Request& request, httplib::Response& response) const;
    HandlerResponse beforeBody(const httplib::Request& request, httplib::Response& response) const;

    const Admission& admission_;
    const ServerLimits& limits_;
    const std::atomic<Clock::rep>& stop_at_;
    Verdict verdict_;           ///< on the request that is being answered
    AcceptedCodings accepted_;  ///< by its client
};

}  // namespace deixis::server
