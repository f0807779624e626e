#include "results/analysis/effect_estimates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "preference_estimates.hpp"
#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"
#include "studies/study_file/answer_curve.hpp"

namespace deixis::results {

namespace {

using studies::AnswerCurve;
using studies::AnswerKind;
using studies::StudyMeasure;

/// One answer less the mean of its system.
struct Residual {
    const ResponseRow* row;
    double off;
};

/// Sum of the products of two different answers in the same group, and how many such pairs there are.
struct Pairs {
    double sum = 0.0;
    double count = 0.0;

    Pairs operator-(const Pairs& other) const { return {sum - other.sum, count - other.count}; }
    Pairs operator+(const Pairs& other) const { return {sum + other.sum, count + other.count}; }
    [[nodiscard]] double mean() const { return count > 0.5 ? std::max(0.0, sum / count) : 0.0; }
};

template <typename KeyOf>
Pairs pairsWithin(const std::vector<Residual>& residuals, KeyOf key) {
    std::map<decltype(key(*residuals.front().row)), std::array<double, 3>> groups;  // sum, squares, n
    for (const Residual& one : residuals) {
        auto& [sum, squares, n] = groups[key(*one.row)];
        sum += one.off;
        squares += one.off * one.off;
        n += 1.0;
    }
    Pairs out;
    for (const auto& [name, group] : groups) {
        out.sum += group[0] * group[0] - group[1];
        out.count += group[2] * (group[2] - 1.0);
    }
    return out;
}

/// Covariances of two answers, on the scale of the answers.
struct Shared {
    double participant = 0.0;         ///< of one participant, different systems and items
    double participant_system = 0.0;  ///< of one participant and one system, different items
    double item = 0.0;                ///< on one item, different participants
    double variance = 0.0;            ///< of one answer
};

Shared sharedParts(const std::vector<Residual>& residuals) {
    const Pairs participant = pairsWithin(residuals, [](const ResponseRow& r) { return r.participant; });
    const Pairs with_system =
        pairsWithin(residuals, [](const ResponseRow& r) { return std::tie(r.participant, r.system); });
    const Pairs with_item =
        pairsWithin(residuals, [](const ResponseRow& r) { return std::tie(r.participant, r.target_id); });
    const Pairs with_both = pairsWithin(
        residuals, [](const ResponseRow& r) { return std::tie(r.participant, r.system, r.target_id); });
    const Pairs item = pairsWithin(residuals, [](const ResponseRow& r) { return r.target_id; });
    Shared out;
    out.participant = (participant - with_system - with_item + with_both).mean();
    out.participant_system = std::max(out.participant, (with_system - with_both).mean());
    out.item = (item - with_item).mean();
    for (const Residual& one : residuals) out.variance += one.off * one.off;
    out.variance /= static_cast<double>(residuals.size());
    return out;
}

/// SDs of what lies behind the answers that give these covariances: each is corrected by how far the model's
/// is off, again and again.
struct Behind {
    studies::AssumedSpread spread{};
    double noise_sd = 0.0;

