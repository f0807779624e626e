// Who may ask, and for what: judged by a request's head alone, before its body is read.
#pragma once

#include <httplib.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "page_files.hpp"
#include "server/http/http_server.hpp"

namespace deixis::server {

/// Either a refusal, or one of the others.
struct Verdict {
    std::optional<Refusal> refusal{};
    std::vector<std::pair<std::string, std::string>> headers{};  ///< of the refusal
    const Route* route = nullptr;
    std::map<std::string, std::string> path_parts{};
    const PageFile* page = nullptr;
    bool signs_in = false;       ///< by /?token=, which was right
    std::size_t body_bytes = 0;  ///< that follow the head
    bool ends = false;           ///< the connection: of the refused request more may follow than is known
};

class Admission {
  public:
    /// `port` as it turned out. All are kept.
    Admission(ServerSettings settings, int port, std::vector<Route> routes, PageFiles pages);

    [[nodiscard]] Verdict judge(const httplib::Request& request) const;

    [[nodiscard]] bool secure() const { return !settings_.certificate.empty(); }
    [[nodiscard]] std::string signInCookie() const;
    [[nodiscard]] std::size_t largestBody() const;

  private:
    void judge(const httplib::Request& request, Verdict& verdict) const;
    [[nodiscard]] bool isOurName(std::string_view authority, const std::string& local_address,
                                 bool secure) const;
    [[nodiscard]] bool isOurOrigin(std::string_view origin, const std::string& local_address) const;
    [[nodiscard]] bool hasToken(const httplib::Request& request) const;
    [[nodiscard]] std::optional<Refusal> foreign(const httplib::Request& request) const;
    void findTarget(const httplib::Request& request, std::string_view path, Verdict& verdict) const;
    [[nodiscard]] static std::optional<Refusal> bodyProblem(const httplib::Request& request,
                                                            const Route& route, std::size_t bytes);

    ServerSettings settings_;
    int port_;
    std::vector<std::string> names_;
    std::vector<Route> routes_;
    PageFiles pages_;
};

}  // namespace deixis::server
