#include "xr_swapchain.hpp"

#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <utility>

#include "xr_runtime.hpp"

namespace deixis::app {

XrGlSwapchain::XrGlSwapchain(XrSession session, std::int64_t format, XrSwapchainUsageFlags usage,
                             XrSwapchainSize size)
    : XrGlSwapchain() {  // so that the destructor runs where something below throws
    auto creation = typed<XrSwapchainCreateInfo>(XR_TYPE_SWAPCHAIN_CREATE_INFO);
    creation.usageFlags = usage;
    creation.format = format;
    creation.sampleCount = 1;
    creation.width = static_cast<std::uint32_t>(size.width);
    creation.height = static_cast<std::uint32_t>(size.height);
    creation.faceCount = 1;
    creation.arraySize = 1;
    creation.mipCount = 1;
    check(xrCreateSwapchain(session, &creation, &handle_), "xrCreateSwapchain");
    size_ = size;

    std::uint32_t count = 0;
    check(xrEnumerateSwapchainImages(handle_, 0, &count, nullptr), "xrEnumerateSwapchainImages");
    std::vector<XrSwapchainImageOpenGLKHR> images(
        count, XrSwapchainImageOpenGLKHR{XR_TYPE_SWAPCHAIN_IMAGE_OPENGL_KHR, nullptr, 0});
    check(xrEnumerateSwapchainImages(handle_, count, &count,
                                     reinterpret_cast<XrSwapchainImageBaseHeader*>(images.data())),
          "xrEnumerateSwapchainImages");
    for (const auto& image : images) textures_.push_back(image.image);
}

XrGlSwapchain::XrGlSwapchain(XrGlSwapchain&& other) noexcept {
    *this = std::move(other);
}

XrGlSwapchain& XrGlSwapchain::operator=(XrGlSwapchain&& other) noexcept {
    std::swap(handle_, other.handle_);
    std::swap(size_, other.size_);
    std::swap(textures_, other.textures_);
    std::swap(acquired_, other.acquired_);
    return *this;
}

XrGlSwapchain::~XrGlSwapchain() {
    // Fails where the session is gone; then the images are gone with it.
    if (handle_ != XR_NULL_HANDLE) xrDestroySwapchain(handle_);
}

unsigned int XrGlSwapchain::acquire() {
    std::uint32_t index = 0;
    check(xrAcquireSwapchainImage(handle_, nullptr, &index), "xrAcquireSwapchainImage");
    acquired_ = true;
    auto wait = typed<XrSwapchainImageWaitInfo>(XR_TYPE_SWAPCHAIN_IMAGE_WAIT_INFO);
    wait.timeout = XR_INFINITE_DURATION;
    check(xrWaitSwapchainImage(handle_, &wait), "xrWaitSwapchainImage");
    return textures_.at(index);
}

void XrGlSwapchain::release() {
    if (!acquired_) return;
    acquired_ = false;
    check(xrReleaseSwapchainImage(handle_, nullptr), "xrReleaseSwapchainImage");
}

std::int64_t firstOfferedFormat(XrSession session, const std::vector<std::int64_t>& wanted) {
    std::uint32_t count = 0;
    check(xrEnumerateSwapchainFormats(session, 0, &count, nullptr), "xrEnumerateSwapchainFormats");
    std::vector<std::int64_t> offered(count);
    check(xrEnumerateSwapchainFormats(session, count, &count, offered.data()), "xrEnumerateSwapchainFormats");
    const auto found = std::find_first_of(wanted.begin(), wanted.end(), offered.begin(), offered.end());
    return found == wanted.end() ? 0 : *found;
}

}  // namespace deixis::app
