// How it was done, in full: a paragraph for each thing that was computed.
#include <fmt/core.h>

#include <algorithm>

#include "computed.hpp"
#include "findings.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

namespace {

/// A study tells the scale; of other data only the answers are known.
std::string ratingSentence(const ResponseTable& table, const Measure& measure, const std::string& name) {
    if (!measure.unit.empty()) return fmt::format(" {} is measured in {}; 0 is exact.", name, measure.unit);
    if (!table.study_hash.empty())
        return fmt::format(" {} is the rating on the scale from {} to {}.", name, measure.low, measure.high);
    if (measure.low == measure.high)
        return fmt::format(" {} is a rating; all answers are {}.", name, measure.low);
    return fmt::format(
        " {} is a rating; the answers range from {} to {}, and the data do not give the scale.", name,
        measure.low, measure.high);
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
                " {} runs from 2 (clearly the first) over 0 (equal) to &#8722;2 (clearly the second), "
                "whichever was on the left.",
                name);
    }
    return out;
}

std::string answersParagraph(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::string out = "<p>";
    if (isPointing2023(table))
        out += "The analysis follows section 3.1 of Deichler, Wang, Alexanderson and Beskow (2023).";
    out += measureSentences(result);
    const bool checked = !table.checks.empty();
    if (!table.study_hash.empty() || checked)
        out += checked ? " Practice trials and attention checks are left out."
                       : " Practice trials are left out.";
    if (std::any_of(table.checks.begin(), table.checks.end(),
                    [](const CheckCount& one) { return one.kind == "repeat"; }))
        out += " For a stimulus shown twice as a check, the first answer counts.";
    return out + "</p>";
}

std::string studiesParagraph(const AnalysisResult& result) {
    if (result.by_study.empty()) return "";
    return "<p><b>Several studies.</b> They have measures, scales and systems in common, and are groups of "
           "participants (the factor study): participants and items of different studies are different, even "
           "if they have the same name. Systems are compared within each study, by its own participants, and "
           "pooled, by all participants, each of whom counts once; whether a difference between systems "
           "differs between studies is tested as an interaction of system and study. Medians are of "
           "participants' means; those of single ratings, as in Yoon et al. (2021), are for description. "
           "Holm's families of pairs are those of one measure in one study, and those of one measure "
           "pooled.</p>";
}

std::string meansParagraph(const AnalysisResult& result, const Computed& computed) {
    if (result.measures.empty()) return "";
    const bool accuracy = std::any_of(result.measures.begin(), result.measures.end(),
                                      [](const Measure& one) { return one.kind == MeasureKind::accuracy; });
    std::string out =
        "<p><b>Means and standard deviations.</b> First each participant's answers to one system are "
        "averaged; the means given are means of these participants' means. \"SD participants\" is the "
        "standard deviation of the participants' means, \"SD trials\" that of all single answers";
    if (accuracy) out += ", which for right or wrong answers is about &#8730;(p(1&#8722;p))";
    out += ".";
    if (!result.levels.empty())
        out += fmt::format(" Tables by a factor's levels{} give mean and standard deviation over trials.",
                           isPointing2023(result.table) ? ", like Table&#160;1 of the paper," : "");
    out += " Standard deviations divide by n&#160;&#8722;&#160;1.</p>";
    if (computed.intervals)
        out += fmt::format(
            "<p><b>Intervals</b> of means are {:g}&#160;% bootstrap intervals over participants "
            "(bias-corrected and accelerated, {} resamples, seed {}; percentiles if the correction is not "
            "defined).</p>",
            100.0 * result.level, result.options.resamples, result.options.seed);
    return out;
}

/// "A, b, and c" of what there is.
std::string joinedWith(const std::vector<std::string>& items) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i)
        out += (i == 0 ? "" : i + 1 == items.size() ? "; and " : "; ") + items[i];
    return out;
}

