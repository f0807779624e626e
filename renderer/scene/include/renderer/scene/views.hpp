// The eyes of one frame, and draw programs that draw for one of them or, in one pass, for both.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>

#include "renderer/gl/gl.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/stereo.hpp"

namespace deixis::renderer {

/// What a draw call draws for.
enum class Views : unsigned char {
    one,   ///< the bound view
    both,  ///< the left view and the right, into the layers of a multiview framebuffer
};

/// Uniform buffers are bound at multiples of this; GL lets no driver ask for more.
constexpr std::size_t uniform_alignment = 256;

/// Laid out as std140 has it.
struct alignas(uniform_alignment) ViewBlock {
    glm::mat4 clip_from_stage{1.0F};
    glm::mat4 eye_from_stage{1.0F};
    glm::mat4 clip_from_eye{1.0F};
    glm::vec4 eye{0.0F};     ///< w: size of a pixel at 1 m, metres
    std::uint32_t side = 0;  ///< 0: left or only, 1: right
};

[[nodiscard]] ViewBlock viewBlock(const Camera& camera, int width, int height);
/// `side` 0 is the left eye.
[[nodiscard]] ViewBlock viewBlock(const Eye& eye, std::uint32_t side, double near_m, double far_m,
                                  int height);

constexpr unsigned int view_block_binding = 2;

/// A draw program whose shaders may read `this_view`. The variant for both views is compiled when it is
/// first used, since few drivers have multiview.
class ViewProgram {
  public:
    ViewProgram(std::string_view name, gl::Parts vertex, gl::Parts fragment);
    void use(Views views);

  private:
    std::string name_, vertex_, fragment_;
    gl::Program one_, both_;
};

}  // namespace deixis::renderer
