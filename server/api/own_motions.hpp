// Motions that people added to the library: files of the kept folder.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "motion/unit_gestures/unit_gesture.hpp"
#include "motion/upper_body/upper_body.hpp"
#include "server/http/json_shape.hpp"
#include "server/http/route.hpp"
#include "server/kept/kept_folder.hpp"

namespace deixis::server {

inline constexpr std::size_t max_own_motions = 300;
inline constexpr std::size_t max_own_frames = 300;  ///< 20 s

struct OwnMotion {
    std::string id;
    std::string name;
    std::string meaning;  ///< one line; may be empty
    motion::GestureClass gesture_class = motion::GestureClass::iconic;
    motion::UpperBodyMotion motion;
};

struct OwnMotions {
    std::vector<OwnMotion> motions;  ///< by their names
    std::vector<DamagedFile> damaged;
};

[[nodiscard]] OwnMotions ownMotions(const KeptFolder& folder);
/// Of all files that are there, readable or not.
[[nodiscard]] std::vector<std::string> ownMotionIds(const KeptFolder& folder);

/// What a new one is made of: `name`, `meaning`, `class` and `frames`.
[[nodiscard]] std::vector<ShapeField> ownMotionFields();
/// Of what has these fields. Refuses a name that another motion has, of `library` or an own one, poses that
/// are none, and one too many.
[[nodiscard]] tl::expected<OwnMotion, Refusal> addOwnMotion(const KeptFolder& folder,
                                                            const nlohmann::json& asked,
                                                            const motion::GestureLibrary& library);
/// Refuses an id that no file has.
[[nodiscard]] tl::expected<void, Refusal> removeOwnMotion(const KeptFolder& folder, const std::string& id);

}  // namespace deixis::server
