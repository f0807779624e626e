// deixis serve and deixis studio, started as somebody starts them and asked over real sockets.
#pragma once

#include <chrono>
#include <cstdlib>
#include <string>

#include "program.hpp"
#include "server/raw_client.hpp"
#include "text.hpp"

namespace deixis::tests {

/// The program with these arguments on a free port, once it has told its address.
class Serving {
  public:
    explicit Serving(const std::string& arguments, const std::string& command = "serve",
                     const std::string& environment = "")
        : running_("env ASAN_OPTIONS=detect_leaks=0 " + environment + " " + programFile() + " " + command +
                   " --port 0 " + arguments + " >" + (scratch_ / "out") + " 2>" + (scratch_ / "err")) {
        REQUIRE_MESSAGE(eventually(60, [this] { return contains(out(), "\n") || !running_.running(); }),
                        err());
        REQUIRE_MESSAGE(contains(out(), "\n"), err());
    }
    [[nodiscard]] std::string out() const { return slurp(scratch_ / "out"); }
    [[nodiscard]] std::string err() const { return slurp(scratch_ / "err"); }
    [[nodiscard]] int port() const {
        return std::atoi(out().c_str() + std::string("http://127.0.0.1:").size());
    }
    Background& running() { return running_; }

    [[nodiscard]] std::string head(const std::string& line, const std::string& token,
                                   const std::string& more = "") const {
        return line + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port()) + "\r\nConnection: close\r\n" +
               (token.empty() ? "" : "Authorization: Bearer " + token + "\r\n") + more + "\r\n";
    }
    [[nodiscard]] std::string answerTo(const std::string& bytes) const {
        RawClient client(port());
        client.send(bytes);
        return client.receiveAll(std::chrono::seconds(60));
    }
    [[nodiscard]] std::string post(const std::string& path, const nlohmann::json& body,
                                   const std::string& token) const {
        return send("POST", path, body, token);
    }
    [[nodiscard]] std::string send(const std::string& method, const std::string& path,
                                   const nlohmann::json& body, const std::string& token,
                                   const std::string& more = "") const {
        const std::string text = body.dump();
        return answerTo(head(method + " " + path, token,
                             more + "Content-Type: application/json\r\nContent-Length: " +
                                 std::to_string(text.size()) + "\r\n") +
                        text);
    }

  private:
    Scratch scratch_;
    Background running_;
};

inline std::string bodyOf(const std::string& answer) {
    const auto at = answer.find("\r\n\r\n");
    return at == std::string::npos ? "" : answer.substr(at + 4);
}

}  // namespace deixis::tests
