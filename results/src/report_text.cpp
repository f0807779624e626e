#include "report_text.hpp"

#include "analysis_details.hpp"
#include "report_interactions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "observers_html.hpp"

namespace deixis::results {

std::string escapeHtml(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                // Control characters are not allowed in XML.
                if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') out += c;
        }
    }
    return out;
}

std::string pText(double p) {
    return p < 0.001 ? "&lt;0.001" : fmt::format("{:.3f}", p);
}

std::string starsText(double p) {
    return p <= 0.001 ? "***" : p <= 0.01 ? "**" : p <= 0.05 ? "*" : fmt::format("p = {:.2f}", p);
}

std::string pText(const std::optional<double>& p) {
    return p ? pText(*p) : std::string(dash);
}

std::string fixedText(double value, int decimals) {
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool zero = digits.find_first_not_of("0.") == std::string::npos;
    return (value < 0.0 && !zero ? "\u2212" : "") + digits;
}

std::string scoreText(const Measure& measure, double value) {
    return measure.kind == MeasureKind::accuracy ? fixedText(100.0 * value, 1) + "\u00a0%"
                                                 : fixedText(value, 2);
}

std::string intervalText(const Measure& measure, double lower, double upper) {
    return fmt::format("[{}, {}]", scoreText(measure, lower), scoreText(measure, upper));
}

std::string shiftText(const HodgesLehmann& shift, const std::function<std::string(double)>& text) {
    if (!shift.estimate) return dash;
    if (!shift.lower || !shift.upper) return text(*shift.estimate);
    return fmt::format("{} {}{}, {}{}", text(*shift.estimate), shift.lower_included ? "[" : "(",
                       text(*shift.lower), text(*shift.upper), shift.upper_included ? "]" : ")");
}

std::string signedText(std::string_view number) {
    return number.starts_with('-') ? "&#8722;" + std::string(number.substr(1)) : std::string(number);
}

std::string ballsText(const Measure& measure) {
    return measure.fewest_balls < measure.balls
               ? fmt::format("1 of {} to {} balls", measure.fewest_balls, measure.balls)
               : fmt::format("1 of {} balls", measure.balls);
}

std::string capitalised(std::string_view text) {
    std::string out(text);
    if (!out.empty() && out.front() >= 'a' && out.front() <= 'z')
        out.front() = static_cast<char>(out.front() - 32);
    return out;
}

