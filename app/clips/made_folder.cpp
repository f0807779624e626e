#include "made_folder.hpp"

#include <system_error>

#include "core/staging.hpp"

namespace deixis::app {

Result<std::filesystem::path> madeOnce(
    const std::filesystem::path& clips,
    const std::function<Result<void>(const std::filesystem::path& making)>& make) {
    const std::filesystem::path manifest = clips / "manifest.csv";
    std::error_code code;
    if (std::filesystem::exists(manifest, code)) return manifest;
    auto making = Staging::within(clips.parent_path());
    if (!making) return tl::unexpected(making.error());
    if (auto made = make(making->path()); !made) return tl::unexpected(made.error());
    // One without a manifest was left half by a program that was killed.
    if (!std::filesystem::exists(manifest, code)) std::filesystem::remove_all(clips, code);
    auto moved = making->become(clips, false);
    if (!moved && !std::filesystem::exists(manifest, code)) return tl::unexpected(moved.error());
    return manifest;
}

}  // namespace deixis::app
