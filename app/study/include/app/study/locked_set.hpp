// A study as it was when its first participant came: everything that participants see, or that determines
// it, as files in a folder beside the database (docs/running-a-study.md, "What is locked").
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/study/seen_files.hpp"
#include "core/error.hpp"
#include "core/staging.hpp"

namespace deixis::app {

/// NAME.locked beside NAME.sqlite: holds the sets, each in a folder named after its hash.
[[nodiscard]] std::filesystem::path lockedFolder(const std::filesystem::path& database);

/// Hashes of the sets' files, and of the lab's that they were made from, remembered beside the sets.
[[nodiscard]] SeenFiles seenFiles(const std::filesystem::path& database);

/// The folder of one set.
[[nodiscard]] std::filesystem::path lockedSet(const std::filesystem::path& database, const std::string& hash);

/// Name and SHA-256 of every file of a set, as in its list "locked.sha256", which `sha256sum -c` reads. Fails
/// where the set is not there, its list has another hash, or a file is not what the list says.
using LockedFiles = std::map<std::string, std::string>;
[[nodiscard]] Result<LockedFiles> verifyLocked(const std::filesystem::path& database,
                                               const std::string& hash);

/// What is said of a set that is not what its list says: `how`, in words.
[[nodiscard]] Error damaged(const std::filesystem::path& set, const std::string& how);

/// The same of a set that nothing but its own name vouches for.
[[nodiscard]] Result<LockedFiles> readLockedList(const std::filesystem::path& set);

/// A set in the making, in a folder that only its owner may read. While there is one for a database, further
/// ones wait, in whatever program. Whatever ends the work before finish() leaves nothing.
class LockedSetWriter {
  public:
    [[nodiscard]] static Result<LockedSetWriter> begin(const std::filesystem::path& database);
    LockedSetWriter(LockedSetWriter&& other) noexcept;
    LockedSetWriter& operator=(LockedSetWriter&&) = delete;
    ~LockedSetWriter();

    /// `name` is relative to the set. May be called by several threads.
    [[nodiscard]] Result<void> add(const std::string& name, std::string_view bytes);
    /// The set's hash. A set of that hash that is there already and complete stays. `durable`: all of it is
    /// on the disk on return.
    [[nodiscard]] Result<std::string> finish(bool durable);

  private:
    LockedSetWriter(std::filesystem::path database, int lock);

    std::filesystem::path database_;
    std::optional<Staging> staging_{};
    int lock_ = -1;
    LockedFiles files_{};
    std::unique_ptr<std::mutex> adding_;
};

/// Copies the sets of a database that `to` does not have beside it. Returns those that are not there or not
/// whole.
[[nodiscard]] Result<std::vector<std::string>> copyLockedSets(const std::vector<std::filesystem::path>& from,
                                                              const std::filesystem::path& to,
                                                              const std::vector<std::string>& hashes);

}  // namespace deixis::app
