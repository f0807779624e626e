// Draws a scene with OpenGL 4.5 core. A context must be current on the calling thread when a Renderer is
// made, used and destroyed. GL failures throw std::runtime_error with the failing call.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/stereo.hpp"

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
    int shadow_resolution = 1024;            ///< over 2.8 m around each avatar
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
    /// std::invalid_argument where one of Scene::avatars does not fit the avatar, or there are too many.
    void draw(const Scene& scene, int width, int height, unsigned int framebuffer = 0);

    /// Draws off screen and reads back.
    [[nodiscard]] Image capture(const Scene& scene, int width, int height);

    /// Draws both eyes (Scene::camera gives only near and far) into `target`, resolved, in sRGB. Skinning,
    /// the shadow maps and the list of what is drawn are made once for both. The first of the scene's boards
    /// is left out as a hole: alpha 0 if it would be seen, 1 elsewhere, colours premultiplied, so that it
    /// can be shown beneath this layer as a sharp layer of its own, rightly covered by whatever stands before
    /// it. Further boards are drawn. `mode` two_passes is always there, multiview where hasMultiview(). GL
    /// state afterwards as after draw().
    void drawStereo(const Scene& scene, const Eyes& eyes, const StereoTarget& target, StereoMode mode);
    /// Whether the driver draws into two layers in one pass, with as many samples as Quality asks for
    /// (several take GL_EXT_multiview_texture_multisample too).
    [[nodiscard]] bool hasMultiview() const;
    /// What drawStereo need not draw, by eye. Kept until set again.
    void setHiddenArea(const std::array<HiddenArea, 2>& areas);

    /// The size in pixels of the board's picture.
    [[nodiscard]] std::array<int, 2> boardSize(const Board& board) const;
    /// Paints the board where its content has changed, and copies it into the texture (sRGB8_ALPHA8, at least
    /// of boardSize(), its first row the board's foot), from its lower left corner on. The picture covers
    /// boardExtent(), a little more than the board.
    void copyBoard(const Board& board, unsigned int texture);
    /// The lower left and upper right corner of the board's picture on the board, metres.
    [[nodiscard]] BoardRect boardExtent(const Board& board) const;

    /// What the left eye saw last, its first board filled in, into framebuffer `framebuffer` of this size,
    /// the picture kept in shape and cut at the longer sides. Black before the first drawStereo().
    void drawMirror(const Scene& scene, const Eye& left, int width, int height, unsigned int framebuffer = 0);

    [[nodiscard]] std::string driver() const;  ///< GL_RENDERER and GL_VERSION
    [[nodiscard]] int boardPaints() const;     ///< how often a board's content was painted again
    /// Characters (UTF-8, in the order of their numbers) that boards had and no font has: a question mark
    /// stands for each. It only grows.
    [[nodiscard]] const std::string& missingCharacters() const;

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
