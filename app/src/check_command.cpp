// deixis check: every problem of a study file at once.
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "assets/manifest.hpp"
#include "commands.hpp"
#include "studies/plan.hpp"
#include "study_setup.hpp"
#include "visibility_text.hpp"

namespace deixis::app {

namespace {

// Each cell of the factors between participants.
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

// The lab's clips that the study names.
void checkManifests(const StudySetup& setup, std::vector<Error>& problems) {
    for (const auto& system : setup.study.systems) {
        if (system.manifest.empty()) continue;
        const auto manifest = assets::readManifest(system.manifest);
        if (!manifest) {
            problems.push_back(manifest.error());
            continue;
        }
        for (const auto& row : manifest->rows) {
            std::error_code code;
            if (!std::filesystem::is_regular_file(manifest->file.parent_path() / row.clip, code))
                problems.push_back({manifest->file.string() + ": clip " + row.clip, "No such file",
                                    "Clips are looked for beside their manifest"});
        }
    }
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
    fmt::print("{}", visibilityText(setup, avatar));
}

Result<void> check(const std::string& name) {
    const auto setup = checkStudySetup(name);
    if (!setup) return failWith(name, setup.error());
    std::vector<Error> problems;
    checkManifests(*setup, problems);
    const auto avatar = loadStudyAvatar(setup->study);
    if (!avatar) problems.push_back(avatar.error());
    const auto plans = plansOf(*setup);
    if (!plans) problems.push_back(plans.error());
    if (!problems.empty()) return failWith(name, problems);
    describe(*setup, *avatar, *plans);
    return {};
}

}  // namespace

void addCheckCommand(CLI::App& cli, Command& chosen) {
    auto study = std::make_shared<std::string>();
    CLI::App* command = cli.add_subcommand("check", "Check a study file: every problem, in every language");
    command->add_option("STUDY", *study, "Study file, or the name of one that ships")->required();
    command->callback([study, &chosen] { chosen = [study] { return check(*study); }; });
}

}  // namespace deixis::app
