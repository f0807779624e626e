// What people add to the studio, as files in one folder: their motions, rules and projects. A file is written
// whole or not at all, one that cannot be read hides no other, and several servers can share the folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::server {

/// A file that is there and cannot be used.
struct DamagedFile {
    std::string file;  ///< as in KeptFolder
    std::string problem;
};

/// Files are named within the folder: "rules.json", "motions/ID.json". Names are made by the program, never
/// by those who ask: an id in one is what isKeptId() takes. Links are taken for damaged. Errors name the file
/// in the same way. Calls may come from several threads.
class KeptFolder {
  public:
    enum class Make { now, when_something_is_kept };
    /// Fails where it is no folder, cannot be made (`now`) or not be written to. What servers that were
    /// killed left unfinished in it goes.
    [[nodiscard]] static Result<KeptFolder> open(std::filesystem::path folder, Make make);

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

    /// The right to write, which only one has at a time, of all servers and threads on the folder: taken
    /// before what a change depends on is read, and kept until it is written.
    class Turn {
      public:
        explicit Turn(int file) : file_(file) {}
        Turn(Turn&& other) noexcept : file_(other.file_) { other.file_ = -1; }
        Turn& operator=(Turn&&) = delete;
        ~Turn();

      private:
        int file_;
    };
    /// Makes the folder where it is not there, for its owner alone. Waits, and fails after 20 s.
    [[nodiscard]] Result<Turn> turn() const;

    /// Of the files KIND/ID.json, in order.
    [[nodiscard]] std::vector<std::string> ids(const std::string& kind) const;
    [[nodiscard]] bool has(const std::string& file) const;
    [[nodiscard]] Result<std::string> read(const std::string& file, std::size_t max_bytes) const;
    /// Its first bytes, at most so many.
    [[nodiscard]] Result<std::string> readBeginning(const std::string& file, std::size_t bytes) const;
    [[nodiscard]] std::uintmax_t bytesOf(const std::string& file) const;

    /// On return the disk has it. In one's turn, like the next ones.
    [[nodiscard]] Result<void> write(const std::string& file, std::string_view bytes) const;
    [[nodiscard]] Result<void> remove(const std::string& file) const;
    /// Gives a file that cannot be read another name, beside it.
    [[nodiscard]] Result<void> putAside(const std::string& file) const;

  private:
    explicit KeptFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}
    [[nodiscard]] Result<void> checkFile(const std::string& file) const;

    std::filesystem::path folder_;
};

/// Of a new file: 16 hexadecimal digits by chance.
[[nodiscard]] std::string newKeptId();
[[nodiscard]] bool isKeptId(std::string_view text);

}  // namespace deixis::server
