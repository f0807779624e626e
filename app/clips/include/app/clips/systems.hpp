// The systems that make clips, by the names that studies and commands use: built-in ones, and learned ones
// from weights.
#pragma once

#include <memory>
#include <string>

#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "motion/synthesis/generator.hpp"

namespace deixis::app {

struct System {
    std::unique_ptr<motion::Generator> generator;
    std::string processing;  ///< what a manifest says of its clips
};

/// Makes a system for an avatar. `weights`: the file of a learned one; empty: the file that ships. Fails on a
/// system that is not known, on a learned one whose weights do not ship and are not named, and on weights of
/// another system.
[[nodiscard]] Result<System> makeSystem(const std::string& name, const std::string& weights,
                                        const motion::Skeleton& avatar);

/// Whether a clip was made by formulas, or by what was learned from clips that were.
[[nodiscard]] bool isSynthetic(const assets::ManifestRow& row);

/// The bytes of the file that ships which makes its clips what they are, for telling clips of one version of
/// it from those of another.
[[nodiscard]] Result<std::string> systemSource(const std::string& name);

}  // namespace deixis::app
