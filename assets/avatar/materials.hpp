// Materials of a glTF file as far as an avatar shows them; private to reading avatars.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "assets/gltf/gltf_values.hpp"

namespace deixis::assets {

/// How the triangles of one material are drawn.
struct MaterialLook {
    glm::vec3 factor{1.0F};                    ///< linear
    std::size_t part = 0;                      ///< of MaterialReader::parts()
    int uv_set = -1;                           ///< TEXCOORD_n of the base colour texture; -1 for none
    const gltf::Material* material = nullptr;  ///< none: glTF's default

    /// By the material's texture transform.
    [[nodiscard]] glm::vec2 placed(const glm::vec2& uv) const;
};

/// Reads each material once; materials that are drawn alike share a part.
class MaterialReader {
  public:
    MaterialReader(const gltf::Document& document, const gltf::Values& values,
                   std::vector<std::string>& remarks)
        : doc_(document), values_(values), remarks_(remarks) {}

    /// `material` may be -1, glTF's default material. A texture that cannot be decoded is rejected.
    MaterialLook look(int material);

    /// Without their triangles.
    [[nodiscard]] const std::vector<AvatarPart>& parts() const { return parts_; }
    [[nodiscard]] std::vector<AvatarTexture> takeTextures() { return std::move(textures_); }

  private:
    MaterialLook read(const gltf::Material& material, int index);
    int texture(int index);
    AvatarTexture decoded(int image);
    std::size_t partFor(const AvatarPart& part);

    const gltf::Document& doc_;
    const gltf::Values& values_;
    std::vector<std::string>& remarks_;
    std::map<int, MaterialLook> looks_;
    std::map<std::tuple<int, int>, int> texture_of_;  ///< by image and sampler
    std::vector<AvatarPart> parts_;
    std::vector<AvatarTexture> textures_;
};

}  // namespace deixis::assets