namespace {

std::string extremes(const AnalysisResult& result, std::size_t measure) {
    std::vector<const SystemResult*> answered;
    for (const auto& system : result.systems)
        if (system.measures[measure].n > 0) answered.push_back(&system);
    if (answered.size() < 2) return "";
    const Measure& of = result.measures[measure];
    const auto value = [&](const SystemResult* s) { return s->measures[measure].mean; };
    std::stable_sort(answered.begin(), answered.end(),
                     [&](const auto* a, const auto* b) { return value(a) > value(b); });
    const double highest = value(answered.front());
    const double lowest = value(answered.back());
    const auto equal = [](double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(a); };
    if (equal(highest, lowest))
        return fmt::format("All systems had the same mean {} ({}).", escapeHtml(of.name),
                           scoreText(of, highest));
    // Several may have the same mean.
    const auto named = [&](double mean) {
        std::vector<std::string> names;
        for (const SystemResult* s : answered)
            if (equal(value(s), mean))
                names.push_back(fmt::format("<b>{}</b>{}", escapeHtml(s->system),
                                            hasManySteps(of)
                                                ? fmt::format(" (median of participants {})",
                                                              scoreText(of, s->measures[measure].median))
                                                : ""));
        std::string out;
        for (std::size_t i = 0; i < names.size(); ++i)
            out += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
        return fmt::format("{} ({}{})", out, names.size() > 1 ? "each " : "", scoreText(of, mean));
    };
    return fmt::format("{} had the highest mean {}, {} the lowest.", named(highest), escapeHtml(of.name),
                       named(lowest));
}

/// Pairs of systems, by the signed-rank tests of who met both, and by the rank-sum tests where nobody did.
std::string significance(const AnalysisResult& result, const std::string& measure) {
    int pairs = 0;
    int significant = 0;
    std::string others;
    const auto count = [&](const std::string& a, const std::string& b, bool is_significant) {
        ++pairs;
        if (is_significant)
            ++significant;
        else
            others += fmt::format("{}{} and {}", others.empty() ? "" : "; ", escapeHtml(a), escapeHtml(b));
    };
    for (const auto& one : result.pairwise)
        if (one.measure == measure && one.test.n_pairs > 0) count(one.a, one.b, one.significant);
    bool between = false;
    for (const BetweenResult& one : result.between)
        if (one.measure == measure && one.factor == systems_between && one.test.p_two_sided) {
            count(one.a, one.b, one.significant);
            between = true;
        }
    if (pairs == 0) return "";
    std::string out = pairs == 1 ? fmt::format("The test of the two systems is {}significant in {}",
                                               significant == 1 ? "" : "not ", escapeHtml(measure))
                                 : fmt::format("{} of {} pairs of systems differ significantly in {}",
                                               significant, pairs, escapeHtml(measure));
    if (significant > 0 && !others.empty()) out += " (not significant: " + others + ")";
    if (between) out += ", compared between participants";
    return out + ".";
}

std::string levelSentence(const AnalysisResult& result, const std::string& measure,
                          const std::string& factor) {
    std::vector<std::string> systems;
    bool tested = false;
    bool over_systems = false;
    for (const auto& comparison : result.level_tests) {
        if (comparison.factor != factor || comparison.measure != measure) continue;
        tested = tested || comparison.test.n_pairs > 0;
        over_systems = comparison.system == "all";
        if (comparison.significant && (systems.empty() || systems.back() != comparison.system))
            systems.push_back(comparison.system);
    }
    if (!tested) return "";
    std::string names;
    for (const auto& system : systems) names += (names.empty() ? "" : ", ") + escapeHtml(system);
    if (systems.empty())
        return fmt::format(
            "No test of {} is significant in {}{}; that does not show that it makes no "
            "difference.",
            escapeHtml(factor), escapeHtml(measure), over_systems ? "" : ", for any system");
    return fmt::format("The {} made a significant difference to {}{}.", escapeHtml(factor),
                       escapeHtml(measure), over_systems ? "" : " for " + names);
}

std::string groupSentence(const AnalysisResult& result, const std::string& measure,
                          const std::string& factor) {
    bool tested = false;
    std::string names;
    for (const BetweenResult& one : result.between) {
        if (one.factor != factor || one.measure != measure) continue;
        tested = tested || one.test.p_two_sided;
        if (one.significant)
            names += fmt::format("{}{} and {} ({})", names.empty() ? "" : ", ", escapeHtml(one.a),
                                 escapeHtml(one.b),
                                 one.system == "all" ? "over all systems" : escapeHtml(one.system));
    }
    if (!tested) return "";
    return names.empty()
               ? fmt::format(
                     "No test of the groups by {} is significant in {}; that does not show that they "
                     "are alike.",
                     escapeHtml(factor), escapeHtml(measure))
               : fmt::format("Groups by {} that differ significantly in {}: {}.", escapeHtml(factor),
                             escapeHtml(measure), names);
}

std::string groupPreferenceSentence(const AnalysisResult& result, const std::string& factor) {
    bool tested = false;
    std::string names;
    for (const PreferenceBetweenResult& one : result.preferences_between) {
        if (one.factor != factor) continue;
        tested = tested || one.test.p_two_sided;
        if (one.significant)
            names += fmt::format("{}{} and {} ({} and {})", names.empty() ? "" : ", ", escapeHtml(one.a),
                                 escapeHtml(one.b), escapeHtml(one.system), escapeHtml(one.other_system));
    }
    if (!tested) return "";
    return names.empty()
               ? fmt::format(
                     "No test of the groups by {} is significant in their preferences; that does not "
                     "show that they are alike.",
                     escapeHtml(factor))
               : fmt::format("Groups by {} that differ significantly in their preferences: {}.",
                             escapeHtml(factor), names);
}

std::string preferenceSentence(const AnalysisResult& result) {
    if (result.preferences.empty()) return "";
    std::string out;
    for (const auto& pair : result.preferences)
        if (pair.significant)
            out += fmt::format("{}<b>{}</b> to {}", out.empty() ? "" : ", ",
                               escapeHtml(pair.mean > 0.0 ? pair.a : pair.b),
                               escapeHtml(pair.mean > 0.0 ? pair.b : pair.a));
    return out.empty()
               ? "No preference between two systems is significant; that does not show that there is none."
               : "Significantly preferred: " + out + ".";
}

}  // namespace

