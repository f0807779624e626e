#include "admission.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/number.hpp"
#include "core/text.hpp"
#include "listening.hpp"
#include "secrets.hpp"

namespace deixis::server {

namespace {

constexpr int http_port = 80;
constexpr int https_port = 443;

/// "name:port"; without a port 0. The name in small letters, IPv6 in its brackets.
std::optional<std::pair<std::string, int>> nameAndPort(std::string_view authority) {
    const std::size_t bracket = authority.starts_with('[') ? authority.find(']') : 0;
    if (bracket == std::string_view::npos) return std::nullopt;
    const std::size_t colon = authority.find(':', bracket);
    if (colon == std::string_view::npos) return std::pair(lowerCase(authority), 0);
    const auto port = naturalNumber(authority.substr(colon + 1));
    if (!port || *port == 0 || *port > 65535) return std::nullopt;
    return std::pair(lowerCase(authority.substr(0, colon)), static_cast<int>(*port));
}

/// The values of that name in all Cookie headers.
std::vector<std::string> cookies(const httplib::Request& request, std::string_view name) {
    std::vector<std::string> out;
    const auto [first, last] = request.headers.equal_range("Cookie");
    for (auto header = first; header != last; ++header) {
        std::string_view rest = header->second;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(';'), rest.size());
            const auto pair = nameAndValue(trimmed(rest.substr(0, end)));
            if (pair && pair->first == name) out.push_back(pair->second);
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    return out;
}

std::string mediaType(const httplib::Request& request) {
    const std::string value = request.get_header_value("Content-Type");
    return lowerCase(trimmed(std::string_view(value).substr(0, value.find(';'))));
}

Refusal unauthorised() {
    return {401, "the request has no token, or another one; send 'Authorization: Bearer TOKEN'"};
}

/// How long a body follows; refused where that is not said in one clear way.
tl::expected<std::size_t, Refusal> contentLength(const httplib::Request& request) {
    if (request.has_header("Transfer-Encoding"))
        return tl::unexpected(Refusal{411, "bodies in pieces are not taken; send Content-Length"});
    const std::size_t count = request.get_header_value_count("Content-Length");
    if (count == 0) return 0;
    const auto length = naturalNumber(request.get_header_value("Content-Length"));
    if (count > 1 || !length)
        return tl::unexpected(Refusal{400, "Content-Length is no whole number, or stands there twice"});
    return static_cast<std::size_t>(*length);
}

}  // namespace

Admission::Admission(ServerSettings settings, int port, std::vector<Route> routes, PageFiles pages)
    : settings_(std::move(settings)), port_(port), routes_(std::move(routes)), pages_(std::move(pages)) {
    names_.push_back(inUrl(settings_.address));
    for (const char* name : {"localhost", "127.0.0.1", "[::1]"}) names_.emplace_back(name);
    for (const std::string& host : settings_.hosts) names_.push_back(lowerCase(host));
}

std::size_t Admission::largestBody() const {
    std::size_t largest = 0;
    for (const Route& route : routes_)
        largest = std::max({largest, route.max_body_bytes, route.max_form_bytes});
    return largest;
}

std::string Admission::signInCookie() const {
    return fmt::format("deixis_token={}; Path=/; HttpOnly; SameSite=Strict{}", settings_.token,
                       secure() || settings_.behind_proxy ? "; Secure" : "");
}

bool Admission::isOurName(std::string_view authority, const std::string& local_address, bool secure) const {
    const auto asked = nameAndPort(authority);
    if (!asked) return false;
    // A page of another site can have a name of its own lead here, but not an address.
    const bool known = std::find(names_.begin(), names_.end(), asked->first) != names_.end() ||
                       (!local_address.empty() && asked->first == inUrl(local_address));
    if (!known) return false;
    if (settings_.behind_proxy) return true;
    const int usual = secure ? https_port : http_port;
    return (asked->second == 0 ? usual : asked->second) == port_;
}

bool Admission::isOurOrigin(std::string_view origin, const std::string& local_address) const {
    for (const bool secure_scheme : {false, true}) {
        const std::string_view scheme = secure_scheme ? "https://" : "http://";
        if (!origin.starts_with(scheme)) continue;
        if (secure_scheme != secure() && !settings_.behind_proxy) return false;
        return isOurName(origin.substr(scheme.size()), local_address, secure_scheme);
    }
    return false;
}

bool Admission::hasToken(const httplib::Request& request) const {
    if (settings_.token.empty()) return true;
    const std::string authorization = request.get_header_value("Authorization");
    constexpr std::string_view scheme = "bearer ";
    if (authorization.size() > scheme.size() && lowerCase(authorization.substr(0, scheme.size())) == scheme)
        return sameSecret(trimmed(std::string_view(authorization).substr(scheme.size())), settings_.token);
    const auto kept = cookies(request, "deixis_token");
    return std::any_of(kept.begin(), kept.end(),
                       [this](const std::string& one) { return sameSecret(one, settings_.token); });
}

std::optional<Refusal> Admission::foreign(const httplib::Request& request) const {
    if (request.get_header_value_count("Host") != 1) return Refusal{400, "one Host header is expected"};
    const std::string local = request.local_addr;
    const std::string host = request.get_header_value("Host");
    if (!isOurName(host, local, secure()))
        return Refusal{421, fmt::format("'{}' is no name of this server", host.substr(0, 100))};
    if (!request.has_header("Origin")) return std::nullopt;
    if (request.get_header_value_count("Origin") != 1 ||
        !isOurOrigin(request.get_header_value("Origin"), local))
        return Refusal{403, "pages of other sites may not ask this server"};
    return std::nullopt;
}

std::optional<Refusal> Admission::bodyProblem(const httplib::Request& request, const Route& route,
                                              std::size_t bytes) {
    if (!route.body && route.form.empty()) {
        if (bytes > 0) return Refusal{400, "a body is not taken here"};
        return std::nullopt;
    }
    if (!request.has_header("Content-Length")) return Refusal{411, "Content-Length is missing"};
    const std::string type = mediaType(request);
    const bool as_json = route.body && type == "application/json";
    const bool as_form = !route.form.empty() && type == "multipart/form-data";
    if (request.has_header("Content-Encoding") || !(as_json || as_form))
        return Refusal{415, fmt::format("expected a body of type {}{}{}, not compressed",
                                        route.body ? "application/json" : "",
                                        route.body && !route.form.empty() ? " or " : "",
                                        route.form.empty() ? "" : "multipart/form-data")};
    const std::size_t most = as_form ? route.max_form_bytes : route.max_body_bytes;
    if (bytes > most)
        return Refusal{413, fmt::format("found a body of {} bytes, expected at most {}", bytes, most)};
    return std::nullopt;
}

void Admission::findTarget(const httplib::Request& request, std::string_view path, Verdict& verdict) const {
    const std::string method = request.method == "HEAD" ? "GET" : request.method;
    std::string others;
    for (const Route& route : routes_) {
        auto parts = matchPath(route.path, path);
        if (!parts) continue;
        if (route.method == method) {
            verdict.route = &route;
            verdict.path_parts = std::move(*parts);
            return;
        }
        others += (others.empty() ? "" : ", ") + route.method;
    }
    if (const auto page = pages_.find(path); page != pages_.end()) {
        if (method == "GET") {
            verdict.page = &page->second;
            return;
        }
        others = "GET";
    }
    if (others.empty()) {
        verdict.refusal = Refusal{404, "there is nothing at this address"};
        return;
    }
    verdict.headers.emplace_back("Allow", others);
    verdict.refusal = Refusal{405, fmt::format("{} is not taken here, only {}", request.method, others)};
}

void Admission::judge(const httplib::Request& request, Verdict& verdict) const {
    if ((verdict.refusal = foreign(request))) return;
    const std::string_view target = request.target;
    const std::size_t query = target.find('?');
    const std::string_view path = target.substr(0, query);
    const bool signs_in =
        path == "/" && request.method == "GET" && !settings_.token.empty() && request.has_param("token");
    const bool may =
        signs_in ? sameSecret(request.get_param_value("token"), settings_.token) : hasToken(request);
    if (!may) {
        verdict.headers.emplace_back("WWW-Authenticate", "Bearer");
        verdict.refusal = unauthorised();
        return;
    }
    if (!signs_in) findTarget(request, path, verdict);
    if (verdict.refusal) return;
    if (verdict.route == nullptr) {
        verdict.signs_in = signs_in;
        if (verdict.body_bytes > 0) verdict.refusal = Refusal{400, "a body is not taken here"};
    } else if (query != std::string_view::npos && verdict.route->query.empty()) {
        verdict.refusal = Refusal{400, "the address takes no parameters"};
    } else {
        verdict.refusal = bodyProblem(request, *verdict.route, verdict.body_bytes);
    }
}

Verdict Admission::judge(const httplib::Request& request) const {
    Verdict verdict;
    const auto length = contentLength(request);
    if (length) {
        verdict.body_bytes = *length;
        judge(request, verdict);
    } else {
        verdict.refusal = length.error();
    }
    const bool without_body =
        length && verdict.body_bytes == 0 && (request.method == "GET" || request.method == "HEAD");
    verdict.ends = verdict.refusal && !without_body;
    return verdict;
}

}  // namespace deixis::server
