// Which speeches a participant authors: participants whose conditions are mirrored get the same ones, so that
// each speech is made under every condition (Yoon et al. 2021, 7.1.1).
#include <algorithm>
#include <numeric>
#include <span>

#include "plan_units.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

/// All speeches in an order of chance, another one in each round through them.
std::vector<const TargetItem*> shuffledSpeeches(const std::vector<TargetItem>& targets, std::uint64_t seed,
                                                int round) {
    std::vector<const TargetItem*> out;
    for (const TargetItem& item : targets) out.push_back(&item);
    Random(deriveSeed(seed, "speeches"), std::to_string(round)).shuffle(std::span<const TargetItem*>(out));
    return out;
}

/// The next of them that are not taken yet, from that many on.
std::vector<const TargetItem*> takeSpeeches(const std::vector<TargetItem>& targets, std::uint64_t seed,
                                            int from, int count) {
    const int all = static_cast<int>(targets.size());
    std::vector<const TargetItem*> out, round;
    for (int at = from; static_cast<int>(out.size()) < count; ++at) {
        if (round.empty() || at % all == 0) round = shuffledSpeeches(targets, seed, at / all);
        const TargetItem* item = round[static_cast<std::size_t>(at % all)];
        if (std::find(out.begin(), out.end(), item) == out.end()) out.push_back(item);
    }
    return out;
}

}  // namespace

bool mirrorsConditions(const Stage& stage) {
    const TrialDesign& design = stage.design;
    return declarationOf(stage.kind).in_studio && design.system_meets == Crossing::nested &&
           design.block_by == "system" && design.block_order == BlockOrder::williams &&
           design.items % static_cast<int>(design.systems.size()) == 0;
}

std::vector<PlannedTrial> mirroredTrials(const Study& study, const Stage& stage,
                                         const std::vector<TargetItem>& targets, int row) {
    const int systems = static_cast<int>(stage.design.systems.size());
    const int layouts = static_cast<int>(stage.design.layouts.size());
    const int in_block = stage.design.items / systems;
    const int practice = stage.authoring.practice_per_block;
    const auto square = williamsSquare(systems);
    const int in_group = static_cast<int>(square.size());
    const int group = (row - 1) / in_group;
    const std::vector<int>& order = square[static_cast<std::size_t>((row - 1) % in_group)];

    const std::uint64_t seed = deriveSeed(study.seed, stage.name);
    const int scored = systems * (in_block - practice);
    const auto counting = takeSpeeches(targets, seed, group * scored, scored);
    std::vector<const TargetItem*> practised;
    for (const TargetItem& item : targets)
        if (std::find(counting.begin(), counting.end(), &item) == counting.end()) practised.push_back(&item);
    Random(deriveSeed(seed, "practice"), std::to_string(group))
        .shuffle(std::span<const TargetItem*>(practised));

    std::vector<PlannedTrial> out;
    std::size_t next = 0, next_practice = 0;
    for (int block = 0; block < systems; ++block)
        for (int place = 0; place < in_block; ++place) {
            const TargetItem* item = place < practice ? practised[next_practice++] : counting[next++];
            PlannedTrial trial{item, order[static_cast<std::size_t>(block)], place % layouts};
            trial.block = block;
            out.push_back(trial);
        }
    return out;
}

}  // namespace deixis::studies