std::string findingsHtml(const AnalysisResult& result) {
    // What simulated participants chose is one observer's reading.
    std::string out = result.synthetic ? observersFinding(result.observers) : std::string();
    for (std::size_t measure = 0; measure < result.measures.size(); ++measure) {
        std::string item = extremes(result, measure);
        if (result.participants > 1) item += " " + significance(result, result.measures[measure].name);
        if (item.size() > 1) out += "<li>" + item + "</li>";
    }
    if (result.participants > 1) {
        std::vector<std::string> items;
        for (const Measure& measure : result.measures) {
            for (const Factor& factor : withinFactors(result.table))
                items.push_back(levelSentence(result, measure.name, factor.name));
            for (const Factor& factor : result.table.between)
                items.push_back(groupSentence(result, measure.name, factor.name));
        }
        items.push_back(preferenceSentence(result));
        for (const Factor& factor : result.table.between)
            items.push_back(groupPreferenceSentence(result, factor.name));
        for (const auto& item : items)
            if (!item.empty()) out += "<li>" + item + "</li>";
        out += interactionFindings(result);
    }
    if (out.empty()) return "";
    out = "<ul class=\"findings\">" + out + "</ul>";
    if (result.participants > 1)
        out += fmt::format(
            "<p class=\"small\">Significant: at &#945;&#160;=&#160;{}, two-sided Wilcoxon signed-rank "
            "tests over participants{}, after Holm's correction.</p>",
            result.alpha,
            result.between.empty() && result.preferences_between.empty() ? "" : " (groups: rank-sum tests)");
    return out;
}

namespace {

/// A study tells the scale; of other data only the answers are known.
std::string ratingSentence(const ResponseTable& table, const Measure& measure, const std::string& name) {
    if (!table.study_hash.empty())
        return fmt::format(" {} is the rating on the scale from {} to {}.", name, measure.low, measure.high);
    if (measure.low == measure.high)
        return fmt::format(" {} is a rating; all answers are {}.", name, measure.low);
    return fmt::format(" {} is a rating; the answers go from {} to {}, and the data do not tell the scale.",
                       name, measure.low, measure.high);
}

std::string measureSentences(const AnalysisResult& result) {
    std::string out;
    for (const Measure& measure : result.table.measures) {
        const std::string name = escapeHtml(capitalised(measure.name));
        if (measure.kind == MeasureKind::accuracy)
            out += fmt::format(
                " {} is the share of trials of the referential game in which the target was chosen{}.", name,
                measure.balls > 1 ? fmt::format(" (chance: {})", ballsText(measure)) : std::string());
        else if (measure.kind == MeasureKind::rating)
            out += ratingSentence(result.table, measure, name);
        else
            out += fmt::format(
                " {} runs from 2 (clearly the one) over 0 (equal) to &#8722;2 (clearly the other), whichever "
                "stood left.",
                name);
    }
    return out;
}

}  // namespace

