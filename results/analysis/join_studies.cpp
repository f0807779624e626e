// Which studies can be analysed together, and their table.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "results/analysis/several_studies.hpp"
#include "study_fit.hpp"

namespace deixis::results {

namespace {

/// The data of one study.
struct StudyData {
    std::string name;
    std::string hash;
    std::vector<ResponseTable> tables{};
};

/// In order of their names, so that the order of the data changes nothing.
std::vector<StudyData> partByStudy(std::vector<ResponseTable> tables, bool by_study) {
    std::vector<StudyData> out;
    for (ResponseTable& table : tables) {
        const bool of_file = table.study_hash.empty();
        const std::string name = of_file && !by_study ? "" : table.study_name;
        const auto known = std::find_if(out.begin(), out.end(), [&](const StudyData& one) {
            return !(of_file && by_study) && one.name == name && one.hash == table.study_hash;
        });
        if (known == out.end())
            out.push_back({name, table.study_hash, {}}), out.back().tables.push_back(std::move(table));
        else
            known->tables.push_back(std::move(table));
    }
    if (out.size() < 2) return out;
    for (StudyData& one : out)
        std::stable_sort(one.tables.begin(), one.tables.end(),
                         [](const auto& a, const auto& b) { return a.database < b.database; });
    std::stable_sort(out.begin(), out.end(), [](const StudyData& a, const StudyData& b) {
        return std::tie(a.name, a.hash, a.tables.front().database) <
               std::tie(b.name, b.hash, b.tables.front().database);
    });
    return out;
}

/// Without `by_study` only what cannot be meant otherwise is compared: databases of studies of different
/// names.
Result<void> checkMeant(const std::vector<StudyData>& studies) {
    constexpr const char* hint = "Only data of the same study file form one study; --by study compares";
    for (std::size_t i = 0; i < studies.size(); ++i) {
        const ResponseTable& table = studies[i].tables.front();
        const ResponseTable& other = studies[i == 0 ? 1 : i - 1].tables.front();
        if (studies[i].hash.empty())
            return fail(table.database,
                        fmt::format("is not a database and names no study, while {} is of the study {}",
                                    other.database, other.study_name),
                        fmt::format("{} the two as studies", hint));
        if (i > 0 && studies[i].name == studies[i - 1].name)
            return fail(table.database,
                        fmt::format("its study {} (SHA-256 {:.12}) is not that of {} ({:.12}), although the "
                                    "names are the same",
                                    studies[i].name, studies[i].hash, other.database, studies[i - 1].hash),
                        fmt::format("{} its two versions as studies", hint));
    }
    return {};
}

/// A study that has its name in common with another is known by its hash.
Result<std::vector<std::string>> namesOf(const std::vector<StudyData>& studies) {
    std::vector<std::string> out;
    for (const StudyData& one : studies) {
        const auto same = std::count_if(studies.begin(), studies.end(),
                                        [&](const StudyData& other) { return other.name == one.name; });
        out.push_back(same > 1 && !one.hash.empty() ? fmt::format("{} ({:.8})", one.name, one.hash)
                                                    : one.name);
    }
    std::set<std::string> known;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!known.insert(out[i]).second)
            return fail(studies[i].tables.front().database,
                        fmt::format("another file is also a study \"{}\"", out[i]),
                        "A CSV file's study has the file's name: give the two different names");
    return out;
}

DataOrigin originOf(const ResponseTable& table, const std::string& study) {
    NameSet people;
    NameSet simulated;
    for (const ResponseRow& row : table.rows) (row.synthetic ? simulated : people).insert(row.participant);
    return {study,
            table.database,
            table.study_title,
            table.study_hash,
            answersHash(table),
            table.schema_version,
            table.program_versions,
            table.operating_systems,
            table.avatar_hashes,
            static_cast<int>(people.size()),
            static_cast<int>(simulated.size()),
            static_cast<int>(table.rows.size()),
            static_cast<int>(table.left_out.size()),
            table.withdrawn};
}

NameSet participantsOf(const ResponseTable& table) {
    NameSet out;
    for (const auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows}) {
        for (const ResponseRow& row : *rows) out.insert(row.participant);
    }
    for (const auto& row : table.scores) out.insert(row.participant);
    for (const auto& row : table.fields) out.insert(row.participant);
    for (const auto& [participant, minutes] : table.session_minutes) out.insert(participant);
    for (const auto& [participant, planned] : table.planned_answers) out.insert(participant);
    return out;
}

