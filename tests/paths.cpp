#include "paths.hpp"

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
    return DEIXIS_PROGRAM;
}

bool isSanitized() {
    return !std::string(DEIXIS_SANITIZE).empty();
}

}  // namespace deixis::tests
