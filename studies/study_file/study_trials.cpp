// What stages with trials have: their design, scale, breaks and attention checks.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "studies/study_file/standing.hpp"
#include "study_reading.hpp"

namespace deixis::studies {

namespace {

constexpr std::string_view meetings[] = {"crossed", "nested"};

Meeting readMeeting(TomlTable& table, std::string_view key, Meeting fallback) {
    const std::optional<std::size_t> found = table.choice(key, meetings, false);
    return found ? static_cast<Meeting>(*found) : fallback;
}

void readSystemsOf(TomlTable& table, const Study& study, Stage& stage) {
    const std::vector<std::string_view> known = namesIn(study.systems);
    std::vector<std::string>& systems = stage.design.systems;
    systems = table.namesOf("systems", known, "[[systems]]", false);
    if (!table.has("systems")) systems.assign(known.begin(), known.end());
    if (table.faulty("systems") || systems.empty()) return;
    if (stage.kind == StageKind::pairwise && systems.size() < 2)
        table.problem("systems", "found 1 system, expected 2 or more: a pair has two");
    constexpr std::size_t most = 6;
    if (stage.kind == StageKind::parallel_rating && (systems.size() < 2 || systems.size() > most))
        table.problem("systems", fmt::format("found {} system{}, expected 2 to {}: they stand on one page",
                                             systems.size(), systems.size() == 1 ? "" : "s", most));
}

/// A pair stands to either side of the line of sight: none of the two on the participant's place.
void checkRoomForPair(TomlTable& table, const Study& study, const std::vector<std::string>& layouts) {
    constexpr double least_m = 1.0;
    for (const std::string& name : layouts) {
        const Layout* layout = study.findLayout(name);
        if (layout == nullptr || table.faulty("layouts")) continue;
        for (const Standing standing : {Standing::headset, Standing::desktop}) {
            const Pose viewer = viewerPose(viewerPlace(*layout, standing));
            for (const Vec3& place : pairPlaces(viewer))
                if (const double away_m = glm::length(place - viewer.position); away_m < least_m) {
                    table.problem(
                        "layouts",
                        fmt::format("found \"{}\", where one avatar of a pair would stand {:.2f} m from the "
                                    "participant; expected a layout with at least {} m",
                                    name, away_m, least_m));
                    return;
                }
        }
    }
}

std::size_t levelsOf(const TrialDesign& design, std::string_view factor) {
    if (factor == "system") return design.systems.size();
    return factor == "layout" ? design.layouts.size() : design.distances.size();
}

void readBlocks(TomlTable& table, Stage& stage) {
    std::vector<std::string_view> factors{"layout"};
    if (stageHasKey(static_cast<std::size_t>(stage.kind), "max_run_of_system"))
        factors.insert(factors.begin(), "system");
    if (stage.kind == StageKind::game) factors.push_back("distance");
    TrialDesign& design = stage.design;
    if (const std::optional<std::size_t> found = table.choice("block_by", factors, false)) {
        design.block_by = factors[*found];
        const std::string list = design.block_by + "s";
        const std::size_t levels = levelsOf(design, design.block_by);
        if (levels == 1 && !table.faulty(list))
            table.problem("block_by",
                          fmt::format("found \"{}\", of which the stage has one level; expected a "
                                      "factor with two or more",
                                      design.block_by));
    }
    constexpr std::string_view orders[] = {"williams", "shuffled", "listed"};
    if (const std::optional<std::size_t> order = table.choice("block_order", orders, false))
        design.block_order = static_cast<BlockOrder>(*order);
    if (!table.has("block_by")) table.refuse("block_order", "without block_by");
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
        table.refuse("max_run_of_system", "with block_by = \"system\"");
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
    if (stage.kind == StageKind::pairwise) checkRoomForPair(table, study, design.layouts);
    design.layout_meets = readMeeting(table, "layout_meets", Meeting::nested);
    if (stage.kind != StageKind::parallel_rating)
        design.system_meets = readMeeting(table, "system_meets", Meeting::crossed);
    if (stage.kind == StageKind::game) {
        design.distances = table.namesOf("distances", namesIn(study.distances), "[[distances]]", true);
        design.distance_meets = readMeeting(table, "distance_meets", Meeting::nested);
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
        table.refuse("break_text", "without break_every");
        table.refuse("break_minimum_s", "without break_every");
    }
}

/// The kinds of checks that a stage may have.
std::vector<std::string_view> checksOf(StageKind kind) {
    switch (kind) {
        case StageKind::rating:
        case StageKind::parallel_rating:
            return {"number", "repeat"};
        case StageKind::pairwise:
            return {"repeat"};
        default:
            return {"catch"};
    }
}

AttentionChecks readCheck(TomlTable& table, const Study& study, const Stage& stage, long long trials) {
    AttentionChecks checks;
    constexpr std::string_view all[] = {"number", "catch", "repeat"};
    checks.count = table.count("count", 1, 100, checks.count);
    constexpr std::string_view rules[] = {"note", "warn", "exclude", "end"};
    checks.rule = static_cast<CheckRule>(table.choice("rule", rules, false).value_or(0));
    if (checks.rule != CheckRule::note)
        checks.after_failures = table.count("after_failures", 1, 100, 1);
    else if (!table.faulty("rule"))
        table.refuse("after_failures", "with the rule \"note\"");
    if (!table.faulty("count") && !table.faulty("after_failures") && checks.after_failures > checks.count)
        table.problem("after_failures",
                      fmt::format("found {}, expected at most count ({}): the rule would never hold",
                                  checks.after_failures, checks.count));

    const std::vector<std::string_view> possible = checksOf(stage.kind);
    const std::optional<std::size_t> kind = table.choice("kind", possible, true);
    if (!kind) return checks;
    checks.kind = static_cast<CheckKind>(std::find(std::begin(all), std::end(all), possible[*kind]) - all);
    if (checks.kind == CheckKind::catch_trial) {
        table.refuse("tolerance", "with a catch trial");
        checks.distance = table.name("distance");
        if (table.sound("distance"))
            table.checkKnown("distance", checks.distance, namesIn(study.distances), "[[distances]]");
        return checks;
    }
    table.refuse("distance", "with a check that is no catch trial");
    const double widest =
        stage.kind == StageKind::pairwise ? 4.0 : std::abs(stage.scale.high - stage.scale.low);
    checks.tolerance = table.number("tolerance", 0.0, widest, 0.0);
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

Question readConfidence(TomlTable& parent) {
    TomlTable table = parent.below("confidence", parent.section("confidence", true), keys::confidence);
    Question question;
    question.id = "confidence";
    question.text = table.text("text");
    question.scale = readScale(table, "scale");
    return question;
}

Question readReasons(TomlTable& parent) {
    TomlTable table = parent.below("reasons", parent.section("reasons", true), keys::reasons);
    Question question;
    question.id = "reasons";
    question.text = table.text("text");
    question.required = table.flag("required", true);
    constexpr std::string_view kinds[] = {"choice", "choices", "text"};
    constexpr QuestionKind values[] = {QuestionKind::choice, QuestionKind::choices, QuestionKind::text};
    question.kind = values[table.choice("kind", kinds, false).value_or(1)];
    if (question.kind != QuestionKind::text)
        question.options = readOptions(table);
    else
        table.refuse("options", "in a question of kind \"text\"");
    return question;
}

}  // namespace

long long trialsOf(const Stage& stage) {
    const TrialDesign& design = stage.design;
    const auto crossed = [](Meeting meeting, std::size_t levels) {
        return meeting == Meeting::crossed ? static_cast<long long>(levels) : 1;
    };
    const std::size_t n = design.systems.size();
    long long trials = design.items;
    if (stage.kind != StageKind::parallel_rating)
        trials *= crossed(design.system_meets, stage.kind == StageKind::pairwise ? n * (n - 1) / 2 : n);
    trials *= crossed(design.layout_meets, design.layouts.size());
    if (stage.kind == StageKind::game) trials *= crossed(design.distance_meets, design.distances.size());
    return trials;
}

void readTrials(TomlTable& table, const Study& study, Stage& stage) {
    readDesign(table, study, stage);
    stage.question = table.text("question");
    stage.plays = table.count("plays", 1, 10, stage.plays);
    const bool rating = stage.kind == StageKind::rating || stage.kind == StageKind::parallel_rating;
    if (rating) stage.scale = readScale(table, "scale");
    if (stage.kind != StageKind::game) stage.measure = table.name("measure", stage.name);
    // The report has one table of each name.
    if (rating && (stage.measure == "accuracy" || stage.measure == "preference"))
        table.problem(
            "measure",
            fmt::format("found \"{}\", which the report calls {} so; expected another name", stage.measure,
                        stage.measure == "accuracy" ? "right choices of the game" : "answers to pairs"));
    if (stage.kind == StageKind::rating || stage.kind == StageKind::game)
        stage.max_replays = table.count("max_replays", 0, 100, 0);
    readBreaks(table, stage);
    readChecks(table, study, stage);
    if (stage.kind == StageKind::game) {
        stage.feedback = table.flag("feedback", false);
        stage.time_limit_s = table.number("time_limit_s", 0.0, 600.0, 0.0);
        if (table.has("confidence")) stage.confidence = readConfidence(table);
    }
    if (stage.kind == StageKind::pairwise && table.has("reasons")) stage.reasons = readReasons(table);
}

}  // namespace deixis::studies
