// Any clip file -> a clip in metres, right-handed, y up, and how that was determined. docs/clip-format.md
// describes each format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::assets {

/// The axis of the file's coordinates that points away from the floor.
enum class UpAxis : unsigned char { x, y, z, minus_x, minus_y, minus_z };
[[nodiscard]] std::string_view upAxisName(UpAxis axis);  ///< "x", "-z"
[[nodiscard]] std::optional<UpAxis> upAxisFromName(std::string_view name);

struct ImportOptions {
    std::optional<double> metres_per_unit{};  ///< above 0; none: as the file says or its figure's size tells
    std::optional<UpAxis> up_axis{};          ///< none: as the file says or its figure tells
    /// Frames a second, above 0; none: as the file says. What the file says is then not looked at: its frames
    /// follow each other at this rate; a glTF file, whose keys have times, is sampled at it.
    std::optional<double> fps{};
    std::string animation{};  ///< by name or index from 0, where a file holds several; empty: the first
};

/// Where a value comes from.
enum class Origin : unsigned char {
    given,     ///< by the options
    declared,  ///< by the file or by its format's definition
    detected,  ///< from the figure
    assumed,   ///< by nobody: the usual value
};
[[nodiscard]] std::string_view originName(Origin origin);

struct FoundUnit {
    double metres = 1.0;  ///< of one unit of the file
    Origin origin = Origin::declared;
    std::string name = "metre";
};
struct FoundUp {
    UpAxis axis = UpAxis::y;
    Origin origin = Origin::declared;
};
struct FoundRate {
    double fps = 30.0;
    Origin origin = Origin::declared;
};

struct ImportedClip {
    motion::Clip clip;
    std::optional<motion::HumanoidMap> humanoid{};  ///< where the file itself says which joint is which bone
    std::string format;                             ///< such as "BVH"
    FoundUnit unit{};
    FoundUp up{};
    FoundRate rate{};
    std::vector<std::string> remarks{};  ///< what was unusual about the file and how it was taken
};

/// Reads BVH, glTF (.gltf, .glb, .vrm, .vrma), joint positions as CSV with named joints, Kinect v2
/// recordings, rows of exponential maps and the SGToolkit's JSON; each may be packed with gzip. The kind is
/// told by the content and, where that does not tell, by the name's ending. Formats without rotations come on
/// motion::referenceHumanoid(). Errors name the file, the line or key, what was found and what was expected.
[[nodiscard]] Result<ImportedClip> importClip(const std::filesystem::path& path,
                                              const ImportOptions& options = {});
/// The same from bytes, without buffers in other files; `name` stands for the file in errors and its ending
/// for the kind.
[[nodiscard]] Result<ImportedClip> importClipBytes(std::string_view bytes, const std::string& name,
                                                   const ImportOptions& options = {});

/// The files that importClip() reads besides this one: the buffers in other files that a glTF file names,
/// each once. None of a clip that cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> partsOfClip(const std::filesystem::path& path);

/// One line for people: format, joints, frames, rate, unit, up axis, each with where it comes from.
[[nodiscard]] std::string describe(const ImportedClip& imported);

}  // namespace deixis::assets
