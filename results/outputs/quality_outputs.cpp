#include "results/outputs/quality_outputs.hpp"

#include <algorithm>

#include "results/analysis/analysis.hpp"
#include "results/page/report_tables.hpp"
#include "results/tables/json_values.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::ordered_json;
using studies::LeaveOutRule;

// From where on the page names a participant; nobody is left out for it.
constexpr double mostly_one_rating = 0.9;
constexpr double side_p = 0.01;
constexpr double many_odd_times = 0.1;

bool mostlyOneRating(const ParticipantQuality& one) {
    return one.same_of >= LeaveOutRule::least_answers && one.same_share >= mostly_one_rating;
}

bool oddTimes(const ParticipantQuality& one) {
    return one.times >= LeaveOutRule::least_answers && one.fast + one.slow > many_odd_times * one.times;
}

bool standsOut(const ParticipantQuality& one) {
    return one.failed_check.value_or(false) || mostlyOneRating(one) ||
           (one.p_side && *one.p_side <= side_p) || oddTimes(one) || (one.agreement && *one.agreement < 0.0);
}

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

Json qualityJson(const AnalysisResult& result) {
    const LeaveOutRule& rule = result.table.leave_out;
    Json out;
    out["rule"] = {{"same_rating_share", numberOrNull(rule.same_rating_share)},
                   {"one_side_share", numberOrNull(rule.one_side_share)},
                   {"median_time_below_s", numberOrNull(rule.median_time_below_s)},
                   {"least_answers", LeaveOutRule::least_answers}};
    out["reliability"] = Json::array();
    for (const Reliability& one : result.quality.reliability)
        out["reliability"].push_back({{"measure", one.measure},
                                      {"participants", one.raters},
                                      {"clips", one.units},
                                      {"ratings", one.ratings},
                                      {"krippendorff_alpha", numberOrNull(one.alpha)},
                                      {"icc_1_1", numberOrNull(one.icc_single)},
                                      {"icc_1_k", numberOrNull(one.icc_mean)},
                                      {"k", numberOrNull(one.k > 0.0, one.k)}});
    out["participants"] = Json::array();
    for (const ParticipantQuality& one : result.quality.participants)
        out["participants"].push_back({{"participant", one.participant},
                                       {"left_out", one.left_out},
                                       {"stands_out", standsOut(one)},
                                       {"failed_check", one.failed_check ? Json(*one.failed_check) : Json()},
                                       {"ratings", one.ratings},
                                       {"same_rating", numberOrNull(one.ratings > 0, one.same_rating)},
                                       {"same_share", numberOrNull(one.ratings > 0, one.same_share)},
                                       {"same_of", one.same_of},
                                       {"same_measure", one.same_measure},
                                       {"longest_run", one.longest_run},
                                       {"pairs_decided", one.decided},
                                       {"pairs_left", one.left},
                                       {"p_side", numberOrNull(one.p_side)},
                                       {"times", one.times},
                                       {"median_time_s", numberOrNull(one.median_s)},
                                       {"fast", one.fast},
                                       {"slow", one.slow},
                                       {"agreement", numberOrNull(one.agreement)}});
    return out;
}

PlainTable reliabilityTable(const AnalysisResult& result) {
    using enum ColumnType;
    PlainTable out{"reliability",
                   units::ratings,
                   "Agreement of participants in rating the same clips",
                   {{"measure", text, Print::plain},
                    {"participants", whole, Print::plain},
                    {"clips", whole, Print::plain},
                    {"ratings", whole, Print::plain},
                    {"krippendorff_alpha", number, Print::plain, "$\\alpha$"},
                    {"icc_1_1", number, Print::plain, "ICC(1,1)"},
                    {"icc_1_k", number, Print::plain, "ICC(1,$k$)"},
                    {"k", number, Print::plain, "$k$"}}};
    for (const Reliability& one : result.quality.reliability)
        out.rows.push_back({one.measure, wholeCell(one.raters), wholeCell(one.units), wholeCell(one.ratings),
                            plainCell(one.alpha), plainCell(one.icc_single), plainCell(one.icc_mean),
                            knownCell(one.k > 0.0, one.k)});
    return out;
}

PlainTable qualityTable(const AnalysisResult& result) {
    using enum ColumnType;
    PlainTable out{"quality",
                   units::participants,
                   "How participants answered",
                   {{"participant", text},
                    {"left_out", truth},
                    {"stands_out", truth},
                    {"failed_check", truth},
                    {"ratings", whole},
                    {"same_rating", number},
                    {"same_share", number},
                    {"same_of", whole},
                    {"same_measure", text},
                    {"longest_run", whole},
                    {"pairs_decided", whole},
                    {"pairs_left", whole},
                    {"p_side", number},
                    {"times", whole},
                    {"median_time_s", number},
                    {"fast", whole},
                    {"slow", whole},
                    {"agreement", number}}};
    for (const ParticipantQuality& one : result.quality.participants)
        out.rows.push_back(
            {one.participant, one.left_out, standsOut(one),
             one.failed_check ? PlainCell(*one.failed_check) : PlainCell(), wholeCell(one.ratings),
             knownCell(one.ratings > 0, one.same_rating), knownCell(one.ratings > 0, one.same_share),
             wholeCell(one.same_of), one.same_measure, wholeCell(one.longest_run), wholeCell(one.decided),
             wholeCell(one.left), plainCell(one.p_side), wholeCell(one.times), plainCell(one.median_s),
             wholeCell(one.fast), wholeCell(one.slow), plainCell(one.agreement)});
    return out;
}

}  // namespace deixis::results
