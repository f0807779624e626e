#include "lab_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>

#include "app/clips/project_folder.hpp"
#include "app/clips/study_clips.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/tables/humanoid_file.hpp"
#include "assets/tables/manifest.hpp"
#include "core/files.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

std::string fromStudy(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_normal().lexically_relative(
        folder.empty() ? fs::path(".") : folder.lexically_normal());
    return relative.empty() ? file.string() : relative.generic_string();
}

/// The first line that is another one.
std::string lineDifference(const std::string& before, const std::string& now) {
    std::istringstream old_lines(before), new_lines(now);
    std::string a, b;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(old_lines, a));
        const bool more_b = static_cast<bool>(std::getline(new_lines, b));
        if (!more_a && !more_b) return "";
        if (!more_a) a.clear();
        if (!more_b) b.clear();
        constexpr int longest = 60;
        if (more_a != more_b || a != b)
            return fmt::format(" (line {} was '{:.{}}', is '{:.{}}')", line, a, longest, b, longest);
    }
}

/// What a changed manifest says of the clips that were locked.
std::string manifestDifference(const LockedStudy& locked, const std::string& file, const fs::path& now) {
    const auto manifest = assets::checkManifest(now);
    if (!manifest) return fmt::format(" ({})", manifest.error().front().text());
    std::vector<std::string> told;
    for (const auto& system : locked.setup.study.systems) {
        if (system.manifest != file) continue;
        const auto before = assets::readManifest(locked.manifest(system.name));
        if (!before) continue;
        const auto rows = rowsOfSystem(*manifest, system.name);
        for (const auto& kept : before->rows) {
            const auto same = std::find_if(rows.begin(), rows.end(),
                                           [&](const auto* row) { return row->target_id == kept.target_id; });
            if (same == rows.end())
                told.push_back(fmt::format("{} is not listed any more", kept.target_id));
            else if (kept.target && (*same)->target && *kept.target != *(*same)->target)
                told.push_back(fmt::format("the target of {} was ({}, {}, {}), is ({}, {}, {})",
                                           kept.target_id, kept.target->x, kept.target->y, kept.target->z,
                                           (*same)->target->x, (*same)->target->y, (*same)->target->z));
        }
    }
    constexpr std::size_t max = 3;
    if (told.empty()) return "";
    const std::size_t further = told.size() - std::min(max, told.size());
    told.resize(std::min(max, told.size()));
    return fmt::format(" ({}{})", fmt::join(told, "; "),
                       further > 0 ? fmt::format("; {} more", further) : "");
}

}  // namespace

bool isShipped(const fs::path& file) {
    std::error_code code;
    const fs::path shipped = fs::weakly_canonical(assets::dataFile("studies"), code).parent_path();
    const fs::path relative = fs::weakly_canonical(file, code).lexically_relative(shipped);
    return !relative.empty() && *relative.begin() != "..";
}

Result<std::vector<LabFile>> labFiles(const StudySetup& setup, const assets::Avatar& avatar,
                                      SeenFiles& seen) {
    const studies::Study& study = setup.study;
    if (isShipped(study.file)) return std::vector<LabFile>{};
    const fs::path folder = study.file.parent_path();
    std::vector<fs::path> files{study.file};
    const auto with = [&](const fs::path& file) {
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    };
    std::error_code code;
    for (const fs::path& file : study.questionnaire_files)
        if (!isShipped(file)) with(file);
    for (const std::string& file : {study.targets.fit_manifest, study.targets.from_manifest})
        if (!file.empty()) with(file);
    std::set<fs::path> clips;
    for (const auto& system : study.systems) {
        if (!system.projects.empty() && !isShipped(system.projects))
            for (const auto& item : setup.targets) with(projectFile(system, item.id));
        if (system.manifest.empty()) continue;
        with(system.manifest);
        const auto manifest = assets::readManifest(system.manifest);
        if (!manifest) continue;  // told, with its place, by whoever takes the clips
        std::set<std::string> items;
        for (const auto& item : setup.targets) items.insert(item.id);
        for (const auto* row : rowsOfSystem(*manifest, system.name)) {
            if (!items.contains(row->target_id)) continue;
            const fs::path clip = manifest->file.parent_path() / row->clip;
            clips.insert(clip);
            if (!row->sound.empty()) clips.insert(manifest->file.parent_path() / row->sound);
            for (const fs::path& part : assets::partsOfClip(clip)) clips.insert(part);
            if (const fs::path words = assets::humanoidFileOf(clip); fs::is_regular_file(words, code))
                clips.insert(words);
        }
    }
    files.insert(files.end(), clips.begin(), clips.end());
    if (!study.avatar.empty()) {
        for (const fs::path& file : avatar.files) with(file);
        if (const fs::path words = assets::humanoidFileOf(study.avatar); fs::is_regular_file(words, code))
            with(words);
    }
    const auto hashes = seen.hashes(files);
    std::vector<LabFile> out;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (hashes[i]) out.push_back({fromStudy(files[i], folder), *hashes[i]});
    return out;
}

Result<std::vector<std::string>> labDifferences(const LockedStudy& locked, const std::string& name,
                                                SeenFiles seen) {
    const fs::path study = assets::fileOrShipped(name, "studies");
    const auto text = readFile(study);
    if (!text) return tl::unexpected(text.error());
    std::vector<std::string> out;
    if (*text != locked.setup.study.source && !(locked.shipped && isShipped(study)))
        out.push_back(study.filename().string() + " has changed" +
                      lineDifference(locked.setup.study.source, *text));
    std::vector<fs::path> files;
    for (const LabFile& file : locked.lab_files) files.push_back(study.parent_path() / file.file);
    const auto hashes = seen.hashes(files);
    for (std::size_t i = 1; i < files.size(); ++i) {
        const LabFile& before = locked.lab_files[i];
        if (!hashes[i])
            out.push_back(before.file + " is missing");
        else if (*hashes[i] != before.hash)
            out.push_back(
                before.file + " has changed" +
                (files[i].extension() == ".csv" ? manifestDifference(locked, before.file, files[i]) : ""));
    }
    std::set<fs::path> known(files.begin(), files.end());
    // A further item.
    const fs::path projects = study.parent_path() / locked.setup.study.targets.from_projects;
    std::error_code none;
    if (!locked.setup.study.targets.from_projects.empty() && fs::is_directory(projects, none)) {
        std::set<std::string> items;
        for (const auto& item : locked.setup.targets) items.insert(item.id);
        if (const auto now = itemsOfProjects(projects))
            for (const std::string& item : *now)
                if (!items.contains(item))
                    out.push_back(
                        fmt::format("{} has a new item {}", fromStudy(projects, study.parent_path()), item));
    }
    // A word on a figure's bones that was not there before.
    for (std::size_t i = 1; i < files.size(); ++i) {
        const fs::path words = assets::humanoidFileOf(files[i]);
        std::error_code code;
        if (known.insert(words).second && fs::is_regular_file(words, code))
            out.push_back(fromStudy(words, study.parent_path()) + " is new");
    }
    return out;
}

}  // namespace deixis::app
