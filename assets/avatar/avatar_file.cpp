#include "avatar_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <string_view>

#include "core/files.hpp"
#include "core/hash.hpp"

namespace deixis::assets {

namespace {

namespace fs = std::filesystem;

/// What reading the files beside the glTF needs and finds out.
struct Beside {
    std::optional<fs::path> folder;
    std::string problem;  ///< the first
    std::string hashes;   ///< of the files read, in their order
    std::vector<fs::path> files{};

    /// Whether the file lies in the folder, by its name and wherever links lead.
    [[nodiscard]] bool holds(const fs::path& file) const {
        const auto leaves = [](const fs::path& relative) {
            return relative.empty() || relative.is_absolute() || *relative.begin() == "..";
        };
        if (!folder || leaves(file.lexically_normal().lexically_relative(folder->lexically_normal())))
            return false;
        std::error_code code;
        const fs::path real = fs::weakly_canonical(file, code);
        return !code && !leaves(real.lexically_relative(fs::weakly_canonical(*folder, code)));
    }

    void note(std::string text) {
        if (problem.empty()) problem = std::move(text);
    }
};

bool besideExists(const std::string& file, void* user) {
    auto& beside = *static_cast<Beside*>(user);
    if (!beside.holds(file)) {
        beside.note(fmt::format("names the file \"{}\", which lies outside its folder", file));
        return false;
    }
    std::error_code code;
    if (fs::is_regular_file(file, code)) return true;
    beside.note(fmt::format("names the file \"{}\", which is not there", file));
    return false;
}

bool readBeside(std::vector<unsigned char>* out, std::string* problem, const std::string& file, void* user) {
    auto& beside = *static_cast<Beside*>(user);
    const auto bytes = readFile(file);
    if (!bytes) {
        if (problem != nullptr) *problem += bytes.error().text();
        beside.note(bytes.error().text());
        return false;
    }
    beside.hashes += sha256Hex(*bytes);
    beside.files.emplace_back(file);
    out->assign(bytes->begin(), bytes->end());
    return true;
}

/// A template, since later versions of tinygltf (2.9, Debian 13) ask for a file's size too.
template <typename Callbacks>
Callbacks besideCallbacks(Beside& beside) {
    Callbacks files{};
    files.FileExists = besideExists;
    files.ExpandFilePath = [](const std::string& name, void*) { return name; };
    files.ReadWholeFile = readBeside;
    files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
        return false;
    };
    if constexpr (requires { files.GetFileSizeInBytes; })
        files.GetFileSizeInBytes = [](std::size_t* size, std::string* problem, const std::string& file,
                                      void*) {
            std::error_code code;
            *size = static_cast<std::size_t>(fs::file_size(file, code));
            if (code && problem != nullptr) *problem += file + ": " + code.message();
            return !code;
        };
    files.user_data = &beside;
    return files;
}

/// Keeps an image's bytes as they are: only those that a material uses are decoded later.
bool keepImage(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
               int size, void*) {
    image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

/// Extensions that a file may call required: what they add is read, or does not matter to a figure.
constexpr std::array<std::string_view, 17> known_extensions{"KHR_materials_unlit",
                                                            "KHR_texture_transform",
                                                            "KHR_mesh_quantization",
                                                            "KHR_materials_emissive_strength",
                                                            "KHR_materials_ior",
                                                            "KHR_materials_specular",
                                                            "KHR_materials_sheen",
                                                            "KHR_materials_clearcoat",
                                                            "KHR_lights_punctual",
                                                            "VRM",
                                                            "VRMC_vrm",
                                                            "VRMC_materials_mtoon",
                                                            "VRMC_materials_hdr_emissiveMultiplier",
                                                            "VRMC_springBone",
                                                            "VRMC_springBone_extended_collider",
                                                            "VRMC_springBone_limit",
                                                            "VRMC_node_constraint"};

std::string trimmed(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
    return text;
}

/// A data URI, or a path below the folder: the names of the files are judged before any is opened.
Result<void> checkUri(const std::string& uri, const std::string& file) {
    if (uri.starts_with("data:")) return {};
    const auto colon = uri.find(':');
    const bool scheme = colon != std::string::npos && uri.find('/') > colon;
    if (scheme || uri.starts_with("/") || uri.starts_with("\\"))
        return fail(file, fmt::format("names \"{}\", expected a file in its folder", uri.substr(0, 200)),
                    "Save the file with all that belongs to it as one .glb");
    return {};
}

/// The JSON text of a glTF file of either kind.
std::string_view jsonOf(std::string_view bytes) {
    if (!bytes.starts_with("glTF") || bytes.size() < 20) return bytes;
    const auto at = [&](std::size_t i) {
        return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
    };
    const std::size_t length = at(12) | at(13) << 8U | at(14) << 16U | at(15) << 24U;
    return bytes.substr(20, std::min(length, bytes.size() - 20));
}

/// Looks at each "uri" in the text. The whole text is only parsed by the library, which opens files at once.
Result<void> checkUris(std::string_view json, const std::string& file) {
    constexpr std::string_view key = "\"uri\"";
    for (auto at = json.find(key); at != std::string_view::npos; at = json.find(key, at + key.size())) {
        const auto colon = json.find_first_not_of(" \t\r\n", at + key.size());
        if (colon == std::string_view::npos || json[colon] != ':') continue;
        const auto quote = json.find_first_not_of(" \t\r\n", colon + 1);
        if (quote == std::string_view::npos || json[quote] != '"') continue;
        const auto end = json.find('"', quote + 1);
        const auto length =
            std::min<std::size_t>(end == std::string_view::npos ? end : end - quote - 1, 1024);
        if (auto good = checkUri(std::string(json.substr(quote + 1, length)), file); !good) return good;
    }
    return {};
}

}  // namespace

Result<AvatarFile> readAvatarFile(const fs::path& path) {
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return readAvatarBytes(*bytes, path.string(),
                           path.has_parent_path() ? path.parent_path() : fs::path("."));
}

Result<AvatarFile> readAvatarBytes(std::string_view bytes, const std::string& file,
                                   const std::optional<fs::path>& folder) {
    const bool binary = bytes.starts_with("glTF");
    const auto first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (!binary && (first == std::string_view::npos || bytes[first] != '{'))
        return fail(file, "not a glTF binary, which starts with the letters glTF, nor glTF's JSON",
                    "Export the avatar as .glb, .vrm or .gltf");
    if (bytes.size() > std::numeric_limits<std::int32_t>::max())
        return fail(file, "larger than 2 GiB, expected a figure");
    if (auto good = checkUris(jsonOf(bytes), file); !good) return tl::unexpected(good.error());

    Beside beside{folder, {}, {}, {}};
    const std::string base = folder ? folder->string() : std::string();
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keepImage, nullptr);
    loader.SetFsCallbacks(besideCallbacks<tinygltf::FsCallbacks>(beside));
    AvatarFile out;
    std::string problem, warning;
    const char* kind = binary ? "glTF binary" : "glTF file";
    try {
        const auto size = static_cast<unsigned int>(bytes.size());
        const bool loaded =
            binary ? loader.LoadBinaryFromMemory(&out.model, &problem, &warning,
                                                 reinterpret_cast<const unsigned char*>(bytes.data()), size,
                                                 base)
                   : loader.LoadASCIIFromString(&out.model, &problem, &warning, bytes.data(), size, base);
        if (!beside.problem.empty())
            return fail(file, beside.problem, "Keep the files that belong together in one folder");
        if (!loaded)
            return fail(file, fmt::format("not a readable {}: {}", kind, trimmed(problem)),
                        "Export the file anew");
    } catch (const std::exception& error) {  // tinygltf lets its JSON library's exceptions through
        return fail(file, fmt::format("not a readable {}: {}", kind, error.what()), "Export the file anew");
    }
    for (const std::string& extension : out.model.extensionsRequired)
        if (std::find(known_extensions.begin(), known_extensions.end(), extension) == known_extensions.end())
            return fail(file, fmt::format("needs the extension {}, which is not read", extension),
                        "Export without compression, and with PNG or JPEG textures");
    out.content_hash = beside.hashes.empty() ? sha256Hex(bytes) : sha256Hex(sha256Hex(bytes) + beside.hashes);
    out.beside = std::move(beside.files);
    return out;
}

}  // namespace deixis::assets
