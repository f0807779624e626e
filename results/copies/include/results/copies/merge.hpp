// Joining the databases of several stations.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

struct MergeOutcome {
    /// Stood in a database, and are left out: another one says that they withdrew.
    std::vector<std::string> withdrawn{};
    /// Of whom copies differ only in whether and why they are excluded or dropped out: they are.
    std::vector<std::string> excluded_in_one{};
};

/// Joins databases of one study into a new file, without whoever withdrew according to one of them. Refuses,
/// with every reason in the list: different studies (hash) or program schema, a participant or number in more
/// than one (unless all that is kept of them but their standing is equal), an existing output, or one beside
/// which another database's log lies.
[[nodiscard]] tl::expected<MergeOutcome, std::vector<Error>> mergeDatabases(
    const std::vector<std::filesystem::path>& databases, const std::filesystem::path& output);

}  // namespace deixis::results
