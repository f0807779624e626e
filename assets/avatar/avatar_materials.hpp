// Materials of a glTF file as far as an avatar shows them; private to reading avatars.
#pragma once

#include <tiny_gltf.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"

namespace deixis::assets {

/// How the triangles of one material are drawn.
struct MaterialLook {
    glm::vec3 factor{1.0F};  ///< linear
    std::size_t part = 0;    ///< of MaterialReader::parts()
    int uv_set = -1;         ///< TEXCOORD_n of the base colour texture; -1 for none
    // KHR_texture_transform: uv' = offset + rotation * (scale * uv).
    glm::dvec2 uv_offset{0.0}, uv_scale{1.0};
    double uv_rotation_rad = 0.0;

    [[nodiscard]] glm::vec2 placed(const glm::vec2& uv) const;
};

/// Reads each material once; materials that are drawn alike share a part.
class MaterialReader {
  public:
    MaterialReader(const tinygltf::Model& model, const std::string& file, std::vector<std::string>& remarks)
        : model_(model), file_(file), remarks_(remarks) {}

    /// `material` may be -1, glTF's default material. A texture that cannot be decoded is an error.
    Result<MaterialLook> look(int material);

    /// Without their triangles.
    [[nodiscard]] const std::vector<AvatarPart>& parts() const { return parts_; }
    [[nodiscard]] std::vector<AvatarTexture> takeTextures() { return std::move(textures_); }

  private:
    Result<MaterialLook> read(const tinygltf::Material& material, int index);
    Result<int> texture(int index);
    Result<AvatarTexture> decoded(int image);
    std::size_t partFor(const AvatarPart& part);

    const tinygltf::Model& model_;
    const std::string& file_;
    std::vector<std::string>& remarks_;
    std::map<int, MaterialLook> looks_;
    std::map<std::tuple<int, int>, int> texture_of_;  ///< by image and sampler
    std::vector<AvatarPart> parts_;
    std::vector<AvatarTexture> textures_;
};

}  // namespace deixis::assets
