// What the text of a study file says, even if the file itself and the files that it names are gone.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace deixis::studies {

/// The avatar that the text names (`study.avatar`), as it stands there: relative to the folder of the study
/// file, or absolute. Empty if it names none or is not a study.
[[nodiscard]] std::string avatarNamedIn(std::string_view source);

/// How tall it is to be (`study.avatar_height_m`), metres; none if the text does not say.
[[nodiscard]] std::optional<double> avatarHeightIn(std::string_view source);

/// The name of the study; empty if it has none, or does not parse.
[[nodiscard]] std::string studyNamedIn(std::string_view source);

}  // namespace deixis::studies
