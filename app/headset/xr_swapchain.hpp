// A swapchain of OpenGL textures.
#pragma once

#include <openxr/openxr.h>

#include <cstdint>
#include <vector>

namespace deixis::app {

struct XrSwapchainSize {
    int width = 0;
    int height = 0;
};

class XrGlSwapchain {
  public:
    XrGlSwapchain() = default;
    /// `format` is a GL internal format that the runtime offers.
    XrGlSwapchain(XrSession session, std::int64_t format, XrSwapchainUsageFlags usage, XrSwapchainSize size);
    XrGlSwapchain(XrGlSwapchain&& other) noexcept;
    XrGlSwapchain& operator=(XrGlSwapchain&& other) noexcept;
    ~XrGlSwapchain();

    /// Acquires and waits for the next image; the GL name of its texture.
    [[nodiscard]] unsigned int acquire();
    /// Hands it back.
    void release();
    [[nodiscard]] XrSwapchain handle() const { return handle_; }
    [[nodiscard]] const XrSwapchainSize& size() const { return size_; }
    [[nodiscard]] explicit operator bool() const { return handle_ != XR_NULL_HANDLE; }

  private:
    XrSwapchain handle_ = XR_NULL_HANDLE;
    XrSwapchainSize size_{};
    std::vector<unsigned int> textures_;
    bool acquired_ = false;
};

/// The first of `wanted` that the runtime offers; 0: none.
[[nodiscard]] std::int64_t firstOfferedFormat(XrSession session, const std::vector<std::int64_t>& wanted);

}  // namespace deixis::app
