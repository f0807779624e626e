// deixis check: every problem of a study file at once.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

#include "app/clips/study_clips.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/study/angles_text.hpp"
#include "app/study/visibility_text.hpp"
#include "app/study_commands/study_commands.hpp"
#include "assets/tables/manifest.hpp"
#include "studies/design/plan.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

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
    for (const auto& system : study.systems) {
        const std::string key = "systems." + system.name;
        warnPath(key, system.manifest);
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

Result<void> failWith(const std::string& study, const std::vector<Error>& problems) {
    for (const Error& problem : problems) fmt::print(stderr, "{}\n", problem.text());
    return fail(study,
                fmt::format("has {} {}", problems.size(), problems.size() == 1 ? "problem" : "problems"));
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
        for (const std::string& name : plan.stages) {
            int trials = 0, stimuli = 0, checks = 0;
            for (const auto& trial : plan.trials) {
                if (trial.stage != name) continue;
                ++trials;
                stimuli += static_cast<int>(trial.stimuli.size());
                checks += trial.check.has_value();
            }
            const studies::Stage& stage = *study.findStage(name);
            fmt::print("  {} ({})", name, stage.practice ? "practice" : studies::stageKindName(stage.kind));
            if (stimuli > 0)
                fmt::print(": {} trials, {} clips{}", trials, stimuli,
                           checks > 0 ? fmt::format(", {} attention checks", checks) : "");
            fmt::print("\n");
        }
    }
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

Result<void> check(const std::string& name) {
    const auto setup = checkStudySetup(name);
    if (!setup) return failWith(name, setup.error());
    std::vector<Error> problems;
    const auto avatar = loadStudyAvatar(setup->study);
    if (!avatar) problems.push_back(avatar.error());
    // As the first run does, which takes them.
    const auto nothing = [](const studies::SystemSource&, const StudyClip&) { return Result<void>(); };
    for (Error& problem : readStudyClips({*setup, avatar ? &*avatar : nullptr}, nothing))
        problems.push_back(std::move(problem));
    const auto plans = plansOf(*setup);
    if (!plans) problems.push_back(plans.error());
    if (!problems.empty()) return failWith(name, problems);
    describe(*setup, *avatar, *plans);
    for (const std::string& warning : warningsOf(setup->study)) fmt::print("doubtful: {}\n", warning);
    return {};
}

}  // namespace

void addCheckCommand(Parser cli, Command& chosen) {
    auto study = std::make_shared<std::string>();
    Parser command = cli.addCommand("check", "Check a study file: every problem, in every language");
    describe(command, {.writes = "nothing; it prints what the study contains, or its mistakes.",
                       .example = "deixis check my-study.toml",
                       .page = "docs/study-file.md"});
    command.addOption("STUDY", *study, "Study file, or the name of one included").required();
    command.callback([study, &chosen] { chosen = [study] { return check(*study); }; });
}

}  // namespace deixis::app
