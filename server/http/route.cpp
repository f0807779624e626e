#include "server/http/route.hpp"

#include <algorithm>

namespace deixis::server {

namespace {

constexpr std::size_t longest_path_part = 64;

bool belongsToPart(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

Refusal refusalOf(const Error& error, int status) {
    Refusal refusal;
    refusal.status = status;
    refusal.message = Error{"", error.message, error.hint}.text();
    if (!error.where.empty()) refusal.field = error.where;
    return refusal;
}

std::string bodyOf(const Refusal& refusal) {
    nlohmann::ordered_json body;
    body["error"]["message"] = refusal.message;
    body["error"]["field"] =
        refusal.field ? nlohmann::ordered_json(*refusal.field) : nlohmann::ordered_json();
    // What was found may be any bytes.
    return body.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Shape refusalShape() {
    Shape field = textShape("The field that is wrong; null: the request as a whole");
    field.nullable = true;
    return objectShape(
        "Why a request was not done",
        {mustField("error",
                   objectShape("", {mustField("message", textShape("What was found, and what was expected")),
                                    mustField("field", std::move(field))}))});
}

Reply jsonReply(const nlohmann::json& value) {
    return jsonTextReply(value.dump());
}

Reply jsonReply(const nlohmann::ordered_json& value) {
    return jsonTextReply(value.dump());
}

Reply jsonTextReply(std::string text) {
    Reply reply;
    reply.bytes = std::make_shared<const std::string>(std::move(text));
    return reply;
}

Reply emptyReply() {
    Reply reply;
    reply.status = 204;
    return reply;
}

void addRevision(Reply& reply, const std::string& revision) {
    reply.headers.emplace_back("ETag", '"' + revision + '"');
}

std::optional<std::map<std::string, std::string>> matchPath(const std::string& pattern,
                                                            std::string_view path) {
    std::map<std::string, std::string> parts;
    std::size_t at = 0;
    for (std::size_t i = 0; i < pattern.size();) {
        if (pattern[i] != '{') {
            if (at >= path.size() || path[at] != pattern[i]) return std::nullopt;
            ++at, ++i;
            continue;
        }
        const std::size_t end = pattern.find('}', i);
        const std::size_t from = at;
        while (at < path.size() && belongsToPart(path[at])) ++at;
        if (at == from || at - from > longest_path_part) return std::nullopt;
        parts[pattern.substr(i + 1, end - i - 1)] = std::string(path.substr(from, at - from));
        i = end + 1;
    }
    if (at != path.size()) return std::nullopt;
    return parts;
}

}  // namespace deixis::server
