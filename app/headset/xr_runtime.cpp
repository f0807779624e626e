#include "xr_runtime.hpp"

#include <fmt/format.h>
#include <openxr/openxr_reflection.h>

#include <array>
#include <utility>
#include <vector>

namespace deixis::app {

namespace {

constexpr const char* opengl_extension = "XR_KHR_opengl_enable";
constexpr const char* eye_gaze_extension = "XR_EXT_eye_gaze_interaction";
constexpr const char* hand_tracking_extension = "XR_EXT_hand_tracking";

/// Enabled where the runtime offers them.
constexpr std::array welcome_extensions{
    "XR_KHR_composition_layer_depth", "XR_KHR_visibility_mask", "XR_EXT_local_floor",
    hand_tracking_extension,          eye_gaze_extension,       "XR_EXT_hand_interaction",
    "XR_FB_display_refresh_rate",
#ifndef _WIN32
    "XR_KHR_convert_timespec_time",
#endif
};

/// Only 1.0 is needed, and runtimes of 1.1 accept it.
constexpr XrVersion api_version = XR_MAKE_VERSION(1, 0, 20);

std::string versionText(XrVersion version) {
    return fmt::format("{}.{}.{}", XR_VERSION_MAJOR(version), XR_VERSION_MINOR(version),
                       XR_VERSION_PATCH(version));
}

/// The loader could not even ask a runtime what it offers.
tl::unexpected<Error> noRuntime(XrResult result) {
    return fail(
        "headset",
        fmt::format("no OpenXR runtime is installed and active: "
                    "xrEnumerateInstanceExtensionProperties says {}",
                    nameOf(result)),
        "Install one (SteamVR, Monado, WiVRn) and make it the active runtime; XR_RUNTIME_JSON, where it "
        "is set, must name its manifest");
}

tl::unexpected<Error> noInstance(XrResult result) {
    const std::string found = fmt::format("xrCreateInstance says {}", nameOf(result));
    switch (result) {
        case XR_ERROR_API_VERSION_UNSUPPORTED:
            return fail("headset", "the OpenXR runtime does not know OpenXR 1.0: " + found,
                        "Update the runtime");
        case XR_ERROR_API_LAYER_NOT_PRESENT:
            return fail("headset", "an OpenXR API layer is not installed: " + found,
                        "Install it, or unset XR_ENABLE_API_LAYERS");
        default:
            // Runtimes that are installed but not running differ in what they say.
            return fail("headset", "the OpenXR runtime does not answer: " + found,
                        "Start it (SteamVR, monado-service, WiVRn's server) before this program");
    }
}

Result<std::set<std::string>> offeredExtensions() {
    std::uint32_t count = 0;
    XrResult result = xrEnumerateInstanceExtensionProperties(nullptr, 0, &count, nullptr);
    if (XR_FAILED(result)) return noRuntime(result);
    std::vector<XrExtensionProperties> properties(
        count, XrExtensionProperties{XR_TYPE_EXTENSION_PROPERTIES, nullptr, {}, 0});
    result = xrEnumerateInstanceExtensionProperties(nullptr, count, &count, properties.data());
    if (XR_FAILED(result)) return noRuntime(result);
    std::set<std::string> names;
    for (const auto& property : properties) names.emplace(property.extensionName);
    return names;
}

}  // namespace

std::string nameOf(XrResult result) {
    switch (result) {
#define DEIXIS_RESULT_NAME(name, value) \
    case name:                          \
        return #name;
        XR_LIST_ENUM_XrResult(DEIXIS_RESULT_NAME)
#undef DEIXIS_RESULT_NAME
    }
    return std::to_string(static_cast<int>(result));
}

XrResult check(XrResult result, const char* call) {
    if (XR_FAILED(result)) throw XrFailure(fmt::format("{} failed: {}", call, nameOf(result)), result);
    return result;
}

Result<XrRuntime> XrRuntime::open() {
    const auto offered = offeredExtensions();
    if (!offered) return tl::unexpected(offered.error());
    if (!offered->contains(opengl_extension))
        return fail("headset", fmt::format("the OpenXR runtime does not offer {}", opengl_extension),
                    "Use a runtime that takes OpenGL pictures (SteamVR, Monado, WiVRn)");

    XrRuntime runtime;
    runtime.extensions_.emplace(opengl_extension);
    for (const char* name : welcome_extensions)
        if (offered->contains(name)) runtime.extensions_.emplace(name);
    std::vector<const char*> names;
    for (const auto& name : runtime.extensions_) names.push_back(name.c_str());

    auto creation = typed<XrInstanceCreateInfo>(XR_TYPE_INSTANCE_CREATE_INFO);
    creation.applicationInfo = {"Deixis", 1, "Deixis", 1, api_version};
    creation.enabledExtensionCount = static_cast<std::uint32_t>(names.size());
    creation.enabledExtensionNames = names.data();
    const XrResult created = xrCreateInstance(&creation, &runtime.instance_);
    if (XR_FAILED(created)) {
        runtime.instance_ = XR_NULL_HANDLE;
        return noInstance(created);
    }

    auto about = typed<XrInstanceProperties>(XR_TYPE_INSTANCE_PROPERTIES);
    check(xrGetInstanceProperties(runtime.instance_, &about), "xrGetInstanceProperties");
    runtime.name_ = about.runtimeName;
    runtime.version_ = versionText(about.runtimeVersion);

    auto found = runtime.findSystem();
    if (!found) return tl::unexpected(found.error());
    return runtime;
}

Result<void> XrRuntime::findSystem() {
    auto wanted = typed<XrSystemGetInfo>(XR_TYPE_SYSTEM_GET_INFO);
    wanted.formFactor = XR_FORM_FACTOR_HEAD_MOUNTED_DISPLAY;
    const XrResult result = xrGetSystem(instance_, &wanted, &system_);
    const std::string runtime = fmt::format("{} {}", name_, version_);
    if (result == XR_ERROR_FORM_FACTOR_UNAVAILABLE)
        return fail("headset", fmt::format("{} finds no headset", runtime),
                    "Connect the headset, switch it on, and see that the runtime's own window shows it");
    if (result == XR_ERROR_FORM_FACTOR_UNSUPPORTED)
        return fail("headset", fmt::format("{} is not for headsets", runtime),
                    "Make a runtime for headsets the active one (SteamVR, Monado, WiVRn)");
    if (XR_FAILED(result))
        return fail("headset", fmt::format("{}: xrGetSystem says {}", runtime, nameOf(result)),
                    "Restart the runtime");

    auto eyes =
        typed<XrSystemEyeGazeInteractionPropertiesEXT>(XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT);
    auto hands = typed<XrSystemHandTrackingPropertiesEXT>(XR_TYPE_SYSTEM_HAND_TRACKING_PROPERTIES_EXT);
    auto system = typed<XrSystemProperties>(XR_TYPE_SYSTEM_PROPERTIES);
    if (has(eye_gaze_extension)) {
        eyes.next = system.next;
        system.next = &eyes;
    }
    if (has(hand_tracking_extension)) {
        hands.next = system.next;
        system.next = &hands;
    }
    check(xrGetSystemProperties(instance_, system_, &system), "xrGetSystemProperties");
    system_name_ = system.systemName;
    tracks_eyes_ = eyes.supportsEyeGazeInteraction == XR_TRUE;
    tracks_hands_ = hands.supportsHandTracking == XR_TRUE;
    return {};
}

XrRuntime::XrRuntime(XrRuntime&& other) noexcept {
    *this = std::move(other);
}

XrRuntime& XrRuntime::operator=(XrRuntime&& other) noexcept {
    std::swap(instance_, other.instance_);
    std::swap(system_, other.system_);
    std::swap(extensions_, other.extensions_);
    std::swap(tracks_eyes_, other.tracks_eyes_);
    std::swap(tracks_hands_, other.tracks_hands_);
    std::swap(name_, other.name_);
    std::swap(version_, other.version_);
    std::swap(system_name_, other.system_name_);
    return *this;
}

XrRuntime::~XrRuntime() {
    // Fails where the runtime is gone; then there is nothing left to destroy.
    if (instance_ != XR_NULL_HANDLE) xrDestroyInstance(instance_);
}

XrPath XrRuntime::path(const char* text) const {
    XrPath path = XR_NULL_PATH;
    check(xrStringToPath(instance_, text, &path), "xrStringToPath");
    return path;
}

std::string XrRuntime::text(XrPath path) const {
    if (path == XR_NULL_PATH) return {};
    std::array<char, XR_MAX_PATH_LENGTH> text{};
    std::uint32_t length = 0;
    check(xrPathToString(instance_, path, static_cast<std::uint32_t>(text.size()), &length, text.data()),
          "xrPathToString");
    return text.data();
}

}  // namespace deixis::app
