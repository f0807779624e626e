// Draws a scene with OpenGL 4.5 core. A context must be current on the calling thread when a Renderer is
// made, used and destroyed. GL failures throw std::runtime_error with the failing call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assets/avatar.hpp"
#include "core/error.hpp"
#include "renderer/scene.hpp"

namespace deixis::renderer {

/// 8-bit sRGB, rows from the top, 3 bytes a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

[[nodiscard]] Result<void> writePng(const std::filesystem::path& path, const Image& image);

struct Quality {
    int samples = 4;                         ///< MSAA; lowered to what the driver has, 1: none
    int shadow_resolution = 1024;            ///< over 2.8 m around the avatar
    double board_pixels_per_metre = 1400.0;  ///< lowered where the board would pass 2048 pixels
};

class Renderer {
  public:
    /// Fails (with the driver's own words) where the current context is not OpenGL 4.5 or newer, and where
    /// the board's font files are missing.
    [[nodiscard]] static Result<Renderer> create(const assets::Avatar& avatar, const Quality& quality);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Draws into framebuffer `framebuffer` (0: the window) of the given size in pixels, resolved and in
    /// sRGB. The framebuffer needs no samples of its own and may, but need not, be sRGB-capable: it gets the
    /// same bytes as capture(). It stays bound, with blending, depth test and sRGB conversion off. Throws
    /// std::invalid_argument where Scene::avatar_joints does not fit the avatar.
    void draw(const Scene& scene, int width, int height, unsigned int framebuffer = 0);

    /// Draws off screen and reads back.
    [[nodiscard]] Image capture(const Scene& scene, int width, int height);

    [[nodiscard]] std::string driver() const;  ///< GL_RENDERER and GL_VERSION
    [[nodiscard]] int boardPaints() const;     ///< how often a board's content was painted anew

  private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// An OpenGL 4.5 core context without a window or an X server (EGL). Current on the calling thread while it
/// lives.
class OffscreenContext {
  public:
    [[nodiscard]] static Result<OffscreenContext> create();
    OffscreenContext(OffscreenContext&&) noexcept;
    OffscreenContext& operator=(OffscreenContext&&) noexcept;
    ~OffscreenContext();

  private:
    struct Impl;
    explicit OffscreenContext(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace deixis::renderer
