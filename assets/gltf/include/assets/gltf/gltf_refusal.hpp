// How reading a glTF file ends where it cannot go on.
#pragma once

#include <string>
#include <utility>

#include "core/error.hpp"

namespace deixis::assets::gltf {

/// Thrown inside the readers of glTF files only, and turned into a Result where they are entered.
struct Refusal {
    Error error;
};

[[noreturn]] inline void refuse(std::string where, std::string message,
                                std::string mend = "Export the file anew") {
    throw Refusal{Error{std::move(where), std::move(message), std::move(mend)}};
}

}  // namespace deixis::assets::gltf
