#include <nlohmann/json.hpp>

#include "analysis_json_ratings.hpp"
#include "analysis_json_studies.hpp"
#include "analysis_json_tests.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/accuracy_by_angle.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_json_groups.hpp"
#include "results/outputs/bradley_terry_outputs.hpp"
#include "results/outputs/observers_tables.hpp"
#include "results/outputs/quality_outputs.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/tables/json_values.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::ordered_json;

Json intervalJson(const std::optional<BootstrapInterval>& interval) {
    return interval ? Json{{"lower", interval->lower}, {"upper", interval->upper}} : Json();
}

Json boxJson(const std::optional<BoxSummary>& box) {
    if (!box) return {};
    return {{"q05", box->q05},
            {"q25", box->q25},
            {"median", box->median},
            {"q75", box->q75},
            {"q95", box->q95},
            {"notch_low", box->notch_low},
            {"notch_high", box->notch_high}};
}

Json summaryJson(const Summary& summary) {
    const std::size_t participants = summary.by_participant.size();
    return {{"mean", numberOrNull(summary.n > 0, summary.mean)},
            {"median", numberOrNull(summary.n > 0, summary.median)},
            {"interval", intervalJson(summary.interval)},
            {"interval_falls_short", summary.interval_falls_short},
            {"box", boxJson(boxSummary(summary.by_participant))},
            {"participants", participants},
            {"sd_participants", numberOrNull(participants > 1, summary.sd_participants)},
            {"sd_trials", numberOrNull(summary.n > 1, summary.sd_trials)},
            {"n", summary.n}};
}

Json comparisonJson(const Comparison& comparison, const AnalysisResult& result) {
    Json out;
    out["measure"] = comparison.measure;
    if (!comparison.factor.empty()) out["factor"] = comparison.factor;
    if (!comparison.system.empty()) out["system"] = comparison.system;
    out["a"] = comparison.a;
    out["b"] = comparison.b;
    out["mean_difference"] = numberOrNull(comparison.test.n_pairs > 0, comparison.mean_difference);
    addTest(out, comparison, result);
    return out;
}

/// Rows of a factor; the level stands under `key`, and beside it the factor's name where `with_factor`.
Json levelsJson(const AnalysisResult& result, const std::string& factor, const std::string& key,
                bool with_factor) {
    Json out = Json::array();
    for (const auto& row : result.levels) {
        if (row.factor != factor) continue;
        Json one{{"measure", row.measure}, {"system", row.system}};
        if (with_factor) one["factor"] = row.factor;
        one[key] = row.level;
        one["mean"] = numberOrNull(row.n > 0, row.mean);
        one["sd_trials"] = numberOrNull(row.n > 1, row.sd_trials);
        one["n"] = row.n;
        const Summary& of = row.over_participants;
        one["mean_participants"] = numberOrNull(of.n > 0, of.mean);
        one["interval"] = intervalJson(of.interval);
        one["participants"] = of.by_participant.size();
        out.push_back(std::move(one));
    }
    return out;
}

Json levelTestsJson(const AnalysisResult& result, const std::string& factor) {
    Json out = Json::array();
    for (const auto& comparison : result.level_tests)
        if (comparison.factor == factor) out.push_back(comparisonJson(comparison, result));
    return out;
}

}  // namespace

Json pairwiseJson(const AnalysisResult& result) {
    Json out = Json::array();
    for (const auto& comparison : result.pairwise) out.push_back(comparisonJson(comparison, result));
    return out;
}

Json systemsJson(const AnalysisResult& result) {
    Json out = Json::array();
    for (const auto& system : result.systems) {
        Json row{{"system", system.system}};
        for (std::size_t i = 0; i < result.measures.size(); ++i)
            row[result.measures[i].name] = summaryJson(system.measures[i]);
        out.push_back(std::move(row));
    }
    return out;
}

Json preferencesJson(const AnalysisResult& result) {
    Json out = Json::array();
    for (const auto& pair : result.preferences) {
        Json row{{"a", pair.a},
                 {"b", pair.b},
                 {"prefers_a", pair.prefers_a},
                 {"ties", pair.ties},
                 {"prefers_b", pair.prefers_b},
                 {"mean", pair.mean}};
        addTest(row, pair, result);
        out.push_back(std::move(row));
    }
    return out;
}