std::string testsParagraph(const AnalysisResult& result, const Computed& computed) {
    if (!computed.signedRank()) return "";
    std::vector<std::string> what;
    if (computed.pairs) what.emplace_back("participants' means under two systems");
    if (computed.levels) what.emplace_back("under two levels of a factor");
    if (computed.preferences) what.emplace_back("participants' mean preferences against none");
    if (computed.chance) what.emplace_back("correct choices minus chance against none");
    if (computed.halves) what.emplace_back("the second half of a participant's answers against the first");
    if (computed.scores) what.emplace_back("a questionnaire's scores when it is asked again against before");
    if (computed.times) what.emplace_back("participants' median response times under two systems");
    const std::size_t systems = result.table.systems.size();
    const std::size_t pairs = systems * (systems - 1) / 2;
    std::vector<std::string> families;
    const std::string of_systems =
        pairs == 1 ? "the one pair of systems" : fmt::format("the {} pairs of systems", pairs);
    if (computed.pairs) families.push_back(of_systems + " within one measure");
    if (computed.levels)
        families.emplace_back("for each within-participants factor the tests of all systems");
    if (computed.preferences) families.emplace_back("all pairs in preference");
    if (computed.chance) families.emplace_back("all systems against chance");
    if (computed.halves) families.emplace_back("the halves of all measures");
    if (computed.scores) families.emplace_back("the scores of two stages");
    if (computed.times) families.emplace_back("the pairs of systems in the response times of one measure");
    std::string out = fmt::format(
        "<p><b>Tests.</b> Compared by the two-sided Wilcoxon signed-rank test, in exact fractions: {}. "
        "Differences of zero are dropped before ranking (Wilcoxon's rule), equal differences share their "
        "mean rank",
        joinedWith(what));
    if (computed.zeros) out += "; if there are zeros, Pratt's p, which ranks them, is given beside it";
    out +=
        ". W+ and W&#8722; are the rank sums of positive and negative differences. p is exact, also with "
        "ties";
    if (computed.approximate)
        out +=
            ", for up to 2,000 differences; beyond, it is a normal approximation with tie and continuity "
            "corrections";
    out += fmt::format(
        ". The shift is the median of all Walsh averages, including zeros; its interval contains the shifts "
        "that the same test does not reject, at the level of the intervals ({:g}&#160;%) and before Holm's "
        "correction. r is the rank-biserial correlation, (W+ &#8722; W&#8722;) / (W+ + W&#8722;). Holm's "
        "correction covers these families: {}. Corrected p values up to &#945;&#160;=&#160;{} count as "
        "significant. A participant without answers under one of two conditions is left out of their "
        "comparison; nothing is imputed. A non-significant difference does not show that there is none: look "
        "at its interval.</p>",
        100.0 * result.level, joinedWith(families), result.alpha);
    if (computed.friedman)
        out +=
            "<p><b>All systems at once.</b> Friedman's test, corrected for ties, and Iman and Davenport's F "
            "derived from it, for the participants with answers under every system.</p>";
    return out;
}

