#include "app/study/locked_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>

#include "app/clips/study_clips.hpp"
#include "app/study/locked_set.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/tables/humanoid_file.hpp"
#include "assets/tables/manifest.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "lab_files.hpp"
#include "studies/design/plan.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// No questionnaire can have this file's name, which holds a dot.
constexpr const char* study_file = "study.text.toml";
constexpr const char* description_file = "set.json";
constexpr const char* targets_file = "targets.json";

/// Files of a set, in the making; the first that fails is the one that is told.
class SetFiles {
  public:
    explicit SetFiles(LockedSetWriter& writer) : writer_(writer) {}
    void add(const std::string& name, const fs::path& source) {
        if (problem_) return;
        const auto bytes = readFile(source);
        if (!bytes)
            problem_ = bytes.error();
        else
            addBytes(name, *bytes);
    }
    void addBytes(const std::string& name, std::string_view bytes) {
        if (problem_) return;
        if (auto added = writer_.add(name, bytes); !added) problem_ = added.error();
    }
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  private:
    LockedSetWriter& writer_;
    std::optional<Error> problem_;
};

/// The clips of one system as they come, and in the end their manifest.
struct SystemFiles {
    std::vector<assets::ManifestRow> rows;
    std::set<std::string> names;

    /// After the item, with a number where it has another clip already.
    std::string nameFor(const StudyClip& clip) {
        std::string stem;
        for (const char c : clip.row.target_id)
            stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ? c : '_';
        std::string name = stem + clip.extension;
        for (int number = 2; !names.insert(name).second; ++number)
            name = fmt::format("{}-{}{}", stem, number, clip.extension);
        return name;
    }
};

void addAvatar(SetFiles& files, const assets::Avatar& avatar) {
    const fs::path folder = avatar.files.front().parent_path();
    for (const fs::path& file : avatar.files)
        files.add("avatar/" + file.lexically_relative(folder).generic_string(), file);
    const fs::path words = assets::humanoidFileOf(avatar.files.front());
    std::error_code code;
    if (fs::is_regular_file(words, code)) files.add("avatar/" + words.filename().string(), words);
}

Json description(const StudySetup& setup, const assets::Avatar& avatar, const std::vector<LabFile>& lab) {
    Json out;
    out["format"] = 1;
    out["study"] = setup.study.name;
    out["study_hash"] = setup.study.hash;
    out["planner"] = studies::planner_version;
    out["avatar"] = "avatar/" + avatar.files.front().filename().string();
    out["shipped"] = lab.empty();
    out["lab_files"] = Json::array();
    for (const LabFile& file : lab) out["lab_files"].push_back({{"file", file.file}, {"sha256", file.hash}});
    return out;
}

/// What the systems' manifests say was done to their clips.
Result<void> fillProcessing(LockedStudy& locked) {
    for (auto& system : locked.setup.study.systems) {
        const auto manifest = assets::readManifest(locked.manifest(system.name));
        if (!manifest) return tl::unexpected(manifest.error());
        std::vector<std::string> found;
        for (const auto& row : manifest->rows)
            if (!row.processing.empty() && std::ranges::find(found, row.processing) == found.end())
                found.push_back(row.processing);
        system.processing = fmt::format("{}", fmt::join(found, ", "));
    }
    return {};
}

/// Paths as the study file writes them: where the set lies is no matter of the study's.
void asWritten(studies::Study& study, const fs::path& folder) {
    const auto written = [&](std::string& path) {
        if (path.empty()) return;
        const fs::path relative = fs::path(path).lexically_relative(folder.lexically_normal());
        // One that is written whole leads elsewhere, and stays.
        const bool within = !relative.empty() && *relative.begin() != "..";
        if (within || !fs::path(path).is_absolute()) path = relative.generic_string();
    };
    for (auto& system : study.systems) {
        written(system.manifest);
        written(system.projects);
    }
    written(study.targets.from_manifest);
    written(study.targets.from_projects);
    written(study.targets.fit_manifest);
}

}  // namespace

