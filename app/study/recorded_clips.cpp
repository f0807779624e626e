#include "app/study/recorded_clips.hpp"

#include <fmt/core.h>

#include <map>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/clips/clip_files.hpp"
#include "app/study/locked_set.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

// The file of each content that is locked beside the database; sets that are broken are skipped.
std::map<std::string, fs::path> lockedClips(const fs::path& database) {
    std::map<std::string, fs::path> out;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(lockedFolder(database), code)) {
        const auto files = readLockedList(entry.path());
        if (!files) continue;
        for (const auto& [name, hash] : *files) out.emplace(hash, entry.path() / name);
    }
    return out;
}

// Locked, or under `folder`, wherever there is a file of this name with these bytes.
Result<fs::path> findClip(const results::ClipRecord& record, const fs::path& folder,
                          const std::map<std::string, fs::path>& locked) {
    const auto isIt = [&](const fs::path& file) {
        const auto bytes = readFile(file);
        return bytes && sha256Hex(*bytes) == record.content_hash;
    };
    std::error_code code;
    bool met = false;
    if (const auto kept = locked.find(record.content_hash); kept != locked.end()) {
        if (isIt(kept->second)) return kept->second;
        met = true;
    }
    if (!folder.empty())
        for (const auto& entry : fs::recursive_directory_iterator(folder, code)) {
            if (entry.path().filename() != fs::path(record.file).filename()) continue;
            met = true;
            if (isIt(entry.path())) return entry.path();
        }
    if (fs::is_regular_file(record.file, code)) {
        if (isIt(record.file)) return fs::path(record.file);
        met = true;
    }
    if (met)
        return fail(record.file, "has another movement than the one that was shown",
                    "Name the folder of the clips that were shown with --stimuli");
    return fail(record.file, "No such file; it is the clip that was shown", "Name its folder with --stimuli");
}

}  // namespace

Result<void> addShownClip(results::ClipRecords& to, const studies::Stimulus& stimulus,
                          const results::ClipRecord& record, const fs::path& database) {
    const auto [known, added] = to.emplace(stimulus, record);
    if (added || known->second.content_hash == record.content_hash) return {};
    return fail(
        database.string(),
        fmt::format("participants were shown different clips of {} for {}", stimulus.system, stimulus.item),
        "Use the databases of each set of clips separately");
}

Result<RecordedClips> RecordedClips::load(const results::ClipRecords& records, const assets::Avatar& avatar,
                                          const fs::path& folder, const fs::path& database) {
    RecordedClips out;
    const auto locked = lockedClips(database);
    for (const auto& [stimulus, record] : records) {
        const auto file = findClip(record, folder, locked);
        if (!file) return tl::unexpected(file.error());
        const auto read = assets::importClip(*file);
        if (!read) return tl::unexpected(read.error());
        auto on_avatar = clipOnAvatar(*read, file->string(), avatar);
        if (!on_avatar) return tl::unexpected(on_avatar.error());
        out.clips_.emplace(stimulus, std::move(*on_avatar));
    }
    return out;
}

const motion::Clip& RecordedClips::clip(const studies::Stimulus& stimulus) const {
    const auto found = clips_.find(stimulus);
    if (found == clips_.end())
        throw std::logic_error(
            fmt::format("clip of {} for {} was not loaded", stimulus.system, stimulus.item));
    return found->second;
}

}  // namespace deixis::app
