#include "paragraphs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>

#include "computed.hpp"
#include "participants.hpp"
#include "ratings.hpp"
#include "results/analysis/analysis_steps.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

namespace {

/// "naturalness, rated from 1 to 5".
std::string measureText(const ResponseTable& table, const Measure& measure) {
    const std::string name = escapeHtml(measure.name);
    if (measure.kind == MeasureKind::accuracy)
        return name + " (the target chosen, or not" +
               (measure.balls > 1 ? fmt::format("; chance: {})", ballsText(measure)) : ")");
    if (measure.kind == MeasureKind::preference) return name + " (between two systems, side by side)";
    if (!measure.unit.empty()) return fmt::format("{} (measured, in {})", name, measure.unit);
    if (table.study_hash.empty())
        return fmt::format("{} (rated; answers from {} to {})", name, measure.low, measure.high);
    return fmt::format("{} (rated from {} to {})", name, measure.low, measure.high);
}

}  // namespace

std::vector<std::string> measureTexts(const ResponseTable& table) {
    std::vector<std::string> out;
    for (const Measure& measure : table.measures) out.push_back(measureText(table, measure));
    return out;
}

std::pair<int, int> answersPerParticipant(const ResponseTable& table) {
    std::map<std::string, int> answers;
    for (const ResponseRow& row : table.rows) ++answers[row.participant];
    std::pair<int, int> range{std::numeric_limits<int>::max(), 0};
    for (const auto& [participant, n] : answers)
        range = {std::min(range.first, n), std::max(range.second, n)};
    return range;
}

bool systemsMeetInParticipants(const ResponseTable& table) {
    std::map<std::string, std::string> first;
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const ResponseRow& row) {
        return first.try_emplace(row.participant, row.system).first->second != row.system ||
               !row.other_system.empty();
    });
}

std::string leftOutText(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const auto dropped = std::count_if(table.left_out.begin(), table.left_out.end(),
                                       [](const LeftOut& one) { return one.dropped; });
    const auto excluded = static_cast<std::ptrdiff_t>(table.left_out.size()) - dropped;
    std::vector<std::string> out;
    if (excluded > 0) out.push_back(fmt::format("{} excluded", excluded));
    if (dropped > 0) out.push_back(fmt::format("{} dropped out", dropped));
    if (table.withdrawn > 0) out.push_back(fmt::format("{} withdrew", table.withdrawn));
    return inSentence(out);
}

