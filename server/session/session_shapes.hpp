// What a session's routes answer and take, in parts.
#pragma once

#include <vector>

#include "server/http/json_shape.hpp"

namespace deixis::server {

/// All that GET /v1/session answers.
[[nodiscard]] Shape sessionShape();
[[nodiscard]] Shape revisionAnswer();
[[nodiscard]] ShapeField revisionField();
/// Of a work, and of the last one of a trial.
[[nodiscard]] std::vector<ShapeField> workFields();

}  // namespace deixis::server
