// glTF 2.0 files (.gltf, .glb, .vrm, .vrma) <-> clips. docs/clip-format.md says what is read and written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::assets {

struct GltfClipOptions {
    std::string animation{};                  ///< name; empty: by index
    int animation_index = 0;                  ///< from 0, where no name is given
    std::optional<double> fps{};              ///< none: the rate at which the keys stand
    std::optional<double> metres_per_unit{};  ///< none: 1, as glTF has it
};

struct GltfClipFile {
    motion::Clip clip;  ///< metres; frame 0 is the first key
    /// The humanoid bones that VRM's extensions name; none if the file has no such extension.
    std::optional<motion::HumanoidMap> humanoid{};
    std::string humanoid_source{};  ///< "VRM 0.x", "VRMC_vrm", "VRMC_vrm_animation" or empty
    std::string animation{};        ///< name of the one that was read; "animation 0" where it has none
    std::vector<std::string> animations{};  ///< all that the file has
    double metres_per_unit = 1.0;           ///< what was used
    std::string unit{};                     ///< in words, such as "metre (as in glTF)"
    std::string frame_rate{};               ///< in words, such as "30 fps (the keys' rate)"
    std::vector<std::string> remarks{};     ///< what was unusual about the file and how it was taken
};

/// Reads one animation; a file without any gives its rest pose as one frame, and says so. Errors name the
/// file and the place in it. Buffers in other files are read from the file's own folder alone.
[[nodiscard]] Result<GltfClipFile> readGltfClip(const std::filesystem::path& path,
                                                const GltfClipOptions& options = {});
/// The same from bytes; `name` stands for the file in errors. Without a folder, buffers in other files are
/// rejected.
[[nodiscard]] Result<GltfClipFile> parseGltfClip(std::string_view bytes, const std::string& name,
                                                 const GltfClipOptions& options = {},
                                                 const std::optional<std::filesystem::path>& folder = {});

/// The other files that buffers of the glTF file `path` with these bytes stand in, each once. None of a file
/// that cannot be read, or names others than parseGltfClip() would read.
[[nodiscard]] std::vector<std::filesystem::path> gltfBufferFiles(std::string_view bytes,
                                                                 const std::filesystem::path& path);

struct GlbOptions {
    std::string animation_name = "clip";
    /// Written as a VRM animation's humanoid where whyNoVrmAnimation() finds nothing against it.
    std::optional<motion::HumanoidMap> humanoid{};
};

/// A binary glTF: a node for each joint, a node NAME_End for each end site, a skin (so that programs see an
/// armature) and one animation of float keys. The same bytes from every compiler. Throws
/// std::invalid_argument where the clip breaks its invariants or holds a number that is not finite.
[[nodiscard]] std::string writeGlb(const motion::Clip& clip, const GlbOptions& options = {});

/// What keeps a clip from being a VRM animation (VRMC_vrm_animation-1.0): a required bone is missing, a bone
/// other than the hips moves in its parent, or the rest pose is not a T pose that faces +z. Empty: nothing.
[[nodiscard]] std::string whyNoVrmAnimation(const motion::Clip& clip, const motion::HumanoidMap& humanoid);

}  // namespace deixis::assets
