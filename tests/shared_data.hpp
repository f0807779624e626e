// Real recordings by others that tests may read where they are there; they are never part of the project.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

namespace deixis::tests {

inline std::filesystem::path sharedData(const std::string& relative) {
    return std::filesystem::path(DEIXIS_SHARED_DATA) / relative;
}

}  // namespace deixis::tests

/// Leaves the test case, saying so, where the file is absent.
#define DEIXIS_SKIP_WITHOUT(file)                                \
    if (!std::filesystem::exists(file)) {                        \
        MESSAGE("skipped: ", std::string(file), " is not here"); \
        return;                                                  \
    }
