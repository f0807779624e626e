// What a route of the server is: declared once, it is matched, checked and documented by this.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "server/http/json_shape.hpp"

namespace deixis::server {

/// Why a request is not done; it is answered by {"error": {"message", "field"}}.
struct Refusal {
    int status = 400;  ///< of HTTP, 400 or above
    std::string message;
    std::optional<std::string> field{};
};

/// An error of the program: its `where` is the field.
[[nodiscard]] Refusal refusalOf(const Error& error, int status = 400);
[[nodiscard]] std::string bodyOf(const Refusal& refusal);
/// The same as a shape, for the document.
[[nodiscard]] Shape refusalShape();

struct Reply {
    int status = 200;
    std::string content_type{"application/json"};
    std::shared_ptr<const std::string> bytes{};  ///< none: an empty body
    std::vector<std::pair<std::string, std::string>> headers{};
};

[[nodiscard]] Reply jsonReply(const nlohmann::json& value);
[[nodiscard]] Reply jsonReply(const nlohmann::ordered_json& value);
/// Of a text that is JSON.
[[nodiscard]] Reply jsonTextReply(std::string text);
/// 204.
[[nodiscard]] Reply emptyReply();
/// The revision of what is answered, as ETag.
void addRevision(Reply& reply, const std::string& revision);

using Answer = tl::expected<Reply, Refusal>;

/// What a route is called with: checked by its declaration.
struct Call {
    std::map<std::string, std::string> path{};  ///< what stands in the braces
    nlohmann::json query{};                     ///< an object: what stood behind the '?', as declared
    nlohmann::json body{};                      ///< null where the route takes none, or a form came
    std::optional<std::map<std::string, std::string>> form{};  ///< name and bytes of each part
    std::optional<std::string> revision{};                     ///< of If-Match, without its quotes; "*": any
};

/// A part of an upload (multipart/form-data).
struct FormPart {
    std::string name;
    Shape shape;  ///< of kind text; for a file only its `about` counts
    bool required = true;
    bool file = false;
    std::string content_type{};  ///< of a file, for the document
};

struct Outcome {
    int status = 200;
    std::string about;
    std::string content_type{"application/json"};  ///< empty: an empty body
    std::optional<Shape> shape{};                  ///< of JSON
};

struct Route {
    std::string method;  ///< GET, POST, PUT or DELETE
    /// "/v1/speech/{id}.wav": a name in braces stands for 1 to 64 letters of a-z, A-Z, 0-9, '_' and '-'.
    std::string path;
    std::string name;  ///< of the operation in the document
    std::string about;
    std::map<std::string, std::string> path_parts{};     ///< what the names in braces are
    std::vector<ShapeField> query{};                     ///< whole numbers behind the '?'
    std::optional<Shape> body{};                         ///< JSON that it takes
    std::vector<FormPart> form{};                        ///< or an upload
    std::size_t max_body_bytes = std::size_t{1} << 20U;  ///< of JSON
    std::size_t max_form_bytes = std::size_t{1} << 20U;
    bool in_parts = false;          ///< parts of what it answers may be asked for: a sound that is played
    bool takes_revision = false;    ///< what it changes must be as If-Match says
    std::vector<Outcome> outcomes;  ///< several of one status: of several types
    std::function<Answer(const Call&)> run;
};

/// What stands in the braces, if that is a path of the route; `path` as it came, without its query.
[[nodiscard]] std::optional<std::map<std::string, std::string>> matchPath(const std::string& pattern,
                                                                          std::string_view path);

}  // namespace deixis::server
