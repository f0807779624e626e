#include "import_options.hpp"

#include <map>
#include <string>

#include "core/number.hpp"

namespace deixis::app {

namespace {

// Metres of a unit by its name, or as a number.
double metresOf(const std::string& unit) {
    static const std::map<std::string, double> names{
        {"m", 1.0}, {"dm", 0.1}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}};
    if (const auto found = names.find(unit); found != names.end()) return found->second;
    constexpr double min = 1e-6, max = 1e3;
    const auto metres = finiteNumber(unit);
    if (!metres || *metres < min || *metres > max)
        rejectUsage("--unit", "found '" + unit +
                                  "', expected m, dm, cm, mm, inch, or a unit's length in "
                                  "metres, from 0.000001 to 1000");
    return *metres;
}

}  // namespace

const char* const clip_file_kinds =
    "Clip: BVH, glTF or VRM, CSV of joint positions, Kinect v2 CSV, exponential maps or SGToolkit JSON; also "
    "packed (.gz)";

void addImportOptionsWithoutRate(Parser command, assets::ImportOptions& options) {
    command.addTextOption(
        "--unit", [&options](const std::string& unit) { options.metres_per_unit = metresOf(unit); },
        "Unit of length: m, dm, cm, mm, inch, or its length in metres [as the file says, or detected]");
    command
        .addTextOption(
            "--up", [&options](const std::string& axis) { options.up_axis = assets::upAxisFromName(axis); },
            "Axis that points up, such as y, z or -y (write --up=-y) [as the file says, or detected]")
        .check(OneOf{{"x", "y", "z", "-x", "-y", "-z"}});
    command.addOption("--animation", options.animation,
                      "Which animation of a file that holds several: its name, or its number from 0");
}

void addImportOptions(Parser command, assets::ImportOptions& options) {
    addImportOptionsWithoutRate(command, options);
    command
        .addNumberOption(
            "--fps", [&options](double fps) { options.fps = fps; }, "Frames per second [as the file says]")
        .check(Range(1.0, 10000.0));
}

}  // namespace deixis::app
