#include "app/clips/study_clips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <glm/geometric.hpp>
#include <optional>
#include <set>
#include <utility>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_retargeting.hpp"
#include "app/clips/project_folder.hpp"
#include "app/program/progress_line.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/tables/humanoid_file.hpp"
#include "built_in_clips.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

// A sound of another length belongs to another clip; one that is read to its end may trail off a little.
constexpr double max_sound_apart_s = 2.0;

std::string position(const Vec3& p) {
    return fmt::format("({:.4f}, {:.4f}, {:.4f})", p.x, p.y, p.z);
}

/// One system's clips.
class SystemClips {
  public:
    SystemClips(const ClipSources& sources, const studies::SystemSource& system, const assets::Avatar* maker,
                ProjectClips& projects)
        : sources_(sources), system_(system), maker_(maker), project_clips_(projects) {}

    std::vector<Error> read(const ClipTaker& take) {
        if (!system_.generator.empty()) {
            if (sources_.made.empty()) {
                checkPlaced();
                return std::move(problems_);
            }
            readBuiltIn(take);
            return std::move(problems_);
        }
        if (!system_.projects.empty()) {
            takeProjects(take);
            return std::move(problems_);
        }
        auto manifest = assets::checkManifest(system_.manifest);
        if (!manifest) {
            for (Error& error : manifest.error()) problem(std::move(error));
            return std::move(problems_);
        }
        manifest_ = std::move(*manifest);
        for (const assets::ManifestRow* row : checkedRows()) takeLabClip(*row, take);
        return std::move(problems_);
    }

  private:
    void problem(Error error) {
        const std::string place = sources_.setup.study.place("systems." + system_.name);
        error.where = error.where.empty() ? place : place + ": " + error.where;
        problems_.push_back(std::move(error));
    }
    void problem(const assets::ManifestRow& row, const char* column, std::string message,
                 std::string hint = {}) {
        problem(Error{fmt::format("{}:{}: {}", manifest_.file.string(), row.line, column), std::move(message),
                      std::move(hint)});
    }

    /// A built-in system points at targets.
    bool checkPlaced() {
        for (const auto& item : sources_.setup.targets) {
            if (item.placed) continue;
            problem(Error{"",
                          fmt::format("item {} has no target, but the system '{}' points at targets", item.id,
                                      system_.name),
                          "A built-in system can stand beside a lab's clips only where these point at "
                          "something"});
            return false;
        }
        return true;
    }

    /// The rows for the study's items; notes what is wrong with them.
    std::vector<const assets::ManifestRow*> checkedRows() {
        const auto rows = rowsOfSystem(manifest_, system_.name);
        if (rows.empty()) {
            std::set<std::string> names;
            for (const auto& row : manifest_.rows) names.insert(row.system);
            problem(names.empty()
                        ? Error{manifest_.file.string(), "lists no clips"}
                        : Error{manifest_.file.string(),
                                fmt::format("has clips of the systems {}, but none named '{}' as the study "
                                            "does",
                                            fmt::join(names, ", "), system_.name)});
            return {};
        }
        std::multimap<std::string, const assets::ManifestRow*> by_item;  // each item's in their order
        for (const auto* row : rows) {
            const auto [first, last] = by_item.equal_range(row->target_id);
            const auto same =
                std::find_if(first, last, [&](const auto& one) { return one.second->clip == row->clip; });
            if (same != last)
                problem(*row, "clip",
                        fmt::format("the clip {} of system '{}' a second time for target {}; line {} has the "
                                    "first",
                                    row->clip, row->system, row->target_id, same->second->line),
                        "Several clips of one target are different files");
            by_item.emplace(row->target_id, row);
        }
        std::vector<const assets::ManifestRow*> out;
        std::vector<std::string> lacking;
        int in_centimetres = 0;
        for (const auto& item : sources_.setup.targets) {
            const auto [first, last] = by_item.equal_range(item.id);
            if (first == last) lacking.push_back(item.id);
            for (auto row = first; row != last; ++row) {
                out.push_back(row->second);
                checkTarget(*row->second, item, in_centimetres);
            }
        }
        if (in_centimetres > 0)
            problem(Error{manifest_.file.string(),
                          fmt::format("the targets of {} rows are the study's a hundredfold: they look like "
                                      "centimetres, expected metres",
                                      in_centimetres),
                          "Divide target_x, target_y and target_z by 100"});
        constexpr std::size_t max_listed = 10;
        if (!lacking.empty())
            problem(Error{manifest_.file.string(),
                          fmt::format("has no clip of system '{}' for {} of {} targets: {}{}", system_.name,
                                      lacking.size(), sources_.setup.targets.size(),
                                      fmt::join(lacking.begin(),
                                                lacking.begin() + static_cast<std::ptrdiff_t>(
                                                                      std::min(max_listed, lacking.size())),
                                                ", "),
                                      lacking.size() > max_listed ? ", ..." : ""),
                          "Make the clips for the targets that 'deixis targets' prints for this study"});
        checkEarlier(rows);
        return out;
    }

