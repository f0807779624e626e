#include "studies/simulation/assumed_answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/random.hpp"
#include "studies/study_file/answer_curve.hpp"

namespace deixis::studies {

/// Random numbers of one participant, and what tells the participant from others. All participants' parts are
/// drawn before any answer.
class AssumedParticipant {
  public:
    AssumedParticipant(std::uint64_t seed, std::size_t number, std::size_t measures, std::size_t systems)
        : random(deriveSeed(seed, fmt::format("participant {}", number))), systems_(systems) {
        for (std::size_t i = 0; i < measures; ++i) own_.push_back(random.normal());
        for (std::size_t i = 0; i < measures * systems; ++i) with_system_.push_back(random.normal());
    }
    [[nodiscard]] double part(std::size_t measure, std::size_t system, const AssumedSpread& spread) const {
        return spread.participant_sd * own_[measure] + withSystem(measure, system, spread);
    }
    [[nodiscard]] double withSystem(std::size_t measure, std::size_t system,
                                    const AssumedSpread& spread) const {
        return spread.participant_system_sd * with_system_[measure * systems_ + system];
    }

    Random random;

  private:
    std::size_t systems_;
    std::vector<double> own_;
    std::vector<double> with_system_;
};

namespace {

double shiftOf(const ByName& shifts, const std::string& level) {
    const auto found = shifts.find(level);
    return found == shifts.end() ? 0.0 : found->second;
}

double shiftOfGroups(const GroupShifts& shifts, const Groups& groups) {
    double sum = 0.0;
    for (const auto& [factor, levels] : shifts)
        if (const auto level = groups.find(factor); level != groups.end())
            sum += shiftOf(levels, level->second);
    return sum;
}

/// Locations at which the systems' expected answers are those assumed; 0 for systems that are not named,
/// which the measure does not ask about.
std::vector<double> locationsFor(const Study& study, const ByName& expected, const AnswerCurve& curve,
                                 double sd, std::span<const double> shifts) {
    std::vector<double> out;
    for (const SystemSource& system : study.systems) {
        const auto found = expected.find(system.name);
        const auto location =
            found == expected.end() ? std::optional<double>(0.0) : curve.location(found->second, sd, shifts);
        if (!location) throw std::invalid_argument("an expected answer out of reach: " + system.name);
        out.push_back(*location);
    }
    return out;
}

double totalSd(const AssumedSpread& spread, double noise_sd) {
    return std::sqrt(spread.participant_sd * spread.participant_sd +
                     spread.participant_system_sd * spread.participant_system_sd +
                     spread.item_sd * spread.item_sd + noise_sd * noise_sd);
}

/// Which of the measures a stage's answers belong to; -1: to none that is assumed.
int measureOf(const std::vector<StudyMeasure>& measures, const std::string& name) {
    for (std::size_t i = 0; i < measures.size(); ++i)
        if (measures[i].name == name) return static_cast<int>(i);
    return -1;
}

}  // namespace

void AssumedAnswers::addModel(const Study& study, const StudyMeasure& measure,
                              const AssumedEffects& effects) {
    Model model;
    model.kind = measure.kind;
    if (measure.kind == AnswerKind::accuracy) {
        if (!effects.accuracy) return;
        model.groups = effects.accuracy->groups;
        model.spread = effects.accuracy->spread;
        model.lapse_rate = effects.accuracy->lapse_rate;
        model.locations = locationsFor(study, effects.accuracy->systems,
                                       AnswerCurve::choice(model.lapse_rate, measure.balls),
                                       totalSd(model.spread, 0.0), gameShifts(study, *effects.accuracy));
    } else if (measure.kind == AnswerKind::rating) {
        const auto found = effects.ratings.find(measure.name);
        if (found == effects.ratings.end()) return;
        model.groups = found->second.groups;
        model.spread = found->second.spread;
        model.noise_sd = found->second.noise_sd;
        model.locations =
            locationsFor(study, found->second.systems, AnswerCurve::scale(measure.low, measure.high),
                         totalSd(model.spread, model.noise_sd), groupShifts(study, model.groups));
    } else {
        if (!effects.preference) return;
        model.spread.participant_system_sd = effects.preference->participant_system_sd;
        model.noise_sd = effects.preference->noise_sd;
        model.tie_zone = effects.preference->tie_zone;
        model.clear_zone = effects.preference->clear_zone;
        for (const SystemSource& system : study.systems)
            model.locations.push_back(shiftOf(effects.preference->systems, system.name));
    }
    measures_.push_back(measure);
    models_.push_back(std::move(model));
}

AssumedAnswers::AssumedAnswers(const Study& study, const AssumedEffects& effects,
                               std::span<const StudyPlan> plans)
    : systems_(study.systems.size()) {
    for (const StudyMeasure& measure : studyMeasures(study)) addModel(study, measure, effects);
    const auto systemOf = [&](const std::string& name) {
        return static_cast<std::size_t>(
            std::find_if(study.systems.begin(), study.systems.end(),
                         [&](const SystemSource& system) { return system.name == name; }) -
            study.systems.begin());
    };
    std::map<std::string, std::size_t> items;  // in the order in which they are met
    const auto add = [&](std::size_t participant, const std::string& measure, const Trial& trial,
                         std::size_t stimulus) {
        const int index = measureOf(measures_, measure);
        if (index < 0) return;
        const Stimulus& shown = trial.stimuli[stimulus];
        const auto place = static_cast<std::size_t>(index);
        const StudyMeasure& asked = measures_[place];
        const bool choice = asked.kind == AnswerKind::accuracy;
        draws_.push_back({participant, place, systemOf(shown.system), systemOf(trial.stimuli.back().system),
                          items.emplace(shown.item, items.size()).first->second,
                          shiftOfGroups(models_[place].groups, plans[participant].groups) +
                              (choice ? shiftOf(effects.accuracy->layouts, trial.layout) +
                                            shiftOf(effects.accuracy->distances, trial.distance)
                                      : 0.0),
                          choice ? AnswerCurve::choice(models_[place].lapse_rate,
                                                       static_cast<int>(trial.ball_order.size()))
                                 : AnswerCurve::scale(asked.low, asked.high)});
        planned_.push_back({participant, place, &trial, stimulus});
    };
    std::map<const Stage*, std::vector<StudyMeasure>> asked_in;
    for (const Stage& stage : study.stages) asked_in[&stage] = measuresOf(study, stage);
    for (std::size_t p = 0; p < plans.size(); ++p)
        for (const Trial& trial : plans[p].trials) {
            const Stage* stage = study.findStage(trial.stage);
            if (stage == nullptr || trial.stimuli.empty()) continue;
            const std::size_t answered =
                declarationOf(trial.kind).answersEach() ? trial.stimuli.size() : std::size_t{1};
            for (std::size_t i = 0; i < answered; ++i) {
                if (!trial.scored(static_cast<int>(i))) continue;
                for (const StudyMeasure& asked : asked_in.at(stage)) add(p, asked.name, trial, i);
            }
        }
    items_ = items.size();
}

double AssumedAnswers::drawOne(const Draw& draw, AssumedParticipant& participant,
                               const std::vector<double>& items) const {
    const Model& model = models_[draw.measure];
    if (model.kind == AnswerKind::preference) {
        const auto strength = [&](std::size_t system) {
            return model.locations[system] + participant.withSystem(draw.measure, system, model.spread);
        };
        const double left_better = strength(draw.system) - strength(draw.other_system) +
                                   model.noise_sd * participant.random.normal();
        return PreferenceCurve{model.tie_zone, model.clear_zone}.answer(-left_better);
    }
    const double behind = model.locations[draw.system] + draw.shift +
                          participant.part(draw.measure, draw.system, model.spread) +
                          model.spread.item_sd * items[draw.measure * items_ + draw.item];
    if (model.kind == AnswerKind::accuracy)
        return participant.random.uniform() < draw.curve.chance(behind) ? 1.0 : 0.0;
    return draw.curve.step(behind + model.noise_sd * participant.random.normal());
}

void AssumedAnswers::draw(std::uint64_t seed, std::span<double> values) const {
    std::vector<double> items;
    items.reserve(measures_.size() * items_);
    for (const StudyMeasure& measure : measures_) {
        Random random(seed, fmt::format("items of {}", measure.name));
        for (std::size_t i = 0; i < items_; ++i) items.push_back(random.normal());
    }
    std::optional<AssumedParticipant> participant;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Draw& one = draws_[i];
        if (i == 0 || one.participant != draws_[i - 1].participant)
            participant.emplace(seed, one.participant, measures_.size(), systems_);
        values[i] = drawOne(one, *participant, items);
    }
}

}  // namespace deixis::studies
