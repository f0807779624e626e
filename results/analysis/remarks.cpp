#include "remarks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "results/analysis/several_studies.hpp"
#include "results/statistics/rounded_fraction.hpp"

namespace deixis::results {

namespace {

/// A participant who lacks answers under one of two conditions is missing from their comparison.
void remarkLeftOut(const std::vector<Comparison>& comparisons, const std::string& measure,
                   const std::string& factor, AnalysisResult& result) {
    int min = result.participants;
    int max = 0;
    for (const auto& comparison : comparisons) {
        if (comparison.measure != measure || comparison.factor != factor) continue;
        min = std::min(min, comparison.test.n_pairs);
        max = std::max(max, comparison.test.n_pairs);
    }
    if (min == result.participants || max == 0) return;
    result.remarks.push_back(fmt::format(
        "Tests of {}: participants without answers under one of the two conditions are left out; {} of {} "
        "participants are used.",
        factor.empty() || measure == "accuracy" ? (factor.empty() ? measure : factor)
                                                : fmt::format("{} in {}", factor, measure),
        min == max ? fmt::format("{}", max) : fmt::format("{} to {}", min, max), result.participants));
}

/// What a reader must know of every test.
template <typename Test>
void remarkDecisions(const std::vector<Test>& tests, AnalysisResult& result) {
    int out_of_reach = 0;
    int tested = 0;
    for (const Test& one : tests) {
        if (one.test.n_pairs == 0) continue;
        ++tested;
        out_of_reach += one.out_of_reach ? 1 : 0;
        if (one.depends_on_zeros)
            result.remarks.push_back(
                fmt::format("{}: {} against {} is {}significant at {} if differences of zero are dropped (p "
                            "= {:.3g} after Holm's correction) and is {}if they are ranked (Pratt's rule: p "
                            "= {:.3g}): the decision depends on that choice.",
                            one.family, one.a, one.b, one.significant ? "" : "not ", result.alpha,
                            *one.p_holm, one.significant ? "not " : "", *one.p_holm_pratt));
    }
    // Of a single participant nothing is tested, and the report says so.
    if (out_of_reach == 0 || result.participants < 2) return;
    if (out_of_reach < tested)
        result.remarks.push_back(
            fmt::format("{} of {} tests ({}) can be significant at {} after Holm's correction only if other "
                        "pairs have a smaller p: they have few non-zero differences.",
                        out_of_reach, tested, tests.front().family, result.alpha));
    else
        result.remarks.push_back(
            fmt::format("{} of {} tests ({}) cannot be significant at {} after Holm's correction, whatever "
                        "the answers: they have too few non-zero differences.",
                        out_of_reach, tested, tests.front().family, result.alpha));
}

const char* wordsOf(AnswerChoice choice) {
    switch (choice) {
        case AnswerChoice::with_left_out:
            return "if those who are left out count";
        case AnswerChoice::without_doubtful:
            return "without marked trials and participants who failed a check";
        case AnswerChoice::answered_only:
            return "if choices that timed out are left out";
        case AnswerChoice::unanswered_wrong:
            return "if skipped choices count as wrong";
    }
    return "";
}

/// Choices that were not made, and trials whose chance is not known.
void remarkUnanswered(AnalysisResult& result) {
    int timed_out = 0;
    for (const ResponseRow& row : result.table.rows) timed_out += row.unanswered.empty() ? 0 : 1;
    const std::size_t skipped = result.table.skipped_rows.size();
    if (timed_out > 0)
        result.remarks.push_back(
            fmt::format("{} {} made in time and {} as wrong: the table of choices that were not made also "
                        "has the accuracy without them.",
                        timed_out, timed_out == 1 ? "choice was not" : "choices were not",
                        timed_out == 1 ? "counts" : "count"));
    if (skipped > 0)
        result.remarks.push_back(
            fmt::format("{} {} skipped by the experimenter and left out: the table of choices that were not "
                        "made also has the accuracy with them as wrong.",
                        skipped, skipped == 1 ? "choice was" : "choices were"));
    int known = 0;
    int all = 0;
    for (const ChanceResult& one : result.chance) {
        known += one.n_known;
        all += one.n;
    }
    if (known > 0 && known < all)
        result.remarks.push_back(
            fmt::format("For {} of {} choices the number of balls is not known: they are not used in the "
                        "comparison with chance.",
                        all - known, all));
}

/// Bootstrap intervals of so few participants that they cannot reach their level.
void remarkFewParticipants(AnalysisResult& result) {
    std::size_t min = 0;
    for (const SystemResult& system : result.systems)
        for (const Summary& one : system.measures)
            if (one.interval_falls_short && (min == 0 || one.by_participant.size() < min))
                min = one.by_participant.size();
    if (min > 0)
        result.remarks.push_back(fmt::format(
            "Intervals of means of {} participants are too narrow: even the range of {} means covers the "
            "median in only {:.4g} % of all samples, and {:.4g} % were requested.",
            min, min, 100.0 * (1.0 - std::ldexp(1.0, 1 - static_cast<int>(min))), 100.0 * result.level));
}

/// Decimals that are taken as the fractions they were rounded from.
void remarkRounded(AnalysisResult& result) {
    int n = 0;
    std::string example;
    for (const ResponseRow& row : result.table.rows) {
        const auto fraction = roundedFraction(row.value);
        if (!fraction) continue;
        if (n == 0) example = fmt::format("{} as {}", row.value, fraction->text());
        ++n;
    }
    if (n > 0)
        result.remarks.push_back(
            fmt::format("{} {} a rounded fraction and {} read as that fraction ({}), so that what is equal "
                        "on paper is tied.",
                        n, n == 1 ? "answer is" : "answers are", n == 1 ? "is" : "are", example));
}

/// Decisions that depend on whose answers, and which, are taken.
void remarkSensitivity(AnalysisResult& result) {
    for (const SensitivityResult& one : result.sensitivity) {
        const auto remark = [&](const char* choice, const AdjustedTest& other) {
            result.remarks.push_back(fmt::format(
                "{}: {} against {} is {}significant at {} and is {}{}{}: the decision depends on that "
                "choice.",
                one.headline.family, one.a, one.b, one.headline.significant ? "" : "not ", result.alpha,
                one.headline.significant ? "not " : "", choice,
                other.p_holm ? fmt::format(" (p = {:.3g} after Holm's correction)", *other.p_holm) : ""));
        };
        for (const SensitivityResult::Other& other : one.others)
            if (other.changes) remark(wordsOf(other.choice), other.test);
    }
}

}  // namespace

void remarkAnswers(AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::map<std::string, int> answered;
    int interrupted = 0;
    for (const auto& row : table.rows) {
        ++answered[row.measure];
        interrupted += row.pauses > 0 ? 1 : 0;
    }
    for (const auto& row : table.aside_rows) ++answered[row.measure];
    auto& remarks = result.remarks;
    remarks.insert(remarks.end(), table.notes.begin(), table.notes.end());
    std::string missing;
    for (const Measure& measure : table.measures) {
        if (answered[measure.name] == 0)
            remarks.push_back(fmt::format("There are no answers on {}: it is not reported.", measure.name));
        if (answered[measure.name] != measure.planned)
            missing += fmt::format("{}{} of {} planned on {}", missing.empty() ? "" : ", ",
                                   answered[measure.name], measure.planned, measure.name);
    }
    if (!missing.empty())
        remarks.push_back(fmt::format("The data are incomplete: {} are answered.", missing));
    if (table.planned_participants > 0 && result.participants != table.planned_participants)
        remarks.push_back(fmt::format("{} of {} participants with a plan have answered.", result.participants,
                                      table.planned_participants));
    if (interrupted > 0)
        remarks.push_back(fmt::format(
            "{} answers were given in trials that had been interrupted and shown again from the start.",
            interrupted));
    if (table.withdrawn > 0)
        remarks.push_back(fmt::format("{} {} withdrew; none of their data is kept.", table.withdrawn,
                                      table.withdrawn == 1 ? "participant" : "participants"));
    for (const Factor& factor : table.between)
        if (table.origins.empty() || factor.name != study_factor)
            remarks.push_back(
                fmt::format("Participants differ in {}: systems are compared over all of them, whatever "
                            "their {}; the groups are compared separately.",
                            factor.name, factor.name));
}

namespace {

void remarkFamilies(const std::vector<Comparison>& tests, AnalysisResult& result) {
    std::map<std::string, std::vector<Comparison>> families;
    for (const Comparison& one : tests) families[one.family].push_back(one);
    for (const auto& [name, family] : families) remarkDecisions(family, result);
}

/// Of one of several studies.
void remarkMissing(const AnalysisResult& study, AnalysisResult& result) {
    for (const Measure& measure : study.table.measures) {
        std::ptrdiff_t answered = 0;
        for (const auto* rows : {&study.table.rows, &study.table.aside_rows})
            answered += std::count_if(rows->begin(), rows->end(),
                                      [&](const ResponseRow& row) { return row.measure == measure.name; });
        if (answered != measure.planned)
            result.remarks.push_back(fmt::format("{}: {} of {} planned on {} are answered.",
                                                 study.table.study_name, answered, measure.planned,
                                                 measure.name));
    }
}

/// What every study has one level of, and not all studies the same, cannot be told from the study.
void remarkConfounded(AnalysisResult& result) {
    if (result.by_study.empty()) return;
    for (const Factor& factor : result.table.between) {
        if (factor.name == study_factor) continue;
        std::map<std::string, std::set<std::string>> levels;  // by study
        for (const auto& [participant, of] : result.table.groups) {
            const auto study = of.find(study_factor);
            const auto level = of.find(factor.name);
            if (study != of.end() && level != of.end()) levels[study->second].insert(level->second);
        }
        std::set<std::string> all;
        bool one_each = true;
        for (const auto& [study, found] : levels) {
            one_each = one_each && found.size() == 1;
            all.insert(found.begin(), found.end());
        }
        if (one_each && all.size() > 1)
            result.remarks.push_back(
                fmt::format("All participants of a study have the same {0}, and not all studies do: no test "
                            "can separate a difference between studies from one of {0}.",
                            factor.name));
    }
}

}  // namespace

void remarkTests(AnalysisResult& result) {
    remarkUnanswered(result);
    remarkRounded(result);
    remarkFewParticipants(result);
    remarkSensitivity(result);
    for (const Measure& measure : result.measures) remarkLeftOut(result.pairwise, measure.name, "", result);
    for (const Factor& factor : withinFactors(result.table))
        for (const Measure& measure : result.measures)
            remarkLeftOut(result.level_tests, measure.name, factor.name, result);
    remarkFamilies(result.pairwise, result);
    remarkFamilies(result.level_tests, result);
    remarkDecisions(result.preferences, result);
    remarkConfounded(result);
    for (const AnalysisResult& study : result.by_study) {
        remarkMissing(study, result);
        if (study.participants < 2) continue;
        remarkFamilies(study.pairwise, result);
        remarkDecisions(study.preferences, result);
    }
}

}  // namespace deixis::results