    void checkTarget(const assets::ManifestRow& row, const studies::TargetItem& item, int& in_centimetres) {
        if (madeFor(row, item)) return;
        if (!row.target) {
            problem(row, "target_x",
                    fmt::format("has no target, but the study's {} is at {}", row.target_id,
                                position(item.target)));
        } else if (glm::length(*row.target / 100.0 - item.target) < 0.001) {
            ++in_centimetres;
        } else {
            problem(row, "target_x",
                    fmt::format("was made for the target {}, but the study's {} is at {}",
                                position(*row.target), row.target_id, position(item.target)),
                    "Make the clips for the targets that 'deixis targets' prints for this study");
        }
    }

    /// What stored plans show must be there as it was.
    void checkEarlier(const std::vector<const assets::ManifestRow*>& rows) {
        for (const auto& item : sources_.earlier)
            if (std::none_of(rows.begin(), rows.end(), [&](const auto* row) {
                    return row->target_id == item.id && madeFor(*row, item);
                }))
                problem(Error{manifest_.file.string(),
                              fmt::format("has no clip for target {} at {}, which a stored plan shows",
                                          item.id, position(item.target)),
                              "Put the manifest back that the study was begun with"});
    }

    void takeLabClip(const assets::ManifestRow& row, const ClipTaker& take) {
        const fs::path file = manifest_.file.parent_path() / row.clip;
        const std::size_t before = problems_.size();
        const auto broken = [&](const Error& error) {
            problem(row, "clip", error.where.empty() ? error.message : error.where + ": " + error.message,
                    error.hint);
        };
        std::error_code code;
        if (!fs::is_regular_file(file, code)) {
            problem(row, "clip", "No such file: " + file.string(),
                    "Clips are looked for beside their manifest");
            return;
        }
        const auto bytes = readFile(file);
        if (!bytes) return broken(bytes.error());
        const auto read = assets::importClip(file);
        if (!read) return broken(read.error());
        checkFrames(row, read->clip);
        const std::string sound = readSound(row, read->clip);
        if (problems_.size() > before || sources_.avatar == nullptr) return;
        auto clip = onAvatar(*read, file, *bytes, row);
        if (!clip) return broken(clip.error());
        clip->sound = sound;
        if (auto taken = take(system_, std::move(*clip)); !taken) problem(taken.error());
    }

    /// Bytes of the file of what is said; empty where there is none, or it is not what it should be.
    std::string readSound(const assets::ManifestRow& row, const motion::Clip& clip) {
        if (row.sound.empty()) return {};
        const auto bytes = readFile(manifest_.file.parent_path() / row.sound);
        if (!bytes) {
            problem(row, "sound", bytes.error().where + ": " + bytes.error().message,
                    "Sounds are looked for beside their manifest");
            return {};
        }
        const auto sound = speech::readWavBytes(*bytes, row.sound);
        if (!sound) {
            problem(row, "sound", sound.error().where + ": " + sound.error().message, sound.error().hint);
            return {};
        }
        const double apart_s = durationOf(*sound) - (clip.duration_s() + clip.frame_time_s);
        if (std::abs(apart_s) > max_sound_apart_s)
            problem(
                row, "sound",
                fmt::format("{} lasts {:.2f} s, but the clip {} {:.2f} s; expected the same within {} s",
                            row.sound, durationOf(*sound), row.clip, clip.duration_s(), max_sound_apart_s));
        return *bytes;
    }

