// glTF 2.0 binary of the avatar.
#pragma once

#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"

namespace deixis::avatar_maker {

/// One node per joint of motion::referenceHumanoid() and per tip ("<bone>_end"), one skin, one mesh of one
/// primitive. The same mesh gives the same bytes.
[[nodiscard]] std::string glbOf(const std::vector<assets::SkinnedVertex>& vertices,
                                const std::vector<std::uint32_t>& indices);

}  // namespace deixis::avatar_maker
