#include "core/unique_name.hpp"

#include <fmt/core.h>

#include <random>

namespace deixis {

std::string uniqueName() {
    std::random_device chance;
    return fmt::format("{:08x}{:08x}", chance(), chance());
}

}  // namespace deixis
