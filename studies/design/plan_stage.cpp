#include "plan_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>

#include "core/random.hpp"
#include "counterbalancing.hpp"
#include "plan_balls.hpp"
#include "plan_units.hpp"
#include "studies/study_file/stage_kind.hpp"
#include "trial_order.hpp"

namespace deixis::studies {

namespace {

tl::unexpected<Error> failIn(const Stage& stage, std::string_view key, std::string message,
                             std::string hint = {}) {
    return fail(fmt::format("stages.{}.{}", stage.name, key), std::move(message), std::move(hint));
}

int countOf(const Stage& stage, CheckKind kind) {
    int count = 0;
    for (const AttentionChecks& check : stage.checks)
        if (check.kind == kind) count += check.count;
    return count;
}

/// A study file has been checked when it was read; this keeps a study made by hand from breaking the plan.
Result<void> checkDesign(const Study& study, const Stage& stage) {
    const TrialDesign& design = stage.design;
    const StageDeclaration& kind = declarationOf(stage.kind);
    const auto min = static_cast<std::size_t>(kind.min_stimuli);
    if (design.systems.size() < min)
        return failIn(stage, "systems",
                      fmt::format("found {}, expected at least {}", design.systems.size(), min));
    if (design.layouts.empty()) return failIn(stage, "layouts", "found none, expected at least one");
    if (design.items < 1)
        return failIn(stage, "items", fmt::format("found {}, expected at least 1", design.items));
    if (kind.arrangement == Arrangement::shuffled && design.system_meets != Crossing::crossed)
        return failIn(stage, "system_meets",
                      "found \"nested\", expected \"crossed\": a page shows all systems");
    if (kind.balls && design.distances.empty())
        return failIn(stage, "distances", "found none, expected at least one");
    for (const std::string& name : design.systems)
        if (study.findSystem(name) == nullptr)
            return failIn(stage, "systems", fmt::format("found \"{}\", expected one of [[systems]]", name));
    for (const std::string& name : design.layouts)
        if (study.findLayout(name) == nullptr)
            return failIn(stage, "layouts", fmt::format("found \"{}\", expected one of [[layouts]]", name));
    for (const std::string& name : design.distances)
        if (study.findDistance(name) == nullptr)
            return failIn(stage, "distances",
                          fmt::format("found \"{}\", expected one of [[distances]]", name));
    for (const AttentionChecks& check : stage.checks) {
        if (check.kind == CheckKind::number && !kind.has("scale"))
            return failIn(stage, "checks.kind",
                          "found \"number\", expected \"repeat\" or \"catch\": there is no scale for it");
        if (check.kind != CheckKind::catch_trial) continue;
        if (!kind.balls)
            return failIn(stage, "checks.kind", "found \"catch\", expected it in a referential game only");
        if (study.findDistance(check.distance) == nullptr)
            return failIn(stage, "checks.distance",
                          fmt::format("found \"{}\", expected one of [[distances]]", check.distance));
    }
    return {};
}

/// Runs of a system and of an item, where the design limits them.
OrderTask orderTask(const TrialDesign& design, const DesignLevels& levels,
                    const std::vector<PlannedTrial>& units) {
    OrderTask task;
    std::vector<const TargetItem*> items;
    for (const PlannedTrial& unit : units) items.push_back(unit.item);
    std::sort(items.begin(), items.end());
    items.erase(std::unique(items.begin(), items.end()), items.end());
    const int systems = static_cast<int>(design.systems.size());
    task.max_run.assign(systems, design.max_run_of_system);
    task.max_run.resize(systems + items.size(), 1);
    for (const PlannedTrial& unit : units) {
        OrderTask::Unit& out = task.units.emplace_back();
        out.block = unit.block;
        if (design.max_run_of_system > 0) out.labels = levels.shown[unit.shown];
        if (design.no_target_twice_running) {
            const auto item = std::lower_bound(items.begin(), items.end(), unit.item);
            out.labels.push_back(systems + static_cast<int>(item - items.begin()));
        }
    }
    return task;
}

std::string describeLimits(const TrialDesign& design) {
    std::string out;
    if (design.max_run_of_system > 0)
        out = fmt::format("no system occurs more than {} times in a row", design.max_run_of_system);
    if (design.no_target_twice_running)
        out += (out.empty() ? "" : " and ") + std::string("no target occurs twice in a row");
    return out;
}

/// Puts `count` second times into an order: each of another unit, in the same block, with a quarter of the
/// block's trials or more in between. False where there is no room.
bool insertRepeats(std::vector<PlannedTrial>& units, OrderTask& task, std::vector<int>& order, int count,
                   Random& random) {
    struct Room {
        int unit = 0;
        std::size_t before = 0;
    };
    std::vector<int> block_size;
    for (const int i : order) {
        block_size.resize(std::max<std::size_t>(block_size.size(), units[i].block + 1));
        ++block_size[units[i].block];
    }
    std::vector<char> taken(units.size());
    for (int n = 0; n < count; ++n) {
        std::vector<Room> rooms;
        for (std::size_t first = 0; first < order.size(); ++first) {
            const PlannedTrial& unit = units[order[first]];
            if (unit.is_catch || unit.repeat_of >= 0 || taken[order[first]]) continue;
            const std::size_t between = std::max(1, block_size[unit.block] / 4);
            for (std::size_t before = first + 1 + between; before <= order.size(); ++before) {
                if (units[order[before - 1]].block != unit.block) break;
                if (fitsBefore(task, order, before, task.units[order[first]].labels))
                    rooms.push_back({order[first], before});
            }
        }
        if (rooms.empty()) return false;
        const Room room = rooms[random.below(rooms.size())];
        taken[room.unit] = true;
        taken.push_back(true);
        PlannedTrial repeat = units[room.unit];
        repeat.repeat_of = room.unit;
        order.insert(order.begin() + static_cast<std::ptrdiff_t>(room.before),
                     static_cast<int>(units.size()));
        units.push_back(repeat);
        task.units.push_back(OrderTask::Unit(task.units[room.unit]));
    }
    return true;
}

/// The units' order of presentation, repeats added to both.
Result<std::vector<int>> orderUnits(const Stage& stage, const DesignLevels& levels,
                                    std::vector<PlannedTrial>& units, std::uint64_t seed) {
    const OrderTask task = orderTask(stage.design, levels, units);
    const int repeats = countOf(stage, CheckKind::repeat);
    Random random(seed, "order");
    constexpr int attempts = 20;  // another order may have room for the repeats
    for (int attempt = 0; attempt < attempts; ++attempt) {
        std::optional<std::vector<int>> order = shuffledOrder(task, random);
        if (!order)
            return failIn(
                stage, stage.design.max_run_of_system > 0 ? "max_run_of_system" : "no_target_twice_running",
                fmt::format("found no order of the {} trials in which {}", units.size(),
                            describeLimits(stage.design)),
                "Relax the limits, or use more items");
        if (repeats == 0) return *order;
        std::vector<PlannedTrial> more_units = units;
        OrderTask more_task = task;
        if (!insertRepeats(more_units, more_task, *order, repeats, random)) continue;
        units = std::move(more_units);
        return *order;
    }
    return failIn(stage, "checks.count",
                  fmt::format("found no room for {} repeats, each in the same block as the first and at "
                              "least a quarter of the block's trials later, among {} trials",
                              repeats, units.size()),
                  "Use fewer repeats or more items");
}

void shuffle(std::vector<int>& values, Random& random) {
    random.shuffle(std::span<int>(values));
}

/// Pairwise: by unit, whether the second of the pair stands left. Evenly over a pair's trials, and over those
/// in each layout; a repeat's side is chance's.
std::vector<char> drawSides(const std::vector<PlannedTrial>& units, std::size_t pairs, Random random) {
    std::vector<char> swapped(units.size());
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        std::vector<int> members;
        for (std::size_t i = 0; i < units.size(); ++i)
            if (units[i].shown == static_cast<int>(pair) && units[i].repeat_of < 0)
                members.push_back(static_cast<int>(i));
        shuffle(members, random);
        std::stable_sort(members.begin(), members.end(),
                         [&](int a, int b) { return units[a].layout < units[b].layout; });
        bool swap = random.below(2) == 1;
        for (const int i : members) {
            swapped[i] = swap;
            swap = !swap;
        }
    }
    for (std::size_t i = 0; i < units.size(); ++i)
        if (units[i].repeat_of >= 0) swapped[i] = random.below(2) == 1;
    return swapped;
}

/// Adds a trial of `design`'s kind; the stimuli of a page and the balls in an order of chance.
Trial& addTrial(std::vector<Trial>& trials, const Study& study, const Stage& stage, const Stage& design,
                const PlannedTrial& unit, const std::vector<int>& shown, Random& random) {
    Trial& trial = trials.emplace_back();
    trial.index = static_cast<int>(trials.size()) - 1;
    trial.stage = stage.name;
    trial.kind = design.kind;
    trial.layout = design.design.layouts[unit.layout];
    trial.target = unit.item->target;
    trial.stimuli.reserve(shown.size());
    for (const int system : shown) trial.stimuli.push_back({design.design.systems[system], unit.item->id});
    const StageDeclaration& kind = declarationOf(design.kind);
    if (kind.arrangement == Arrangement::shuffled) random.shuffle(std::span<Stimulus>(trial.stimuli));
    if (kind.balls) drawBalls(trial, study, *unit.item, unit.band, random);
    return trial;
}

/// A number that nobody gives by chance on a slider's ends.
int drawNumber(const Scale& scale, Random& random) {
    const int margin = scale.kind == ScaleKind::slider ? (scale.high - scale.low) / 20 : 0;
    return scale.low + margin + static_cast<int>(random.below(scale.steps() - 2 * margin));
}

/// Numbers take the place of stimuli that would count, each on a trial of its own.
Result<void> addNumbers(const Stage& stage, std::vector<Trial>& trials, Random random) {
    const int count = countOf(stage, CheckKind::number);
    if (count == 0) return {};
    std::vector<int> open;
    std::vector<char> repeated(trials.size());
    for (const Trial& trial : trials)
        if (trial.check && trial.check->of_trial >= 0) repeated[trial.check->of_trial] = true;
    for (const Trial& trial : trials)
        if (!trial.check && !repeated[trial.index]) open.push_back(trial.index);
    if (static_cast<int>(open.size()) < count)
        return failIn(stage, "checks.count",
                      fmt::format("found {} numbers for {} trials, expected at most one per trial", count,
                                  open.size()));
    shuffle(open, random);
    for (int i = 0; i < count; ++i) {
        Trial& trial = trials[open[i]];
        TrialCheck check;
        check.stimulus = static_cast<int>(random.below(trial.stimuli.size()));
        check.expected = drawNumber(stage.scale, random);
        trial.check = check;
    }
    return {};
}

/// Authoring: the first trials of each block are practice (Yoon et al. 2021, 7.1.1).
void markPractice(const Stage& stage, const std::vector<PlannedTrial>& units, const std::vector<int>& order,
                  std::vector<Trial>& trials) {
    int block = -1;
    int place = 0;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        const int own = units[order[i]].block;
        place = own == block ? place + 1 : 0;
        block = own;
        trials[i].practice = place < stage.authoring.practice_per_block;
    }
}

