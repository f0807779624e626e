// The locked sets of a database, copied beside another one without what tells of a lab.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "core/error.hpp"

namespace deixis::app {

struct PackagedSets {
    std::map<std::string, std::string> hashes;   ///< of a set: of its copy
    std::set<std::string> files;                 ///< names within the sets
    std::map<std::string, std::string> authors;  ///< of clips: name, and what stands for it
};

/// Copies all sets that `database` speaks of beside `copy`. What participants saw stays, byte for byte; left
/// out are the places of the lab's files, and authors of clips get other names. Fails where nothing is
/// locked, or a set is not there or damaged.
[[nodiscard]] Result<PackagedSets> packageSets(const std::filesystem::path& database,
                                               const std::filesystem::path& copy);

}  // namespace deixis::app
