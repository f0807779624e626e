#include "results/outputs/quality_outputs.hpp"

#include <algorithm>

#include "results/analysis/analysis.hpp"
#include "results/outputs/standing_out.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

using studies::LeaveOutRule;

std::string optionalText(const std::optional<double>& value, int decimals) {
    return value ? fixedText(*value, decimals) : std::string(dash);
}

std::string reliabilityHtml(const std::vector<Reliability>& all, Numbering& numbering) {
    if (std::none_of(all.begin(), all.end(), [](const Reliability& one) { return one.alpha.has_value(); }))
        return "";
    std::string out = openTable(
        units::ratings,
        "How far participants agree in rating the same clips. Krippendorff&#8217;s &#945; (2011) for "
        "interval "
        "scales: 1 where all agree, 0 as by chance. ICC of one-way analysis of variance (Shrout &amp; Fleiss "
        "1979), in which a participant who rates everything higher disagrees: ICC(1,1) of one rating, "
        "ICC(1,k) "
        "of the mean of k, the clips&#8217; mean number of ratings.",
        "<th>Measure</th><th>participants</th><th>clips</th><th>ratings</th><th>&#945;</th><th>ICC(1,1)</th>"
        "<th>ICC(1,k)</th><th>k</th>",
        numbering);
    for (const Reliability& one : all)
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td></tr>",
            escapeHtml(one.measure), one.raters, one.units, one.ratings, optionalText(one.alpha, 2),
            optionalText(one.icc_single, 2), optionalText(one.icc_mean, 2),
            one.k > 0.0 ? fixedText(one.k, 1) : dash);
    return out + close_table;
}

std::string ruleHtml(const AnalysisResult& result) {
    const LeaveOutRule& rule = result.table.leave_out;
    if (result.table.study_hash.empty()) return "";  // a file of answers knows no rules
    if (!rule.declared())
        return result.table.origins.empty()
                   ? "<p>The study declares no rule by which answers are left out.</p>"
                   : "<p>The studies declare no rule in common by which answers are left out; whom a rule of "
                     "one of them concerns is left out and named below.</p>";
    std::string out;
    const auto add = [&out](const std::string& text) { out += (out.empty() ? "" : "; ") + text; };
    if (rule.same_rating_share)
        add(fmt::format("one rating in at least {:g}&#160;% of a measure&#8217;s",
                        100.0 * *rule.same_rating_share));
    if (rule.one_side_share)
        add(fmt::format("one side in at least {:g}&#160;% of the pairs", 100.0 * *rule.one_side_share));
    if (rule.median_time_below_s)
        add(fmt::format("a median response time below {:g}&#160;s", *rule.median_time_below_s));
    return fmt::format(
        "<p>Declared before the study, of participants with at least {} such answers: {}. Whom that concerns "
        "is left out, and named among the exclusions below{}.</p>",
        LeaveOutRule::least_answers, out,
        result.table.left_out_rows.empty() ? "" : "; the section on other choices shows both results");
}

std::string sideText(const ParticipantQuality& one) {
    return one.decided == 0 ? dash : fmt::format("{} of {}", one.left, one.decided);
}

/// What nobody did, of what could be judged.
std::string nobodyText(const AnalysisResult& result) {
    const std::vector<ParticipantQuality>& people = result.quality.participants;
    const auto any = [&](const auto& judged) { return std::any_of(people.begin(), people.end(), judged); };
    constexpr int least = LeaveOutRule::least_answers;
    std::vector<std::string> what;
    if (!result.table.checks.empty()) what.emplace_back("failed a check");
    if (any([](const ParticipantQuality& one) { return one.same_of >= least; }))
        what.push_back(fmt::format("gave one rating in {:g}&#160;% of a measure&#8217;s ratings",
                                   100.0 * mostly_one_rating));
    if (any([](const ParticipantQuality& one) { return one.decided > 0; }))
        what.push_back(
            fmt::format("preferred one side more often than chance (p&#160;&#8804;&#160;{:g})", side_p));
    if (any([](const ParticipantQuality& one) { return one.times >= least; }))
        what.push_back(
            fmt::format("took unusual times in more than {:g}&#160;% of the trials", 100.0 * many_odd_times));
    if (any([](const ParticipantQuality& one) { return one.agreement.has_value(); }))
        what.emplace_back("rated against the others");
    std::string out;
    for (std::size_t i = 0; i < what.size(); ++i)
        out += (i == 0 ? "" : i + 1 == what.size() ? " or " : ", ") + what[i];
    if (out.empty()) return "";
    return people.size() == 1 ? fmt::format("<p>The participant has not {}.</p>", out)
                              : fmt::format("<p>None of {} participants {}.</p>", people.size(), out);
}

std::string participantsHtml(const AnalysisResult& result, Numbering& numbering) {
    const std::vector<ParticipantQuality>& people = result.quality.participants;
    const auto n = std::count_if(people.begin(), people.end(), standsOut);
    if (n == 0) return nobodyText(result);
    std::string out = openTable(
        units::participants,
        fmt::format(
            "Whose answers stand out, {} of {}: a failed check; one rating in {:g}&#160;% of a "
            "measure&#8217;s; one side of pairs more often than chance (exact binomial test, "
            "p&#160;&#8804;&#160;{:g}); response times more than 3 MAD from the median of all "
            "participants&#8217; logarithms (Leys et al. 2013) in more than {:g}&#160;% of the trials; "
            "ratings "
            "that go against the others&#8217; means of the same clips (r&#160;&lt;&#160;0). The tables have "
            "everybody.",
            n, people.size(), 100.0 * mostly_one_rating, side_p, 100.0 * many_odd_times),
        "<th>Participant</th><th>check</th><th>most frequent rating</th><th>longest run</th><th>left</th>"
        "<th>p</th><th>median time</th><th>fast</th><th>slow</th><th>r with others</th>",
        numbering, TableWidth::dense);
    for (const ParticipantQuality& one : people) {
        if (!standsOut(one)) continue;
        const std::string same =
            one.ratings == 0
                ? dash
                : fmt::format("{} in {}&#160;% of {}", signedText(fmt::format("{:g}", one.same_rating)),
                              fixedText(100.0 * one.same_share, 0), one.same_of);
        out += fmt::format(
            "<tr><th "
            "scope=\"row\">{}{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td><td>{}</td><td>{}</td></tr>",
            escapeHtml(one.participant), one.left_out ? " (left out)" : "",
            one.failed_check.value_or(false) ? "failed" : dash, same,
            one.ratings > 0 ? fmt::format("{}", one.longest_run) : std::string(dash), sideText(one),
            pText(one.p_side), one.median_s ? fixedText(*one.median_s, 2) + "&#160;s" : dash, one.fast,
            one.slow, optionalText(one.agreement, 2));
    }
    return out + close_table;
}

}  // namespace

std::string qualityHtml(const AnalysisResult& result, Numbering& numbering) {
    const DataQuality& quality = result.quality;
    if (quality.participants.empty()) return "";
    std::string out = "<h2>Quality of the data</h2>" + ruleHtml(result);
    out += reliabilityHtml(quality.reliability, numbering);  // tables number themselves in this order
    return out + participantsHtml(result, numbering);
}

}  // namespace deixis::results
