// Tables of the people: what they told, how carefully they answered, who is left out.
#include <fmt/format.h>

#include "results/outputs/analysis_tables.hpp"
#include "results/outputs/quality_html.hpp"
#include "test_fields.hpp"

namespace deixis::results::tables {

Table scores(const AnalysisResult& result) {
    Table out = tableOf<ScoreResult>(
        "scores", units::scores, "Scores of questionnaires over participants",
        {{"stage", &ScoreResult::stage, {.heading = true}},
         {"score", &ScoreResult::score},
         {"factor", &ScoreResult::factor, {.sparse = true, .heading = true}},
         {"level", &ScoreResult::level, {.sparse = true}},
         {"group",
          [](auto& one) { return one.factor.empty() ? "all" : one.factor + ": " + one.level; },
          {.label = "Group", .in = page_only}},
         {"mean", &ScoreResult::mean},
         {"sd", [](auto& one) { return known(one.n > 1, one.sd); }},
         {"n", &ScoreResult::n},
         {"q25", &ScoreResult::q25},
         {"median", &ScoreResult::median},
         {"q75", &ScoreResult::q75}},
        result.scores);
    for (Table::Row& row : out.rows) row.all = !result.table.between.empty() && row.cells[2].text().empty();
    return out;
}

Table scoreChanges(const AnalysisResult& result) {
    Table out = tableOf("score_changes", units::scores, "",
                        joined<ScoreChange>({{"score", &ScoreChange::score},
                                             {"a", &ScoreChange::a},
                                             {"b", &ScoreChange::b},
                                             {"mean_a", &ScoreChange::mean_a},
                                             {"mean_b", &ScoreChange::mean_b}},
                                            testFields(result)),
                        result.score_changes);
    out.column("p_holm").marked = true;
    return out;
}

Table scoreGroups(const AnalysisResult& result) {
    return tableOf("score_groups", units::scores, "",
                   joined<ScoreGroupResult>({{"stage", &ScoreGroupResult::stage},
                                             {"score", &ScoreGroupResult::score},
                                             {"factor", &ScoreGroupResult::factor},
                                             {"a", &ScoreGroupResult::a},
                                             {"b", &ScoreGroupResult::b}},
                                            groupFields(result)),
                   result.score_groups);
}

Table participantFields(const AnalysisResult& result) {
    const auto number = [](double FieldResult::*of) {
        return [=](const FieldResult& one) { return known(one.options.empty(), one.*of); };
    };
    const auto options = [](const FieldResult& one) {
        Json out = Json::object();
        for (const auto& [option, n] : one.options) out[option] = n;
        return out;
    };
    return tableOf<FieldResult>("participant_fields", units::participants, "",
                                {{"field", &FieldResult::field},
                                 {"n", &FieldResult::n},
                                 {"median", number(&FieldResult::median)},
                                 {"min", number(&FieldResult::min)},
                                 {"max", number(&FieldResult::max)},
                                 {"options", options}},
                                result.fields);
}

Table sessionTimes(const AnalysisResult& result) {
    return tableOf<SessionTimeResult>("session_times", units::participants, "",
                                      {{"factor", &SessionTimeResult::factor},
                                       {"level", &SessionTimeResult::level},
                                       {"n", &SessionTimeResult::n},
                                       {"median_min", &SessionTimeResult::median_min},
                                       {"min_min", &SessionTimeResult::min_min},
                                       {"max_min", &SessionTimeResult::max_min}},
                                      result.session_times);
}

Table reliability(const AnalysisResult& result) {
    return tableOf<Reliability>(
        "reliability", units::ratings, "Agreement of participants in rating the same clips",
        {{"measure", &Reliability::measure, {.format = Format::plain}},
         {"participants", &Reliability::raters},
         {"clips", &Reliability::units},
         {"ratings", &Reliability::ratings},
         {"krippendorff_alpha", &Reliability::alpha},
         {"icc_1_1", &Reliability::icc_single, {"ICC(1,1)", "ICC(1,1)"}},
         {"icc_1_k", &Reliability::icc_mean, {"ICC(1,k)", "ICC(1,$k$)"}},
         {"k", [](auto& one) { return known(one.k > 0.0, one.k); }, {"k", "$k$", Format::one_decimal}}},
        result.quality.reliability);
}

Table quality(const AnalysisResult& result) {
    using Row = ParticipantQuality;
    const auto rated = [](auto member) {
        return [=](const Row& one) { return known(one.ratings > 0, one.*member); };
    };
    return tableOf<Row>("quality", units::participants, "How participants answered",
                        {{"participant", &Row::participant},
                         {"left_out", &Row::left_out},
                         {"stands_out", standsOut},
                         {"failed_check", &Row::failed_check},
                         {"ratings", &Row::ratings},
                         {"same_rating", rated(&Row::same_rating)},
                         {"same_share", rated(&Row::same_share)},
                         {"same_of", &Row::same_of},
                         {"same_measure", &Row::same_measure},
                         {"longest_run", &Row::longest_run},
                         {"pairs_decided", &Row::decided},
                         {"pairs_left", &Row::left},
                         {"p_side", &Row::p_side, {.label = "p", .format = Format::p_value}},
                         {"times", &Row::times},
                         {"median_time_s", &Row::median_s},
                         {"fast", &Row::fast},
                         {"slow", &Row::slow},
                         {"agreement", &Row::agreement, {.label = "r with others"}}},
                        result.quality.participants);
}

Table checks(const AnalysisResult& result) {
    return tableOf<CheckCount>("checks", units::checks, "Attention checks",
                               {{"stage", &CheckCount::stage, {.heading = true}},
                                {"kind", &CheckCount::kind, {.label = "Kind"}},
                                {"passed", &CheckCount::passed},
                                {"failed", &CheckCount::failed}},
                               result.table.checks);
}

Table leftOut(const AnalysisResult& result) {
    return tableOf<LeftOut>("left_out", units::participants, "Participants left out",
                            {{"participant", &LeftOut::participant},
                             {"why", [](auto& one) { return one.dropped ? "dropped" : "excluded"; }},
                             {"reason", &LeftOut::reason}},
                            result.table.left_out);
}

}  // namespace deixis::results::tables
