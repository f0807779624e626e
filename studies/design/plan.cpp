#include "studies/design/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <span>

#include "core/random.hpp"
#include "plan_balls.hpp"
#include "plan_stage.hpp"
#include "plan_units.hpp"
#include "studies/study_file/stage_kind.hpp"

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
            return fail("groups." + group.first, "found a factor that is not in the study's [[between]]");
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

/// Gives every stage targets of its own, drawn by chance. Those that ask most of an item come first, for some
/// items may have no place in the room and can only be rated.
Result<void> drawItems(std::vector<OpenStage>& stages, const std::vector<TargetItem>& targets, int bands,
                       Random random) {
    ItemNeed in_room{0, 0, true, false};
    ItemNeed with_balls{0, 0, true, true};
    int needed = 0;
    for (const OpenStage& open : stages) {
        needed += open.need.total();
        in_room.scored += open.need.placed ? open.need.total() : 0;
        with_balls.scored += open.need.balls ? open.need.total() : 0;
    }
    const auto suits = [&](const TargetItem& item, const ItemNeed& need) {
        return (!need.placed || item.placed) &&
               (!need.balls || static_cast<int>(item.distractors.size()) >= bands);
    };
    if (static_cast<int>(targets.size()) < needed)
        return fail("targets.count",
                    fmt::format("found {} targets, expected at least {} for the items, practice and catch "
                                "trials of all stages",
                                targets.size(), needed));
    for (const ItemNeed& need : {with_balls, in_room}) {
        const auto found = std::count_if(targets.begin(), targets.end(),
                                         [&](const TargetItem& item) { return suits(item, need); });
        if (found < need.scored)
            return fail("targets",
                        fmt::format("found {} with a position in the room{}, expected at least {} for the {}",
                                    found, need.balls ? " and distractors" : "", need.scored,
                                    need.balls ? "referential games" : "stages that need one"));
    }

    std::vector<const TargetItem*> left;
    left.reserve(targets.size());
    for (const TargetItem& item : targets) left.push_back(&item);
    random.shuffle(std::span<const TargetItem*>(left));
    const auto demand = [](const ItemNeed& need) { return (need.placed ? 1 : 0) + (need.balls ? 1 : 0); };
    for (const int round : {2, 1, 0})
        for (OpenStage& open : stages) {
            if (demand(open.need) != round) continue;
            const auto wanted = static_cast<std::size_t>(open.need.total());
            for (const TargetItem*& item : left) {
                if (open.items.size() == wanted) break;
                if (item == nullptr || !suits(*item, open.need)) continue;
                open.items.push_back(item);
                item = nullptr;
            }
        }
    return {};
}

std::vector<Trial> pageTrials(const Stage& stage) {
    std::vector<Trial> out;
    const StageDeclaration& kind = declarationOf(stage.kind);
    const int pages = kind.pages != nullptr ? kind.pages(stage) : 0;
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

    // Where nobody else takes of the targets, they can be shared out over participants.
    const bool alone =
        std::count_if(stages->begin(), stages->end(), [](const OpenStage& open) { return open.clips; }) == 1;
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
        Result<std::vector<Trial>> trials =
            !open.clips                         ? pageTrials(stage)
            : alone && mirrorsConditions(stage) ? authoredTrials(study, stage, targets, row, stage_seed)
            : stage.practice                    ? practiceTrials(study, stage, open.items, turns, stage_seed)
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
    noteBalls(study, plan.trials);
    return plan;
}

std::vector<KeptValue> keptValues(const Trial& trial) {
    return declarationOf(trial.kind).balls ? ballValues(trial) : std::vector<KeptValue>();
}

}  // namespace deixis::studies
