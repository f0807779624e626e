// The stages: what each one's own table tells.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

#include "study_reading.hpp"

namespace deixis::studies {

#define DEIXIS_KIND(name) extern const KindReader name##_reader;
DEIXIS_STAGE_KINDS(DEIXIS_KIND)
#undef DEIXIS_KIND

const KindReader& readerOf(StageKind kind) {
#define DEIXIS_KIND(name) &name##_reader,
    static constexpr const KindReader* readers[] = {DEIXIS_STAGE_KINDS(DEIXIS_KIND)};
#undef DEIXIS_KIND
    return *readers[static_cast<std::size_t>(kind)];
}

namespace {

namespace fs = std::filesystem;

/// A key that other kinds have is a problem of its own, with the kinds that have it.
/// `kind` null: practice.
void rejectOtherKinds(TomlTable& table, const StageDeclaration* kind) {
    const Keys known = stageKeys();
    for (const std::string_view key : table.keys()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) continue;
        if (kind != nullptr ? kind->has(key) : practiceHas(key)) continue;
        std::vector<std::string> kinds;
        for (const StageDeclaration* other : allDeclarations())
            if (other->has(key)) kinds.push_back(fmt::format("\"{}\"", other->name));
        if (practiceHas(key)) kinds.push_back(fmt::format("\"{}\"", practice_name));
        table.problem(key, fmt::format("found in a stage of kind \"{}\", expected in {} only",
                                       kind != nullptr ? kind->name : practice_name, fmt::join(kinds, ", ")));
    }
}

Practice readPractice(TomlTable& table) {
    Practice practice;
    practice.of = table.name("of");
    practice.criterion = table.number("criterion", 0.0, 1.0, 0.0);
    practice.max_attempts = table.count("max_attempts", 1, 10, 1);
    practice.end_if_failed = table.flag("end_if_failed", false);
    if (practice.max_attempts > 1)
        practice.again_text = table.text("again_text");
    else if (!table.faulty("max_attempts"))
        table.reject("again_text", "without max_attempts over 1");
    if (practice.criterion == 0.0 && !table.faulty("criterion")) {
        if (practice.max_attempts > 1)
            table.problem(
                "max_attempts",
                fmt::format(
                    "found {}, expected 1 without a criterion: only a criterion leads to a further attempt",
                    practice.max_attempts));
        table.reject("end_if_failed", "without a criterion");
    }
    return practice;
}

void readWhen(TomlTable& table, const Study& study, Stage& stage) {
    stage.when = table.levels("when");
    const std::vector<std::string_view> factors = namesIn(study.between);
    for (const auto& [name, level] : stage.when) {
        const auto factor =
            std::find_if(study.between.begin(), study.between.end(),
                         [&, wanted = name](const BetweenFactor& entry) { return entry.name == wanted; });
        if (factor == study.between.end()) {
            table.problemAt("when", name, fmt::format("there is no factor \"{}\" in [[between]]", name),
                            factors.empty() ? "" : proposeName(name, factors));
        } else if (!factor->levels.empty() &&
                   std::find(factor->levels.begin(), factor->levels.end(), level) == factor->levels.end()) {
            table.problemAt(
                "when", name, fmt::format("there is no level \"{}\" of \"{}\" in [[between]]", level, name),
                proposeName(level,
                            std::vector<std::string_view>(factor->levels.begin(), factor->levels.end())));
        }
    }
}

void readSession(TomlTable& table, int before, Stage& stage) {
    stage.session = table.count("session", 1, 100, before == 0 ? 1 : before);
    if (!table.sound("session") || stage.session == before || stage.session == before + 1) {
        if (table.faulty("session")) stage.session = std::max(before, 1);
        return;
    }
    table.problem("session", before == 0
                                 ? fmt::format("found {}, expected 1 in the first stage", stage.session)
                             : stage.session < before
                                 ? fmt::format("found {}, expected {} or {}: session numbers do not decrease",
                                               stage.session, before, before + 1)
                                 : fmt::format("found {}, expected {} or {}: session numbers have no gaps",
                                               stage.session, before, before + 1));
}

/// A visit that asks nothing would count as answered before it began.
void rejectSessionsOfPages(std::deque<StageEntry>& stages) {
    const auto asks = [](const StageEntry& one) {
        return one.stage.practice || (one.kind != nullptr && one.kind->answered);
    };
    for (std::size_t i = 1; i < stages.size(); ++i) {
        const int session = stages[i].stage.session;
        if (session == stages[i - 1].stage.session) continue;
        if (std::none_of(stages.begin(), stages.end(), [&](const StageEntry& other) {
                return other.stage.session == session && (asks(other) || !other.known);
            }))
            stages[i].table.problem(
                "session", fmt::format("session {} asks nothing, expected a stage with answers", session),
                "Move its pages to the end of the session before");
    }
}

}  // namespace

std::deque<StageEntry> readStages(StudyReader& reader) {
    StageReading reading{reader};
    std::vector<std::string_view> kind_names;
    for (const StageDeclaration* kind : allDeclarations()) kind_names.push_back(kind->name);
    kind_names.push_back(practice_name);
    std::deque<StageEntry> out;
    int session = 0;
    for (const toml::table* section : reader.root.sections("stages", true)) {
        TomlTable table = reader.root.below("stages", section, stageKeys());
        Stage stage;
        stage.name = table.name("name");
        if (!stage.name.empty() && std::any_of(out.begin(), out.end(), [&](const StageEntry& other) {
                return other.stage.name == stage.name;
            }))
            table.problem("name", fmt::format("\"{}\" occurs twice, expected a unique name", stage.name));
        readSession(table, session, stage);
        session = stage.session;
        readWhen(table, reader.study, stage);
        const std::optional<std::size_t> chosen = table.choice("kind", kind_names, true);
        const StageDeclaration* kind = findDeclaration(chosen ? kind_names[*chosen] : "");
        if (chosen) rejectOtherKinds(table, kind);
        if (kind != nullptr) {
            stage.kind = *stageKindFromName(kind->name);
            readerOf(stage.kind).read(table, reading, stage);
        } else if (chosen) {
            stage.practice = readPractice(table);
            stage.design.items = table.count("items", 1, 10000);
        }
        out.push_back({std::move(table), kind, chosen.has_value(), std::move(stage)});
    }
    rejectSessionsOfPages(out);
    return out;
}

}  // namespace deixis::studies
