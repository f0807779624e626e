// What stages with trials have: their design, scale, breaks and attention checks.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "studies/study_file/assumed_effects.hpp"
#include "study_reading.hpp"

namespace deixis::studies {

namespace {

constexpr std::string_view meetings[] = {"crossed", "nested"};

Crossing readMeeting(TomlTable& table, std::string_view key, Crossing fallback) {
    const std::optional<std::size_t> found = table.choice(key, meetings, false);
    return found ? static_cast<Crossing>(*found) : fallback;
}

void readSystemsOf(TomlTable& table, const Study& study, Stage& stage) {
    const std::vector<std::string_view> known = namesIn(study.systems);
    std::vector<std::string>& systems = stage.design.systems;
    systems = table.namesOf("systems", known, "[[systems]]", false);
    if (!table.has("systems")) systems.assign(known.begin(), known.end());
}

std::size_t levelsOf(const TrialDesign& design, std::string_view factor) {
    if (factor == "system") return design.systems.size();
    return factor == "layout" ? design.layouts.size() : design.distances.size();
}

void readBlocks(TomlTable& table, Stage& stage) {
    std::vector<std::string_view> factors{"layout"};
    const StageDeclaration& kind = declarationOf(stage.kind);
    if (kind.has("max_run_of_system")) factors.insert(factors.begin(), "system");
    if (kind.balls) factors.push_back("distance");
    TrialDesign& design = stage.design;
    if (const std::optional<std::size_t> found = table.choice("block_by", factors, false)) {
        design.block_by = factors[*found];
        const std::string list = design.block_by + "s";
        const std::size_t levels = levelsOf(design, design.block_by);
        if (levels == 1 && !table.faulty(list))
            table.problem(
                "block_by",
                fmt::format(
                    "found \"{}\", which has one level in this stage; expected a factor with two or more",
                    design.block_by));
    }
    constexpr std::string_view orders[] = {"williams", "shuffled", "listed"};
    if (const std::optional<std::size_t> order = table.choice("block_order", orders, false))
        design.block_order = static_cast<BlockOrder>(*order);
    if (!table.has("block_by")) table.reject("block_order", "without block_by");
}

/// The stage's trials; 0 where what they follow from is not sound.
long long countedTrials(const TomlTable& table, const Stage& stage) {
    const bool sound = table.sound("items") && !table.faulty("systems") && !table.faulty("layouts") &&
                       !table.faulty("distances");
    return sound ? trialsOf(stage) : 0;
}

void readConstraints(TomlTable& table, Stage& stage) {
    TrialDesign& design = stage.design;
    design.max_run_of_system = table.count("max_run_of_system", 0, 100, 0);
    design.no_target_twice_running = table.flag("no_target_twice_running", false);
    const long long trials = countedTrials(table, stage);
    if (design.block_by == "system")
        table.reject("max_run_of_system", "with block_by = \"system\"");
    else if (design.max_run_of_system > 0 && design.systems.size() == 1 && trials > design.max_run_of_system)
        table.problem("max_run_of_system",
                      fmt::format("found {}, expected 0: the stage has {} trials, all of one system",
                                  design.max_run_of_system, trials));
    if (design.no_target_twice_running && design.items == 1 && trials > 1)
        table.problem(
            "no_target_twice_running",
            fmt::format("found true, expected false: the stage has {} trials, all of one target", trials));
}

void readDesign(TomlTable& table, const Study& study, Stage& stage) {
    TrialDesign& design = stage.design;
    design.items = table.count("items", 1, 10000);
    readSystemsOf(table, study, stage);
    design.layouts = table.namesOf("layouts", namesIn(study.layouts), "[[layouts]]", true);
    const StageDeclaration& kind = declarationOf(stage.kind);
    if (const KindReader& reader = readerOf(stage.kind); reader.checkLevels != nullptr)
        reader.checkLevels(table, study, stage);
    design.layout_meets = readMeeting(table, "layout_meets", Crossing::nested);
    if (kind.has("system_meets")) design.system_meets = readMeeting(table, "system_meets", Crossing::crossed);
    if (kind.balls) {
        design.distances = table.namesOf("distances", namesIn(study.distances), "[[distances]]", true);
        design.distance_meets = readMeeting(table, "distance_meets", Crossing::nested);
    }
    readBlocks(table, stage);
    readConstraints(table, stage);
}

void readBreaks(TomlTable& table, Stage& stage) {
    stage.break_every = table.count("break_every", 0, 10000, 0);
    if (stage.break_every > 0) {
        stage.break_text = table.text("break_text");
        stage.break_minimum_s = table.number("break_minimum_s", 0.0, 3600.0, 0.0);
    } else if (!table.faulty("break_every")) {
        table.reject("break_text", "without break_every");
        table.reject("break_minimum_s", "without break_every");
    }
}

/// How far two answers to a trial can be apart.
double widestDifference(const Study& study, const Stage& stage) {
    const std::vector<StudyMeasure> asked = measuresOf(study, stage);
    return asked.empty() ? 0.0 : std::abs(asked.front().high - asked.front().low);
}

AttentionChecks readCheck(TomlTable& table, const Study& study, const Stage& stage, long long trials) {
    AttentionChecks checks;
    checks.count = table.count("count", 1, 100, checks.count);
    constexpr std::string_view rules[] = {"note", "warn", "exclude", "end"};
    checks.rule = static_cast<CheckRule>(table.choice("rule", rules, false).value_or(0));
    if (checks.rule != CheckRule::note)
        checks.after_failures = table.count("after_failures", 1, 100, 1);
    else if (!table.faulty("rule"))
        table.reject("after_failures", "with the rule \"note\"");
    if (!table.faulty("count") && !table.faulty("after_failures") && checks.after_failures > checks.count)
        table.problem("after_failures",
                      fmt::format("found {}, expected at most count ({}): the rule would never apply",
                                  checks.after_failures, checks.count));

    std::vector<std::string_view> possible;
    for (const CheckKind kind : declarationOf(stage.kind).checks) possible.push_back(checkKindName(kind));
    const std::optional<std::size_t> kind = table.choice("kind", possible, true);
    if (!kind) return checks;
    checks.kind = declarationOf(stage.kind).checks[*kind];
    if (checks.kind == CheckKind::catch_trial) {
        table.reject("tolerance", "with a catch trial");
        checks.distance = table.name("distance");
        if (table.sound("distance"))
            table.checkKnown("distance", checks.distance, namesIn(study.distances), "[[distances]]");
        return checks;
    }
    table.reject("distance", "with a check that is not a catch trial");
    checks.tolerance = table.number("tolerance", 0.0, widestDifference(study, stage), 0.0);
    if (trials > 0 && !table.faulty("count") && checks.count > trials)
        table.problem("count", fmt::format("found {}, expected at most {}, the trials of the stage",
                                           checks.count, trials));
    return checks;
}

/// Numbers and repeats, and the trials that are repeated, are trials apart from each other.
void readChecks(TomlTable& table, const Study& study, Stage& stage) {
    const long long trials = countedTrials(table, stage);
    long long taken = 0;
    bool sound = trials > 0;
    for (const toml::table* section : table.sections("checks", false)) {
        TomlTable below = table.below("checks", section, keys::checks);
        AttentionChecks checks = readCheck(below, study, stage, trials);
        if (!below.faulty("kind") &&
            std::any_of(stage.checks.begin(), stage.checks.end(),
                        [&](const auto& other) { return other.kind == checks.kind; }))
            below.problem("kind",
                          fmt::format("found \"{}\" a second time in the stage, expected each kind once",
                                      checkKindName(checks.kind)));
        stage.checks.push_back(std::move(checks));
        sound = sound && !below.faulty("count");
        if (stage.checks.back().kind != CheckKind::catch_trial) taken += stage.checks.back().count;
    }
    if (sound && taken > trials)
        table.problem("checks",
                      fmt::format("found {} numbers and repeats together, expected at most {}, the trials "
                                  "of the stage",
                                  taken, trials));
}

}  // namespace

long long trialsOf(const Stage& stage) {
    const TrialDesign& design = stage.design;
    const auto crossed = [](Crossing meeting, std::size_t levels) {
        return meeting == Crossing::crossed ? static_cast<long long>(levels) : 1;
    };
    const StageDeclaration& kind = declarationOf(stage.kind);
    const std::size_t shown = kind.shown(static_cast<int>(design.systems.size())).size();
    long long trials = design.items * crossed(design.system_meets, shown);
    trials *= crossed(design.layout_meets, design.layouts.size());
    if (kind.balls) trials *= crossed(design.distance_meets, design.distances.size());
    return trials;
}

void readTrials(TomlTable& table, StageReading& reading, Stage& stage) {
    const StageDeclaration& kind = declarationOf(stage.kind);
    const Study& study = reading.reader.study;
    readDesign(table, study, stage);
    stage.question = table.text("question");
    stage.plays = table.count("plays", 1, 10, stage.plays);
    stage.muted = table.flag("muted", stage.muted);
    if (kind.has("scale")) stage.scale = readScale(table, "scale");
    if (kind.has("measure")) stage.measure = table.name("measure", stage.name);
    // The report has one table of each name.
    if (kind.has("scale") && (stage.measure == "accuracy" || stage.measure == "preference"))
        table.problem(
            "measure",
            fmt::format("found \"{}\", the report's name for {}; expected another name", stage.measure,
                        stage.measure == "accuracy" ? "correct choices of the game" : "answers to pairs"));
    if (kind.has("max_replays")) stage.max_replays = table.count("max_replays", 0, 100, 0);
    readBreaks(table, stage);
    readChecks(table, study, stage);
}

}  // namespace deixis::studies
