// Opening a page in the person's browser.
#pragma once

#include <string>

namespace deixis::app {

/// As the desktop does it; where that cannot be, standard error asks the person to.
void openInBrowser(const std::string& address);

}  // namespace deixis::app
