#include "gltf_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <system_error>
#include <utility>

#include "assets/gltf/gltf_rejection.hpp"
#include "core/base64.hpp"
#include "core/files.hpp"
#include "core/text.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr std::uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, bin_chunk = 0x004E4942;
constexpr std::uintmax_t max_file = std::uintmax_t{1} << 31;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// %20 and alike decoded (RFC 3986, section 2.1).
std::string percentDecoded(std::string_view uri, const std::string& where) {
    std::string path;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            path += uri[i];
            continue;
        }
        const int high = i + 1 < uri.size() ? hexDigit(uri[i + 1]) : -1;
        const int low = i + 2 < uri.size() ? hexDigit(uri[i + 2]) : -1;
        if (high < 0 || low < 0)
            reject(where, fmt::format("\"{}\" has a % without two hexadecimal digits after it", uri));
        path += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return path;
}

constexpr auto hint = "Keep the file's parts in its folder, or export it as .glb";

/// What is wrong with a decoded path; empty where it stays in the folder.
std::string_view whyRejected(const std::string& path) {
    if (path.empty()) return "is empty";
    const auto odd = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
    if (std::any_of(path.begin(), path.end(), odd)) return "contains a control character";
    if (path.find('\\') != std::string::npos) return "contains a backslash";
    if (path.front() == '/') return "is an absolute path";
    if (path.find(':') < path.find('/')) return "has a scheme or a drive";
    for (const auto& part : std::filesystem::path(path))
        if (part == "..") return "leaves the folder";
    return {};
}

}  // namespace

Chunks splitChunks(std::string_view bytes, const std::string& file) {
    Chunks chunks;
    if (bytes.size() > max_file) reject(file, "larger than 2 GiB, expected a clip or a figure");
    if (bytes.size() < 4 || wordAt(bytes, 0) != glb_magic) {
        bytes = withoutByteOrderMark(bytes);
        const std::size_t first = bytes.find_first_not_of(" \t\r\n");
        if (first == std::string_view::npos || bytes[first] != '{')
            reject(file, "neither a glTF binary nor glTF text, which start with glTF or {",
                   "Export the file as .glb, .vrm or .gltf");
        chunks.json = bytes;
        return chunks;
    }
    if (bytes.size() < 20) reject(file, fmt::format("ends after {} bytes, inside its header", bytes.size()));
    if (const std::uint32_t version = wordAt(bytes, 4); version != 2)
        reject(file, fmt::format("a glTF binary of version {}, expected 2", version));
    const std::size_t total = wordAt(bytes, 8);
    if (total > bytes.size())
        reject(file, fmt::format("ends after {} of {} bytes", bytes.size(), total), "Copy the file again");
    bytes = bytes.substr(0, total);
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::size_t length = wordAt(bytes, at);
        const std::uint32_t type = wordAt(bytes, at + 4);
        if (length > bytes.size() - at - 8)
            reject(file, fmt::format("a chunk at byte {} claims {} bytes; {} are there", at, length,
                                     bytes.size() - at - 8));
        const std::string_view content = bytes.substr(at + 8, length);
        if (at == 12 && type != json_chunk) reject(file, "its first chunk is not JSON");
        if (at == 12) chunks.json = content;
        if (type == bin_chunk && !chunks.has_bin) {
            chunks.bin = content;
            chunks.has_bin = true;
        }
        at += 8 + length;
    }
    if (chunks.json.empty()) reject(file, "has no JSON chunk");
    return chunks;
}

std::string decodeDataUri(std::string_view uri, const std::string& where) {
    const std::size_t comma = uri.find(',');
    constexpr std::string_view base64 = ";base64";
    if (comma == std::string_view::npos || uri.substr(0, comma).size() < base64.size() ||
        uri.substr(comma - base64.size(), base64.size()) != base64)
        reject(where, "is a data URI without \";base64,\"");
    auto bytes = decodeBase64(uri.substr(comma + 1));
    if (!bytes) reject(where, "contains a character that is not a base64 digit");
    return std::move(*bytes);
}

std::string neighbourPath(std::string_view uri, const std::string& where) {
    std::string relative = percentDecoded(uri, where);
    if (const auto why = whyRejected(relative); !why.empty())
        reject(where, fmt::format("\"{}\" {}; only files in the folder of the glTF file are read", uri, why),
               hint);
    return relative;
}

std::string readNeighbour(const std::string& relative, const std::filesystem::path& folder,
                          std::size_t min_bytes, const std::string& where) {
    std::error_code code;
    const auto home = std::filesystem::canonical(folder.empty() ? "." : folder, code);
    const auto path = std::filesystem::canonical(home / relative, code);
    if (code || !std::filesystem::is_regular_file(path, code))
        reject(where, fmt::format("names the file \"{}\", which does not exist", relative), hint);
    if (std::mismatch(home.begin(), home.end(), path.begin(), path.end()).first != home.end())
        reject(where, fmt::format("\"{}\" is a link that leaves the folder", relative), hint);
    const std::uintmax_t size = std::filesystem::file_size(path, code);
    if (code || size < min_bytes || size > max_file)
        reject(where,
               fmt::format("\"{}\" has {} bytes, expected {} or more, and no more than {}", relative, size,
                           min_bytes, max_file),
               hint);
    auto bytes = readFile(path);
    if (!bytes) throw Rejection{bytes.error()};
    return std::move(*bytes);
}

}  // namespace deixis::assets::gltf
