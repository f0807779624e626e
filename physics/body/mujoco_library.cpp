#include "mujoco_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <stdexcept>
#include <type_traits>

#include "physics/body/body.hpp"

namespace deixis::physics {

namespace {

/// 2.2.2 is 222.
std::string versionName(int version) {
    return fmt::format("{}.{}.{}", version / 100, version / 10 % 10, version % 10);
}

std::string hint() {
    return fmt::format(
        "Install MuJoCo {} (on Debian: apt-get install libmujoco{}), or name its library in the environment "
        "variable DEIXIS_MUJOCO. All that does not simulate a body works without it",
        versionName(mjVERSION_HEADER), versionName(mjVERSION_HEADER));
}

[[noreturn]] void throwError(const char* message) {
    throw std::runtime_error(fmt::format("MuJoCo: {}", message));
}

void ignoreWarning(const char* /*message*/) {}

Result<MujocoLibrary> load(const std::string& name) {
    void* handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
        const char* why = dlerror();
        return fail("",
                    fmt::format("MuJoCo, which simulates the body, cannot be loaded: {}",
                                why != nullptr ? why : name.c_str()),
                    hint());
    }
    MujocoLibrary library;
    std::string missing;
    const auto find = [&](auto& function, const char* symbol) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, symbol));
        if (function == nullptr && missing.empty()) missing = symbol;
    };
    void (**on_error)(const char*) = nullptr;
    void (**on_warning)(const char*) = nullptr;
    find(library.version, "mj_version");
    if (missing.empty() && library.version() != mjVERSION_HEADER)
        return fail(name,
                    fmt::format("is MuJoCo {}, expected {}, for which the program was built",
                                versionName(library.version()), versionName(mjVERSION_HEADER)),
                    hint());
    find(library.load_xml, "mj_loadXML");
    find(library.delete_model, "mj_deleteModel");
    find(library.make_data, "mj_makeData");
    find(library.copy_data, "mj_copyData");
    find(library.reset_data, "mj_resetData");
    find(library.delete_data, "mj_deleteData");
    find(library.step, "mj_step");
    find(library.forward, "mj_forward");
    find(library.kinematics, "mj_kinematics");
    find(library.id_to_name, "mj_id2name");
    find(on_error, "mju_user_error");
    find(on_warning, "mju_user_warning");
    if (!missing.empty())
        return fail(name, fmt::format("has no function {}, expected the library of MuJoCo", missing), hint());
    *on_error = throwError;
    *on_warning = ignoreWarning;
    return library;
}

}  // namespace

std::string mujocoLibraryName() {
    return DEIXIS_MUJOCO_LIBRARY;
}

Result<const MujocoLibrary*> loadMujoco(const std::string& name) {
    static std::mutex mutex;
    static std::map<std::string, MujocoLibrary> loaded;
    const char* from_environment = std::getenv("DEIXIS_MUJOCO");
    std::string file = name;
    if (file.empty() && from_environment != nullptr) file = from_environment;
    if (file.empty()) file = mujocoLibraryName();
    const std::lock_guard lock(mutex);
    if (const auto found = loaded.find(file); found != loaded.end()) return &found->second;
    const auto library = load(file);
    if (!library) return tl::unexpected(library.error());
    return &loaded.emplace(file, *library).first->second;
}

}  // namespace deixis::physics
