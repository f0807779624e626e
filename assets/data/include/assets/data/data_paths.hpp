// Where the content that comes with the program is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace deixis::assets {

/// A file that ships, such as "studies/pointing2023.toml" or "avatar.glb". Looked for in $DEIXIS_DATA, then
/// in share/deixis, as it lies from the program: beside it in a build (links to assets/data), in
/// ../share/deixis where it is installed as bin/deixis.
[[nodiscard]] std::filesystem::path dataFile(std::string_view relative);

/// What a person means by `name`: a file, or a TOML file of `kind` that ships, such as "pointing2023" of
/// "studies". A folder of that name is not a file.
[[nodiscard]] std::filesystem::path fileOrShipped(const std::string& name, std::string_view kind);

}  // namespace deixis::assets
