#include "ratings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

namespace {

constexpr const char* pseudo_replicated =
    "pseudo-replicated: ratings of one participant are not independent, so p is too small";

std::string medianText(const Measure& measure, const std::optional<double>& median) {
    return median ? scoreText(measure, *median) : std::string(dash);
}

/// "Medians of all ratings, highest first: x 56.00, y 54.00."
std::string mediansInOrder(const std::vector<const RatingComparison*>& pairs, const Measure& measure) {
    std::vector<std::pair<std::string, double>> medians;
    const auto add = [&](const std::string& system, const std::optional<double>& median) {
        const auto known = [&](const auto& one) { return one.first == system; };
        if (median && std::none_of(medians.begin(), medians.end(), known))
            medians.emplace_back(system, *median);
    };
    for (const RatingComparison* one : pairs) {
        add(one->a, one->median_a);
        add(one->b, one->median_b);
    }
    std::stable_sort(medians.begin(), medians.end(),
                     [](const auto& one, const auto& other) { return one.second > other.second; });
    std::string out;
    for (const auto& [system, median] : medians)
        out += fmt::format("{}{} {}", out.empty() ? "" : ", ", system, scoreText(measure, median));
    return out;
}

}  // namespace

std::string ratingPairsHtml(const AnalysisResult& result, const Measure& measure, const std::string& where,
                            Numbering& numbering) {
    std::vector<const RatingComparison*> pairs;
    bool tested = false;
    for (const RatingComparison& one : result.rating_pairs)
        if (one.measure == measure.name) {
            pairs.push_back(&one);
            tested = tested || one.test.n_pairs > 0;
        }
    if (!tested) return "";
    return tableHtml(
               tables::ratingPairs(result).where("measure", measure.name),
               fmt::format("{}, all pairs of systems{} again by single ratings, {}. Pairs: a participant's "
                           "two ratings on one page, or of one item.",
                           capitalised(measure.name), where, pseudo_replicated),
               {"a",
                "b",
                "median_a",
                "median_b",
                {"n", "pairs"},
                "participants",
                "z",
                "p",
                "p_holm",
                "rating_verdict"},
               numbering, {true, false}) +
           noteHtml(fmt::format(
               "Holm's family: {}, \u03b1\u00a0=\u00a0{}. Z: normal approximation. Medians of all "
               "ratings, highest first: {}.",
               counted(pairs.front()->family_size, "test", "tests"), result.alpha,
               mediansInOrder(pairs, measure)));
}

namespace {

/// The trials by their numbers.
Table namedTrials(Table table) {
    for (Table::Row& row : table.rows)
        for (const char* column : {"a", "b"}) {
            Cell& cell = row.cells[table.at(column)];
            cell = "trial " + cell.text();
        }
    return table;
}

}  // namespace

std::string authorTrialsHtml(const AnalysisResult& result, const std::string& where, Numbering& numbering) {
    if (result.author_trials.empty()) return "";
    std::string out = tableHtml(
        namedTrials(tables::authorTrials(result)),
        fmt::format(
            "Ratings{} of clips that their authors made in an earlier trial (A) against those of a later "
            "one (B), to see whether authors learn: rank-sum test, {}.",
            where, pseudo_replicated),
        {"measure", "system", "a", "b", "n_a", "n_b", "median_a", "median_b", "z", "p", "p_holm"}, numbering,
        dense_table);
    Table paired = namedTrials(tables::authorTrialsPaired(result));
    paired.column("p_holm").marked = true;
    out += tableHtml(
        paired,
        fmt::format("The same{} by participants: each one's mean rating of clips from trial A minus that "
                    "from trial B, signed-rank test of those who rated both; it generalises to other "
                    "participants with these same clips, not to other authors. Bold: significant.",
                    where),
        {"measure", "system", "a", "b", "median_a", "median_b", "n", "hodges_lehmann", "rank_biserial", "p",
         "p_holm"},
        numbering, dense_table);
    return out +
           noteHtml(fmt::format("Holm's families: {} by ratings, {} by participants, \u03b1\u00a0=\u00a0{}. "
                                "A non-significant difference is not shown to be zero.",
                                counted(result.author_trials.front().family_size, "test", "tests"),
                                result.author_trials_paired.front().family_size, result.alpha));
}

namespace {

/// "Z = 5.74, p &lt; 0.001, Holm-corrected p &lt; 0.001".
std::string testText(const std::optional<double>& z, const std::optional<double>& p,
                     const std::optional<double>& p_holm) {
    const auto equals = [](const std::optional<double>& value) {
        return !value ? std::string("not defined") : (*value < 0.001 ? "" : "= ") + pText(*value);
    };
    return fmt::format("Z = {}, p {}, Holm-corrected p {}", z ? fixedText(*z, 2) : "not defined", equals(p),
                       equals(p_holm));
}

}  // namespace

std::string ratingResults(const AnalysisResult& result, const std::string& where, const Measure& measure) {
    const std::string name = capitalised(measure.name) + where;
    std::string pairs;
    for (const RatingComparison& one : result.rating_pairs)
        if (one.measure == measure.name && one.test.n_pairs > 0)
            pairs += fmt::format("{}{} against {} (medians {} and {}, n = {} pairs of ratings, {})",
                                 pairs.empty() ? "" : "; ", escapeHtml(one.a), escapeHtml(one.b),
                                 medianText(measure, one.median_a), medianText(measure, one.median_b),
                                 one.test.n_pairs, testText(one.test.z, one.test.p_two_sided, one.p_holm));
    std::string trials;
    for (std::size_t i = 0; i < result.author_trials.size(); ++i) {
        const AuthorTrialResult& one = result.author_trials[i];
        const MedianComparison& paired = result.author_trials_paired[i];
        if (one.measure != measure.name) continue;
        trials += fmt::format("{}{}, trial {} against {} (n = {} and {} ratings, {}",
                              trials.empty() ? "" : "; ", escapeHtml(one.system), one.a, one.b, one.test.n_a,
                              one.test.n_b, testText(one.test.z, one.test.p_two_sided, one.p_holm));
        trials += paired.test.n_pairs == 0
                      ? ")"
                      : fmt::format("; by participants' means n = {}, {})", paired.test.n_pairs,
                                    testText(paired.test.z, paired.test.p_two_sided, paired.p_holm));
    }
    std::string out;
    if (!pairs.empty())
        out += titledParagraph(name + " by single ratings (pseudo-replicated: p too small).", pairs + ".");
    if (!trials.empty())
        out +=
            titledParagraph(name + " by authors' trials (tests of ratings pseudo-replicated).", trials + ".");
    return out;
}

}  // namespace deixis::results