    [[nodiscard]] double total() const {
        return std::sqrt(spread.participant_sd * spread.participant_sd +
                         spread.participant_system_sd * spread.participant_system_sd +
                         spread.item_sd * spread.item_sd + noise_sd * noise_sd);
    }
};

Behind fitBehind(const Shared& wanted, const std::vector<double>& means, const AnswerCurve& curve,
                 bool rating) {
    constexpr std::array<double, 1> unshifted{0.0};
    Behind out;
    double own = std::sqrt(wanted.participant);  // shared by one participant's answers to different systems
    double with_system = std::sqrt(wanted.participant_system);
    double item = std::sqrt(wanted.item);
    if (rating) out.noise_sd = std::sqrt(std::max(0.01, wanted.variance));
    const auto corrected = [](double sd, double want, double have) {
        return want <= 0.0 || have <= 0.0 ? 0.0 : std::min(20.0, sd * std::sqrt(want / have));
    };
    constexpr int rounds = 40;
    for (int round = 0; round < rounds; ++round) {
        out.spread = {own, std::sqrt(std::max(0.0, with_system * with_system - own * own)), item};
        const double sd = out.total();
        Shared have;
        for (const double mean : means) {
            const double location = curve.location(mean, sd, unshifted).value_or(0.0);
            have.participant += curve.covariance(location, sd, own);
            have.participant_system += curve.covariance(location, sd, with_system);
            have.item += curve.covariance(location, sd, item);
            have.variance += curve.variance(location, sd);
        }
        const auto n = static_cast<double>(means.size());
        own = corrected(own, wanted.participant, have.participant / n);
        with_system =
            std::max(own, corrected(with_system, wanted.participant_system, have.participant_system / n));
        item = corrected(item, wanted.item, have.item / n);
        if (rating) {
            const double want = wanted.variance / (have.variance / n) * sd * sd;
            const double others = with_system * with_system + item * item;
            out.noise_sd = std::clamp(std::sqrt(std::max(0.0, want - others)), 0.01, 20.0);
        }
    }
    return out;
}

/// Of what lies behind the answers to all systems together.
double sdOverSystems(const std::vector<double>& means, const AnswerCurve& curve, double sd) {
    constexpr std::array<double, 1> unshifted{0.0};
    std::vector<double> locations;
    for (const double of_system : means)
        locations.push_back(curve.location(of_system, sd, unshifted).value_or(0.0));
    return std::hypot(sd, sampleSd(locations));
}

/// Shifts of a factor's levels: how far their locations lie from the mean of all levels'.
template <typename LevelOf>
studies::ByName levelShifts(const std::vector<Residual>& residuals, const std::vector<std::string>& levels,
                            LevelOf level_of, const AnswerCurve& curve, double sd) {
    constexpr std::array<double, 1> unshifted{0.0};
    studies::ByName out;
    double sum = 0.0;
    for (const std::string& name : levels) {
        std::vector<double> answers;
        for (const Residual& one : residuals)
            if (level_of(*one.row) == name) answers.push_back(one.row->value);
        const auto location = curve.location(mean(answers), sd, unshifted);
        if (!location) return {};
        out[name] = *location;
        sum += *location;
    }
    for (auto& [name, shift] : out) shift -= sum / static_cast<double>(out.size());
    if (out.size() < 2) out.clear();
    return out;
}

/// Of those factors of the study of which two levels or more have answers.
studies::GroupShifts shiftsOfGroups(const std::vector<Residual>& residuals, const ResponseTable& table,
                                    const studies::Study& study, const AnswerCurve& curve, double sd) {
    studies::GroupShifts out;
    for (const studies::BetweenFactor& factor : study.between) {
        const auto level_of = [&](const ResponseRow& row) {
            return levelOfParticipant(table, row.participant, factor.name);
        };
        std::vector<std::string> levels;
        for (const std::string& level : factor.levels)
            if (std::any_of(residuals.begin(), residuals.end(),
                            [&](const Residual& one) { return level_of(*one.row) == level; }))
                levels.push_back(level);
        auto shifts = levelShifts(residuals, levels, level_of, curve, sd);
        if (!shifts.empty()) out[factor.name] = std::move(shifts);
    }
    return out;
}

/// Takes the groups' own means out of what is left of the answers: they are no spread of participants.
void centreGroups(std::vector<Residual>& residuals, const ResponseTable& table, const studies::Study& study) {
    for (const studies::BetweenFactor& factor : study.between) {
        std::map<std::string, std::vector<double>> by_level;
        for (const Residual& one : residuals)
            by_level[levelOfParticipant(table, one.row->participant, factor.name)].push_back(one.off);
        for (Residual& one : residuals)
            one.off -= mean(by_level[levelOfParticipant(table, one.row->participant, factor.name)]);
    }
}

struct MeasureAnswers {
    std::vector<Residual> residuals;
    studies::ByName means;  ///< by system
};

Result<MeasureAnswers> answersOf(const ResponseTable& table, const studies::Study& study,
                                 const StudyMeasure& measure, const std::set<std::string>& systems) {
    MeasureAnswers out;
    std::map<std::string, std::vector<double>> values;
    for (const ResponseRow& row : table.rows)
        if (row.measure == measure.name && systems.contains(row.system))
            values[row.system].push_back(row.value);
    for (const std::string& system : systems) {
        const auto& of_system = values[system];
        if (of_system.empty())
            return fail(table.database, fmt::format("has no answer on {} for the system \"{}\" of the study",
                                                    measure.name, system));
        if (const double of_mean = mean(of_system); of_mean > measure.low && of_mean < measure.high)
            out.means[system] = of_mean;
        else
            return fail(table.database,
                        fmt::format("all answers on {} to \"{}\" are {:g}: how much they vary cannot be "
                                    "estimated",
                                    measure.name, system, of_system.front()),
                        "Write a file of assumed effects and name it with --effect");
    }
    for (const ResponseRow& row : table.rows)
        if (row.measure == measure.name && systems.contains(row.system))
            out.residuals.push_back({&row, row.value - out.means[row.system]});
    centreGroups(out.residuals, table, study);
    return out;
}

std::set<std::string> systemsAsked(const studies::Study& study, const StudyMeasure& measure) {
    std::set<std::string> out;
    for (const studies::Stage& stage : study.stages) {
        if (!stage.scored()) continue;
        for (const StudyMeasure& asked : studies::measuresOf(study, stage))
            if (asked.kind == measure.kind && asked.name == measure.name)
                out.insert(stage.design.systems.begin(), stage.design.systems.end());
    }
    return out;
}

void addPreference(const ResponseTable& table, const std::set<std::string>& systems, EffectEstimates& out) {
    auto estimated = estimatePreference(table, {systems.begin(), systems.end()});
    if (const auto* why = std::get_if<std::string>(&estimated)) {
        out.notes.push_back(fmt::format("preference: not estimated, {}", *why));
        return;
    }
    out.effects.preference = std::get<studies::AssumedPreference>(std::move(estimated));
    out.notes.push_back("preference: noise_sd is set to 1, since answers contain only ratios to it");
}

}  // namespace

Result<EffectEstimates> estimateEffects(const ResponseTable& table, const studies::Study& study) {
    EffectEstimates out;
    for (const StudyMeasure& measure : studies::studyMeasures(study)) {
        const bool answered = std::any_of(table.rows.begin(), table.rows.end(), [&](const ResponseRow& row) {
            return row.measure == measure.name;
        });
        if (!answered) {
            out.notes.push_back(fmt::format("{}: not estimated, there are no answers", measure.name));
            continue;
        }
        if (measure.kind == AnswerKind::preference) {
            addPreference(table, systemsAsked(study, measure), out);
            continue;
        }
        const auto answers = answersOf(table, study, measure, systemsAsked(study, measure));
        if (!answers) return tl::unexpected(answers.error());
        const bool rating = measure.kind == AnswerKind::rating;
        const AnswerCurve curve =
            rating ? AnswerCurve::scale(measure.low, measure.high) : AnswerCurve::choice(0.0, measure.balls);
        std::vector<double> means;
        for (const auto& [system, of_system] : answers->means) means.push_back(of_system);
        const Behind behind = fitBehind(sharedParts(answers->residuals), means, curve, rating);
        const double sd = sdOverSystems(means, curve, behind.total());
        auto groups = shiftsOfGroups(answers->residuals, table, study, curve, sd);
        if (rating) {
            out.effects.ratings[measure.name] = {answers->means, behind.spread, behind.noise_sd,
                                                 std::move(groups)};
            continue;
        }
        studies::AssumedAccuracy accuracy{answers->means, behind.spread};
        const auto layout = [](const ResponseRow& row) { return row.layout; };
        const auto distance = [](const ResponseRow& row) { return row.distance; };
        accuracy.layouts = levelShifts(answers->residuals, table.layouts, layout, curve, sd);
        accuracy.distances = levelShifts(answers->residuals, table.distances, distance, curve, sd);
        accuracy.groups = std::move(groups);
        out.effects.accuracy = std::move(accuracy);
        out.notes.push_back(
            "accuracy: lapse_rate is left at 0, since lapses cannot be separated from the spread of choices; "
            "their cost is in the shares of correct choices");
    }
    if (!out.effects.accuracy && out.effects.ratings.empty() && !out.effects.preference)
        return fail(table.database,
                    fmt::format("has no answers on what {} measures that can be estimated", study.name),
                    "Write a file of assumed effects and name it with --effect");
    if (!table.study_hash.empty() && table.study_hash != study.hash)
        out.notes.push_back("the answers are from another study file");
    std::set<std::string> participants;
    for (const ResponseRow& row : table.rows) participants.insert(row.participant);
    out.notes.push_back(
        fmt::format("estimated from {} participants; with few, the estimates and the power are uncertain",
                    participants.size()));
    if (std::any_of(table.rows.begin(), table.rows.end(),
                    [](const ResponseRow& row) { return row.synthetic; }))
        out.notes.push_back("simulated participants are among them: no evidence about people");
    return out;
}

}  // namespace deixis::results
