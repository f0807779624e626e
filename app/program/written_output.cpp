#include "app/program/written_output.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/files.hpp"
#include "core/staging.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* how_to_replace = "Give another name, or --force to replace it";

/// Every page names the program at its head, and so does every JSON file; pages of 0.1.0 did in their text.
bool isOurs(const std::string& file) {
    constexpr std::size_t head_size = 4096;
    const auto text = readFile(file);
    if (!text) return false;
    const std::string head = text->substr(0, head_size);
    return text->empty() || head.find("content=\"deixis\"") != std::string::npos ||
           head.find("\"deixis-") != std::string::npos ||
           text->find("eixis 0.1.0 (commit") != std::string::npos;
}

/// Whether each of these files that is there begins as it will begin.
Result<void> checkEarlierVersions(const FolderFiles& wanted) {
    const auto first_line = [](std::string_view text) { return text.substr(0, text.find('\n')); };
    std::error_code code;
    for (const auto& [name, bytes] : wanted.files) {
        const fs::path file = fs::path(wanted.folder) / name;
        if (!fs::exists(file, code)) continue;
        const auto there = readFile(file);
        if (!there || first_line(*there) != first_line(bytes))
            return fail(file.string(),
                        "is there already, and is not an earlier version of what is to be written",
                        "Name another folder, or --force to replace it");
    }
    return {};
}

}  // namespace

std::FILE* remarksBeside(const std::string& json) {
    return json == standard_output ? stderr : stdout;
}

Result<void> writeOutput(const std::string& file, std::string_view bytes) {
    if (file != standard_output) return writeFile(file, bytes);
    fmt::print("{}", bytes);
    return {};
}

void printAsJson(const nlohmann::ordered_json& json) {
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

bool isDatabase(const std::string& file) {
    std::error_code code;
    if (!fs::is_regular_file(file, code)) return false;
    std::ifstream in(file, std::ios::binary);
    std::string start(15, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == "SQLite format 3";
}

Result<void> checkOutput(const std::string& file) {
    if (!file.empty() && isDatabase(file))
        return fail(file, "is a database and is not overwritten by a report", "Name another file");
    return {};
}

Result<void> checkReplaceable(const std::string& file, bool force) {
    std::error_code code;
    if (force || !fs::is_regular_file(file, code) || isOurs(file)) return {};
    return fail(file, "exists already, and Deixis did not write it", how_to_replace);
}

Result<void> checkFree(const std::string& file, bool force) {
    std::error_code code;
    const auto there = fs::status(file, code);
    if (isDatabase(file)) return fail(file, "is a database and is not overwritten", "Give another name");
    if (force || !fs::exists(there) || fs::is_other(there)) return {};  // a pipe or a device
    return fail(file, "is there already", how_to_replace);
}

Result<void> writeFolders(const std::vector<FolderFiles>& folders, bool force) {
    for (const FolderFiles& one : folders)
        if (auto ours = checkEarlierVersions(one); !ours && !force) return ours;
    for (const FolderFiles& one : folders) {
        auto staging = Staging::within(one.folder);
        if (!staging) return tl::unexpected(staging.error());
        std::vector<fs::path> names;
        for (const auto& [name, bytes] : one.files) {
            if (auto written = staging->add(name, bytes); !written) return written;
            names.emplace_back(name);
        }
        if (auto moved = staging->moveHome(names, {}, false); !moved) return moved;
    }
    return {};
}

Result<void> writeUnlessEdited(const std::string& file, std::string_view bytes, bool force) {
    std::error_code code;
    if (!force && fs::exists(file, code)) {
        const auto there = readFile(file);
        if (!there || *there != bytes) return fail(file, "exists already", how_to_replace);
    }
    return writeFile(file, bytes);
}

}  // namespace deixis::app