namespace {

/// " of the studies relaxed (12) and rushed (12)"; empty of one study.
std::string ofStudies(const AnalysisResult& result) {
    std::vector<std::string> studies;
    for (const AnalysisResult& one : result.by_study)
        studies.push_back(fmt::format("{} ({})", escapeHtml(one.table.study_name), one.participants));
    return studies.empty() ? "" : fmt::format(" of the studies {}", inSentence(studies));
}

std::string participantSentence(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const auto [min, max] = answersPerParticipant(table);
    std::string answers = min >= max ? fmt::format("{}", max) : fmt::format("{} to {}", min, max);
    answers += max == 1 ? " answer" : " answers";
    if (result.participants > 1) answers += " each";
    const std::string left_out = leftOutText(result);
    return fmt::format("{} {}{}{}{}.",
                       result.synthetic ? "Simulated participants, not people, take the place of a sample of"
                                        : "The answers come from",
                       counted(result.participants, "participant", "participants"), ofStudies(result),
                       max > 0 ? ", who gave " + answers : "",
                       left_out.empty() ? "" : " (left out: " + left_out + ")");
}

/// What the signed-rank tests were of, in the words of a list.
std::vector<std::string> signedRankWords(const Computed& computed) {
    std::vector<std::string> what;
    if (computed.pairs) what.emplace_back("participants' means of each pair of systems");
    if (computed.levels)
        what.emplace_back(what.empty() ? "participants' means of each pair of a factor's levels"
                                       : "their means of each pair of a factor's levels");
    if (computed.preferences)
        what.emplace_back(what.empty()
                              ? "participants' mean preferences in each pair of systems, against none,"
                              : "their mean preferences in each pair of systems, against none,");
    return what;
}

std::string testsSentences(const AnalysisResult& result, const Computed& computed) {
    std::string out;
    if (const auto what = signedRankWords(computed); !what.empty())
        out += fmt::format(
            " We compared {} by two-sided Wilcoxon signed-rank tests ({}, differences of zero dropped){}, at "
            "α = {} after Holm's correction within each of these families of tests. Shifts are "
            "Hodges–Lehmann estimates with {:g}\u00A0% intervals that invert these tests; r is the "
            "rank-biserial correlation.",
            inSentence(what),
            computed.approximate ? "normal approximation for more than 2,000 differences, otherwise exact"
                                 : "exact, also with ties",
            computed.friedman ? ", after Friedman's test of all systems" : "", result.alpha,
            100.0 * result.level);
    if (!result.by_study.empty() && computed.signedRank())
        out +=
            " Systems were compared within each study and pooled over all participants, each with its own "
            "family.";
    std::vector<std::string> groups;
    if (computed.systems_apart) groups.emplace_back("systems that no participant saw both of");
    if (computed.groups)
        groups.emplace_back(result.by_study.empty() ? "groups of participants"
                                                    : "groups of participants (the studies among them)");
    if (computed.preferences_of_groups) groups.emplace_back("the preferences of groups");
    if (!groups.empty())
        out += fmt::format(
            " We compared {} by two-sided Wilcoxon rank-sum tests of participants' means, Holm-corrected "
            "(α = {}); δ is Cliff's delta.",
            inSentence(groups), result.alpha);
    if (computed.ratings)
        out +=
            " Single ratings, paired by participant and page or item, were tested in the same way (Yoon et "
            "al. "
            "2021), which treats a participant's ratings as independent: these p values are too small.";
    if (computed.author_trials)
        out +=
            " Clips from their authors' earlier and later trials were compared by rank-sum tests of single "
            "ratings, as Yoon et al. (2021) did, and by signed-rank tests of participants' means.";
    if (computed.interactions)
        out += " Interactions were tested as differences of participants' differences, Holm-corrected.";
    if (computed.equivalence) out += " Equivalence was tested by two one-sided tests within declared bounds.";
    if (computed.intervals)
        out += fmt::format(
            " Intervals of means are {:g}\u00A0% bootstrap intervals over participants ({} resamples).",
            100.0 * result.level, result.options.resamples);
    if (isPointing2023(result.table) && computed.pairs)
        out += " The analysis follows Deichler et al. (2023, section 3.1).";
    return out;
}

/// "deixis 0.1.0 (commit ...)" as a paper names it.
std::string programText(const AnalysisResult& result) {
    std::string program = result.options.program;
    if (program.starts_with("deixis ")) program = "Deixis " + program.substr(7);
    return escapeHtml(program);
}

std::string equalsP(const std::optional<double>& p) {
    if (!p) return "no p";
    return *p < 0.001 ? "&lt; 0.001" : fmt::format("= {:.3f}", *p);
}

std::string rankText(double sum) {
    return fmt::format("{:g}", sum);
}

/// "n = 39, W = 120.5, p = 0.012, Holm-corrected p = 0.036, r = 0.41, shift 0.2 [0.0, 0.4]".
std::string signedRankText(const AdjustedTest& one, const Measure& measure) {
    const SignedRankTest& test = one.test;
    const std::string shift =
        shiftText(test.hodges_lehmann, [&](double value) { return scoreText(measure, value); });
    return fmt::format(
        "n = {}, W = {}, p {}, Holm-corrected p {}, r {}, shift {}", test.n_pairs, rankText(test.w_plus),
        equalsP(test.p_two_sided), equalsP(one.p_holm),
        test.rank_biserial ? "= " + fixedText(*test.rank_biserial, 2) : std::string("not defined"), shift);
}

std::string rankSumText(const GroupTest& one, const Measure& measure) {
    const RankSumTest& test = one.test;
    const std::string shift =
        shiftText(test.hodges_lehmann, [&](double value) { return scoreText(measure, value); });
    return fmt::format(
        "n = {} and {}, U = {}, p {}, Holm-corrected p {}, δ {}, shift {}", test.n_a, test.n_b,
        rankText(test.u), equalsP(test.p_two_sided), equalsP(one.p_holm),
        test.cliffs_delta ? "= " + fixedText(*test.cliffs_delta, 2) : std::string("not defined"), shift);
}

/// "a against b (...)", joined; the significant ones first.
class Sentence {
  public:
    void add(bool significant, const std::string& what, const std::string& numbers) {
        std::string& of = significant ? significant_ : others_;
        of += fmt::format("{}{} ({})", of.empty() ? "" : "; ", what, numbers);
    }
    /// " Significant: ... Not significant: ..."; empty without comparisons.
    [[nodiscard]] std::string text() const {
        return (significant_.empty() ? "" : " Significant: " + significant_ + ".") +
               (others_.empty() ? "" : " Not significant: " + others_ + ".");
    }