tl::expected<std::string, std::vector<Error>> lockStudy(const StudySetup& setup, const LockRequest& request) {
    const auto one = [](Error error) { return tl::unexpected(std::vector<Error>{std::move(error)}); };
    const auto avatar = loadStudyAvatar(setup.study);
    if (!avatar) return one(avatar.error());
    SeenFiles seen = seenFiles(request.database);
    const auto lab = labFiles(setup, *avatar, seen);
    if (!lab) return one(lab.error());
    auto writer = LockedSetWriter::begin(request.database);
    if (!writer) return one(writer.error());

    SetFiles files(*writer);
    files.addBytes(study_file, setup.study.source);
    for (const fs::path& file : setup.study.questionnaire_files)
        files.add("questionnaires/" + file.filename().string(), file);
    for (const fs::path& file : setup.study.language_files)
        files.add("languages/" + file.filename().string(), file);
    addAvatar(files, *avatar);
    if (std::any_of(setup.study.systems.begin(), setup.study.systems.end(),
                    [](const auto& system) { return !system.generator.empty(); }))
        files.add("demonstrations.toml", assets::dataFile("demonstrations.toml"));
    files.addBytes(targets_file, studies::targetsJson(setup.targets));
    if (files.problem()) return one(*files.problem());

    std::map<std::string, SystemFiles> systems;
    for (const auto& system : setup.study.systems) systems[system.name];
    auto problems = readStudyClips(
        {setup, &*avatar, request.made, request.earlier, request.shown},
        [&](const studies::SystemSource& system, StudyClip clip) -> Result<void> {
            SystemFiles& kept = systems.at(system.name);
            clip.row.clip = kept.nameFor(clip);
            clip.row.system = system.name;
            const std::string folder = fmt::format("clips/{}/", system.name);
            const std::string name = folder + clip.row.clip;
            clip.row.sound = clip.sound.empty() ? "" : clip.row.clip + ".wav";
            const std::string sound = folder + clip.row.sound;
            kept.rows.push_back(std::move(clip.row));
            if (!clip.project.empty())
                if (auto added = writer->add(projectBeside(name).string(), clip.project); !added)
                    return added;
            if (!clip.sound.empty())
                if (auto added = writer->add(sound, clip.sound); !added) return added;
            return writer->add(name, clip.bytes);
        });
    if (!problems.empty()) return tl::unexpected(std::move(problems));
    for (const auto& [name, kept] : systems)
        files.addBytes(fmt::format("clips/{}/manifest.csv", name), assets::manifestCsv(kept.rows));
    files.addBytes(description_file, description(setup, *avatar, *lab).dump(1) + "\n");
    if (files.problem()) return one(*files.problem());
    auto hash = writer->finish(request.durable);
    if (!hash) return one(hash.error());
    return *hash;
}

Result<std::string> lockForPlanner(const fs::path& database, const LockedStudy& locked) {
    const auto files = readLockedList(locked.folder);
    if (!files) return tl::unexpected(files.error());
    auto writer = LockedSetWriter::begin(database);
    if (!writer) return tl::unexpected(writer.error());
    for (const auto& [name, hash] : *files) {
        auto bytes = readFile(locked.folder / name);
        if (!bytes) return tl::unexpected(bytes.error());
        if (name == description_file) {
            Json json = Json::parse(*bytes);
            json["planner"] = studies::planner_version;
            *bytes = json.dump(1) + "\n";
        }
        if (auto added = writer->add(name, *bytes); !added) return tl::unexpected(added.error());
    }
    return writer->finish(true);
}

Result<LockedStudy> openLocked(const fs::path& database, const std::string& hash,
                               const std::string& language) {
    auto verified = verifyLocked(database, hash);
    if (!verified) return tl::unexpected(verified.error());
    LockedStudy out;
    out.hash = hash;
    out.files = std::move(*verified);
    out.folder = lockedSet(database, hash);
    auto study = studies::loadStudy(
        out.folder / study_file,
        {out.folder / "languages", out.folder / "questionnaires", assets::dataFile("languages")}, language);
    if (!study) return tl::unexpected(study.error().front());
    out.setup.study = std::move(*study);
    asWritten(out.setup.study, out.folder);
    const fs::path description = out.folder / description_file;
    const auto text = readFile(description);
    if (!text) return tl::unexpected(text.error());
    std::string avatar;
    try {
        const Json json = Json::parse(*text);
        if (const int format = json.at("format").get<int>(); format != 1)
            return fail(description.string(), fmt::format("found format {}, expected 1", format),
                        "A newer program has written it: use that one");
        out.planner = json.at("planner").get<int>();
        out.shipped = json.at("shipped").get<bool>();
        avatar = json.at("avatar").get<std::string>();
        for (const Json& file : json.at("lab_files"))
            out.lab_files.push_back(
                {file.at("file").get<std::string>(), file.at("sha256").get<std::string>()});
    } catch (const Json::exception& error) {
        return fail(description.string(), error.what());
    }
    out.setup.study.avatar = out.folder / avatar;
    const auto kept = readFile(out.folder / targets_file);
    if (!kept) return tl::unexpected(kept.error());
    auto targets = studies::targetsFromJson(*kept);
    if (!targets) return fail((out.folder / targets_file).string(), targets.error().message);
    out.setup.targets = std::move(*targets);
    out.setup.study.targets.count = static_cast<int>(out.setup.targets.size());
    if (auto filled = fillProcessing(out); !filled) return tl::unexpected(filled.error());
    return out;
}

}  // namespace deixis::app
