#include "commands.hpp"

namespace deixis::app {

std::string programVersion() {
    return "deixis " DEIXIS_VERSION;
}

}  // namespace deixis::app