  private:
    std::string significant_{};
    std::string others_{};
};

std::string against(const std::string& a, const std::string& b) {
    return fmt::format("{} against {}", escapeHtml(a), escapeHtml(b));
}

/// `text` begins with a space; empty without one.
std::string paragraph(const std::string& head, const std::string& text) {
    return text.empty() ? "" : titledParagraph(head + ".", text.substr(1));
}

std::string meansSentence(const AnalysisResult& result, std::size_t index) {
    const Measure& measure = result.measures[index];
    std::vector<std::string> means;
    bool intervals = false;
    for (const SystemResult& system : result.systems) {
        const Summary& one = system.measures[index];
        if (one.n == 0) continue;
        std::string text = escapeHtml(system.system) + " " + scoreText(measure, one.mean);
        if (one.interval) {
            text += " " + intervalText(measure, one.interval->lower, one.interval->upper);
            intervals = true;
        }
        means.push_back(std::move(text));
    }
    if (means.empty()) return "";
    return fmt::format(" Means{}: {}.",
                       intervals ? fmt::format(" with {:g}\u00A0% intervals", 100.0 * result.level) : "",
                       inSentence(means));
}

std::string friedmanSentence(const AnalysisResult& result, const std::string& measure) {
    for (const OmnibusResult& one : result.omnibus)
        if (one.measure == measure && one.test.chi2 && tellsFriedman(result, measure))
            return fmt::format(
                " Friedman's test of all systems: χ²({}) = {}, n = {}, p {}, Kendall's "
                "W = {}.",
                one.test.df, fixedText(*one.test.chi2, 2), one.test.n, equalsP(one.test.p),
                fixedText(*one.test.kendalls_w, 2));
    return "";
}

/// `where`: of several studies, " in STUDY", text.
std::string measureParagraphs(const AnalysisResult& result, const std::string& where, std::size_t index) {
    const Computed computed(result);
    const Measure& measure = result.measures[index];
    const std::string name = capitalised(measure.name) + where;
    std::string out = meansSentence(result, index);
    if (computed.friedman) out += friedmanSentence(result, measure.name);
    Sentence pairs;
    if (computed.pairs)
        for (const Comparison& one : result.pairwise)
            if (one.measure == measure.name && one.test.n_pairs > 0)
                pairs.add(one.significant, against(one.a, one.b), signedRankText(one, measure));
    for (const BetweenResult& one : result.between)
        if (one.measure == measure.name && one.factor == systems_between && one.test.p_two_sided)
            pairs.add(one.significant, against(one.a, one.b), rankSumText(one, measure));
    out = paragraph(name, out + pairs.text());
    for (const Factor& factor : withinFactors(result.table)) {
        Sentence levels;
        if (computed.levels)
            for (const Comparison& one : result.level_tests)
                if (one.measure == measure.name && one.factor == factor.name && one.test.n_pairs > 0)
                    levels.add(
                        one.significant,
                        (one.system == "all" ? "" : escapeHtml(one.system) + ", ") + against(one.a, one.b),
                        signedRankText(one, measure));
        out += paragraph(fmt::format("{} by {}", name, factor.name), levels.text());
    }
    for (const Factor& factor : result.table.between) {
        Sentence groups;
        for (const BetweenResult& one : result.between)
            if (one.measure == measure.name && one.factor == factor.name && one.test.p_two_sided)
                groups.add(one.significant,
                           (one.system == "all" ? "over all systems, " : escapeHtml(one.system) + ", ") +
                               against(one.a, one.b),
                           rankSumText(one, measure));
        out += paragraph(fmt::format("{} by groups ({})", name, factor.name), groups.text());
    }
    return out;
}

std::string preferenceParagraph(const AnalysisResult& result, const std::string& where) {
    const Measure scale{"preference", MeasureKind::preference, -2.0, 2.0, 0, 0};
    std::string counts;
    Sentence tests;
    for (const PreferenceResult& one : result.preferences) {
        counts += fmt::format("{}{} {}, equal {}, {} {}", counts.empty() ? "" : "; ", escapeHtml(one.a),
                              one.prefers_a, one.ties, escapeHtml(one.b), one.prefers_b);
        if (result.participants > 1 && one.test.n_pairs > 0)
            tests.add(one.significant, against(one.a, one.b), signedRankText(one, scale));
    }
    return counts.empty() ? "" : paragraph("Preference" + where, " Answers: " + counts + "." + tests.text());
}

}  // namespace

