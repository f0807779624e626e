// Files and folders while they are written: they are made beside their final place until complete, so that
// nothing incomplete is ever found there, and unfinished ones leave nothing.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis {

/// A hidden folder within another one, its home. Removed at the end with what is still in it, and with it the
/// home, where that was made for it and is empty.
class Staging {
  public:
    /// Made with the folders above it. `name` is that of the folder; where one of this name is there, it was
    /// left by a program that was killed, and goes. Without a name it has one of its own.
    [[nodiscard]] static Result<Staging> within(const std::filesystem::path& home, std::string name = {});
    Staging(Staging&& other) noexcept;
    Staging& operator=(Staging&&) = delete;
    ~Staging();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// A file in it; `name` may name folders below.
    [[nodiscard]] Result<void> add(const std::filesystem::path& name, std::string_view bytes) const;

    /// Moves files to the same names in its home, in this order, over those that are there. `outdated` names
    /// files of the home that go before. Fails before anything is moved where a folder has one of the names;
    /// where a move fails all the same, the folder stays with what has not been moved.
    /// `durable`: on return the disk has them.
    [[nodiscard]] Result<void> moveHome(const std::vector<std::filesystem::path>& names,
                                        const std::vector<std::filesystem::path>& outdated, bool durable);
    /// The folder itself becomes `target`, which must not be there or be empty. Nothing may be added after.
    [[nodiscard]] Result<void> become(const std::filesystem::path& target, bool durable);

  private:
    Staging(std::filesystem::path home, std::filesystem::path path, bool made_home);

    std::filesystem::path home_;
    std::filesystem::path path_;  ///< empty: it is no more
    bool made_home_ = false;
};

/// A file that others write than writeFile(), such as a database or a film: beside its place, under its name
/// and `ending`. Removed, as what SQLite puts beside a database is, unless it was moved there.
class PartialFile {
  public:
    /// What a program that was killed has left of it is removed.
    explicit PartialFile(std::filesystem::path target, const char* ending = ".partial");
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;
    ~PartialFile();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// moveFile() to its place.
    [[nodiscard]] Result<void> finish();

  private:
    void remove() const;

    std::filesystem::path target_;
    std::filesystem::path path_;
};

}  // namespace deixis
