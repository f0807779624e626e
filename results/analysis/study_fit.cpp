#include "study_fit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace deixis::results {

std::string listed(const NameSet& names) {
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

const Measure* measureIn(const ResponseTable& table, const std::string& name) {
    for (const Measure& one : table.measures)
        if (one.name == name) return &one;
    return nullptr;
}

namespace {

NameSet answeredMeasures(const ResponseTable& table) {
    NameSet out;
    for (const ResponseRow& row : table.rows) out.insert(row.measure);
    return out;
}

NameSet answeredSystems(const ResponseTable& table) {
    NameSet out;
    for (const ResponseRow& row : table.rows) {
        out.insert(row.system);
        if (!row.other_system.empty()) out.insert(row.other_system);
    }
    return out;
}

/// "sgtoolkit2021 (relaxed.sqlite)"
std::string calledIn(const ResponseTable& table) {
    return fmt::format("{} ({})", table.study_name, table.database);
}

/// Every measure that is answered in the one is answered in the other, in the same way and on the same scale.
Result<void> checkMeasures(const ResponseTable& one, const ResponseTable& other) {
    const NameSet here = answeredMeasures(one);
    const NameSet there = answeredMeasures(other);
    NameSet shared;
    std::set_intersection(here.begin(), here.end(), there.begin(), there.end(),
                          std::inserter(shared, shared.end()));
    const auto keep = [&]() -> std::string {
        if (shared.empty())
            return fmt::format("The two have no measure in common: {} and {}", listed(here), listed(there));
        return fmt::format("Studies are compared in measures that all of them have: --measure {}",
                           fmt::join(shared, " --measure "));
    };
    for (const std::string& name : here) {
        const Measure& measure = *measureIn(one, name);
        const Measure* same = measureIn(other, name);
        if (!there.contains(name))
            return fail(other.database,
                        fmt::format("{} \"{}\", which {} has",
                                    same != nullptr ? "has no answers yet on" : "does not measure", name,
                                    calledIn(one)),
                        keep());
        if (measure.kind != same->kind)
            return fail(other.database,
                        fmt::format("\"{}\" has another kind of answers than in {}", name, calledIn(one)),
                        "Give the two measures different names");
        if (measure.kind != MeasureKind::rating || (measure.low == same->low && measure.high == same->high))
            continue;
        const bool of_files = one.study_hash.empty() || other.study_hash.empty();
        return fail(
            other.database,
            fmt::format("\"{}\" is rated from {:g} to {:g}, but from {:g} to {:g} in {}", name, same->low,
                        same->high, measure.low, measure.high, calledIn(one)),
            of_files ? fmt::format("Answers on different scales have no common mean. The scale of a "
                                   "CSV file is the range of its answers unless it is given: --scale "
                                   "{}={:g}..{:g}",
                                   name, std::min(measure.low, same->low), std::max(measure.high, same->high))
                     : std::string("Answers on different scales have no common mean"));
    }
    return {};
}

}  // namespace

Result<void> checkTogether(const std::vector<ResponseTable>& tables, const JoinChoice& choice) {
    const ResponseTable& first = tables.front();
    if (answeredMeasures(first).empty())
        return fail(first.database, "has no answers on systems that could be compared by study");
    for (const ResponseTable& table : tables) {
        for (const auto* factors : {&table.between, &table.within})
            for (const Factor& factor : *factors)
                if (factor.name == study_factor)
                    return fail(table.database,
                                "has its own factor \"study\", which is the name for comparing studies",
                                "Give that factor another name");
        if (&table == &first) continue;
        if (auto checked = checkMeasures(first, table); !checked) return checked;
        if (auto checked = checkMeasures(table, first); !checked) return checked;
        if (!choice.alpha && table.alpha != first.alpha)
            return fail(table.database,
                        fmt::format("is tested at alpha = {:g}, but {} at {:g}", table.alpha, calledIn(first),
                                    first.alpha),
                        "Choose one level of significance: --alpha 0.01");
    }
    return {};
}

void keepMeasures(const NameSet& kept, ResponseTable& table) {
    const auto leaves = [&](const std::string& measure) { return !kept.contains(measure); };
    std::erase_if(table.measures, [&](const Measure& one) { return leaves(one.name); });
    for (auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        std::erase_if(*rows, [&](const ResponseRow& row) { return leaves(row.measure); });
    for (auto& [participant, planned] : table.planned_answers)
        std::erase_if(planned, [&](const auto& one) { return leaves(one.first); });
    if (kept.contains("accuracy")) return;
    table.choices.clear();
    table.watched.clear();
}

Result<void> keepSharedSystems(std::vector<ResponseTable>& tables) {
    std::vector<NameSet> systems;
    for (const ResponseTable& table : tables) systems.push_back(answeredSystems(table));
    NameSet shared = systems.front();
    for (const NameSet& of_study : systems)
        std::erase_if(shared, [&](const std::string& one) { return !of_study.contains(one); });
    if (shared.empty())
        return fail(tables.back().database,
                    fmt::format("no system is in all studies: {} in {}, {} in {}", listed(systems.front()),
                                calledIn(tables.front()), listed(systems.back()), calledIn(tables.back())),
                    "Systems are compared by name: the same system must have the same name");
    for (std::size_t i = 0; i < tables.size(); ++i) {
        ResponseTable& table = tables[i];
        NameSet gone;
        for (const std::string& one : systems[i])
            if (!shared.contains(one)) gone.insert(one);
        std::erase_if(table.systems, [&](const std::string& one) { return !shared.contains(one); });
        if (gone.empty()) continue;
        const auto goes = [&](const auto& row) { return gone.contains(row.system); };
        const auto before = table.rows.size();
        for (auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
            std::erase_if(
                *rows, [&](const ResponseRow& row) { return goes(row) || gone.contains(row.other_system); });
        std::erase_if(table.choices, goes);
        std::erase_if(table.watched, [&](const ObservedChoice& one) { return goes(one.seen); });
        table.notes.push_back(
            fmt::format("not in all studies, and left out here ({} answers): {}. A separate report of this "
                        "study has them.",
                        before - table.rows.size(), listed(gone)));
        // What was planned on the other systems alone is not known.
        table.planned_answers.clear();
        table.planned_participants = 0;
        for (Measure& measure : table.measures)
            measure.planned = static_cast<int>(
                std::count_if(table.rows.begin(), table.rows.end(),
                              [&](const ResponseRow& row) { return row.measure == measure.name; }));
    }
    return {};
}

}  // namespace deixis::results