std::string methodsParagraph(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const Computed computed(result);
    std::vector<std::string> systems;
    for (const std::string& system : table.systems) systems.push_back(escapeHtml(system));
    std::string out = participantSentence(result);
    for (const FieldResult& field : result.fields)
        out += fmt::format(" {}: {}.", escapeHtml(propertyLabel(field.field)), fieldText(field));
    if (!systems.empty())
        out += fmt::format(" Systems: {}{}.", inSentence(systems),
                           systems.size() < 2                 ? ""
                           : systemsMeetInParticipants(table) ? ", within participants"
                                                              : ", one for each participant");
    if (!table.measures.empty()) out += fmt::format(" Measures: {}.", inSentence(measureTexts(table)));
    out += testsSentences(result, computed);
    if (const std::string program = programText(result); !program.empty())
        out += fmt::format(" Computed with {}.", program);
    return out;
}

std::string resultsParagraphs(const AnalysisResult& result) {
    const std::string pooled = result.by_study.empty() ? "" : ", all studies pooled";
    std::string out;
    for (std::size_t i = 0; i < result.measures.size(); ++i) {
        for (const AnalysisResult& study : result.by_study) {
            const std::string in_study = " in " + study.table.study_name;
            out += measureParagraphs(study, in_study, i);
            out += ratingResults(study, in_study, result.measures[i]);
        }
        out += measureParagraphs(result, pooled, i);
        out += ratingResults(result, pooled, result.measures[i]);
    }
    for (const AnalysisResult& study : result.by_study)
        out += preferenceParagraph(study, " in " + study.table.study_name);
    return out + preferenceParagraph(result, pooled);
}

std::vector<std::string> references(const AnalysisResult& result) {
    const Computed computed(result);
    std::vector<std::string> out;
    if (const std::string program = programText(result); !program.empty())
        out.push_back("The Deixis authors (2026). " + program +
                      ": evaluation of how embodied agents point. Computer program, MIT licence.");
    if (isPointing2023(result.table))
        out.emplace_back(
            "Deichler, A., Wang, S., Alexanderson, S., &amp; Beskow, J. (2023). Learning to generate "
            "pointing gestures in situated embodied conversational agents. Frontiers in Robotics and AI, 10, "
            "1110534.");
    if (!result.by_study.empty())
        out.emplace_back(
            "Yoon, Y., Park, K., Jang, M., Kim, J., &amp; Lee, G. (2021). SGToolkit: An interactive gesture "
            "authoring toolkit for embodied conversational agents. Proceedings of UIST '21.");
    if (computed.signedRank() || computed.rankSum())
        out.emplace_back(
            "Wilcoxon, F. (1945). Individual comparisons by ranking methods. Biometrics "
            "Bulletin, 1(6), 80–83.");
    if (computed.signedRank() || computed.rankSum())
        out.emplace_back(
            "Holm, S. (1979). A simple sequentially rejective multiple test procedure. "
            "Scandinavian Journal of Statistics, 6(2), 65–70.");
    if (computed.signedRank() || computed.rankSum())
        out.emplace_back(
            "Hodges, J. L., &amp; Lehmann, E. L. (1963). Estimates of location based on rank "
            "tests. The Annals of Mathematical Statistics, 34(2), 598–611.");
    if (computed.zeros)
        out.emplace_back(
            "Pratt, J. W. (1959). Remarks on zeros and ties in the Wilcoxon signed rank "
            "procedures. Journal of the American Statistical Association, 54, 655–667.");
    if (computed.friedman)
        out.emplace_back(
            "Friedman, M. (1937). The use of ranks to avoid the assumption of normality implicit "
            "in the analysis of variance. Journal of the American Statistical Association, 32, "
            "675–701.");
    if (computed.intervals)
        out.emplace_back(
            "Efron, B. (1987). Better bootstrap confidence intervals. Journal of the American "
            "Statistical Association, 82, 171–185.");
    if (computed.ratings || computed.author_trials)
        out.emplace_back(
            "Yoon, Y., Park, K., Jang, M., Kim, J., &amp; Lee, G. (2021). SGToolkit: An interactive gesture "
            "authoring toolkit for embodied conversational agents. Proceedings of UIST '21. "
            "https://doi.org/10.1145/3472749.3474789");
    if (!result.bradley_terry.abilities.empty())
        out.emplace_back(
            "Bradley, R. A., &amp; Terry, M. E. (1952). Rank analysis of incomplete block "
            "designs. Biometrika, 39, 324–345.");
    if (computed.equivalence)
        out.emplace_back(
            "Schuirmann, D. J. (1987). A comparison of the two one-sided tests procedure and the "
            "power approach. Journal of Pharmacokinetics and Biopharmaceutics, 15, "
            "657–680.");
    return out;
}

}  // namespace deixis::results
