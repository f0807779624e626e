// An avatar as a binary glTF in the one form that it has here: for pages that draw it.
#pragma once

#include <string>

#include "assets/avatar/avatar.hpp"

namespace deixis::assets {

/// Textures are made smaller by halves until no side has more pixels: more cannot be seen on a whole figure.
inline constexpr int largest_texture_side = 2048;

/// T pose, a node for each joint, named as in the skeleton and without rotations; one mesh, a primitive for
/// each part; base colours, alpha cut-offs and both sides as the parts have them. Read again it is the same
/// avatar.
[[nodiscard]] std::string writeAvatarGlb(const Avatar& avatar);

}  // namespace deixis::assets