std::string groupsParagraphs(const AnalysisResult& result, const Computed& computed) {
    std::string out;
    if (computed.systems_apart)
        out +=
            "<p><b>Systems between participants.</b> Systems that no participant met both of are compared "
            "like groups of participants, by the two-sided Wilcoxon rank-sum test of participants' means, "
            "exact also with ties for up to 400 participants; Holm's correction covers these pairs in one "
            "measure.</p>";
    if (computed.groups || computed.preferences_of_groups || computed.scores_of_groups ||
        computed.times_of_groups) {
        out += "<p><b>Groups.</b>";
        if (computed.groups)
            out +=
                " Participants of two groups are compared by the two-sided Wilcoxon rank-sum test of their "
                "means, exact also with ties for up to 400 participants: for each system, and over all, "
                "where "
                "a participant's score is the mean of that participant's means under each system. Holm's "
                "correction covers all of these tests of one factor in one measure.";
        if (computed.preferences_of_groups)
            out +=
                " For each pair of systems, the net preferences of the participants of two groups, the means "
                "of their answers, are compared by the two-sided Wilcoxon rank-sum test; Holm's correction "
                "covers all pairs of systems and of groups of one factor.";
        if (computed.scores_of_groups || computed.times_of_groups)
            out += fmt::format(" So are {}{}{}; Holm's correction covers {}.",
                               computed.scores_of_groups ? "the scores of questionnaires" : "",
                               computed.scores_of_groups && computed.times_of_groups ? ", and " : "",
                               computed.times_of_groups ? "participants' median response times" : "",
                               "all of one factor in one stage or measure");
        out += "</p>";
    }
    if (computed.interactions)
        out += fmt::format(
            "<p><b>Interactions.</b> If two factors are crossed, each pair of levels of one and each pair of "
            "the other gives a difference of differences for each participant, in which the participant's "
            "own level and the main effects of both factors cancel (aligned observations: Hodges and Lehmann "
            "1962; "
            "interaction contrasts: Marascuilo and Levin 1970). {}{}Holm's correction covers all of one "
            "measure and pair of factors.</p>",
            result.interactions.empty() ? "" : "Within participants it is tested by the signed-rank test. ",
            result.group_interactions.empty()
                ? ""
                : "Between groups their differences are compared by the rank-sum test. ");
    if (computed.equivalence)
        out +=
            "<p><b>Equivalence.</b> If a bound was declared, two one-sided tests (Schuirmann 1987) with the "
            "same rank tests check whether the shift lies above minus the bound and below the bound; p is "
            "the larger one, with Holm's correction as for the tests of difference.</p>";
    return out;
}

std::string ratingsParagraphs(const Computed& computed) {
    std::string out;
    if (computed.ratings)
        out +=
            "<p><b>Single ratings.</b> The unit of Yoon et al. (2021, 7.2.3), requested beside participants' "
            "means: signed-rank tests of pairs of single ratings, each pair from one participant and one "
            "page, or one item, layout and distance (several of one system are averaged first); Holm's "
            "correction "
            "over the pairs of systems in one measure. Z is the normal approximation with tie and continuity "
            "corrections. A participant's ratings are not independent, so these p values are too small "
            "(pseudo-replication): the decisions are those of participants' means. No intervals are "
            "given.</p>";
    if (computed.author_trials)
        out +=
            "<p><b>Authors' trials.</b> The clips' authors may learn from one trial to the next: single "
            "ratings of clips made in an earlier trial are compared with those of a later one, by the "
            "rank-sum test, as in Yoon et al. (2021, 7.2.3), which is pseudo-replicated in the same way; and "
            "beside it each participant's mean ratings of the two, by the signed-rank test over participants "
            "who rated both. The latter generalises to other participants with these same clips; neither "
            "generalises to other authors. Holm's correction covers the systems and pairs of trials in "
            "one measure.</p>";
    return out;
}

}  // namespace

std::string methodsHtml(const AnalysisResult& result) {
    const Computed computed(result);
    std::string out = answersParagraph(result) + studiesParagraph(result) + meansParagraph(result, computed) +
                      testsParagraph(result, computed) + groupsParagraphs(result, computed);
    out += ratingsParagraphs(computed);
    if (computed.pairs || computed.preferences)
        out +=
            "<p><b>Other choices.</b> The pairs of systems are tested again with the participants who are "
            "left out (excluded, dropped out; not those who declined consent or withdrew, nor practice and "
            "checks), and without marked trials and participants who failed an attention check, if there are "
            "any. Each alternative has its own Holm families.</p>";
    if (computed.boxes)
        out +=
            "<p><b>Box plots.</b> Box: 25th to 75th percentile of the participants' means (linear "
            "interpolation, R's type&#160;7); line: median; notch: median &#177; 1.57 box heights / "
            "&#8730;n (McGill, Tukey and Larsen 1978; if two notches do not overlap, the medians differ at "
            "about the 5&#160;% level), left out if it would reach beyond its box; diamond: mean; whiskers: "
            "5th and 95th percentile; points: the participants, side by side where they would overlap. "
            "Brackets join systems that differ after Holm's correction.</p>";
    return out;
}

}  // namespace deixis::results