Json omnibusJson(const AnalysisResult& result) {
    Json out = Json::array();
    for (const OmnibusResult& one : result.omnibus) {
        Json ranks = Json::object();
        for (std::size_t i = 0; i < one.test.mean_ranks.size(); ++i)
            ranks[result.table.systems[i]] = one.test.mean_ranks[i];
        const ImanDavenport& f = one.test.iman_davenport;
        out.push_back(
            {{"measure", one.measure},
             {"test", "Friedman"},
             {"n", one.test.n},
             {"n_missing", result.participants - one.test.n},
             {"ties", one.test.ties},
             {"mean_ranks", ranks},
             {"chi2", numberOrNull(one.test.chi2)},
             {"df", one.test.df},
             {"p", numberOrNull(one.test.p)},
             {"kendalls_w", numberOrNull(one.test.kendalls_w)},
             {"iman_davenport",
              {{"f", numberOrNull(f.f)}, {"df1", f.df1}, {"df2", f.df2}, {"p", numberOrNull(f.p)}}}});
    }
    return out;
}

namespace {

Json decisionJson(const AdjustedTest& one, double p, const std::optional<double>& p_holm, double alpha) {
    return {{"n", one.test.n_pairs},
            {"p", numberOrNull(one.test.n_pairs > 0, p)},
            {"p_holm", numberOrNull(p_holm)},
            {"significant", p_holm && *p_holm <= alpha}};
}

Json countsJson(const AnswerCounts& counts) {
    return {{"participants", counts.participants}, {"answers", counts.answers}};
}

Json sensitivityJson(const AnalysisResult& result) {
    Json pairs = Json::array();
    for (const SensitivityResult& one : result.sensitivity) {
        const AdjustedTest& head = one.headline;
        const auto decision = [&](const AdjustedTest& test) {
            return decisionJson(test, test.test.p_two_sided, test.p_holm, result.alpha);
        };
        Json changes = Json::array();
        if (head.depends_on_zeros) changes.push_back("pratt");
        if (head.depends_on_approximation) changes.push_back("normal");
        for (const SensitivityResult::Other& other : one.others)
            if (other.changes) changes.push_back(nameOf(other.choice));
        Json& pair = pairs.emplace_back(Json{
            {"measure", one.measure},
            {"a", one.a},
            {"b", one.b},
            {"headline", decision(head)},
            {"pratt", decisionJson(head, head.test.pratt_p_two_sided, head.p_holm_pratt, result.alpha)},
            {"normal", decisionJson(head, head.test.normal_p_two_sided, head.p_holm_normal, result.alpha)},
        });
        for (const SensitivityResult::Other& other : one.others)
            pair[nameOf(other.choice)] = decision(other.test);
        pair["changes"] = changes;
    }
    Json out{{"headline", countsJson(result.headline_answers)}};
    for (const AnswerChoice choice : all_choices)
        out[nameOf(choice)] = countsJson(result.other_answers.at(static_cast<std::size_t>(choice)));
    out["pairs"] = pairs;
    return out;
}

Json scoresJson(const AnalysisResult& result, bool by_group) {
    Json out = Json::array();
    for (const ScoreResult& score : result.scores) {
        if (score.factor.empty() == by_group) continue;
        Json one{{"stage", score.stage}, {"score", score.score}};
        if (by_group) {
            one["factor"] = score.factor;
            one["level"] = score.level;
        }
        one["mean"] = score.mean;
        one["sd"] = numberOrNull(score.n > 1, score.sd);
        one["n"] = score.n;
        one["q25"] = score.q25;
        one["median"] = score.median;
        one["q75"] = score.q75;
        out.push_back(std::move(one));
    }
    return out;
}

void addChoices(Json& out, const AnalysisResult& result) {
    out["confusion"] = Json::array();
    for (const ConfusionResult& one : result.confusion)
        out["confusion"].push_back(
            {{"system", one.system}, {"role", one.role}, {"chosen", one.chosen}, {"shown", one.shown}});
    out["accuracy_by_angle"] = Json::array();
    for (const AngleResult& one : accuracyByAngle(result.table))
        out["accuracy_by_angle"].push_back({{"eyes", one.eyes},
                                            {"system", one.system},
                                            {"from_deg", one.from_deg},
                                            {"below_deg", numberOrNull(one.below_deg)},
                                            {"right", one.right},
                                            {"choices", one.choices}});
    out["observers"] = readingsJson(result.observers);
    out["drift"] = Json::array();
    for (const DriftResult& one : result.drift)
        out["drift"].push_back({{"system", one.system},
                                {"line", one.line},
                                {"choices", one.choices},
                                {"of_first", one.of_first},
                                {"of_last", one.of_last},
                                {"moved", one.moved},
                                {"moved_first", one.moved_first},
                                {"moved_last", one.moved_last}});
    out["target_space"] = Json::array();
    for (const TargetPlace& one : result.target_space)
        out["target_space"].push_back({{"system", one.system},
                                       {"item", one.target_id},
                                       {"x_m", one.position_m.x},
                                       {"y_m", one.position_m.y},
                                       {"z_m", one.position_m.z},
                                       {"mean", one.mean},
                                       {"n", one.n}});
}

void addPooled(Json& out, const AnalysisResult& result) {
    out["pooled_ratings"] = Json::array();
    for (const PooledResult& one : result.pooled)
        out["pooled_ratings"].push_back({{"measure", one.measure},
                                         {"system", one.system},
                                         {"n", one.n},
                                         {"mean", one.mean},
                                         {"sd", numberOrNull(one.n > 1, one.sd)},
                                         {"q05", one.q05},
                                         {"q25", one.q25},
                                         {"median", one.median},
                                         {"q75", one.q75},
                                         {"q95", one.q95},
                                         {"note", "pseudo-replicated: answers taken as independent"}});
}

void addDetails(Json& out, const AnalysisResult& result) {
    out["chance"] = Json::array();
    for (const ChanceResult& one : result.chance) {
        Json row{{"system", one.system},
                 {"successes", one.successes},
                 {"choices", one.n},
                 {"choices_with_balls", one.n_known},
                 {"estimate", numberOrNull(one.n > 0, static_cast<double>(one.successes) / one.n)},
                 {"chance", numberOrNull(one.n_known > 0, one.chance)},
                 {"mean_above", numberOrNull(one.n_known > 0, one.mean_above)}};
        addTest(row, one, result);
        out["chance"].push_back(std::move(row));
    }
    out["unanswered"] = Json::array();
    for (const UnansweredResult& one : result.unanswered)
        out["unanswered"].push_back({{"system", one.system},
                                     {"answered", one.answered},
                                     {"timed_out", one.timed_out},
                                     {"skipped", one.skipped},
                                     {"headline", numberOrNull(one.headline)},
                                     {"answered_only", numberOrNull(one.answered_only)},
                                     {"unanswered_wrong", numberOrNull(one.unanswered_wrong)}});
    out["order"] = Json::array();
    for (const OrderResult& one : result.order) {
        Json row{{"measure", one.measure}, {"first_half", one.first}, {"second_half", one.second}};
        addTest(row, one, result);
        out["order"].push_back(std::move(row));
    }
    out["response_times"] = Json::array();
    for (const TimeResult& one : result.times)
        out["response_times"].push_back({{"measure", one.measure},
                                         {"system", one.system},
                                         {"n", one.n},
                                         {"q25_s", one.q25_s},
                                         {"median_s", one.median_s},
                                         {"q75_s", one.q75_s}});
    out["items"] = Json::array();
    for (const ItemResult& one : result.items)
        out["items"].push_back(
            {{"measure", one.measure}, {"item", one.item}, {"mean", one.mean}, {"n", one.n}});
    out["answers_by_participant"] = Json::array();
    for (const PresenceRow& row : result.presence) {
        Json answers = Json::object();
        for (std::size_t m = 0; m < result.measures.size(); ++m)
            for (std::size_t i = 0; i < result.systems.size(); ++i)
                answers[result.measures[m].name][result.systems[i].system] = row.answers[m][i];
        out["answers_by_participant"].push_back({{"participant", row.participant}, {"answers", answers}});
    }
}

void addPeople(Json& out, const AnalysisResult& result) {
    out["score_changes"] = Json::array();
    for (const ScoreChange& one : result.score_changes) {
        Json row{
            {"score", one.score}, {"a", one.a}, {"b", one.b}, {"mean_a", one.mean_a}, {"mean_b", one.mean_b}};
        addTest(row, one, result);
        out["score_changes"].push_back(std::move(row));
    }
    out["score_groups"] = scoreGroupsJson(result);
    out["response_time_tests"] = Json::array();
    for (const Comparison& one : result.time_tests)
        out["response_time_tests"].push_back(comparisonJson(one, result));
    out["response_time_groups"] = timeGroupsJson(result);
    out["participant_fields"] = Json::array();
    for (const FieldResult& one : result.fields) {
        const bool numbers = one.options.empty();
        Json options = Json::object();
        for (const auto& [option, n] : one.options) options[option] = n;
        out["participant_fields"].push_back({{"field", one.field},
                                             {"n", one.n},
                                             {"median", numberOrNull(numbers, one.median)},
                                             {"min", numberOrNull(numbers, one.least)},
                                             {"max", numberOrNull(numbers, one.greatest)},
                                             {"options", std::move(options)}});
    }
    out["session_times"] = Json::array();
    for (const SessionTimeResult& one : result.session_times)
        out["session_times"].push_back({{"factor", one.factor},
                                        {"level", one.level},
                                        {"n", one.n},
                                        {"median_min", one.median_min},
                                        {"min_min", one.least_min},
                                        {"max_min", one.greatest_min}});
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

}  // namespace

std::string analysisJson(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    Json out;
    out["schema"] = {{"name", "deixis-analysis"}, {"version", 4}};
    out["program"] = {{"name", "deixis"},
                      {"analysed_by", result.options.program},
                      {"build", Json::object()},
                      {"recorded_by", table.program_versions},
                      {"recorded_on", table.operating_systems}};
    for (const auto& [name, value] : result.options.build) out["program"]["build"][name] = value;
    out["study"] = {
        {"name", table.study_name},
        {"title", table.study_title},
        {"hash", table.study_hash},
        {"planned_participants", numberOrNull(!table.study_hash.empty() && table.planned_participants > 0,
                                              table.planned_participants)}};
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
                                   {"fewest_balls", measure.fewest_balls}});
    out["participants"] = result.participants;
    out["synthetic"] = result.synthetic;
    out["alpha"] = result.alpha;
    out["settings"] = {{"level", result.level},
                       {"resamples", result.options.resamples},
                       {"seed", result.options.seed},
                       {"unit", result.by_ratings ? "ratings" : "participants"}};
    out["systems"] = systemsJson(result);
    out["layouts"] = levelsJson(result, "layout", "layout", false);
    out["distances"] = levelsJson(result, "distance", "distance", false);
    out["factor_levels"] = Json::array();
    for (const Factor& factor : table.within)
        for (Json& row : levelsJson(result, factor.name, "level", true))
            out["factor_levels"].push_back(std::move(row));
    out["omnibus"] = omnibusJson(result);
    out["pairwise"] = pairwiseJson(result);
    addRatings(out, result);
    out["layout_tests"] = levelTestsJson(result, "layout");
    out["distance_tests"] = levelTestsJson(result, "distance");
    out["factor_tests"] = Json::array();
    for (const Factor& factor : table.within)
        for (Json& row : levelTestsJson(result, factor.name)) out["factor_tests"].push_back(std::move(row));
    out["interactions"] = Json::array();
    for (const InteractionResult& one : result.interactions) {
        Json row{{"measure", one.measure},
                 {"factor", one.factor},
                 {"a", one.a},
                 {"b", one.b},
                 {"other_factor", one.other_factor},
                 {"c", one.c},
                 {"d", one.d},
                 {"mean_difference", one.mean_difference}};
        addTest(row, one, result);
        out["interactions"].push_back(std::move(row));
    }
    out["group_interactions"] = groupInteractionsJson(result);
    out["preferences"] = preferencesJson(result);
    out["bradley_terry"] = bradleyTerryJson(result);
    out["sensitivity"] = sensitivityJson(result);
    out["between"] = betweenJson(result);
    out["preferences_between"] = preferencesBetweenJson(result);
    out["by_study"] = byStudyJson(result);
    out["study_medians"] = mediansJson(result);
    addDetails(out, result);
    addChoices(out, result);
    addPooled(out, result);
    out["scores"] = scoresJson(result, false);
    out["scores_by_group"] = scoresJson(result, true);
    out["quality"] = qualityJson(result);
    addPeople(out, result);
    out["checks"] = Json::array();
    for (const auto& check : table.checks)
        out["checks"].push_back({{"stage", check.stage},
                                 {"kind", check.kind},
                                 {"passed", check.passed},
                                 {"failed", check.failed}});
    out["left_out"] = Json::array();
    for (const auto& one : table.left_out)
        out["left_out"].push_back({{"participant", one.participant},
                                   {"why", one.dropped ? "dropped" : "excluded"},
                                   {"reason", one.reason}});
    out["withdrawn"] = table.withdrawn;
    out["remarks"] = result.remarks;
    // Text from a study file may hold bytes that are no UTF-8.
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace deixis::results
