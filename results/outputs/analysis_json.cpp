#include "results/outputs/analysis_json.hpp"

#include "results/answers/motion_origin.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/outputs/observers_json.hpp"

namespace deixis::results {

namespace {

Json joinedArrays(Json first, Json more) {
    for (Json& one : more) first.push_back(std::move(one));
    return first;
}

Json systemsJson(const AnalysisResult& result) {
    Json out = Json::array();
    for (const SystemResult& system : result.systems) {
        Json& row = out.emplace_back(Json{{"system", system.system}});
        for (std::size_t i = 0; i < result.measures.size(); ++i)
            row[result.measures[i].name] = tables::summaryJson(system.measures[i]);
    }
    return out;
}

Json levelTestsJson(const Table& tests, const std::string& factor) {
    return tableJson(tests.where("factor", factor));
}

/// The rest of what within-participants factors come to, beside layouts and distances.
void addLevels(Json& out, const AnalysisResult& result) {
    out["layouts"] = tableJson(tables::levels(result, "layout", "layout"));
    out["distances"] = tableJson(tables::levels(result, "distance", "distance"));
    out["factor_levels"] = Json::array();
    for (const Factor& factor : result.table.within)
        out["factor_levels"] =
            joinedArrays(std::move(out["factor_levels"]), tableJson(tables::levels(result, factor.name)));
}

void addRatings(Json& out, const AnalysisResult& result) {
    out["pairwise_ratings"] = tableJson(tables::ratingPairs(result));
    out["author_trials"] = tableJson(tables::authorTrials(result));
    out["author_trials_by_participants"] = tableJson(tables::authorTrialsPaired(result));
}

void addLevelTests(Json& out, const AnalysisResult& result) {
    const Table tests = tables::levelTests(result);
    out["layout_tests"] = levelTestsJson(tests, "layout");
    out["distance_tests"] = levelTestsJson(tests, "distance");
    out["factor_tests"] = Json::array();
    for (const Factor& factor : result.table.within)
        out["factor_tests"] =
            joinedArrays(std::move(out["factor_tests"]), levelTestsJson(tests, factor.name));
}

Json bradleyTerryJson(const AnalysisResult& result) {
    const BradleyTerry& fit = result.bradley_terry;
    if (fit.abilities.empty()) return {};
    Json pairs = Json::array();
    for (const PairCount& pair : fit.pairs)
        pairs.push_back({{"a", pair.a},
                         {"b", pair.b},
                         {"prefers_a", pair.prefers_a},
                         {"ties", pair.ties},
                         {"prefers_b", pair.prefers_b}});
    return {{"ties", "half a win for each"},
            {"participants", fit.participants},
            {"abilities", tableJson(tables::abilities(result))},
            {"pairs", pairs},
            {"resamples_left_out", fit.resamples_left_out},
            {"note", fit.note.empty() ? Json() : Json(fit.note)}};
}

Json countsJson(const AnswerCounts& counts) {
    return {{"participants", counts.participants}, {"answers", counts.answers}};
}

/// Each pair has the decision under each choice, and which choices change it.
Json sensitivityJson(const AnalysisResult& result) {
    const Table table = tables::sensitivity(result);
    Json pairs = Json::array();
    std::vector<Json> changes;
    for (const Table::Row& row : table.rows) {
        const auto text = [&](const char* column) { return row.cells[table.at(column)].text(); };
        const std::string choice = text("choice");
        if (choice == "headline") {  // the first of each pair
            pairs.push_back({{"measure", text("measure")}, {"a", text("a")}, {"b", text("b")}});
            changes.push_back(Json::array());
        }
        pairs.back()[choice] = rowJson(table.columns, row.cells);
        if (*row.cells[table.at("changes")].as<bool>()) changes.back().push_back(choice);
    }
    for (std::size_t i = 0; i < changes.size(); ++i) pairs[i]["changes"] = changes[i];
    Json out{{"headline", countsJson(result.headline_answers)}};
    for (const AnswerChoice choice : all_choices)
        out[nameOf(choice)] = countsJson(result.other_answers.at(static_cast<std::size_t>(choice)));
    out["pairs"] = pairs;
    return out;
}

Json byStudyJson(const AnalysisResult& result) {
    const Table data = tables::studies(result);
    Json out = Json::array();
    for (const AnalysisResult& one : result.by_study)
        addRatings(out.emplace_back(Json{{"study", one.table.study_name},
                                         {"data", tableJson(data.where("study", one.table.study_name))},
                                         {"participants", one.participants},
                                         {"synthetic", one.synthetic},
                                         {"answers", one.table.rows.size()},
                                         {"systems", systemsJson(one)},
                                         {"omnibus", tableJson(tables::omnibus(one))},
                                         {"pairwise", tableJson(tables::pairwise(one))},
                                         {"preferences", tableJson(tables::preferences(one))},
                                         {"between", tableJson(tables::between(one))}}),
                   one);
    return out;
}

void addAnswers(Json& out, const AnalysisResult& result) {
    out["chance"] = tableJson(tables::chance(result));
    out["unanswered"] = tableJson(tables::unanswered(result));
    out["order"] = tableJson(tables::order(result));
    out["response_times"] = tableJson(tables::responseTimes(result));
    out["items"] = tableJson(tables::items(result));
    out["answers_by_participant"] = Json::array();
    for (const PresenceRow& row : result.presence) {
        Json answers = Json::object();
        for (std::size_t m = 0; m < result.measures.size(); ++m)
            for (std::size_t i = 0; i < result.systems.size(); ++i)
                answers[result.measures[m].name][result.systems[i].system] = row.answers[m][i];
        out["answers_by_participant"].push_back({{"participant", row.participant}, {"answers", answers}});
    }
    out["confusion"] = tableJson(tables::confusion(result));
    out["accuracy_by_angle"] = tableJson(tables::angles(result));
    out["observers"] = readingsJson(result.observers);
    out["drift"] = tableJson(tables::drift(result));
    out["objective"] = {{"file", result.options.objective ? Json(result.options.objective->file) : Json()},
                        {"means", tableJson(tables::objectiveMeans(result))},
                        {"correlations", tableJson(tables::objectiveCorrelations(result))}};
    out["target_space"] = tableJson(tables::targetSpace(result));
    out["pooled_ratings"] = tableJson(tables::pooledRatings(result));
}

Json qualityJson(const AnalysisResult& result) {
    const studies::LeaveOutRule& rule = result.table.leave_out;
    return {{"rule",
             {{"same_rating_share", jsonOf(rule.same_rating_share)},
              {"one_side_share", jsonOf(rule.one_side_share)},
              {"median_time_below_s", jsonOf(rule.median_time_below_s)},
              {"min_answers", studies::LeaveOutRule::min_answers}}},
            {"reliability", tableJson(tables::reliability(result))},
            {"participants", tableJson(tables::quality(result))}};
}

void addParticipants(Json& out, const AnalysisResult& result) {
    const Table scores = tables::scores(result);
    out["scores"] = tableJson(scores.where("factor", ""));
    out["scores_by_group"] = Json::array();
    for (const Table::Row& row : scores.rows)
        if (!row.cells[scores.at("factor")].text().empty())
            out["scores_by_group"].push_back(rowJson(scores.columns, row.cells));
    out["quality"] = qualityJson(result);
    out["score_changes"] = tableJson(tables::scoreChanges(result));
    out["score_groups"] = tableJson(tables::scoreGroups(result));
    out["response_time_tests"] = tableJson(tables::timeTests(result));
    out["response_time_groups"] = tableJson(tables::timeGroups(result));
    out["participant_fields"] = tableJson(tables::participantFields(result));
    out["session_times"] = tableJson(tables::sessionTimes(result));
    out["checks"] = tableJson(tables::checks(result));
    out["left_out"] = tableJson(tables::leftOut(result));
}

const char* kindName(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::accuracy:
            return "accuracy";
        case MeasureKind::rating:
            return "rating";
        case MeasureKind::preference:
            return "preference";
    }
    return "";
}

void addProvenance(Json& out, const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    Json build = Json::object();
    for (const auto& [name, value] : result.options.build) build[name] = value;
    out["schema"] = {{"name", "deixis-analysis"}, {"version", 5}};
    out["program"] = {{"name", "deixis"},
                      {"analysed_by", result.options.program},
                      {"build", build},
                      {"recorded_by", table.program_versions},
                      {"recorded_on", table.operating_systems}};
    const bool planned = !table.study_hash.empty() && table.planned_participants > 0;
    out["study"] = {
        {"name", table.study_name},
        {"title", table.study_title},
        {"hash", table.study_hash},
        {"planned_participants", planned ? Json(static_cast<double>(table.planned_participants)) : Json()}};
    out["data"] = {
        {"files", table.database}, {"answers_hash", result.answers_hash}, {"answers", table.rows.size()}};
    out["measures"] = Json::array();
    for (const auto& measure : table.measures)
        out["measures"].push_back({{"measure", measure.name},
                                   {"kind", kindName(measure.kind)},
                                   {"low", measure.low},
                                   {"high", measure.high},
                                   {"planned", measure.planned},
                                   {"balls", measure.balls},
                                   {"fewest_balls", measure.min_balls}});
    for (std::size_t i = 0; i < table.measures.size(); ++i)
        if (!table.measures[i].unit.empty()) out["measures"][i]["unit"] = table.measures[i].unit;
    out["participants"] = result.participants;
    out["synthetic"] = result.synthetic;
    out["alpha"] = result.alpha;
    out["settings"] = {{"level", result.level},
                       {"resamples", result.options.resamples},
                       {"seed", result.options.seed},
                       {"unit", result.by_ratings ? "ratings" : "participants"}};
}

}  // namespace

