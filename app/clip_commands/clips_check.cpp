// deixis clips check: whether clip files can be used, and what is doubtful about them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_problems.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"

namespace deixis::app {

namespace {

struct ClipsCheckArguments {
    std::vector<std::string> files;
    assets::ImportOptions import;
    bool json = false;
};

// Every problem of one file; errors of reading and retargeting are among them.
std::vector<ClipProblem> problemsOf(const std::string& file, const ClipsCheckArguments& options,
                                    const assets::Avatar& avatar) {
    const auto imported = assets::importClip(file, options.import);
    if (!imported) return {{true, imported.error().text()}};
    const auto mapping = mapImported(*imported, file);
    if (!mapping) return {{true, mapping.error().text()}};
    auto problems = clipProblems(*imported, file, mapping->map);
    const bool broken = std::any_of(problems.begin(), problems.end(),
                                    [](const ClipProblem& problem) { return problem.fatal; });
    if (broken) return problems;  // why it does not play is said already
    if (const auto played = clipOnAvatar(*imported, file, avatar); !played)
        problems.push_back({true, "does not play on the avatar: " + played.error().message});
    return problems;
}

void print(const std::string& file, const std::vector<ClipProblem>& problems) {
    if (problems.empty()) fmt::print("{}: no problem found\n", file);
    for (const ClipProblem& problem : problems) {
        // A reader's error names the file itself.
        const std::string where = problem.text.starts_with(file) ? "" : file + ": ";
        fmt::print("{}: {}{}\n", problem.fatal ? "error" : "doubt", where, problem.text);
    }
}

Result<void> check(const ClipsCheckArguments& options) {
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());
    using Json = nlohmann::ordered_json;
    int unusable = 0;
    Json files = Json::array();
    for (const std::string& file : options.files) {
        const auto problems = problemsOf(file, options, *avatar);
        const bool usable =
            std::ranges::none_of(problems, [](const ClipProblem& problem) { return problem.fatal; });
        unusable += usable ? 0 : 1;
        if (!options.json) {
            print(file, problems);
            continue;
        }
        Json one{{"file", file}, {"usable", usable}, {"errors", Json::array()}, {"doubts", Json::array()}};
        for (const ClipProblem& problem : problems)
            one[problem.fatal ? "errors" : "doubts"].push_back(problem.text);
        files.push_back(std::move(one));
    }
    if (options.json) printAsJson(files);
    if (unusable == 0) return {};
    return fail("clips check", fmt::format("{} of {} {} cannot be used", unusable, options.files.size(),
                                           options.files.size() == 1 ? "file" : "files"));
}

}  // namespace

void addClipsCheckCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsCheckArguments>();
    Parser command =
        clips.addCommand("check", "List every problem of clip files, and whether they play on the avatar");
    describe(command, {.writes = "nothing; it prints the problems, and exits with 1 if there are any.",
                       .example = "deixis clips check clips/*.bvh",
                       .page = "docs/clip-format.md"});
    command.addOption("FILE", options->files, clip_file_kinds).required().expected(1, 1000000);
    addImportOptions(command, options->import);
    addJson(command, options->json, "Print JSON, an object for each file");
    command.callback([options, &chosen] { chosen = [options] { return check(*options); }; });
}

}  // namespace deixis::app
