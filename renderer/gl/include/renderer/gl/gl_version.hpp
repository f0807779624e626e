// The oldest OpenGL version that the renderer supports, and the message if there is only an older one.
#pragma once

#include "core/error.hpp"

namespace deixis::renderer {

constexpr int needed_gl_major = 4;
constexpr int needed_gl_minor = 5;

/// Fails with the driver's own words where the current context is older; `where` names who asked.
[[nodiscard]] Result<void> requireGlVersion(const char* where);

}  // namespace deixis::renderer
