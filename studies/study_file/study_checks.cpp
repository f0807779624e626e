// What stages have to do with each other and with the targets.
#include <fmt/format.h>

#include <algorithm>

#include "study_reading.hpp"

namespace deixis::studies {

namespace {

bool hasTrials(const StageEntry& entry) {
    return entry.kind != nullptr && entry.kind->showsClips();
}

/// A practice stage is as the one that it practises, but for what its own table says.
Stage practiceOf(const Stage& of, const Stage& own, TomlTable& table) {
    Stage stage = of;
    stage.name = own.name;
    stage.session = own.session;
    if (table.has("when")) stage.when = own.when;
    stage.practice = own.practice;
    stage.design.items = own.design.items;
    stage.checks.clear();
    stage.break_every = 0;
    stage.break_text.clear();
    stage.break_minimum_s = 0.0;
    if (declarationOf(of.kind).has("feedback")) stage.feedback = table.flag("feedback", of.feedback);
    return stage;
}

void finishPractice(StageEntry& entry, const std::deque<StageEntry>& stages) {
    TomlTable& table = entry.table;
    if (!table.sound("of")) return;
    std::vector<std::string_view> known;
    const StageEntry* of = nullptr;
    bool later = false;
    for (const StageEntry& other : stages) {
        if (&other == &entry) later = true;
        if (!hasTrials(other)) continue;
        known.push_back(other.stage.name);
        if (other.stage.name != entry.stage.practice->of) continue;
        of = &other;
        if (!later) {
            table.problem("of",
                          fmt::format("found \"{}\", which comes before its practice; expected a later stage",
                                      other.stage.name));
            return;
        }
        break;
    }
    if (of == nullptr) {
        table.problem("of", fmt::format("there is no stage \"{}\" with trials", entry.stage.practice->of),
                      known.empty() ? "" : proposeName(entry.stage.practice->of, known));
        return;
    }
    if (of->kind->in_studio) {
        table.problem("of",
                      fmt::format("found \"{}\" of kind \"{}\", which has its practice by practice_per_block",
                                  of->stage.name, of->kind->name));
        return;
    }
    if (!of->kind->right_or_wrong) {
        for (const std::string_view key : {"criterion", "max_attempts", "end_if_failed", "again_text"})
            table.reject(key,
                         fmt::format("in practice of a stage of kind \"{}\", whose answers are neither right "
                                     "nor wrong",
                                     of->kind->name));
    }
    if (!of->kind->has("feedback"))
        table.reject("feedback", fmt::format("in practice of a stage of kind \"{}\"", of->kind->name));
    if (table.sound("when"))
        for (const auto& [factor, level] : of->stage.when) {
            const auto found = entry.stage.when.find(factor);
            if (found == entry.stage.when.end() || found->second != level)
                table.problem("when", fmt::format("expected {} = \"{}\", as in the stage practised (\"{}\")",
                                                  factor, level, of->stage.name));
        }
    entry.stage = practiceOf(of->stage, entry.stage, table);
}

/// Whether no participant has both.
bool exclusive(const Stage& a, const Stage& b) {
    return std::any_of(a.when.begin(), a.when.end(), [&](const auto& pair) {
        const auto other = b.when.find(pair.first);
        return other != b.when.end() && other->second != pair.second;
    });
}

/// A field of the participant comes from one question.
void checkFields(std::deque<StageEntry>& stages) {
    for (auto later = stages.begin(); later != stages.end(); ++later) {
        if (!later->stage.about_participant) continue;
        for (auto before = stages.begin(); before != later; ++before) {
            if (!before->stage.about_participant || exclusive(before->stage, later->stage)) continue;
            for (const Question& question : later->stage.questionnaire.questions)
                if (before->stage.questionnaire.find(question.id) != nullptr)
                    later->table.problem("about_participant",
                                         fmt::format("the field \"{}\" of a participant already comes from "
                                                     "the stage \"{}\"; expected other ids",
                                                     question.id, before->stage.name));
        }
    }
}

/// A participant rates a system once by a measure.
void checkRated(std::deque<StageEntry>& stages) {
    std::map<std::pair<std::string, std::string>, std::string> before;
    for (StageEntry& entry : stages)
        for (const Question& question : entry.stage.questionnaire.questions) {
            if (!question.rates) continue;
            const auto [known, is_new] =
                before.emplace(std::pair(question.rates->measure, question.rates->system), question.id);
            if (!is_new)
                entry.table.problem(
                    "questions",
                    fmt::format("\"{}\" and \"{}\" both rate {} by {}, expected one question", known->second,
                                question.id, question.rates->system, question.rates->measure));
        }
}

/// Targets that a stage takes for one participant.
long long targetsOf(const Stage& stage) {
    long long targets = stage.design.items;
    if (stage.practice) targets *= stage.practice->max_attempts;
    for (const AttentionChecks& checks : stage.checks)
        if (checks.kind == CheckKind::catch_trial) targets += checks.count;
    return targets;
}

/// Calls `visit` with every combination of levels.
template <typename Visit>
void forEachGroup(const std::vector<BetweenFactor>& factors, std::size_t from,
                  std::map<std::string, std::string>& group, const Visit& visit) {
    if (from == factors.size()) {
        visit(group);
        return;
    }
    for (const std::string& level : factors[from].levels) {
        group[factors[from].name] = level;
        forEachGroup(factors, from + 1, group, visit);
    }
}

void checkEnoughTargets(StudyReader& reader, const std::deque<StageEntry>& stages) {
    const toml::table* section = reader.file["targets"].as_table();
    if (section == nullptr || reader.study.targets.count == 0 || !section->contains("count")) return;
    long long max = 0;
    std::string list;
    std::map<std::string, std::string> group;
    forEachGroup(reader.study.between, 0, group, [&](const std::map<std::string, std::string>& levels) {
        long long needed = 0;
        std::string terms;
        for (const StageEntry& entry : stages) {
            const Stage& stage = entry.stage;
            const bool applies = std::all_of(stage.when.begin(), stage.when.end(), [&](const auto& pair) {
                const auto found = levels.find(pair.first);
                return found != levels.end() && found->second == pair.second;
            });
            if (!applies || !showsClips(stage.kind)) continue;
            if (entry.table.faulty("items")) continue;
            needed += targetsOf(stage);
            terms += fmt::format("{}{} ({})", terms.empty() ? "" : ", ", stage.name, targetsOf(stage));
        }
        if (needed <= max) return;
        max = needed;
        list = terms;
    });
    if (max <= reader.study.targets.count) return;
    const toml::source_position at = section->get("count")->source().begin;
    reader.problems.add(
        at, "targets.count",
        fmt::format(
            "found {}, expected at least {}: each of a participant's stages uses separate targets: {}",
            reader.study.targets.count, max, list));
}

}  // namespace

void finishStages(StudyReader& reader, std::deque<StageEntry>& stages) {
    for (StageEntry& entry : stages)
        if (entry.stage.practice) finishPractice(entry, stages);
    checkFields(stages);
    checkRated(stages);
    checkEnoughTargets(reader, stages);
}

}  // namespace deixis::studies