/// The level whose systems have been practised least; among equals the one whose turn comes first.
int nextInTurn(const DesignLevels& levels, const std::vector<std::string>& systems, PracticeTurns& turns) {
    std::vector<std::size_t> place(systems.size());
    for (std::size_t i = 0; i < systems.size(); ++i)
        place[i] = static_cast<std::size_t>(
            std::find_if(turns.begin(), turns.end(),
                         [&](const auto& turn) { return turn.first == systems[i]; }) -
            turns.begin());
    const auto practised = [&](const std::vector<int>& shown) {
        return std::accumulate(shown.begin(), shown.end(), 0,
                               [&](int sum, int system) { return sum + turns[place[system]].second; });
    };
    const auto placesOf = [&](const std::vector<int>& shown) {
        std::vector<std::size_t> places;
        for (const int system : shown) places.push_back(place[system]);
        std::sort(places.begin(), places.end());
        return places;
    };
    const auto min =
        std::min_element(levels.shown.begin(), levels.shown.end(), [&](const auto& a, const auto& b) {
            const int of_a = practised(a), of_b = practised(b);
            return of_a != of_b ? of_a < of_b : placesOf(a) < placesOf(b);
        });
    for (const int system : *min) ++turns[place[system]].second;
    return static_cast<int>(min - levels.shown.begin());
}

}  // namespace

