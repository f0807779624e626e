// deixis clips author: what was authored in the studio as clips with sound and their manifest, for a rating
// study (Yoon et al. 2021, section 7.2).
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "app/clips/clip_output.hpp"
#include "app/clips/project_clips.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "assets/projects/studio_project.hpp"
#include "clips_commands.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "results/answers/authored.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct ClipsAuthorArguments {
    std::vector<std::string> projects;
    std::string database;
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

/// What becomes a clip.
struct Source {
    std::string name;  ///< for messages
    assets::StudioProject project;
    std::string system;
    std::string item{};  ///< empty: by its words
    std::string author;
    std::optional<int> trial;
};

Result<std::vector<Source>> projectsOf(const ClipsAuthorArguments& options) {
    std::vector<Source> out;
    for (const std::string& file : options.projects) {
        auto project = assets::readStudioProject(file);
        if (!project) return tl::unexpected(project.error());
        Source source{file, std::move(*project), options.system, "", options.author, options.trial};
        if (source.system.empty()) source.system = conditionOf(source.project);
        if (source.author.empty()) source.author = source.project.author;
        out.push_back(std::move(source));
    }
    return out;
}

/// All that participants of a study authored, under the names of its items and systems.
Result<std::vector<Source>> authoredIn(const std::string& database) {
    const auto authored = results::readAuthored(database);
    if (!authored) return tl::unexpected(authored.error());
    std::vector<Source> out;
    for (const results::AuthoredClip& clip : *authored) {
        std::string name = fmt::format("{}: {}, {} {}", database, clip.author, clip.system, clip.item);
        auto project = assets::parseStudioProject(clip.project, name);
        if (!project) return tl::unexpected(project.error());
        out.push_back(
            {std::move(name), std::move(*project), clip.system, clip.item, clip.author, clip.trial});
    }
    const auto simulated = std::ranges::count_if(*authored, &results::AuthoredClip::synthetic);
    if (simulated > 0)
        fmt::print(stderr, "{} of {} clips are of simulated participants, who make no gestures\n", simulated,
                   authored->size());
    return out;
}

Result<void> authorClips(const ClipsAuthorArguments& options) {
    OutputFolder folder(options.folder, options.force);
    if (auto free = folder.expect({"manifest.csv"}); !free) return free;
    const auto sources = options.database.empty() ? projectsOf(options) : authoredIn(options.database);
    if (!sources) return tl::unexpected(sources.error());
    std::vector<assets::ManifestRow> rows;
    std::set<std::string> taken;
    ProjectClips maker;
    for (const Source& source : *sources) {
        assets::ManifestRow row;
        row.system = source.system;
        const auto made = maker.make(source.project, source.name);
        if (!made) return tl::unexpected(made.error());
        row.target_id = source.item.empty() ? speechId(made->utterance) : source.item;
        std::string stem = slugOf(row.system, 24) + "-" + row.target_id;
        if (!source.item.empty()) stem += "-" + source.author;
        std::string name = stem;
        for (int i = 2; !taken.insert(name).second; ++i) name = fmt::format("{}-{}", stem, i);
        row.author = source.author;
        row.trial = source.trial;
        if (auto added = addProjectClip(*made, name, folder, row); !added) return added;
        rows.push_back(std::move(row));
    }
    if (auto added = folder.add("manifest.csv", assets::manifestCsv(rows)); !added) return added;
    if (auto finished = folder.finish(); !finished) return finished;
    for (std::size_t i = 0; i < rows.size(); ++i)
        fmt::print("{}: {} {}, {}\n", (*sources)[i].name, rows[i].system, rows[i].target_id, rows[i].clip);
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
              .example = "deixis clips author *.deixis.json --author A1 -o authored\n"
                         "deixis clips author --db authoring.sqlite -o authored",
              .page = "docs/studio.md"});
    command.addOption("PROJECT", options->projects, "Projects that the studio saved");
    command.addOption(
        "--db", options->database,
        "Database of an authoring session instead: all that counts of what its participants made");
    addOutput(command, options->folder, "Folder for the clips and their manifest", "DIR").required();
    addForce(command, options->force);
    command.addOption("--system", options->system,
                      "Name of the system [MANUAL by keyframes, SGT with poses or styles, else AUTO]");
    command.addOption("--author", options->author, "Pseudonym of who authored them").valueName("NAME");
    command.addOption("--trial", options->trial, "Which of the author's trials they are of")
        .check(Range(1, 100000));
    command.callback([options, &chosen] {
        if (options->projects.empty() == options->database.empty())
            rejectUsage("PROJECT", "Give PROJECT, or the database of an authoring session with --db");
        if (!options->database.empty() &&
            !(options->system.empty() && options->author.empty() && !options->trial))
            rejectUsage("--db", "The database tells systems, authors and trials");
        chosen = [options] { return authorClips(*options); };
    });
}

}  // namespace deixis::app
