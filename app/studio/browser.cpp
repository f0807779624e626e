#include "app/studio/browser.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdio>

namespace deixis::app {

void openInBrowser(const std::string& address) {
    std::string program = "xdg-open";
    std::string argument = address;
    char* const command[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, "xdg-open", nullptr, nullptr, command, environ) != 0)
        fmt::print(stderr,
                   "no browser could be opened (xdg-open is not installed): open the address above in one\n");
}

}  // namespace deixis::app