Result<const Stage*> designOf(const Study& study, const Stage& stage) {
    if (!stage.practice) return &stage;
    const Stage* of = study.findStage(stage.practice->of);
    if (of == nullptr || !of->scored())
        return failIn(stage, "of",
                      fmt::format("found \"{}\", expected a stage with scored trials", stage.practice->of));
    return of;
}

ItemNeed itemsNeeded(const Stage& stage, const Stage& design) {
    const StageDeclaration& kind = declarationOf(design.kind);
    if (stage.practice)
        return {stage.design.items * stage.practice->max_attempts, 0, kind.placed, kind.balls};
    return {stage.design.items, countOf(stage, CheckKind::catch_trial), kind.placed, kind.balls};
}

Result<std::vector<Trial>> scoredTrials(const Study& study, const Stage& stage,
                                        const std::vector<const TargetItem*>& items, int row,
                                        std::uint64_t seed) {
    if (const Result<void> checked = checkDesign(study, stage); !checked)
        return tl::unexpected(checked.error());
    const DesignLevels levels = levelsOf(study, stage);
    std::vector<PlannedTrial> units = makeUnits(study, stage, items, row, seed);
    const Result<std::vector<int>> order = orderUnits(stage, levels, units, seed);
    if (!order) return tl::unexpected(order.error());

    const std::vector<char> swapped = declarationOf(stage.kind).arrangement == Arrangement::sides
                                          ? drawSides(units, levels.shown.size(), Random(seed, "sides"))
                                          : std::vector<char>(units.size());
    Random random(seed, "places");
    std::vector<Trial> trials;
    std::vector<int> trial_of_unit(units.size(), -1);
    trials.reserve(order->size());
    for (const int i : *order) {
        const PlannedTrial& unit = units[i];
        Trial& trial = addTrial(trials, study, stage, stage, unit, levels.shown[unit.shown], random);
        if (swapped[i]) std::swap(trial.stimuli[0], trial.stimuli[1]);
        if (unit.is_catch) trial.check = TrialCheck{CheckKind::catch_trial};
        if (unit.repeat_of >= 0)
            trial.check = TrialCheck{CheckKind::repeat, 0, 0.0, trial_of_unit[unit.repeat_of]};
        trial_of_unit[i] = trial.index;
    }
    markPractice(stage, units, *order, trials);
    if (const Result<void> added = addNumbers(stage, trials, Random(seed, "numbers")); !added)
        return tl::unexpected(added.error());
    return trials;
}

