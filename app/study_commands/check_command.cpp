// deixis check: every problem of a study file at once.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "app/clips/project_folder.hpp"
#include "app/clips/study_clips.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "app/study/angles_text.hpp"
#include "app/study/visibility_text.hpp"
#include "app/study_commands/study_commands.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/tables/manifest.hpp"
#include "studies/design/plan.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct CheckArguments {
    std::string study;
    bool json = false;
};

// Each cell of the between-participants factors.
std::vector<studies::Groups> cells(const studies::Study& study) {
    std::vector<studies::Groups> out{{}};
    for (const auto& factor : study.between) {
        std::vector<studies::Groups> next;
        for (const auto& cell : out)
            for (const auto& level : factor.levels) {
                next.push_back(cell);
                next.back()[factor.name] = level;
            }
        out = std::move(next);
    }
    return out;
}

// Whether every group's plan can be built; the plans of the first participant in each.
Result<std::vector<studies::StudyPlan>> plansOf(const StudySetup& setup) {
    std::vector<studies::StudyPlan> plans;
    for (const auto& cell : cells(setup.study)) {
        auto plan = studies::buildPlan(setup.study, setup.targets, "P1", 1, cell);
        if (!plan) {
            Error error = plan.error();
            if (error.where.empty()) error.where = setup.study.file.string();
            return tl::unexpected(error);
        }
        plans.push_back(std::move(*plan));
    }
    return plans;
}

// What need not be wrong, but would be noticed late.
std::vector<std::string> warningsOf(const studies::Study& study) {
    std::vector<std::string> out;
    const fs::path folder = fs::absolute(study.file).parent_path();
    const auto warnPath = [&](const std::string& key, const fs::path& file) {
        if (file.empty()) return;
        const fs::path relative = fs::absolute(file).lexically_normal().lexically_relative(folder);
        if (relative.empty() || *relative.begin() == "..")
            out.push_back(fmt::format(
                "{}: {} is outside the study's folder, which is then incomplete on another machine",
                study.place(key), file.string()));
    };
    warnPath("study.avatar", study.avatar);
    warnPath("targets.fit_manifest", study.targets.fit_manifest);
    warnPath("targets.from_manifest", study.targets.from_manifest);
    const auto warnProjects = [&](const std::string& key, const fs::path& projects) {
        if (projects.parent_path() != assets::dataFile("speeches")) warnPath(key, projects);
    };
    warnProjects("targets.from_projects", study.targets.from_projects);
    for (const auto& system : study.systems) {
        const std::string key = "systems." + system.name;
        warnPath(key, system.manifest);
        warnProjects(key, system.projects);
        if (system.manifest.empty()) continue;
        const auto manifest = assets::readManifest(system.manifest);
        if (!manifest) continue;
        for (const auto* row : rowsOfSystem(*manifest, system.name))
            if (fs::path(row->clip).is_absolute())
                out.push_back(fmt::format(
                    "{}: {}:{}: clip: {} is an absolute path, which may not exist on another machine",
                    study.place(key), system.manifest, row->line, row->clip));
    }
    constexpr double full_turn_rad = 6.2832;
    for (const auto& layout : study.layouts)
        if (std::abs(layout.heading_deg) <= full_turn_rad &&
            layout.heading_deg != std::round(layout.heading_deg))
            out.push_back(fmt::format("{}: {} looks like radians, expected degrees ({:.0f}?)",
                                      study.place("layouts." + layout.name), layout.heading_deg,
                                      layout.heading_deg * 57.29577951308232));
    return out;
}

using Json = nlohmann::ordered_json;

Result<void> failWith(const std::string& study, const std::vector<Error>& problems, bool json) {
    Json listed = Json::array();
    for (const Error& problem : problems)
        if (json)
            listed.push_back(
                {{"where", problem.where}, {"message", problem.message}, {"hint", problem.hint}});
        else
            fmt::print(stderr, "{}\n", problem.text());
    if (json) printAsJson({{"study", study}, {"problems", listed}});
    return fail(study,
                fmt::format("has {} {}", problems.size(), problems.size() == 1 ? "problem" : "problems"));
}

/// What a participant meets in a stage.
struct StageContents {
    std::string name;
    std::string kind;  ///< or "practice"
    int trials = 0;
    int clips = 0;
    int attention_checks = 0;
};

std::vector<StageContents> contentsOf(const studies::Study& study, const studies::StudyPlan& plan) {
    std::vector<StageContents> out;
    for (const std::string& name : plan.stages) {
        const studies::Stage& stage = *study.findStage(name);
        StageContents& of = out.emplace_back();
        of.name = name;
        of.kind = stage.practice ? "practice" : studies::stageKindName(stage.kind);
        for (const auto& trial : plan.trials) {
            if (trial.stage != name) continue;
            ++of.trials;
            of.clips += static_cast<int>(trial.stimuli.size());
            of.attention_checks += trial.check.has_value();
        }
    }
    return out;
}

