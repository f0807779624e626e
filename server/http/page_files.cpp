#include "page_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "compression.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"

namespace deixis::server {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = std::size_t{256} << 20U;

const char* contentType(const std::string& extension) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 18> types{{
        {".html", "text/html; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},
        {".mjs", "text/javascript; charset=utf-8"},
        {".css", "text/css; charset=utf-8"},
        {".json", "application/json"},
        {".map", "application/json"},
        {".webmanifest", "application/manifest+json"},
        {".txt", "text/plain; charset=utf-8"},
        {".svg", "image/svg+xml"},
        {".png", "image/png"},
        {".jpg", "image/jpeg"},
        {".webp", "image/webp"},
        {".ico", "image/x-icon"},
        {".woff2", "font/woff2"},
        {".ttf", "font/ttf"},
        {".wasm", "application/wasm"},
        {".glb", "model/gltf-binary"},
        {".wav", "audio/wav"},
    }};
    const auto found =
        std::find_if(types.begin(), types.end(), [&](const auto& one) { return one.first == extension; });
    return found == types.end() ? "application/octet-stream" : found->second;
}

std::shared_ptr<const std::string> compressedOnce(std::string_view bytes, const std::string& content_type,
                                                  Coding coding) {
    if (!isCompressible(content_type)) return nullptr;
    auto out = compressed(bytes, coding, Effort::thorough);
    return out ? std::make_shared<const std::string>(std::move(*out)) : nullptr;
}

bool isPlainName(const std::string& name) {
    return !name.starts_with('.') && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
               c == '_' || c == '-';
    });
}

struct PageReader {
    PageFiles files{};
    std::size_t bytes = 0;

    Result<void> readFolder(const fs::path& folder, const std::string& path) {
        std::error_code code;
        for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
            const std::string name = at->path().filename().string();
            const auto type = at->symlink_status(code).type();
            if (code) break;
            if (!isPlainName(name)) continue;
            if (type == fs::file_type::directory) {
                if (auto read = readFolder(at->path(), path + name + "/"); !read) return read;
            } else if (type == fs::file_type::regular) {
                if (auto read = readPage(at->path(), path, name); !read) return read;
            }
        }
        if (code) return fail(folder.string(), "cannot be read: " + code.message());
        return {};
    }

    Result<void> readPage(const fs::path& file, const std::string& path, const std::string& name) {
        auto content = readFile(file, most_bytes - bytes);
        if (!content) return tl::unexpected(content.error());
        add(path, name, std::move(*content));
        return {};
    }

    void add(const std::string& path, const std::string& name, std::string content) {
        bytes += content.size();
        PageFile page;
        page.etag = fmt::format("\"{}\"", sha256Hex(content).substr(0, 32));
        page.content_type = contentType(fs::path(name).extension().string());
        page.gzip = compressedOnce(content, page.content_type, Coding::gzip);
        page.brotli = compressedOnce(content, page.content_type, Coding::brotli);
        page.bytes = std::make_shared<const std::string>(std::move(content));
        if (name == "index.html") files[path] = page;
        files[path + name] = std::move(page);
    }
};

}  // namespace

Result<PageFiles> loadPageFiles(const fs::path& folder, const std::map<std::string, fs::path>& others,
                                const std::map<std::string, std::string>& contents) {
    // The folder itself may be a link: a build's share has links to the sources.
    PageReader reader;
    if (!folder.empty())
        if (auto read = reader.readFolder(folder, "/"); !read) return tl::unexpected(read.error());
    const auto split = [](const std::string& path) {
        const std::size_t name = path.rfind('/') + 1;
        return std::pair(path.substr(0, name), path.substr(name));
    };
    for (const auto& [path, file] : others) {
        const auto [within, name] = split(path);
        if (auto read = reader.readPage(file, within, name); !read) return tl::unexpected(read.error());
    }
    for (const auto& [path, content] : contents) {
        const auto [within, name] = split(path);
        if (content.size() > most_bytes - std::min(most_bytes, reader.bytes))
            return fail(path, fmt::format("the page's files have more than {} MiB", most_bytes >> 20U));
        reader.add(within, name, content);
    }
    return std::move(reader.files);
}

}  // namespace deixis::server
