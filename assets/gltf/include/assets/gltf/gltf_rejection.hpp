// The exception that ends the reading of a bad glTF file.
#pragma once

#include <string>
#include <utility>

#include "core/error.hpp"

namespace deixis::assets::gltf {

/// Thrown inside the readers of glTF files only, and turned into a Result where they are entered.
struct Rejection {
    Error error;
};

[[noreturn]] inline void reject(std::string where, std::string message,
                                std::string hint = "Export the file again") {
    throw Rejection{Error{std::move(where), std::move(message), std::move(hint)}};
}

}  // namespace deixis::assets::gltf
