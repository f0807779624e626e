#include "server/kept/kept_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include "core/durable.hpp"
#include "core/files.hpp"
#include "core/unique_name.hpp"

namespace deixis::server {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t id_letters = 16;
constexpr std::string_view ending = ".json";
constexpr const char* lock_name = ".lock";
constexpr auto longest_wait = std::chrono::seconds(20);
constexpr auto between_tries = std::chrono::milliseconds(5);

/// Of what is made here: others on the machine have no business with people's texts.
void makeForOwner(const fs::path& folder, std::error_code& code) {
    if (fs::exists(folder, code)) return;
    fs::create_directories(folder, code);
    if (!code) fs::permissions(folder, fs::perms::owner_all, code);
}

/// Named as core's writeFile() names them.
void removeUnfinished(const fs::path& folder) {
    std::error_code code;
    for (fs::directory_iterator at(folder, code), end; !code && at != end; at.increment(code)) {
        std::error_code ignored;
        if (at->path().filename().string().find(".json.partial") != std::string::npos)
            fs::remove(at->path(), ignored);
    }
}

}  // namespace

KeptFolder::Turn::~Turn() {
    if (file_ >= 0) ::close(file_);  // which gives the lock back
}

Result<KeptFolder> KeptFolder::open(fs::path folder, Make make) {
    std::error_code code;
    const auto status = fs::status(folder, code);
    if (fs::exists(status) && !fs::is_directory(status))
        return fail(folder.string(), "found a file, expected a folder");
    KeptFolder out(std::move(folder));
    if (make == Make::when_something_is_kept && !fs::exists(status)) return out;
    const auto turn = out.turn();
    if (!turn) return tl::unexpected(turn.error());
    removeUnfinished(out.folder_);
    for (fs::directory_iterator at(out.folder_, code), end; !code && at != end; at.increment(code)) {
        std::error_code ignored;
        if (at->symlink_status(ignored).type() == fs::file_type::directory) removeUnfinished(at->path());
    }
    return out;
}

Result<KeptFolder::Turn> KeptFolder::turn() const {
    std::error_code code;
    makeForOwner(folder_, code);
    if (code) return fail(folder_.string(), "the folder cannot be made: " + code.message());
    constexpr mode_t for_owner = 0600;
    const int file =
        ::open((folder_ / lock_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, for_owner);
    if (file < 0)
        return fail(folder_.string(), fmt::format("cannot be written to: {}", std::strerror(errno)));
    Turn turn(file);
    const auto until = std::chrono::steady_clock::now() + longest_wait;
    while (::flock(file, LOCK_EX | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return fail(folder_.string(), fmt::format("cannot be locked: {}", std::strerror(errno)));
        if (std::chrono::steady_clock::now() > until)
            return fail(folder_.string(),
                        fmt::format("another server has been writing to it for {} s", longest_wait.count()));
        std::this_thread::sleep_for(between_tries);
    }
    return turn;
}

std::vector<std::string> KeptFolder::ids(const std::string& kind) const {
    std::vector<std::string> out;
    std::error_code code;
    for (fs::directory_iterator at(folder_ / kind, code), end; !code && at != end; at.increment(code)) {
        const fs::path name = at->path().filename();
        if (name.extension() == ending && isKeptId(name.stem().native())) out.push_back(name.stem().native());
    }
    std::sort(out.begin(), out.end());
    return out;
}

bool KeptFolder::has(const std::string& file) const {
    std::error_code code;
    return fs::exists(fs::symlink_status(folder_ / file, code));
}

Result<void> KeptFolder::checkFile(const std::string& file) const {
    std::error_code code;
    const auto type = fs::symlink_status(folder_ / file, code).type();
    if (type == fs::file_type::not_found) return fail(file, "is not there");
    if (type != fs::file_type::regular) return fail(file, "is no plain file");
    return {};
}

Result<std::string> KeptFolder::read(const std::string& file, std::size_t max_bytes) const {
    if (const auto plain = checkFile(file); !plain) return tl::unexpected(plain.error());
    auto bytes = readFile(folder_ / file, max_bytes);
    if (!bytes) return fail(file, bytes.error().message);
    return bytes;
}

Result<std::string> KeptFolder::readBeginning(const std::string& file, std::size_t bytes) const {
    if (const auto plain = checkFile(file); !plain) return tl::unexpected(plain.error());
    std::ifstream in(folder_ / file, std::ios::binary);
    std::string out(bytes, '\0');
    in.read(out.data(), static_cast<std::streamsize>(bytes));
    if (in.bad() || !in.is_open()) return fail(file, "cannot be read");
    out.resize(static_cast<std::size_t>(in.gcount()));
    return out;
}

std::uintmax_t KeptFolder::bytesOf(const std::string& file) const {
    std::error_code code;
    const std::uintmax_t bytes = fs::file_size(folder_ / file, code);
    return code ? 0 : bytes;
}

Result<void> KeptFolder::write(const std::string& file, std::string_view bytes) const {
    auto written = writeFile(folder_ / file, bytes);
    if (!written) return fail(file, written.error().message);
    return {};
}

Result<void> KeptFolder::remove(const std::string& file) const {
    std::error_code code;
    fs::remove(folder_ / file, code);
    if (code) return fail(file, "cannot be removed: " + code.message());
    syncFolder((folder_ / file).parent_path());
    return {};
}

Result<void> KeptFolder::putAside(const std::string& file) const {
    const fs::path place = folder_ / file;
    fs::path aside = place;
    aside += ".damaged-" + uniqueName();
    std::error_code code;
    fs::rename(place, aside, code);
    if (code) return fail(file, "cannot be put aside: " + code.message());
    syncFolder(place.parent_path());
    return {};
}

std::string newKeptId() {
    return uniqueName();
}

bool isKeptId(std::string_view text) {
    return text.size() == id_letters && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace deixis::server