    void checkFrames(const assets::ManifestRow& row, const motion::Clip& clip) {
        if (row.phases && row.phases->end_frame >= clip.frameCount())
            problem(row, "end",
                    fmt::format("found {}, which lies outside the clip {}: it has frames 0 to {}",
                                row.phases->end_frame, row.clip, clip.frameCount() - 1));
        if (std::abs(row.fps - clip.framesPerSecond()) > 0.01 * row.fps)
            problem(row, "fps",
                    fmt::format("found {:g}, but the clip {} has {:.4g} frames per second", row.fps, row.clip,
                                clip.framesPerSecond()));
    }

    /// A lab's clip as a file on the avatar: as it is where it was made for the avatar and is BVH, else
    /// brought to it, which is done once.
    Result<StudyClip> onAvatar(const assets::ImportedClip& read, const fs::path& file,
                               const std::string& bytes, const assets::ManifestRow& row) const {
        const assets::Avatar& avatar = *sources_.avatar;
        StudyClip out{row, {}, ".bvh"};
        if (isOnAvatar(read.clip, avatar) && file.extension() == ".bvh") {
            out.bytes = bytes;
            return out;
        }
        const RetargetSettings settings{system_.keep, system_.pointing_fingers};
        std::string made_from = bytes + avatar.content_hash + assets::manifestCsv({row}) +
                                fmt::format("{} {}", motion::keepName(settings.keep), settings.close_hand);
        if (const auto words = readFile(assets::humanoidFileOf(file))) made_from += *words;
        for (const fs::path& part : assets::partsOfClip(file))
            if (const auto part_bytes = readFile(part)) made_from += sha256Hex(*part_bytes);
        const fs::path made = sources_.made / fmt::format("{}-on-avatar", system_.name) /
                              fmt::format("{}.bvh", sha256Hex(made_from).substr(0, 16));
        std::error_code code;
        if (!sources_.made.empty() && fs::exists(made, code)) {
            auto kept = readFile(made);
            if (!kept) return tl::unexpected(kept.error());
            const auto shown = assets::importClip(made);
            if (!shown) return tl::unexpected(shown.error());
            out.row.fps = shown->clip.framesPerSecond();
            out.bytes = std::move(*kept);
            return out;
        }
        const auto clip = retargetRow(read, file.string(), avatar, settings, out.row);
        if (!clip) return tl::unexpected(clip.error());
        out.bytes = assets::writeBvh(*clip);
        if (!sources_.made.empty())
            if (auto written = writeFileUnsynced(made, out.bytes); !written)
                return tl::unexpected(written.error());
        return out;
    }

    void readBuiltIn(const ClipTaker& take) {
        if (!checkPlaced()) return;
        std::vector<studies::TargetItem> wanted = sources_.earlier;
        // What participants saw before is kept, whatever this program would make.
        if (const auto shown = sources_.shown.find(system_.name); shown != sources_.shown.end()) {
            const auto manifest = assets::readManifest(shown->second);
            if (!manifest) return problem(manifest.error());
            for (const auto& row : manifest->rows) {
                takeBuiltIn(shown->second, row, take);
                std::erase_if(
                    wanted, [&](const auto& item) { return item.id == row.target_id && madeFor(row, item); });
            }
            for (const auto& item : sources_.setup.targets)
                if (std::none_of(manifest->rows.begin(), manifest->rows.end(), [&](const auto& row) {
                        return row.target_id == item.id && madeFor(row, item);
                    }))
                    wanted.push_back(item);
        } else {
            wanted.insert(wanted.begin(), sources_.setup.targets.begin(), sources_.setup.targets.end());
        }
        if (wanted.empty()) return;
        // An item may have had another target in an earlier plan: each round makes one clip of an item.
        while (!wanted.empty()) {
            std::vector<assets::ListedTarget> round;
            std::set<std::string> ids;
            std::erase_if(wanted, [&](const auto& item) {
                if (!ids.insert(item.id).second) return false;
                round.push_back({item.id, item.target});
                return true;
            });
            const auto file =
                builtInManifest(system_, sources_.setup.study.seed, round, *maker_, sources_.made);
            if (!file) return problem(file.error());
            const auto manifest = assets::readManifest(*file);
            if (!manifest) return problem(manifest.error());
            for (const auto& row : manifest->rows) takeBuiltIn(*file, row, take);
        }
    }

