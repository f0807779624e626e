// How a clip or a system is shown: in a window, as a picture or as a film.
#pragma once

#include <string>
#include <vector>

namespace deixis::app {

struct ViewOptions {
    std::string size = "1280x720";
    std::string screenshot;  ///< PNG file; empty, and no film: a window
    std::string mp4_file;    ///< a film of the whole movement
    /// Pictured side by side, a clip from where there is none at its begin, a system's gesture in the middle
    /// of its hold; a clip's window starts at the first.
    std::vector<double> times_s;
    /// Side of the avatar; empty: three-quarter, or from where a system's ball is seen, too.
    std::string from;
};

}  // namespace deixis::app
