#include "results/answers/stations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace deixis::results {

namespace {

std::string kindOf(const ResponseRow& row) {
    return row.synthetic ? simulated_station : row.station;
}

/// By participant.
std::map<std::string, std::set<std::string>> kindsByParticipant(const ResponseTable& table) {
    std::map<std::string, std::set<std::string>> out;
    for (const auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        for (const ResponseRow& row : *rows) out[row.participant].insert(kindOf(row));
    return out;
}

/// What was planned for those whose answers are left; who moved from one kind of station to another was
/// planned to answer here what is answered here.
void planAt(ResponseTable& table, const std::map<std::string, std::set<std::string>>& kinds) {
    std::map<std::string, int> planned;
    const auto whole = [&](const std::string& participant) {
        const auto of = kinds.find(participant);
        return table.planned_answers.contains(participant) && of != kinds.end() && of->second.size() == 1;
    };
    std::set<std::string> answered;
    for (const ResponseRow& row : table.rows) {
        answered.insert(row.measure);
        if (!whole(row.participant)) ++planned[row.measure];
    }
    for (const auto& [participant, measures] : table.planned_answers)
        if (whole(participant))
            for (const auto& [measure, n] : measures) planned[measure] += n;
    for (Measure& measure : table.measures) measure.planned = planned[measure.name];
    std::erase_if(table.measures, [&](const Measure& one) { return !answered.contains(one.name); });
}

}  // namespace

std::vector<std::string> stationKinds(const ResponseTable& table) {
    std::set<std::string> people;
    bool simulated = false;
    for (const ResponseRow& row : table.rows)
        if (row.synthetic)
            simulated = true;
        else
            people.insert(row.station);
    std::vector<std::string> out(people.begin(), people.end());
    if (simulated) out.emplace_back(simulated_station);
    return out;
}

ResponseTable onlyAt(ResponseTable table, const std::optional<std::string>& kind) {
    const auto taken = [&](const std::string& of) { return kind ? of == *kind : of != simulated_station; };
    const auto kinds = kindsByParticipant(table);
    const auto takenParticipant = [&](const std::string& participant) {
        const auto found = kinds.find(participant);
        // Who answered questionnaires alone sat at a station that no row tells.
        return found == kinds.end() || std::any_of(found->second.begin(), found->second.end(), taken);
    };
    for (auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        std::erase_if(*rows, [&](const ResponseRow& row) { return !taken(kindOf(row)); });
    std::erase_if(table.choices, [&](const ChoiceRow& row) { return !taken(row.station); });
    std::erase_if(table.watched,
                  [&](const ObservedChoice& one) { return !takenParticipant(one.participant); });
    std::erase_if(table.scores, [&](const ScoreRow& row) { return !takenParticipant(row.participant); });
    std::erase_if(table.fields, [&](const FieldRow& row) { return !takenParticipant(row.participant); });
    std::erase_if(table.session_minutes, [&](const auto& one) { return !takenParticipant(one.first); });
    std::erase_if(table.left_out, [&](const LeftOut& one) { return !takenParticipant(one.participant); });
    std::erase_if(table.failed_checks, [&](const std::string& one) { return !takenParticipant(one); });
    std::erase_if(table.groups, [&](const auto& one) { return !takenParticipant(one.first); });
    std::erase_if(table.stations, [&](const StationUse& one) {
        return !taken(one.synthetic ? simulated_station : one.kind);
    });
    std::erase_if(table.planned_answers, [&](const auto& one) { return !takenParticipant(one.first); });
    table.planned_participants = 0;  // where those who have not begun will sit is not known
    planAt(table, kinds);
    return table;
}

ResponseTable withStations(ResponseTable table) {
    const std::vector<std::string> kinds = stationKinds(table);
    if (!kinds.empty() && kinds.back() == simulated_station && kinds.size() > 1)
        table = onlyAt(std::move(table), std::nullopt);
    for (const auto& [participant, of] : kindsByParticipant(table))
        if (of.size() == 1 && !of.begin()->empty()) {
            addLevel(table.between, station_factor, *of.begin());
            table.groups[participant][station_factor] = *of.begin();
        }
    return table;
}

}  // namespace deixis::results
