// Hashes of files read before, stored with their size, times and inode: a file that has not changed since
// is not read again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace deixis::app {

/// A file is taken for the same as long as its size, its times of change (of the bytes, and of anything,
/// which nobody can set), its inode and device are the same. One that was touched less than two seconds
/// before it was read is not remembered: it might be written to once more without its times telling.
class SeenFiles {
  public:
    /// `memory`: the file in which they are remembered. It need not be there, nor its folder: then nothing is
    /// remembered. One that is damaged is as none.
    explicit SeenFiles(std::filesystem::path memory);

    /// SHA-256 of each file; none of one that cannot be read. What had to be read is remembered.
    [[nodiscard]] std::vector<std::optional<std::string>> hashes(
        const std::vector<std::filesystem::path>& files);
    /// How many of the last files asked for had to be read.
    [[nodiscard]] int read() const { return read_; }

  private:
    struct Stamp {
        std::int64_t size = 0, changed_ns = 0, touched_ns = 0;
        std::uint64_t inode = 0, device = 0;
        bool operator==(const Stamp&) const = default;
    };
    struct Seen {
        Stamp stamp;
        std::string hash;
    };
    static std::optional<Stamp> stampOf(const std::filesystem::path& file);
    /// With the stamp, where the file stood still while it was read.
    static std::optional<std::pair<std::string, std::optional<Stamp>>> readHash(
        const std::filesystem::path& file);
    void keep() const;

    std::filesystem::path memory_;
    std::map<std::string, Seen> seen_;  ///< by absolute path
    int read_ = 0;
};

}  // namespace deixis::app
