#include "studies/design/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>

#include "core/random.hpp"
#include "plan_stage.hpp"

namespace deixis::studies {

namespace {

/// A stage that applies to the participant.
struct OpenStage {
    const Stage* stage = nullptr;
    bool clips = false;
    ItemNeed need{};
    std::vector<const TargetItem*> items{};
};

Result<void> checkParticipant(const Study& study, std::string_view participant, int number,
                              const Groups& groups) {
    if (auto id = checkParticipantId(participant); !id) return id;
    if (number < 1)
        return fail("participant", fmt::format("found the number {}, expected 1 or more", number));
    for (const BetweenFactor& factor : study.between) {
        const auto group = groups.find(factor.name);
        if (group != groups.end() &&
            std::find(factor.levels.begin(), factor.levels.end(), group->second) != factor.levels.end())
            continue;
        const std::string found = group == groups.end() ? "none" : fmt::format("\"{}\"", group->second);
        return fail("groups." + factor.name, fmt::format("found {}, expected one of \"{}\"", found,
                                                         fmt::join(factor.levels, "\", \"")));
    }
    for (const auto& group : groups)
        if (std::none_of(study.between.begin(), study.between.end(),
                         [&](const BetweenFactor& factor) { return factor.name == group.first; }))
            return fail("groups." + group.first, "found a factor that is none of the study's [[between]]");
    return {};
}

bool applies(const Stage& stage, const Groups& groups) {
    return std::all_of(stage.when.begin(), stage.when.end(), [&](const auto& condition) {
        const auto group = groups.find(condition.first);
        return group != groups.end() && group->second == condition.second;
    });
}

Result<std::vector<OpenStage>> openStages(const Study& study, const Groups& groups) {
    std::vector<OpenStage> out;
    for (const Stage& stage : study.stages) {
        if (!applies(stage, groups)) continue;
        OpenStage& open = out.emplace_back();
        open.stage = &stage;
        open.clips = stage.practice.has_value() || showsClips(stage.kind);
        if (!open.clips) continue;
        const Result<const Stage*> design = designOf(study, stage);
        if (!design) return tl::unexpected(design.error());
        open.need = itemsNeeded(stage, **design);
    }
    return out;
}

/// Gives every stage targets of its own, drawn by chance. Games come first where some items have no place in
/// the room, for those can only be rated.
Result<void> drawItems(std::vector<OpenStage>& stages, const std::vector<TargetItem>& targets, int bands,
                       Random random) {
    int needed = 0;
    int needed_placed = 0;
    for (const OpenStage& open : stages) {
        needed += open.need.total();
        needed_placed += open.need.placed ? open.need.total() : 0;
    }
    const auto playable = [&](const TargetItem& item) {
        return item.placed && static_cast<int>(item.distractors.size()) >= bands;
    };
    const auto placed = std::count_if(targets.begin(), targets.end(), playable);
    if (static_cast<int>(targets.size()) < needed)
        return fail("targets.count",
                    fmt::format("found {} targets, expected at least {} for the items, practice and catch "
                                "trials of all stages",
                                targets.size(), needed));
    if (placed < needed_placed)
        return fail("targets",
                    fmt::format("found {} with a place in the room and distractors, expected at least {} for "
                                "the referential games",
                                placed, needed_placed));

    std::vector<const TargetItem*> left;
    left.reserve(targets.size());
    for (const TargetItem& item : targets) left.push_back(&item);
    random.shuffle(std::span<const TargetItem*>(left));
    for (const bool placed_ones : {true, false})
        for (OpenStage& open : stages) {
            if (open.need.placed != placed_ones) continue;
            const auto wanted = static_cast<std::size_t>(open.need.total());
            for (const TargetItem*& item : left) {
                if (open.items.size() == wanted) break;
                if (item == nullptr || (placed_ones && !playable(*item))) continue;
                open.items.push_back(item);
                item = nullptr;
            }
        }
    return {};
}

std::vector<Trial> pageTrials(const Stage& stage) {
    std::vector<Trial> out;
    const int pages = stage.kind == StageKind::consent         ? 1
                      : stage.kind == StageKind::questionnaire ? stage.questionnaire.pages()
                                                               : 0;
    for (int page = 0; page < pages; ++page) {
        Trial trial;
        trial.stage = stage.name;
        trial.kind = stage.kind;
        trial.page = page;
        out.push_back(std::move(trial));
    }
    return out;
}

/// The participant stays where the last clip was seen; before the first clip, where it will be.
void placePages(const Study& study, std::vector<Trial>& trials) {
    if (study.layouts.empty()) return;
    const auto first =
        std::find_if(trials.begin(), trials.end(), [](const Trial& trial) { return !trial.layout.empty(); });
    std::string layout = first == trials.end() ? study.layouts.front().name : first->layout;
    for (Trial& trial : trials) {
        if (trial.layout.empty())
            trial.layout = layout;
        else
            layout = trial.layout;
    }
}

/// Which clip each stimulus is, where its system has several for the item: one for each participant, whatever
/// else the plan draws.
void drawClips(const std::vector<TargetItem>& targets, std::uint64_t seed, std::vector<Trial>& trials) {
    std::map<std::string, const TargetItem*> several;
    for (const TargetItem& item : targets)
        if (!item.clips.empty()) several.emplace(item.id, &item);
    if (several.empty()) return;
    for (Trial& trial : trials)
        for (Stimulus& stimulus : trial.stimuli) {
            const auto item = several.find(stimulus.item);
            if (item == several.end()) continue;
            const auto clips = item->second->clips.find(stimulus.system);
            if (clips == item->second->clips.end()) continue;
            Random random(seed, "clip of " + stimulus.system + " for " + stimulus.item);
            stimulus.clip = static_cast<int>(random.below(static_cast<std::uint64_t>(clips->second)));
        }
}

/// How far the distractors of each game trial look from its target.
void noteAngles(const Study& study, std::vector<Trial>& trials) {
    for (Trial& trial : trials)
        if (trial.kind == StageKind::game)
            trial.angles =
                ballAngles(study, *study.findLayout(trial.layout), trial.target, trial.distractors);
}

/// What is seen of the balls of each game trial, past the reference avatar. All systems show an item with the
/// same balls, so that it is worked out once for each.
void noteVisibility(const Study& study, std::vector<Trial>& trials) {
    const std::vector<Viewpoint> from = viewpoints(study);
    std::map<std::array<std::string, 3>, std::vector<SeenBalls>> known;  // the target first
    for (Trial& trial : trials) {
        if (trial.kind != StageKind::game) continue;
        const std::array<std::string, 3> key{trial.stimuli.front().item, trial.distance, trial.layout};
        const auto [entry, fresh] = known.try_emplace(key);
        if (fresh) {
            const double radius_m = study.targets.ball_diameter_m / 2;
            std::vector<Sphere> balls{{trial.target, radius_m}};
            for (const Vec3& distractor : trial.distractors) balls.push_back({distractor, radius_m});
            for (const Viewpoint& viewpoint : from)
                if (viewpoint.layout == trial.layout)
                    entry->second.push_back(seenFrom(viewpoint, StandingAvatar::reference(), balls));
        }
        trial.seen = entry->second;
        for (std::size_t i = 0; i < trial.seen.size(); ++i)
            for (std::size_t place = 0; place < trial.ball_order.size(); ++place) {
                const auto ball = static_cast<std::size_t>(trial.ball_order[place]);
                trial.seen[i].at_rest[place] = entry->second[i].at_rest[ball];
                trial.seen[i].pointing[place] = entry->second[i].pointing[ball];
            }
    }
}

}  // namespace

const Vec3& Trial::ball(int place) const {
    const int which = ball_order.at(static_cast<std::size_t>(place));
    return which == 0 ? target : distractors.at(static_cast<std::size_t>(which - 1));
}

int Trial::targetPlace() const {
    const auto found = std::find(ball_order.begin(), ball_order.end(), 0);
    return found == ball_order.end() ? -1 : static_cast<int>(found - ball_order.begin());
}

bool Trial::scored(int stimulus) const {
    if (practice || stimulus < 0 || stimulus >= static_cast<int>(stimuli.size())) return false;
    return !check || (check->kind == CheckKind::number && check->stimulus != stimulus);
}

Result<StudyPlan> buildPlan(const Study& study, const std::vector<TargetItem>& targets,
                            std::string_view participant, int number, const Groups& groups,
                            std::optional<int> number_in_cell) {
    if (const Result<void> checked = checkParticipant(study, participant, number, groups); !checked)
        return tl::unexpected(checked.error());
    Result<std::vector<OpenStage>> stages = openStages(study, groups);
    if (!stages) return tl::unexpected(stages.error());

    const std::uint64_t seed = deriveSeed(deriveSeed(study.seed, "plan"), fmt::format("{}", number));
    const int bands = static_cast<int>(study.distances.size());
    if (const Result<void> drawn = drawItems(*stages, targets, bands, Random(seed, "items")); !drawn)
        return tl::unexpected(drawn.error());

    PracticeTurns turns;
    for (const SystemSource& system : study.systems) turns.emplace_back(system.name, 0);
    Random(seed, "practice turns").shuffle(std::span<PracticeTurns::value_type>(turns));

    const int row = number_in_cell.value_or(number);  // of Williams squares
    StudyPlan plan{std::string(participant), number, study.name, study.hash, study.seed, groups,
                   number_in_cell,           {},     {}};
    for (const OpenStage& open : *stages) {
        const Stage& stage = *open.stage;
        plan.stages.push_back(stage.name);
        const std::uint64_t stage_seed = deriveSeed(seed, stage.name);
        Result<std::vector<Trial>> trials = !open.clips ? pageTrials(stage)
                                            : stage.practice
                                                ? practiceTrials(study, stage, open.items, turns, stage_seed)
                                                : scoredTrials(study, stage, open.items, row, stage_seed);
        if (!trials) return tl::unexpected(trials.error());
        const int first = static_cast<int>(plan.trials.size());
        plan.trials.reserve(plan.trials.size() + trials->size());
        for (Trial& trial : *trials) {
            trial.index = static_cast<int>(plan.trials.size());
            if (trial.check && trial.check->of_trial >= 0) trial.check->of_trial += first;
            plan.trials.push_back(std::move(trial));
        }
    }
    placePages(study, plan.trials);
    drawClips(targets, seed, plan.trials);
    noteVisibility(study, plan.trials);
    noteAngles(study, plan.trials);
    return plan;
}

}  // namespace deixis::studies