std::string methodsHtml(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const auto pairs = table.systems.size() * (table.systems.size() - 1) / 2;
    std::string out = fmt::format(
        "<p>The analysis follows section 3.1 of Deichler, Wang, Alexanderson and Beskow (2023).{} Practice "
        "trials "
        "and attention checks are left out; of a stimulus that was shown twice as a check the first answer "
        "counts.</p>",
        measureSentences(result));
    out +=
        "<p><b>Means and standard deviations.</b> First each participant's answers to one system are "
        "averaged; the means given are means of these participants' means. \"SD participants\" is the "
        "standard "
        "deviation of the participants' means, \"SD trials\" that of all single answers, which for right or "
        "wrong "
        "answers is about &#8730;(p(1&#8722;p)). Tables by layout and by distance, like Table&#160;1 of the "
        "paper, "
        "give mean and standard deviation over trials. Both divide by n&#160;&#8722;&#160;1.</p>";
    out += fmt::format(
        "<p><b>Intervals</b> of means are {:g}&#160;% bootstrap intervals over participants (bias-corrected "
        "and "
        "accelerated, {} resamples, seed {}; percentiles where the correction is not defined).</p>",
        100.0 * result.level, result.options.resamples, result.options.seed);
    out += fmt::format(
        "<p><b>Tests.</b> Two systems are compared by the two-sided Wilcoxon signed-rank test of the "
        "participants' means, whose differences are computed in exact fractions. Differences of zero are "
        "dropped "
        "before ranking (Wilcoxon's rule), equal differences share their mean rank; where there are zeros, "
        "Pratt's p, which ranks them, stands beside. W+ and W&#8722; are the rank sums of positive and "
        "negative "
        "differences. p is exact, with ties too, for up to 2,000 differences; beyond, it is a normal "
        "approximation with tie and continuity corrections. The shift is the median of all Walsh averages, "
        "zeros "
        "among them; its interval holds the shifts that the same test does not reject, at the level of the "
        "intervals and before Holm's correction. Holm's correction covers {}for each factor "
        "within participants the tests of all systems; corrected p "
        "values "
        "up "
        "to &#945;&#160;=&#160;{} count as significant. A participant without answers under one of two "
        "conditions "
        "is left out of their comparison; nothing is filled in. That a difference is not significant does "
        "not "
        "show that there is none: look at its interval.{}</p>",
        pairs == 0 ? ""
                   : fmt::format("the {} of systems within one measure, and ",
                                 pairs == 1 ? "one pair" : fmt::format("{} pairs", pairs)),
        result.alpha,
        result.preferences.empty() ? ""
                                   : " Preferences: the same test of the participants' mean preferences "
                                     "against none, Holm over all pairs.");
    if (std::any_of(result.between.begin(), result.between.end(), [](const BetweenResult& one) {
            return one.factor == systems_between && one.test.p_two_sided;
        }))
        out +=
            "<p><b>Systems between participants.</b> Systems that no participant met both of are compared as "
            "groups of participants are, by the two-sided Wilcoxon rank-sum test of participants' means, "
            "exact "
            "with ties too for up to 400 participants; Holm's correction covers these pairs in one "
            "measure.</p>";
    if (!table.between.empty())
        out +=
            "<p><b>Groups.</b> Participants of two groups are compared by the two-sided Wilcoxon rank-sum "
            "test "
            "of their means, exact with ties too for up to 400 participants: for each system, and over all, "
            "where a participant's score is the mean of that participant's means under each system. Holm's "
            "correction covers all of these tests of one factor in one measure. In preferences the same test "
            "compares, for each pair of systems, the participants' net preferences, the means of their "
            "answers; "
            "Holm's correction covers all pairs of systems and of groups of one factor.</p>";
    if (!result.interactions.empty() || !result.group_interactions.empty())
        out +=
            "<p><b>Interactions.</b> Where two factors cross, each pair of levels of the one and each of the "
            "other "
            "makes a difference of differences of each participant, in which participants' own level and "
            "both "
            "factors by themselves cancel (aligned observations: Hodges and Lehmann 1962; interaction "
            "contrasts: "
            "Marascuilo and Levin 1970). Within participants it is tested by the signed-rank test; between "
            "groups "
            "their differences are compared by the rank-sum test. Holm's correction covers all of one "
            "measure and "
            "pair of factors.</p>";
    if (std::any_of(result.measures.begin(), result.measures.end(),
                    [](const Measure& one) { return one.equivalence_bound > 0.0; }))
        out +=
            "<p><b>Equivalence.</b> Where a bound was declared, two one-sided tests (Schuirmann 1987) by the "
            "same "
            "rank tests ask whether the shift lies above the bound's negative and below the bound; p is the "
            "larger "
            "one, Holm's correction as for the tests of difference.</p>";
    out +=
        "<p><b>Other choices.</b> The pairs of systems are tested again with the participants who are left "
        "out "
        "(excluded, dropped out; not who refused consent, withdrew, or answered practice and checks), and "
        "without marked trials and participants who failed an attention check. Each choice has Holm families "
        "of its own.</p>";
    out +=
        "<p><b>Box plots.</b> Box: 25th to 75th percentile of the participants' means (linear interpolation, "
        "R's type&#160;7); line: median; notch: median &#177; 1.57 box heights / &#8730;n (McGill, Tukey and "
        "Larsen 1978; where two notches do not overlap, the medians differ at about 5&#160;%; with few "
        "participants a notch folds back beyond its box); diamond: mean; whiskers: 5th and 95th percentile; "
        "points: the participants, spread sideways where they would cover each other. Brackets join systems "
        "that differ after Holm's correction.</p>";
    return out;
}

}  // namespace deixis::results