Result<std::vector<Trial>> authoredTrials(const Study& study, const Stage& stage,
                                          const std::vector<TargetItem>& targets, int row,
                                          std::uint64_t seed) {
    if (const Result<void> checked = checkDesign(study, stage); !checked)
        return tl::unexpected(checked.error());
    const DesignLevels levels = levelsOf(study, stage);
    const std::vector<PlannedTrial> units = mirroredTrials(study, stage, targets, row);
    Random random(seed, "places");
    std::vector<Trial> trials;
    trials.reserve(units.size());
    for (const PlannedTrial& unit : units)
        addTrial(trials, study, stage, stage, unit, levels.shown[unit.shown], random);
    std::vector<int> order(units.size());
    std::iota(order.begin(), order.end(), 0);
    markPractice(stage, units, order, trials);
    return trials;
}

Result<std::vector<Trial>> practiceTrials(const Study& study, const Stage& stage,
                                          const std::vector<const TargetItem*>& items, PracticeTurns& turns,
                                          std::uint64_t seed) {
    const Result<const Stage*> found = designOf(study, stage);
    if (!found) return tl::unexpected(found.error());
    const Stage& design = **found;
    if (const Result<void> checked = checkDesign(study, design); !checked)
        return tl::unexpected(checked.error());
    const DesignLevels levels = levelsOf(study, design);

    Random random(seed, "practice");
    std::vector<Trial> trials;
    trials.reserve(items.size());
    PracticeTurns current = turns;  // later attempts may not be done, so other stages do not count on them
    for (int attempt = 0; attempt < stage.practice->max_attempts; ++attempt) {
        const std::vector<std::vector<int>> own = counterbalanceLevels(
            {levels.layouts, static_cast<int>(levels.bands.size())}, stage.design.items, random);
        for (int i = 0; i < stage.design.items; ++i) {
            const int shown = nextInTurn(levels, design.design.systems, current);
            PlannedTrial unit{items[attempt * stage.design.items + i], shown, own[i][0],
                              levels.bands[own[i][1]]};
            std::vector<int> systems = levels.shown[shown];
            if (declarationOf(design.kind).arrangement == Arrangement::sides) shuffle(systems, random);
            Trial& trial = addTrial(trials, study, stage, design, unit, systems, random);
            trial.practice = true;
            trial.attempt = attempt;
        }
        if (attempt == 0) turns = current;
    }
    return trials;
}

}  // namespace deixis::studies