    void takeProjects(const ClipTaker& take) {
        if (sources_.setup.targets.front().placed)
            return problem(Error{"",
                                 fmt::format("item {} has a target, but projects point at nothing",
                                             sources_.setup.targets.front().id),
                                 "Write [targets] from_projects, or a manifest's items without targets"});
        auto projects = readProjects(system_, sources_.setup.targets);
        if (!projects) {
            for (Error& error : projects.error()) problem(std::move(error));
            return;
        }
        if (sources_.made.empty()) return;
        const auto file = projectsManifest(system_, *projects, project_clips_, sources_.made);
        if (!file) return problem(file.error());
        const auto manifest = assets::readManifest(*file);
        if (!manifest) return problem(manifest.error());
        for (std::size_t i = 0; i < std::min(projects->size(), manifest->rows.size()); ++i)
            takeBuiltIn(*file, manifest->rows[i], take, std::move((*projects)[i].bytes));
    }

    /// `project`: what it was made of.
    void takeBuiltIn(const fs::path& manifest, const assets::ManifestRow& row, const ClipTaker& take,
                     std::string project = {}) {
        const fs::path file = manifest.parent_path() / row.clip;
        auto bytes = readFile(file);
        if (!bytes) return problem(bytes.error());
        // The kept file may have suffered since it was made.
        if (const auto read = assets::importClip(file); !read) {
            Error error = read.error();
            error.hint = fmt::format("Remove the folder {}: its clips are then made again",
                                     manifest.parent_path().string());
            return problem(std::move(error));
        }
        StudyClip clip{row, std::move(*bytes), ".bvh", {}, std::move(project)};
        if (!row.sound.empty()) {
            auto sound = readFile(manifest.parent_path() / row.sound);
            if (!sound) return problem(sound.error());
            clip.sound = std::move(*sound);
        }
        if (auto taken = take(system_, std::move(clip)); !taken) problem(taken.error());
    }

    const ClipSources& sources_;
    const studies::SystemSource& system_;
    const assets::Avatar* maker_;
    ProjectClips& project_clips_;
    assets::Manifest manifest_;
    std::vector<Error> problems_;
};

}  // namespace

std::vector<const assets::ManifestRow*> rowsOfSystem(const assets::Manifest& manifest,
                                                     const std::string& system) {
    std::set<std::string> names;
    for (const auto& row : manifest.rows) names.insert(row.system);
    std::vector<const assets::ManifestRow*> rows;
    for (const auto& row : manifest.rows)
        if (names.size() == 1 || row.system == system) rows.push_back(&row);
    return rows;
}

bool madeFor(const assets::ManifestRow& row, const studies::TargetItem& item) {
    if (!item.placed) return true;
    return row.target && glm::length(*row.target - item.target) <= 0.001;
}

std::vector<Error> readStudyClips(const ClipSources& sources, const ClipTaker& take) {
    const auto& systems = sources.setup.study.systems;
    std::optional<assets::Avatar> own;
    const assets::Avatar* maker = sources.avatar;
    const bool built_in = std::any_of(systems.begin(), systems.end(),
                                      [](const auto& system) { return !system.generator.empty(); });
    if (built_in && !sources.made.empty() && !sources.setup.study.avatar.empty()) {
        auto loaded = loadShippedAvatar();
        if (!loaded) return {loaded.error()};
        own = std::move(*loaded);
        maker = &*own;
    }
    const ElapsedOnTerminal told(sources.made.empty() ? "reading the study's clips"
                                                      : "making and reading the study's clips");
    // Systems do not depend on each other, and making and reading their clips is most of a start's work.
    ProjectClips projects;  // a speech is spoken once for all systems
    std::vector<std::future<std::vector<Error>>> parts;
    for (const auto& system : systems)
        parts.push_back(std::async(std::launch::async, [&sources, &system, &take, &projects, maker] {
            return SystemClips(sources, system, maker, projects).read(take);
        }));
    std::vector<Error> problems;
    for (auto& part : parts)
        for (Error& problem : part.get()) problems.push_back(std::move(problem));
    return problems;
}

}  // namespace deixis::app
