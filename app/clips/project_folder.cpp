#include "app/clips/project_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/program/version.hpp"
#include "assets/tables/manifest.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "made_folder.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* saved_by = "Projects are saved by 'deixis studio' (docs/studio.md)";

bool isPlain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

/// "bridge" of "bridge.AUTO.json"; empty: it has another form.
std::string itemIn(const fs::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t dot = stem.find('.');
    if (dot == 0 || dot == std::string::npos || dot + 1 == stem.size()) return "";
    const auto plain = [](std::string_view part) { return std::ranges::all_of(part, isPlain); };
    if (!plain(std::string_view(stem).substr(0, dot)) || !plain(std::string_view(stem).substr(dot + 1)))
        return "";
    return stem.substr(0, dot);
}

}  // namespace

Result<std::set<std::string>> itemsOfProjects(const fs::path& folder) {
    std::error_code code;
    if (!fs::is_directory(folder, code))
        return fail(folder.string(), "No such folder, expected one of projects: ITEM.SYSTEM.json", saved_by);
    std::set<std::string> items;
    std::set<std::string> others;
    for (const auto& entry : fs::directory_iterator(folder, code)) {
        if (entry.path().extension() != ".json") continue;
        std::string item = itemIn(entry.path());
        (item.empty() ? others : items)
            .insert(item.empty() ? entry.path().filename().string() : std::move(item));
    }
    if (!others.empty())
        return fail(
            folder.string(),
            fmt::format("found {}, expected names of the form ITEM.SYSTEM.json of letters, digits, '-' and "
                        "'_'",
                        fmt::join(others, ", ")));
    if (items.empty())
        return fail(folder.string(), "has no projects, expected files ITEM.SYSTEM.json", saved_by);
    return items;
}

fs::path projectFile(const studies::SystemSource& system, const std::string& item) {
    return fs::path(system.projects) / fmt::format("{}.{}.json", item, system.name);
}

tl::expected<std::vector<ItemProject>, std::vector<Error>> readProjects(
    const studies::SystemSource& system, const std::vector<studies::TargetItem>& items) {
    std::error_code code;
    if (!fs::is_directory(system.projects, code))
        return tl::unexpected(std::vector<Error>{
            {system.projects, "No such folder, expected one of projects: ITEM.SYSTEM.json", saved_by}});
    std::vector<ItemProject> out;
    std::vector<Error> problems;
    std::vector<std::string> lacking;
    std::set<std::string> seen;
    for (const auto& item : items) {
        if (!seen.insert(item.id).second) continue;
        const fs::path file = projectFile(system, item.id);
        if (!fs::exists(file, code)) {
            lacking.push_back(file.filename().string());
            continue;
        }
        auto bytes = readFile(file);
        if (!bytes) {
            problems.push_back(bytes.error());
            continue;
        }
        // A file that is wrong is told by its own lines, not by those of what is left of it.
        auto project = assets::parseStudioProject(*bytes, file.string());
        if (project && !system.controls) {
            *bytes = assets::withoutControls(*bytes);
            project = assets::parseStudioProject(*bytes, file.string());
        }
        if (project)
            out.push_back({item.id, std::move(*bytes), std::move(*project)});
        else
            problems.push_back(project.error());
    }
    constexpr std::size_t max_listed = 10;
    if (!lacking.empty())
        problems.insert(problems.begin(),
                        {system.projects,
                         fmt::format("has no project of system '{}' for {} of {} items: {}{}", system.name,
                                     lacking.size(), seen.size(),
                                     fmt::join(lacking.begin(),
                                               lacking.begin() + static_cast<std::ptrdiff_t>(
                                                                     std::min(max_listed, lacking.size())),
                                               ", "),
                                     lacking.size() > max_listed ? ", ..." : ""),
                         saved_by});
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    return out;
}

Result<fs::path> projectsManifest(const studies::SystemSource& system,
                                  const std::vector<ItemProject>& projects, ProjectClips& maker,
                                  const fs::path& folder) {
    const auto sources = maker.sources();
    if (!sources) return tl::unexpected(sources.error());
    // Another version of the program may make other clips.
    std::string made_from = fmt::format("{}\n{}\n{}", programVersion(), system.name, *sources);
    for (const ItemProject& one : projects)
        made_from += fmt::format("{} {}\n", one.item, sha256Hex(one.bytes));
    const fs::path clips = folder / fmt::format("{}-{}", system.name, sha256Hex(made_from).substr(0, 12));
    return madeOnce(clips, [&](const fs::path& making) -> Result<void> {
        OutputFolder output(making, true, false);
        std::vector<assets::ManifestRow> rows;
        for (const ItemProject& one : projects) {
            const auto made = maker.make(one.project, projectFile(system, one.item).string());
            if (!made) return tl::unexpected(made.error());
            assets::ManifestRow& row = rows.emplace_back();
            row.system = system.name;
            row.target_id = one.item;
            row.seed = one.project.seed;
            row.author = one.project.author;
            if (auto added = addProjectClip(*made, one.item, output, row); !added) return added;
        }
        if (auto added = output.add("manifest.csv", assets::manifestCsv(rows)); !added) return added;
        return output.finish();
    });
}

}  // namespace deixis::app
