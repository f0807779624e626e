// The OpenXR runtime: loader, instance, extensions, system. No session yet.
#pragma once

#include <openxr/openxr.h>

#include <set>
#include <stdexcept>
#include <string>

#include "core/error.hpp"

namespace deixis::app {

/// A failed OpenXR call. What a person can mend when starting is a Result instead.
struct XrFailure : std::runtime_error {
    XrFailure(const std::string& what, XrResult code) : std::runtime_error(what), result(code) {}
    XrResult result;
    /// The runtime or the session went away; nothing more can be asked of it.
    [[nodiscard]] bool lost() const {
        return result == XR_ERROR_INSTANCE_LOST || result == XR_ERROR_SESSION_LOST ||
               result == XR_ERROR_RUNTIME_FAILURE || result == XR_ERROR_RUNTIME_UNAVAILABLE;
    }
};

/// "XR_ERROR_SESSION_LOST"; the number where it has no name here.
[[nodiscard]] std::string nameOf(XrResult result);

/// Throws XrFailure naming the call where it failed; success codes other than XR_SUCCESS are returned.
XrResult check(XrResult result, const char* call);

/// An OpenXR structure of that type, all else zero.
template <typename Structure>
[[nodiscard]] Structure typed(XrStructureType type) {
    Structure structure{};
    structure.type = type;
    return structure;
}

class XrRuntime {
  public:
    /// Fails with what a person can do about it: no runtime installed or running, no headset connected, a
    /// runtime without OpenGL.
    [[nodiscard]] static Result<XrRuntime> open();
    XrRuntime(XrRuntime&& other) noexcept;
    XrRuntime& operator=(XrRuntime&& other) noexcept;
    ~XrRuntime();

    [[nodiscard]] XrInstance instance() const { return instance_; }
    [[nodiscard]] XrSystemId system() const { return system_; }
    /// Whether the extension is there, and was enabled.
    [[nodiscard]] bool has(const std::string& extension) const { return extensions_.contains(extension); }
    [[nodiscard]] bool tracksEyes() const { return tracks_eyes_; }
    [[nodiscard]] bool tracksHands() const { return tracks_hands_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::string& version() const { return version_; }
    [[nodiscard]] const std::string& systemName() const { return system_name_; }

    /// An extension's function; null where it is not there.
    template <typename Function>
    [[nodiscard]] Function function(const char* name) const {
        PFN_xrVoidFunction found = nullptr;
        if (XR_FAILED(xrGetInstanceProcAddr(instance_, name, &found))) return nullptr;
        return reinterpret_cast<Function>(found);
    }

    [[nodiscard]] XrPath path(const char* text) const;
    [[nodiscard]] std::string text(XrPath path) const;  ///< empty for XR_NULL_PATH

  private:
    XrRuntime() = default;
    [[nodiscard]] Result<void> findSystem();

    XrInstance instance_ = XR_NULL_HANDLE;
    XrSystemId system_ = XR_NULL_SYSTEM_ID;
    std::set<std::string> extensions_;
    bool tracks_eyes_ = false;
    bool tracks_hands_ = false;
    std::string name_, version_, system_name_;
};

}  // namespace deixis::app
