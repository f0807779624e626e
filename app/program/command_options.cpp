#include "app/program/command_options.hpp"

#include <filesystem>

#include "app/program/written_output.hpp"

namespace deixis::app {

namespace {

/// `--json answers.csv` would take the data for the file to write; databases are refused wherever they are
/// named.
std::string expectNoData(const std::string& file) {
    std::error_code code;
    const std::filesystem::path path(file);
    const bool data = path.extension() == ".csv" || path.extension() == ".toml" ||
                      std::filesystem::is_directory(path, code);
    if (!data) return "";
    return "found '" + file +
           "', which is no JSON file: what follows --json is the file to write. To print, put --json last, "
           "or "
           "write --json=-";
}

}  // namespace

CLI::Option* addOutput(CLI::App& command, std::string& output, const std::string& what, const char* value) {
    return command.add_option("-o,--output", output, what)->type_name(value);
}

CLI::Option* addOutputLast(CLI::App& command, std::string& output, const std::string& what) {
    return command.add_option("OUT,-o,--output", output, what)->type_name("FILE");
}

CLI::Option* addForce(CLI::App& command, bool& force) {
    return command.add_flag("--force", force, "Replace what is there already");
}

CLI::Option* addJson(CLI::App& command, bool& json, const std::string& what) {
    return command.add_flag("--json", json, what);
}

CLI::Option* addJsonOrFile(CLI::App& command, std::string& json) {
    return command
        .add_option("--json", json, "Print the numbers as JSON; with FILE, write them there instead")
        ->expected(0, 1)
        ->default_str(standard_output)
        ->check(expectNoData);
}

CLI::Option* addCsv(CLI::App& command, std::string& folder, const std::string& what) {
    return command.add_option("--csv", folder, what);
}

CLI::Option* addSeed(CLI::App& command, std::uint64_t& seed, const std::string& of_what) {
    return command.add_option("--seed", seed, "Seed of " + of_what)->capture_default_str();
}

CLI::Option* addLanguage(CLI::App& command, std::string& language) {
    return command.add_option("--language", language,
                              "Language of the participant's texts, such as de [the study's first]");
}

}  // namespace deixis::app
