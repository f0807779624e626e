#include "app/program/version.hpp"

#include <fmt/core.h>
#include <gnu/libc-version.h>
#include <openssl/crypto.h>
#include <sqlite3.h>
#include <sys/utsname.h>
#include <zlib.h>
#ifdef DEIXIS_SERVER
#include <libpq-fe.h>
#endif

#include <glm/detail/setup.hpp>
#include <sstream>
#include <string_view>

#include "core/files.hpp"
#include "core/text.hpp"

namespace deixis::app {

// In a source made by cmake/commit.cmake: "unknown" where the sources are no clone.
extern const char* const built_from_commit;
extern const char* const built_with_changes;

namespace {

std::string compiler() {
#if defined(__clang__)
    return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
}

std::string buildType() {
    std::string type = lowerCase(DEIXIS_BUILD_TYPE);
    if (type.empty()) type = "none";
    const std::string_view sanitizers = DEIXIS_SANITIZERS;
    return sanitizers.empty() ? type : fmt::format("{}, sanitizers {}", type, sanitizers);
}

/// Empty in a program without servers.
std::string serverLibrary() {
#ifdef DEIXIS_SERVER
    return fmt::format("libpq {}.{}, ", PQlibVersion() / 10000, PQlibVersion() % 10000);
#else
    return {};
#endif
}

// Those that numbers or what is kept pass through; loaded ones as they are now.
std::string libraries() {
    return fmt::format("SQLite {}, {}OpenSSL {}, zlib {}, GLM {}.{}.{}, glibc {}", sqlite3_libversion(),
                       serverLibrary(), OpenSSL_version(OPENSSL_VERSION_STRING), zlibVersion(),
                       GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH, gnu_get_libc_version());
}

/// What /etc/os-release calls the system; empty where it does not.
std::string distribution() {
    const auto text = readFile("/etc/os-release");
    std::istringstream lines(text.value_or(""));
    const std::string key = "PRETTY_NAME=";
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(key, 0) != 0) continue;
        line.erase(0, key.size());
        std::erase(line, '"');
        return line;
    }
    return {};
}

}  // namespace

std::string programVersion() {
    const std::string_view commit = built_from_commit;
    if (commit == "unknown") return "deixis " DEIXIS_VERSION " (commit unknown)";
    return fmt::format("deixis {} (commit {:.12}{})", DEIXIS_VERSION, commit,
                       std::string_view(built_with_changes) == "yes" ? " with changes" : "");
}

Properties buildProperties() {
    return {{"commit", built_from_commit}, {"uncommitted_changes", built_with_changes},
            {"build_type", buildType()},   {"compiler", compiler()},
            {"libraries", libraries()},    {"built_on", DEIXIS_BUILT_ON}};
}

std::string operatingSystem() {
    utsname system{};
    if (uname(&system) != 0) return distribution();
    const std::string name = distribution();
    return fmt::format("{}{}{} {} {}", name, name.empty() ? "" : ", ", system.sysname, system.release,
                       system.machine);
}

std::string versionText() {
    std::string out = programVersion() + "\n";
    for (const auto& [name, value] : buildProperties()) out += fmt::format("{}: {}\n", name, value);
    return out + fmt::format("operating_system: {}", operatingSystem());
}

studies::StationInfo withProgram(studies::StationInfo info) {
    for (auto& [name, value] : buildProperties()) info.properties.emplace_back("program_" + name, value);
    info.properties.emplace_back("operating_system", operatingSystem());
    return info;
}

}  // namespace deixis::app
