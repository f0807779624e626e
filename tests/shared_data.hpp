// Real recordings by others that tests may read where they are there.
#pragma once

#include <filesystem>
#include <string>

#include "paths.hpp"
#include "skipping.hpp"

/// Leaves the test case, saying so, where the file is absent.
#define DEIXIS_SKIP_WITHOUT(file)                                                            \
    if (!std::filesystem::exists(file)) {                                                    \
        deixis::tests::tellSkipped(std::filesystem::path(file).lexically_normal().string() + \
                                   " is not here");                                          \
        return;                                                                              \
    }
