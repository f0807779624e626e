#include "paths.hpp"

#include <cstdlib>

namespace deixis::tests {

std::filesystem::path sourceDir() {
    return DEIXIS_SOURCE_DIR;
}

std::filesystem::path buildDir() {
    return DEIXIS_BINARY_DIR;
}

std::filesystem::path sharedData(const std::string& relative) {
    return sourceDir() / "../shared/data" / relative;
}

std::string programFile() {
    const char* other = std::getenv("DEIXIS_TESTED_PROGRAM");
    return other ? other : DEIXIS_PROGRAM;
}

bool isSanitized() {
    return !std::string(DEIXIS_SANITIZE).empty();
}

}  // namespace deixis::tests