template <typename Value>
void renameKeys(std::map<std::string, Value>& of, const std::string& prefix) {
    std::map<std::string, Value> renamed;
    for (auto& [name, value] : of) renamed.emplace(prefix + name, std::move(value));
    of = std::move(renamed);
}

/// Participants and items of one study are not those of another, whatever they are called.
void nameApart(ResponseTable& table, const std::string& study) {
    const std::string prefix = study + "/";
    for (const std::string& participant : participantsOf(table))
        table.groups[participant][study_factor] = study;
    table.between.insert(table.between.begin(), Factor{study_factor, {study}});
    for (auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        for (ResponseRow& row : *rows) {
            row.participant = prefix + row.participant;
            if (!row.target_id.empty()) row.target_id = prefix + row.target_id;
        }
    for (ChoiceRow& row : table.choices) {
        row.participant = prefix + row.participant;
        row.target_id = prefix + row.target_id;
    }
    for (ObservedChoice& one : table.watched) one.participant = prefix + one.participant;
    for (ScoreRow& row : table.scores) row.participant = prefix + row.participant;
    for (FieldRow& row : table.fields) row.participant = prefix + row.participant;
    for (LeftOut& one : table.left_out) one.participant = prefix + one.participant;
    for (CheckCount& check : table.checks) check.stage = fmt::format("{}: {}", study, check.stage);
    NameSet failed;
    for (const std::string& participant : table.failed_checks) failed.insert(prefix + participant);
    table.failed_checks = std::move(failed);
    renameKeys(table.groups, prefix);
    renameKeys(table.planned_answers, prefix);
    renameKeys(table.session_minutes, prefix);
    for (std::string& note : table.notes) note = fmt::format("{}: {}", study, note);
}

bool sameRule(const studies::LeaveOutRule& a, const studies::LeaveOutRule& b) {
    return std::tie(a.same_rating_share, a.one_side_share, a.median_time_below_s) ==
           std::tie(b.same_rating_share, b.one_side_share, b.median_time_below_s);
}

/// What the studies declare is declared for all only where all of them do.
void declareTogether(std::vector<ResponseTable>& tables) {
    ResponseTable& first = tables.front();
    NameSet dropped;
    for (const ResponseTable& table : tables) {
        first.stations_together = first.stations_together && table.stations_together;
        first.by_ratings = first.by_ratings && table.by_ratings;
        if (!sameRule(first.leave_out, table.leave_out)) first.leave_out = {};
        for (const auto& [measure, bound] : table.equivalence)
            if (const auto known = first.equivalence.find(measure);
                known == first.equivalence.end() || known->second != bound)
                dropped.insert(measure);
        for (const auto& [measure, bound] : first.equivalence)
            if (!table.equivalence.contains(measure)) dropped.insert(measure);
        for (const auto& stages : table.repeated_questionnaires)
            if (std::find(first.repeated_questionnaires.begin(), first.repeated_questionnaires.end(),
                          stages) == first.repeated_questionnaires.end())
                first.repeated_questionnaires.push_back(stages);
    }
    std::erase_if(first.equivalence, [&](const auto& one) { return dropped.contains(one.first); });
    if (!dropped.empty())
        first.notes.push_back(
            fmt::format("The studies do not declare the same equivalence bound for {}: none is used. "
                        "--equivalence sets one for all.",
                        listed(dropped)));
}

void addNotes(ResponseTable& out, const std::vector<NameSet>& participants, bool asked) {
    std::map<std::string, int> times;
    for (const NameSet& of_study : participants)
        for (const std::string& one : of_study) ++times[one];
    NameSet twice;
    for (const auto& [participant, n] : times)
        if (n > 1) twice.insert(participant);
    std::vector<std::string> notes;
    if (!asked)
        notes.emplace_back(
            "The data are from several studies: they are compared by study, as with --by study, each "
            "separately and pooled.");
    if (!twice.empty()) {
        constexpr std::size_t max = 5;
        NameSet some(twice.begin(),
                     std::next(twice.begin(), static_cast<std::ptrdiff_t>(std::min(max, twice.size()))));
        notes.push_back(
            fmt::format("{} ({}{}) in more than one study: they are treated as different people, are called "
                        "STUDY/ID here, and are not pooled as one person. If the same people took part in "
                        "several studies, the pooled tests and those between studies are not valid.",
                        twice.size() == 1 ? "1 participant's name occurs"
                                          : fmt::format("{} participants' names occur", twice.size()),
                        listed(some), twice.size() > max ? ", ..." : ""));
    }
    if (const Measure* accuracy = measureIn(out, "accuracy");
        accuracy != nullptr && accuracy->min_balls < accuracy->balls)
        notes.push_back(
            fmt::format("Choices were among {} to {} balls: accuracy is not equally hard in studies with "
                        "different numbers of balls.",
                        accuracy->min_balls, accuracy->balls));
    out.notes.insert(out.notes.begin(), notes.begin(), notes.end());
}

template <typename Of>
std::string joinedOnce(const std::vector<ResponseTable>& tables, const char* between, const Of& of) {
    std::vector<std::string> out;
    for (const ResponseTable& table : tables)
        if (std::find(out.begin(), out.end(), of(table)) == out.end()) out.push_back(of(table));
    return fmt::format("{}", fmt::join(out, between));
}

Result<ResponseTable> joinStudies(std::vector<StudyData> studies, const JoinChoice& choice) {
    auto names = namesOf(studies);
    if (!names) return tl::unexpected(names.error());
    std::vector<DataOrigin> origins;
    std::vector<ResponseTable> tables;
    std::vector<NameSet> participants;
    for (std::size_t i = 0; i < studies.size(); ++i) {
        for (const ResponseTable& table : studies[i].tables) origins.push_back(originOf(table, (*names)[i]));
        auto table = joinTables(std::move(studies[i].tables));
        if (!table) return tl::unexpected(table.error());
        table->study_name = (*names)[i];
        participants.push_back(participantsOf(*table));
        tables.push_back(std::move(*table));
    }
    if (auto checked = checkTogether(tables, choice); !checked) return tl::unexpected(checked.error());
    if (auto kept = keepSharedSystems(tables); !kept) return tl::unexpected(kept.error());
    const std::string name = fmt::format("{}", fmt::join(*names, ", "));
    const std::string title = joinedOnce(tables, "; ", [](const auto& one) { return one.study_title; });
    const bool of_files =
        std::any_of(tables.begin(), tables.end(), [](const auto& one) { return one.study_hash.empty(); });
    const std::string hash =
        of_files ? "" : joinedOnce(tables, ", ", [](const auto& one) { return one.study_hash; });
    const bool planned = std::all_of(tables.begin(), tables.end(),
                                     [](const auto& one) { return one.planned_participants > 0; });
    for (std::size_t i = 0; i < tables.size(); ++i) {
        nameApart(tables[i], (*names)[i]);
        tables[i].study_hash = hash;
        tables[i].alpha = choice.alpha.value_or(tables[i].alpha);
    }
    declareTogether(tables);
    auto out = joinTables(std::move(tables));
    if (!out) return out;
    out->study_name = name;
    out->study_title = title;
    if (!planned) out->planned_participants = 0;
    out->schema_version = 0;
    out->origins = std::move(origins);
    addNotes(*out, participants, choice.by_study);
    return out;
}

Result<void> chooseMeasures(const std::vector<std::string>& measures, std::vector<ResponseTable>& tables) {
    if (measures.empty()) return {};
    for (ResponseTable& table : tables) {
        NameSet known;
        for (const Measure& one : table.measures) known.insert(one.name);
        for (const std::string& wanted : measures)
            if (!known.contains(wanted))
                return fail("--measure",
                            fmt::format("found \"{}\", which {} does not measure", wanted, table.database),
                            "It measures: " + listed(known));
        keepMeasures({measures.begin(), measures.end()}, table);
    }
    return {};
}

}  // namespace

Result<ResponseTable> joinData(std::vector<ResponseTable> tables, const JoinChoice& choice) {
    if (auto chosen = chooseMeasures(choice.measures, tables); !chosen) return tl::unexpected(chosen.error());
    std::vector<StudyData> studies = partByStudy(std::move(tables), choice.by_study);
    if (studies.size() == 1) {
        if (choice.by_study)
            return fail("--by study",
                        fmt::format("all data are from one study, {}: there is nothing to compare",
                                    studies.front().name),
                        "Add the data of another study, or leave --by out");
        return joinTables(std::move(studies.front().tables));
    }
    if (!choice.by_study)
        if (auto meant = checkMeant(studies); !meant) return tl::unexpected(meant.error());
    return joinStudies(std::move(studies), choice);
}

}  // namespace deixis::results
