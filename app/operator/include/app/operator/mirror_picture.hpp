// A small copy of what a window has just shown, for another window.
#pragma once

#include "app/window/gl_window.hpp"

namespace deixis::app {

struct MirrorTexture {
    unsigned int texture = 0;  ///< its first row is the picture's foot; 0: there is none yet
    WindowSize size{};
};

/// All calls but texture() with the participant's context current; so must it be when this goes.
class MirrorPicture {
  public:
    MirrorPicture() = default;
    ~MirrorPicture();
    MirrorPicture(const MirrorPicture&) = delete;
    MirrorPicture& operator=(const MirrorPicture&) = delete;

    /// Copies framebuffer 0 of this size before it is swapped, no larger than `max`, in its shape. Does not
    /// wait for the graphics card. Leaves framebuffer 0 bound.
    void take(WindowSize shown, WindowSize max);
    /// For a context that shares this one's textures, and is current: it waits for the copy where it draws
    /// it, without holding up the caller. Texture 0 before the first picture.
    [[nodiscard]] MirrorTexture texture() const;

  private:
    unsigned int framebuffer_ = 0;
    MirrorTexture kept_{};
    void* copied_ = nullptr;  // a GLsync
};

/// The largest size of this shape that fits into `max`; never larger than `shown`, at least 1x1.
[[nodiscard]] WindowSize fittedSize(WindowSize shown, WindowSize max);

}  // namespace deixis::app
