// deixis clips author: what was authored in the studio as clips with sound and their manifest, for a rating
// study (Yoon et al. 2021, section 7.2).
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "app/clips/clip_output.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/projects/studio_project.hpp"
#include "clips_commands.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "motion/upper_body/upper_body_clip.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct ClipsAuthorArguments {
    std::vector<std::string> projects;
    std::string folder;
    std::string system;
    std::string author;
    std::optional<int> trial;
    bool force = false;
};

/// Letters, digits and hyphens of the first words.
std::string slugOf(const std::string& text, std::size_t longest) {
    std::string out;
    for (const char c : lowerCase(text)) {
        if (out.size() >= longest) break;
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (plain)
            out += c;
        else if (!out.empty() && out.back() != '-')
            out += '-';
    }
    while (!out.empty() && out.back() == '-') out.pop_back();
    return out.empty() ? "speech" : out;
}

/// The same for the same words, so that a speech in several conditions is one item of a study.
std::string speechId(const Utterance& utterance) {
    std::string words;
    for (const SpokenWord& word : utterance.words) words += lowerCase(word.text) + " ";
    return slugOf(words, 24) + "-" + sha256Hex(words).substr(0, 6);
}

/// The paper's conditions (section 7.1).
std::string conditionOf(const assets::StudioProject& project) {
    if (project.system == "keyframes") return "MANUAL";
    if (project.pose_controls + project.style_controls > 0) return "SGT";
    return "AUTO";
}

Result<void> authorClips(const ClipsAuthorArguments& options) {
    OutputFolder folder(options.folder, options.force);
    if (auto free = folder.expect({"manifest.csv"}); !free) return free;
    std::vector<assets::ManifestRow> rows;
    std::set<std::string> taken;
    for (const std::string& file : options.projects) {
        const auto project = assets::readStudioProject(file);
        if (!project) return tl::unexpected(project.error());
        assets::ManifestRow row;
        row.system = options.system.empty() ? conditionOf(*project) : options.system;
        row.target_id = speechId(project->utterance);
        const std::string stem = slugOf(row.system, 24) + "-" + row.target_id;
        std::string name = stem;
        for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
        row.clip = name + ".bvh";
        row.sound = name + ".wav";
        row.fps = motion::upper_body_fps;
        row.author = options.author;
        row.trial = options.trial;
        if (project->synthetic) row.processing = std::string(assets::learned_from_synthetic);
        const motion::Clip clip = motion::heldFor(
            motion::avatarClip(project->motion, project->relaxed_fingers), project->utterance.duration_s);
        if (auto added = folder.add(row.clip, assets::writeBvh(clip)); !added) return added;
        if (auto added = folder.add(row.sound, project->wav); !added) return added;
        rows.push_back(std::move(row));
    }
    if (auto added = folder.add("manifest.csv", assets::manifestCsv(rows)); !added) return added;
    if (auto finished = folder.finish(); !finished) return finished;
    for (std::size_t i = 0; i < rows.size(); ++i)
        fmt::print("{}: {} {}, {}\n", options.projects[i], rows[i].system, rows[i].target_id, rows[i].clip);
    fmt::print("{} clips: {}\n", rows.size(), (fs::path(options.folder) / "manifest.csv").string());
    return {};
}

}  // namespace

void addClipsAuthorCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsAuthorArguments>();
    Parser command =
        clips.addCommand("author", "Make clips with sound of the studio's projects, and their manifest");
    describe(command,
             {.writes = "a BVH and a WAV file for each project and manifest.csv to DIR, all of them or none.",
              .example = "deixis clips author *.deixis.json --author A1 -o authored",
              .page = "docs/studio.md"});
    command.addOption("PROJECT", options->projects, "Projects that the studio saved").required();
    addOutput(command, options->folder, "Folder for the clips and their manifest", "DIR").required();
    addForce(command, options->force);
    command.addOption("--system", options->system,
                      "Name of the system [MANUAL by keyframes, SGT with poses or styles, else AUTO]");
    command.addOption("--author", options->author, "Pseudonym of who authored them").valueName("NAME");
    command.addOption("--trial", options->trial, "Which of the author's trials they are of")
        .check(Range(1, 100000));
    command.callback([options, &chosen] { chosen = [options] { return authorClips(*options); }; });
}

}  // namespace deixis::app
