// The table of several studies, study by study.
#include "results/analysis/several_studies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

const Factor* studiesOf(const ResponseTable& table) {
    if (table.origins.empty()) return nullptr;
    const auto found = std::find_if(table.between.begin(), table.between.end(),
                                    [](const Factor& one) { return one.name == study_factor; });
    return found == table.between.end() ? nullptr : &*found;
}

/// Calls visit(row, study) for each answer; those of a participant stand together.
template <typename Visit>
void forStudies(const ResponseTable& table, const Visit& visit) {
    for (const ResponseRow& row : table.rows)
        visit(row, levelOfParticipant(table, row.participant, study_factor));
}

int answersOn(const Measure& measure, const std::vector<ResponseRow>& rows) {
    return static_cast<int>(std::count_if(
        rows.begin(), rows.end(), [&](const ResponseRow& row) { return row.measure == measure.name; }));
}

/// What was planned of one study's participants; where no plan is known, what was answered.
void planStudy(const ResponseTable& all, const std::string& study, ResponseTable& out) {
    for (Measure& measure : out.measures) {
        bool known = false;
        int planned = 0;
        for (const auto& [participant, measures] : all.planned_answers)
            if (levelOfParticipant(all, participant, study_factor) == study) {
                known = true;
                if (const auto of = measures.find(measure.name); of != measures.end()) planned += of->second;
            }
        measure.planned = known ? planned : answersOn(measure, out.rows) + answersOn(measure, out.aside_rows);
    }
}

/// The systems of one study, or of all together, highest first; those without answers are not among them.
void addMedians(const AnalysisResult& of, const std::string& study, std::size_t measure,
                std::vector<MedianResult>& out) {
    const Measure& asked = of.measures[measure];
    std::map<std::string, std::vector<double>> ratings;
    if (asked.kind == MeasureKind::rating)
        for (const ResponseRow& row : of.table.rows)
            if (row.measure == asked.name) ratings[row.system].push_back(row.value);
    const auto first = static_cast<std::ptrdiff_t>(out.size());
    for (const SystemResult& system : of.systems) {
        const Summary& one = system.measures[measure];
        if (one.n == 0) continue;
        const auto found = ratings.find(system.system);
        out.push_back(
            {asked.name, study, 0, system.system, one.median,
             found == ratings.end() ? std::nullopt : std::optional(quantile(std::move(found->second), 0.5)),
             static_cast<int>(one.by_participant.size()), one.n});
    }
    std::stable_sort(out.begin() + first, out.end(),
                     [](const MedianResult& a, const MedianResult& b) { return a.median > b.median; });
    for (auto at = out.begin() + first; at != out.end(); ++at)
        at->place = at != out.begin() + first && at->median == std::prev(at)->median
                        ? std::prev(at)->place
                        : static_cast<int>(at - (out.begin() + first)) + 1;
}

}  // namespace

std::vector<std::string> studiesIn(const ResponseTable& table) {
    const Factor* studies = studiesOf(table);
    if (studies == nullptr) return {};
    std::set<std::string> answered;
    forStudies(table, [&](const ResponseRow&, const std::string& study) { answered.insert(study); });
    std::vector<std::string> out;
    for (const std::string& level : studies->levels)
        if (answered.contains(level)) out.push_back(level);
    return out;
}

ResponseTable onlyStudy(const ResponseTable& table, const std::string& study) {
    ResponseTable out;
    out.study_name = study;
    out.study_hash = table.study_hash;
    out.alpha = table.alpha;
    out.systems = table.systems;
    out.measures = table.measures;
    out.equivalence = table.equivalence;
    out.by_ratings = table.by_ratings;
    forStudies(table, [&](const ResponseRow& row, const std::string& of) {
        if (of == study) out.rows.push_back(row);
    });
    for (ResponseRow& row : out.rows) row.within.clear();
    for (const ResponseRow& row : table.aside_rows)
        if (levelOfParticipant(table, row.participant, study_factor) == study) out.aside_rows.push_back(row);
    planStudy(table, study, out);
    return out;
}

void dropEmptyStudies(ResponseTable& table) {
    if (studiesOf(table) == nullptr) return;
    const std::vector<std::string> answered = studiesIn(table);
    if (answered.size() == studiesOf(table)->levels.size()) return;
    table.notes.push_back(fmt::format("Of the studies {} only {} {} answers here.",
                                      fmt::join(studiesOf(table)->levels, ", "), fmt::join(answered, ", "),
                                      answered.size() == 1 ? "has" : "have"));
    std::erase_if(table.between, [&](Factor& one) {
        if (one.name == study_factor) one.levels = answered;
        return one.name == study_factor && answered.size() < 2;
    });
}

void orderMedians(AnalysisResult& result) {
    for (std::size_t i = 0; i < result.measures.size(); ++i) {
        for (const AnalysisResult& one : result.by_study)
            addMedians(one, one.table.study_name, i, result.medians);
        addMedians(result, pooled_studies, i, result.medians);
    }
}

Result<void> checkStudiesMeet(const ResponseTable& table, bool stations_together) {
    if (studiesOf(table) == nullptr) return {};
    std::map<std::string, std::set<std::string>> by_kind;
    forStudies(table, [&](const ResponseRow& row, const std::string& study) {
        const std::string kind = row.synthetic         ? std::string("simulated participants")
                                 : stations_together   ? std::string("people")
                                 : row.station.empty() ? std::string("people, station not known")
                                                       : fmt::format("people, station {}", row.station);
        by_kind[kind].insert(study);
    });
    std::vector<std::string> found;
    bool people_apart = false;
    for (const auto& [kind, of] : by_kind) {
        if (of.size() > 1) return {};
        found.push_back(fmt::format("{} in {}", kind, fmt::join(of, ", ")));
        people_apart = people_apart || kind.starts_with("people, ");
    }
    return fail(table.database,
                fmt::format("no two studies have answers of the same kind: {}; these are never averaged",
                            fmt::join(found, ", ")),
                people_apart && by_kind.size() > 1 && !by_kind.contains("simulated participants")
                    ? "--stations together compares people's answers of all stations"
                    : "A separate report of each study has them");
}

}  // namespace deixis::results
