#include "clips_motion.hpp"

#include <string_view>

#include "core/files.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

bool isManifest(const std::string& text) {
    const std::string header = "," + text.substr(0, text.find_first_of("\r\n")) + ",";
    return header.find(",clip,") != std::string::npos;
}

}  // namespace

Result<std::vector<NamedClip>> namedClips(const std::vector<std::string>& files) {
    std::vector<NamedClip> out;
    for (const std::string& name : files) {
        const fs::path file(name);
        if (file.extension() == ".csv") {
            const auto text = readFile(file);
            if (!text) return tl::unexpected(text.error());
            if (isManifest(*text)) {
                const auto manifest = assets::readManifest(file);
                if (!manifest) return tl::unexpected(manifest.error());
                for (const assets::ManifestRow& row : manifest->rows)
                    out.push_back({file.parent_path() / row.clip, row.system, row.target_id, row.target,
                                   row.target_frame, row.phases});
                continue;
            }
        }
        out.push_back({file, "", "", {}, {}, {}});
    }
    return out;
}

}  // namespace deixis::app
