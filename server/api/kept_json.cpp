#include "kept_json.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/hash.hpp"
#include "core/text.hpp"
#include "server/http/json_text.hpp"

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr int kept_version = 1;
constexpr std::size_t revision_letters = 32;

}  // namespace

json withFormat(const char* format, json fields) {
    fields["format"] = format;
    fields["version"] = kept_version;
    return fields;
}

Result<json> parseKeptJson(std::string_view text, const char* format, std::vector<ShapeField> fields) {
    auto content = parseJsonText(text);
    if (!content) return content;
    if (content->is_object() && content->contains("version") && (*content)["version"].is_number_integer() &&
        (*content)["version"] > kept_version)
        return fail("version", fmt::format("found {}, expected {}: a newer Deixis wrote it",
                                           (*content)["version"].dump(), kept_version));
    fields.push_back(mustField("format", choiceShape("", {format})));
    fields.push_back(mustField("version", integerShape("", kept_version, kept_version)));
    const Shape shape = objectShape("", std::move(fields));
    if (const auto checked = checkShape(shape, *content); !checked) return tl::unexpected(checked.error());
    fillIn(shape, *content);
    return content;
}

Result<json> readKeptJson(const KeptFolder& folder, const std::string& file, std::size_t max_bytes,
                          const char* format, std::vector<ShapeField> fields) {
    const auto text = folder.read(file, max_bytes);
    if (!text) return fail("", text.error().message);
    return parseKeptJson(*text, format, std::move(fields));
}

Result<void> writeKeptJson(const KeptFolder& folder, const std::string& file, const char* format,
                           const json& fields) {
    return folder.write(file, withFormat(format, fields).dump() + "\n");
}

std::string revisionOf(std::string_view content) {
    return sha256Hex(content).substr(0, revision_letters);
}

tl::unexpected<Refusal> noFolder() {
    return tl::unexpected(
        Refusal{409, "the server has no folder to keep anything in: start it with --folder DIR"});
}

tl::unexpected<Refusal> otherRevision() {
    return tl::unexpected(Refusal{412, "it was changed meanwhile: get it again before changing it"});
}

tl::unexpected<Refusal> notWritten(const Error& error) {
    constexpr int insufficient_storage = 507;
    return tl::unexpected(Refusal{insufficient_storage, "it could not be kept: " + error.text()});
}

json damagedJson(const std::vector<DamagedFile>& files) {
    json out = json::array();
    for (const DamagedFile& one : files)
        out.push_back({{"file", one.file}, {"problem", storable(one.problem)}});
    return out;
}

ShapeField damagedField() {
    return mustField("damaged",
                     listShape("Files of the server's folder that cannot be read, and were left out",
                               objectShape("", {mustField("file", textShape("Within the folder", 1)),
                                                mustField("problem", textShape("What was found", 1))})));
}

}  // namespace deixis::server
