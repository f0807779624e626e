// Progress of the check that a database goes through whenever it is opened, which takes long if it is
// large.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

namespace deixis::results {

/// Called when such a check begins, with the file; what it returns is destroyed when the check is over.
using CheckObserver = std::function<std::shared_ptr<void>(const std::filesystem::path&)>;

/// For the whole program, before any database is opened.
void observeChecks(CheckObserver watch);

}  // namespace deixis::results
