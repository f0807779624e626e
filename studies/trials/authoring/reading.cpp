#include "study_reading.hpp"

namespace deixis::studies {

namespace authoring {
namespace {

constexpr double shortest_s = 1.0;
constexpr double longest_s = 14400.0;

/// A block that is practice alone would be for nothing.
void checkPractice(TomlTable& table, const Stage& stage) {
    if (table.faulty("practice_per_block") || table.faulty("items") || table.faulty("systems") ||
        table.faulty("block_by"))
        return;
    const TrialDesign& design = stage.design;
    const long long blocks = design.block_by == "system"   ? static_cast<long long>(design.systems.size())
                             : design.block_by == "layout" ? static_cast<long long>(design.layouts.size())
                                                           : 1;
    const long long shortest = trialsOf(stage) / std::max(blocks, 1LL);
    if (stage.authoring.practice_per_block > 0 && stage.authoring.practice_per_block >= shortest)
        table.problem("practice_per_block",
                      fmt::format("found {}, expected less than the {} trials of a block",
                                  stage.authoring.practice_per_block, shortest));
}

/// What authors begin with is a project.
void checkSystems(TomlTable& table, const Study& study, const Stage& stage) {
    for (const std::string& name : stage.design.systems) {
        const SystemSource* system = study.findSystem(name);
        if (system != nullptr && system->projects.empty())
            table.problem("systems",
                          fmt::format("found \"{}\", expected systems with projects, which are what "
                                      "authors begin with",
                                      name));
    }
}

void read(TomlTable& table, StageReading& reading, Stage& stage) {
    for (const char* key : {"plays", "muted", "checks"})
        table.reject(key, "in a stage of kind \"authoring\", which shows no clips");
    readTrials(table, reading, stage);
    AuthoringLimits& limits = stage.authoring;
    const std::vector<std::string_view> systems(stage.design.systems.begin(), stage.design.systems.end());
    limits.keyframes_only = table.namesOf("keyframes_only", systems, "the stage's systems", false);
    limits.practice_per_block = table.count("practice_per_block", 0, 100, 0);
    checkPractice(table, stage);
    limits.limit_s = table.number("limit_s", shortest_s, longest_s);
    limits.may_end_early = table.flag("may_end_early", false);
    limits.practice_limit_s = table.number("practice_limit_s", shortest_s, longest_s, limits.limit_s);
    limits.practice_may_end_early = table.flag("practice_may_end_early", limits.may_end_early);
    if (limits.practice_per_block == 0 && !table.faulty("practice_per_block"))
        for (const char* key : {"practice_limit_s", "practice_may_end_early"})
            table.reject(key, "without practice_per_block");
}

}  // namespace
}  // namespace authoring

extern const KindReader authoring_reader{authoring::read, authoring::checkSystems};

}  // namespace deixis::studies
