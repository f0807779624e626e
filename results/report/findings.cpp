#include "findings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "interactions.hpp"
#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/several_studies.hpp"
#include "results/outputs/observers_html.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"
#include "studies.hpp"

namespace deixis::results {

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
    const bool medians = hasManySteps(of);
    const auto named = [&](double mean) {
        std::vector<std::string> names;
        for (const SystemResult* s : answered)
            if (equal(value(s), mean))
                names.push_back(strongHtml(s->system) +
                                (medians
                                     ? fmt::format(" ({}; median of participants {})", scoreText(of, mean),
                                                   scoreText(of, s->measures[measure].median))
                                     : ""));
        const std::string out = inSentence(names);
        return medians ? out
                       : fmt::format("{} ({}{})", out, names.size() > 1 ? "each " : "", scoreText(of, mean));
    };
    const bool measured = !of.unit.empty();  // of errors nobody would call the large ones high
    return fmt::format("{} had the {} mean {}, {} the {}.", named(highest), measured ? "largest" : "highest",
                       escapeHtml(of.name), named(lowest), measured ? "smallest" : "lowest");
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

/// `where` stands before, `medians` behind the means; empty where nothing is known.
std::string systemsItem(const AnalysisResult& result, std::size_t measure, const std::string& where,
                        const std::string& medians) {
    std::string item = extremes(result, measure);
    if (!medians.empty()) item += " " + medians;
    if (result.participants > 1) item += " " + significance(result, result.measures[measure].name);
    return item.size() > 1 ? where + item : "";
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
            "No test of {} is significant in {}{}; this does not show that it makes no difference.",
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
    const bool of_studies = factor == study_factor && !result.by_study.empty();
    return names.empty()
               ? fmt::format(
                     "No test of the {} is significant in {}; this does not show that they are alike.",
                     of_studies ? "studies against each other" : "groups by " + escapeHtml(factor),
                     escapeHtml(measure))
               : fmt::format("{} that differ significantly in {}: {}.",
                             of_studies ? "Studies" : "Groups by " + escapeHtml(factor), escapeHtml(measure),
                             names);
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
    return names.empty() ? fmt::format(
                               "No test of the groups by {} is significant in their preferences; this does "
                               "not show that they are alike.",
                               escapeHtml(factor))
                         : fmt::format("Groups by {} that differ significantly in their preferences: {}.",
                                       escapeHtml(factor), names);
}

std::string preferenceSentence(const AnalysisResult& result) {
    if (result.preferences.empty()) return "";
    std::string out;
    for (const auto& pair : result.preferences)
        if (pair.significant)
            out += fmt::format("{}{} to {}", out.empty() ? "" : ", ",
                               strongHtml(pair.mean > 0.0 ? pair.a : pair.b),
                               escapeHtml(pair.mean > 0.0 ? pair.b : pair.a));
    return out.empty()
               ? "No preference between two systems is significant; this does not show that there is none."
               : "Significantly preferred: " + out + ".";
}

}  // namespace

std::string findingsHtml(const AnalysisResult& result) {
    // What simulated participants chose is one observer's reading.
    std::vector<std::string> items{result.synthetic ? observersFinding(result.observers) : std::string()};
    for (std::size_t measure = 0; measure < result.measures.size(); ++measure) {
        for (const AnalysisResult& study : result.by_study)
            items.push_back(
                systemsItem(study, measure,
                            fmt::format("{} ({}): ", strongHtml("In " + study.table.study_name),
                                        counted(study.participants, "participant", "participants")),
                            mediansSentence(result, study.table.study_name, result.measures[measure])));
        items.push_back(systemsItem(
            result, measure,
            result.by_study.empty()
                ? std::string()
                : fmt::format("{} over the {} studies ({}): ", strongHtml("Pooled"), result.by_study.size(),
                              counted(result.participants, "participant", "participants")),
            mediansSentence(result, pooled_studies, result.measures[measure])));
    }
    if (result.participants > 1) {
        for (const Measure& measure : result.measures) {
            for (const Factor& factor : withinFactors(result.table))
                items.push_back(levelSentence(result, measure.name, factor.name));
            for (const Factor& factor : result.table.between)
                items.push_back(groupSentence(result, measure.name, factor.name));
        }
        for (const AnalysisResult& study : result.by_study)
            if (const std::string item = preferenceSentence(study); !item.empty())
                items.push_back(strongHtml("In " + study.table.study_name) + ": " + item);
        if (const std::string item = preferenceSentence(result); !item.empty())
            items.push_back((result.by_study.empty() ? "" : strongHtml("Pooled") + ": ") + item);
        for (const Factor& factor : result.table.between)
            items.push_back(groupPreferenceSentence(result, factor.name));
        for (const std::string& item : interactionFindings(result)) items.push_back(item);
    }
    std::erase(items, "");
    if (items.empty()) return "";
    std::string out = itemsHtml(items);
    if (result.participants > 1)
        out += noteHtml(fmt::format(
            "Significant: at \u03b1\u00a0=\u00a0{}, two-sided Wilcoxon signed-rank tests over "
            "participants{}, "
            "after Holm's correction{}.",
            result.alpha,
            result.between.empty() && result.preferences_between.empty() ? "" : " (groups: rank-sum tests)",
            result.by_study.empty() ? "" : " in families for each study and for all pooled"));
    return out;
}

}  // namespace deixis::results
