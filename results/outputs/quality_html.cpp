#include "results/outputs/quality_html.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "results/analysis/analysis.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "studies/study_file/leave_out_rule.hpp"

namespace deixis::results {

namespace {

using studies::LeaveOutRule;

std::string reliabilityHtml(const AnalysisResult& result, Numbering& numbering) {
    const std::vector<Reliability>& all = result.quality.reliability;
    if (std::none_of(all.begin(), all.end(), [](const Reliability& one) { return one.alpha.has_value(); }))
        return "";
    return tableHtml(tables::reliability(result),
                     "How far participants agree in rating the same clips. Krippendorff\u2019s \u03b1 (2011) "
                     "for interval scales: 1 if all agree, 0 at chance level. ICC from one-way analysis of "
                     "variance (Shrout & Fleiss 1979), "
                     "in which a participant who "
                     "rates everything higher disagrees: ICC(1,1): one rating; ICC(1,k): the mean of k, the "
                     "clips\u2019 mean number of ratings.",
                     numbering);
}

std::string ruleHtml(const AnalysisResult& result) {
    const LeaveOutRule& rule = result.table.leave_out;
    if (result.table.study_hash.empty()) return "";  // a file of answers knows no rules
    if (!rule.declared())
        return paragraphHtml(
            result.table.origins.empty()
                ? "The study declares no rule for leaving out answers."
                : "The studies declare no common rule for leaving out answers; participants left out by the "
                  "rule of one study are named below.");
    std::string out;
    const auto add = [&out](const std::string& text) { out += (out.empty() ? "" : "; ") + text; };
    if (rule.same_rating_share)
        add(fmt::format("the same rating in at least {:g}\u00a0% of a measure\u2019s answers",
                        100.0 * *rule.same_rating_share));
    if (rule.one_side_share)
        add(fmt::format("the same side in at least {:g}\u00a0% of the pairs", 100.0 * *rule.one_side_share));
    if (rule.median_time_below_s)
        add(fmt::format("a median response time below {:g}\u00a0s", *rule.median_time_below_s));
    return paragraphHtml(fmt::format(
        "Declared before the study, for participants with at least {} such answers: {}. These are left "
        "out, and named among the exclusions below{}.",
        LeaveOutRule::min_answers, out,
        result.table.left_out_rows.empty() ? "" : "; the section on other choices shows both results"));
}

/// What nobody did, of what could be judged.
std::string nobodyText(const AnalysisResult& result) {
    const std::vector<ParticipantQuality>& people = result.quality.participants;
    const auto any = [&](const auto& judged) { return std::any_of(people.begin(), people.end(), judged); };
    constexpr int min = LeaveOutRule::min_answers;
    std::vector<std::string> what;
    if (!result.table.checks.empty()) what.emplace_back("failed a check");
    if (any([](const ParticipantQuality& one) { return one.same_of >= min; }))
        what.push_back(fmt::format("gave the same rating in {:g}\u00a0% of a measure\u2019s ratings",
                                   100.0 * mostly_one_rating));
    if (any([](const ParticipantQuality& one) { return one.decided > 0; }))
        what.push_back(
            fmt::format("preferred one side more often than chance (p\u00a0\u2264\u00a0{:g})", side_p));
    if (any([](const ParticipantQuality& one) { return one.times >= min; }))
        what.push_back(
            fmt::format("took unusual times in more than {:g}\u00a0% of the trials", 100.0 * many_odd_times));
    if (any([](const ParticipantQuality& one) { return one.agreement.has_value(); }))
        what.emplace_back("rated against the others");
    std::string out;
    for (std::size_t i = 0; i < what.size(); ++i)
        out += (i == 0 ? "" : i + 1 == what.size() ? " or " : ", ") + what[i];
    if (out.empty()) return "";
    return paragraphHtml(people.size() == 1 ? fmt::format("The participant has not {}.", out)
                                            : fmt::format("None of {} participants {}.", people.size(), out));
}

std::string participantsHtml(const AnalysisResult& result, Numbering& numbering) {
    const std::vector<ParticipantQuality>& people = result.quality.participants;
    const auto n = std::count_if(people.begin(), people.end(), standsOut);
    if (n == 0) return nobodyText(result);
    using Row = ParticipantQuality;
    std::vector<Row> shown;
    std::copy_if(people.begin(), people.end(), std::back_inserter(shown), standsOut);
    const Show right{.right = true};
    const auto same = [](const Row& one) {
        if (one.ratings == 0) return std::string("\u2013");
        return fmt::format("{}{:g} in {}\u00a0% of {}", one.same_rating < 0.0 ? "\u2212" : "",
                           std::abs(one.same_rating), fixedText(100.0 * one.same_share, 0), one.same_of);
    };
    const Fields<Row> fields{
        {"participant",
         [](auto& one) { return one.participant + (one.left_out ? " (left out)" : ""); },
         {.label = "Participant"}},
        {"check", [](auto& one) { return one.failed_check.value_or(false) ? "failed" : "\u2013"; }, right},
        {"most_frequent_rating", same, right},
        {"longest_run", [](auto& one) { return known(one.ratings > 0, one.longest_run); }},
        {"left",
         [](auto& one) {
             return one.decided == 0 ? "\u2013" : fmt::format("{} of {}", one.left, one.decided);
         },
         right},
        {"p", &Row::p_side},
        {"median_time",
         [](auto& one) { return one.median_s ? fixedText(*one.median_s, 2) + "\u00a0s" : "\u2013"; }, right},
        {"fast", &Row::fast},
        {"slow", &Row::slow},
        {"agreement", &Row::agreement, {.label = "r with others"}}};
    return tableHtml(
        tableOf("standing_out", units::participants, "", fields, shown),
        fmt::format("Whose answers stand out, {} of {}: a failed check; the same rating in {:g}\u00a0% of a "
                    "measure\u2019s answers; one side of pairs more often than chance (exact binomial test, "
                    "p\u00a0\u2264\u00a0{:g}); response times more than 3 "
                    "MAD from the median of all participants\u2019 logarithms (Leys et al. "
                    "2013) in more than {:g}\u00a0% of the "
                    "trials; ratings opposite to the others\u2019 means of the same clips (r\u00a0<\u00a00). "
                    "The exported tables have all participants.",
                    n, people.size(), 100.0 * mostly_one_rating, side_p, 100.0 * many_odd_times),
        numbering, dense_table);
}

}  // namespace

Section qualitySection(const AnalysisResult& result, Numbering& numbering) {
    const DataQuality& quality = result.quality;
    if (quality.participants.empty()) return {};
    std::string out = ruleHtml(result);
    out += reliabilityHtml(result, numbering);  // tables number themselves in this order
    return {"Quality of the data", out + participantsHtml(result, numbering)};
}

bool standsOut(const ParticipantQuality& one) {
    constexpr int min = studies::LeaveOutRule::min_answers;
    return one.failed_check.value_or(false) || (one.same_of >= min && one.same_share >= mostly_one_rating) ||
           (one.p_side && *one.p_side <= side_p) ||
           (one.times >= min && one.fast + one.slow > many_odd_times * one.times) ||
           (one.agreement && *one.agreement < 0.0);
}

}  // namespace deixis::results
