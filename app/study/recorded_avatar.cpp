#include "app/study/recorded_avatar.hpp"

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "app/study/locked_set.hpp"
#include "studies/study_file/study_source.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

Result<assets::Avatar> shippedAvatarFor(const std::set<std::string>& hashes) {
    auto avatar = loadShippedAvatar();
    const bool known = !hashes.empty() && !hashes.contains("");
    if (avatar && known && !hashes.contains(avatar->content_hash))
        fmt::print(stderr,
                   "note: the sessions showed another version of Deixis's avatar; this version's is used\n");
    return avatar;
}

/// Where the named file may lie now. A path below the study file's folder is looked for below the database's:
/// the folder of a study moves as a whole.
std::vector<fs::path> placesOf(const fs::path& named, const fs::path& database) {
    const fs::path folder = database.parent_path();
    std::vector<fs::path> places{(folder / named).lexically_normal()};
    if (const fs::path beside = folder / named.filename(); beside != places.front()) places.push_back(beside);
    return places;
}

}  // namespace

ShownAvatar shownAvatar(const results::Recording& recording) {
    ShownAvatar out{recording.study_source, {}, recording.participant};
    for (const results::RecordedAnswer& answer : recording.answers) out.hashes.insert(answer.avatar_hash);
    return out;
}

Result<assets::Avatar> recordedAvatar(const ShownAvatar& shown, const fs::path& database,
                                      const fs::path& instead) {
    const assets::AvatarOptions size{studies::avatarHeightIn(shown.study_source)};
    if (!instead.empty()) return assets::loadAvatar(instead, size);
    const std::set<std::string>& hashes = shown.hashes;
    // Locked with the study.
    if (hashes.size() == 1 && !hashes.contains("")) {
        std::error_code code;
        for (const auto& set : fs::directory_iterator(lockedFolder(database), code))
            for (const auto& file : fs::directory_iterator(set.path() / "avatar", code)) {
                const std::string ending = file.path().extension().string();
                if (ending != ".glb" && ending != ".gltf" && ending != ".vrm") continue;
                auto avatar = assets::loadAvatar(file.path(), size);
                if (avatar && hashes.contains(avatar->content_hash)) return avatar;
            }
    }
    const std::string named = studies::avatarNamedIn(shown.study_source);
    if (named.empty() || hashes.empty()) return shippedAvatarFor(hashes);
    if (hashes.size() > 1)
        return fail(database.string(),
                    fmt::format("the sessions of {} showed {} different avatars", shown.whose, hashes.size()),
                    "Choose one trial with --trial, or name the avatar to show with --avatar");
    std::string found;
    for (const fs::path& place : placesOf(named, database)) {
        std::error_code code;
        if (!found.empty()) found += "; ";
        if (!fs::is_regular_file(place, code)) {
            found += fmt::format("{} is not there", place.string());
            continue;
        }
        auto avatar = assets::loadAvatar(place, size);
        if (avatar && avatar->content_hash == *hashes.begin()) return avatar;
        found += avatar ? fmt::format("{} is another one (SHA-256 {})", place.string(), avatar->content_hash)
                        : avatar.error().text();
    }
    return fail(database.string(),
                fmt::format("the sessions showed the avatar \"{}\" (SHA-256 {}), which was not found: {}",
                            named, *hashes.begin(), found),
                "Put that file there, or name it with --avatar");
}

}  // namespace deixis::app