void describeInJson(const StudySetup& setup, const std::vector<studies::StudyPlan>& plans) {
    const studies::Study& study = setup.study;
    Json languages = Json::object(), participants = Json::array();
    for (std::size_t i = 0; i < study.languages.size(); ++i)
        languages[study.languages[i]] = {{"words", studies::textStatusText(study.language_status[i].words)},
                                         {"texts", studies::textStatusText(study.language_status[i].texts)}};
    for (const studies::StudyPlan& plan : plans) {
        Json stages = Json::array();
        for (const StageContents& one : contentsOf(study, plan))
            stages.push_back({{"stage", one.name},
                              {"kind", one.kind},
                              {"trials", one.trials},
                              {"clips", one.clips},
                              {"attention_checks", one.attention_checks}});
        participants.push_back({{"groups", plan.groups}, {"stages", stages}});
    }
    printAsJson({{"study", study.file.string()},
                 {"problems", Json::array()},
                 {"doubts", warningsOf(study)},
                 {"languages", languages},
                 {"participants", participants}});
}

/// Systems whose clips are of projects, or that are not compared.
void describeSystems(const StudySetup& setup) {
    ProjectClips maker;
    for (const auto& system : setup.study.systems) {
        std::string about;
        if (!system.projects.empty())
            if (const auto projects = readProjects(system, setup.targets)) {
                std::set<std::string> made;
                for (const ItemProject& one : *projects) {
                    const std::string processing = maker.processing(one.project);
                    made.insert("by " + one.project.system + (processing.empty() ? "" : ", " + processing));
                }
                about = fmt::format("{} projects ({})", projects->size(), fmt::join(made, "; "));
            }
        if (!system.compared)
            about += fmt::format("{}not compared: {}", about.empty() ? "" : "; ", system.remark);
        if (!about.empty()) fmt::print("system {}: {}\n", system.name, about);
    }
}

void describe(const StudySetup& setup, const assets::Avatar& avatar,
              const std::vector<studies::StudyPlan>& plans) {
    const studies::Study& study = setup.study;
    fmt::print("{}: no problem found\n", study.file.string());
    if (!study.avatar.empty()) {
        fmt::print("avatar: {}, {} joints\n", study.avatar.string(), avatar.skeleton.size());
        for (const std::string& remark : avatar.remarks) fmt::print("  {}\n", remark);
    }
    for (std::size_t i = 0; i < study.languages.size(); ++i)
        fmt::print("language {}: the program's words are {}; the study's texts are {}\n", study.languages[i],
                   studies::textStatusText(study.language_status[i].words),
                   studies::textStatusText(study.language_status[i].texts));
    for (const auto& plan : plans) {
        std::string cell;
        for (const auto& [factor, level] : plan.groups) cell += fmt::format(" {} = {}", factor, level);
        fmt::print("a participant{}{}:\n", cell.empty() ? "" : " with", cell);
        for (const StageContents& one : contentsOf(study, plan)) {
            fmt::print("  {} ({})", one.name, one.kind);
            if (one.clips > 0)
                fmt::print(": {} trials, {} clips{}", one.trials, one.clips,
                           one.attention_checks > 0
                               ? fmt::format(", {} attention checks", one.attention_checks)
                               : "");
            fmt::print("\n");
        }
    }
    describeSystems(setup);
    for (const auto& system : study.systems) {
        std::vector<int> several;
        for (const auto& item : setup.targets)
            if (const auto of = item.clips.find(system.name); of != item.clips.end())
                several.push_back(of->second);
        if (several.empty()) continue;
        const auto [min, max] = std::minmax_element(several.begin(), several.end());
        fmt::print("clips: {} has {} for {} of {} items; a participant is shown one of them\n", system.name,
                   *min == *max ? fmt::format("{}", *min) : fmt::format("{} to {}", *min, *max),
                   several.size(), setup.targets.size());
    }
    fmt::print("{}{}", visibilityText(setup, avatar), anglesText(setup));
}

Result<void> check(const std::string& name, bool json) {
    const auto setup = checkStudySetup(name);
    if (!setup) return failWith(name, setup.error(), json);
    std::vector<Error> problems;
    const auto avatar = loadStudyAvatar(setup->study);
    if (!avatar) problems.push_back(avatar.error());
    // As the first run does, which takes them.
    const auto nothing = [](const studies::SystemSource&, const StudyClip&) { return Result<void>(); };
    for (Error& problem : readStudyClips({*setup, avatar ? &*avatar : nullptr}, nothing))
        problems.push_back(std::move(problem));
    const auto plans = plansOf(*setup);
    if (!plans) problems.push_back(plans.error());
    if (!problems.empty()) return failWith(name, problems, json);
    if (json) {
        describeInJson(*setup, *plans);
        return {};
    }
    describe(*setup, *avatar, *plans);
    for (const std::string& warning : warningsOf(setup->study)) fmt::print("doubtful: {}\n", warning);
    return {};
}

}  // namespace

void addCheckCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<CheckArguments>();
    Parser command = cli.addCommand("check", "Check a study file: every problem, in every language");
    describe(command, {.writes = "nothing; it prints what the study contains, or its mistakes.",
                       .example = "deixis check my-study.toml",
                       .page = "docs/study-file.md"});
    command.addOption("STUDY", options->study, "Study file, or the name of one included").required();
    addJson(command, options->json,
            "Print JSON: problems, doubts, and what each group of participants meets");
    command.callback(
        [options, &chosen] { chosen = [options] { return check(options->study, options->json); }; });
}

}  // namespace deixis::app
