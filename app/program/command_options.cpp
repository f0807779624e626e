#include "app/program/command_options.hpp"

#include <filesystem>

#include "app/program/written_output.hpp"

namespace deixis::app {

namespace {

/// `--json answers.csv` would take the data for the file to write; databases are rejected wherever they are
/// named.
std::string expectNoData(const std::string& file) {
    std::error_code code;
    const std::filesystem::path path(file);
    const bool data = path.extension() == ".csv" || path.extension() == ".toml" ||
                      std::filesystem::is_directory(path, code);
    if (!data) return "";
    return "found '" + file +
           "', which is not a JSON file: a word after --json is the file to write. To print, put --json "
           "last, or write --json=-";
}

}  // namespace

Option addOutput(Parser command, std::string& output, const std::string& what, const char* value) {
    return command.addOption("-o,--output", output, what).valueName(value);
}

Option addOutputLast(Parser command, std::string& output, const std::string& what) {
    return command.addOption("OUT,-o,--output", output, what).valueName("FILE");
}

Option addForce(Parser command, bool& force, const std::string& what) {
    return command.addFlag("--force", force, "Replace " + what + " there already");
}

Option addJson(Parser command, bool& json, const std::string& what) {
    return command.addFlag("--json", json, what);
}

Option addJsonOrFile(Parser command, std::string& json) {
    return command.addOption("--json", json, "Print the numbers as JSON; with FILE, write them there instead")
        .expected(0, 1)
        .showDefault(standard_output)
        .check(expectNoData);
}

Option addCsv(Parser command, std::string& folder, const std::string& what) {
    return command.addOption("--csv", folder, what);
}

Option addSeed(Parser command, std::uint64_t& seed, const std::string& of_what) {
    return command.addOption("--seed", seed, "Seed of " + of_what).showDefault();
}

Option addLanguage(Parser command, std::string& language) {
    return command.addOption("--language", language,
                             "Language of the participant's texts, such as de [the study's first]");
}

}  // namespace deixis::app