std::string analysisJson(const AnalysisResult& result) {
    Json out;
    addProvenance(out, result);
    out["systems"] = systemsJson(result);
    out["not_compared"] = tableJson(tables::notCompared(result));
    out["synthetic_systems"] = Json::object();
    for (const auto& [system, motion] : syntheticSystems(result.table))
        out["synthetic_systems"][system] = motion;
    addLevels(out, result);
    out["omnibus"] = tableJson(tables::omnibus(result));
    out["pairwise"] = tableJson(tables::pairwise(result));
    addRatings(out, result);
    addLevelTests(out, result);
    out["interactions"] = tableJson(tables::interactions(result));
    out["group_interactions"] = tableJson(tables::groupInteractions(result));
    out["preferences"] = tableJson(tables::preferences(result));
    out["bradley_terry"] = bradleyTerryJson(result);
    out["sensitivity"] = sensitivityJson(result);
    out["between"] = tableJson(tables::between(result));
    out["preferences_between"] = tableJson(tables::preferencesBetween(result));
    out["by_study"] = byStudyJson(result);
    out["study_medians"] = tableJson(tables::studyMedians(result));
    addAnswers(out, result);
    addParticipants(out, result);
    out["withdrawn"] = result.table.withdrawn;
    out["remarks"] = result.remarks;
    // Text from a study file may hold bytes that are no UTF-8.
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace deixis::results
