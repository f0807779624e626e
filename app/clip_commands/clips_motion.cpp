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

NamedClip named(const assets::ManifestRow& row, const fs::path& folder) {
    NamedClip out{folder / row.clip, row.system, row.target_id, row.target, {}};
    if (row.phases) {
        out.phases.emplace();
        out.phases->hand = row.phases->hand;
        out.phases->onset_frame = row.phases->onset_frame;
        out.phases->peak_frame = row.phases->peak_frame;
        out.phases->hold_frame = row.phases->hold_frame;
        out.phases->end_frame = row.phases->end_frame;
    }
    return out;
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
                    out.push_back(named(row, file.parent_path()));
                continue;
            }
        }
        out.push_back({file, "", "", {}, {}});
    }
    return out;
}

}  // namespace deixis::app
