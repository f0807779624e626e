#include "plan_units.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "counterbalancing.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

int bandIndex(const Study& study, std::string_view name) {
    return static_cast<int>(study.findDistance(name) - study.distances.data());
}

struct LevelRange {
    int first = 0;
    int end = 0;
};

/// All levels where items meet all of them, else the item's own.
LevelRange levelsMet(Crossing meeting, int levels, int own) {
    return meeting == Crossing::nested ? LevelRange{own, own + 1} : LevelRange{0, levels};
}

/// The levels of the factor that makes the blocks, in the order of presentation.
std::vector<int> blockOrder(const TrialDesign& design, int levels, int row, Random random) {
    std::vector<int> order(levels);
    std::iota(order.begin(), order.end(), 0);
    if (design.block_order == BlockOrder::shuffled) random.shuffle(std::span<int>(order));
    if (design.block_order == BlockOrder::williams) {
        const std::vector<std::vector<int>> rows = williamsSquare(levels);
        order = rows[(row - 1) % rows.size()];
    }
    return order;
}

void setBlocks(std::vector<PlannedTrial>& units, const TrialDesign& design, const DesignLevels& levels,
               int row, std::uint64_t seed) {
    if (design.block_by.empty()) return;
    const bool by_system = design.block_by == "system";
    const bool by_layout = design.block_by == "layout";
    const int count = static_cast<int>(by_system   ? levels.shown.size()
                                       : by_layout ? levels.layouts
                                                   : levels.bands.size());
    const std::vector<int> order = blockOrder(design, count, row, Random(seed, "blocks"));
    Random random(seed, "blocks of catch trials");
    for (PlannedTrial& unit : units) {
        int level = by_system ? unit.shown : unit.layout;
        if (!by_system && !by_layout) {
            const auto band = std::find(levels.bands.begin(), levels.bands.end(), unit.band);
            // The band of a catch trial need not be one of the design's: then it comes in any block.
            level = static_cast<int>(band == levels.bands.end() ? random.below(levels.bands.size())
                                                                : band - levels.bands.begin());
        }
        unit.block = static_cast<int>(std::find(order.begin(), order.end(), level) - order.begin());
    }
}

}  // namespace

DesignLevels levelsOf(const Study& study, const Stage& design) {
    DesignLevels out;
    const StageDeclaration& kind = declarationOf(design.kind);
    out.shown = kind.shown(static_cast<int>(design.design.systems.size()));
    out.layouts = static_cast<int>(design.design.layouts.size());
    if (kind.balls)
        for (const std::string& name : design.design.distances) out.bands.push_back(bandIndex(study, name));
    else
        out.bands = {-1};
    return out;
}

std::vector<PlannedTrial> makeUnits(const Study& study, const Stage& stage,
                                    const std::vector<const TargetItem*>& items, int row,
                                    std::uint64_t seed) {
    const TrialDesign& design = stage.design;
    const DesignLevels levels = levelsOf(study, stage);
    const int shown = static_cast<int>(levels.shown.size());
    const int bands = static_cast<int>(levels.bands.size());

    const auto nestedLevels = [](Crossing meeting, int count) {
        return meeting == Crossing::nested ? count : 1;
    };
    Random random(seed, "levels");
    const std::vector<std::vector<int>> own = counterbalanceLevels(
        {nestedLevels(design.system_meets, shown), nestedLevels(design.layout_meets, levels.layouts),
         nestedLevels(design.distance_meets, bands)},
        design.items, random);
    std::vector<PlannedTrial> units;
    for (int i = 0; i < design.items; ++i) {
        const LevelRange systems = levelsMet(design.system_meets, shown, own[i][0]);
        const LevelRange layouts = levelsMet(design.layout_meets, levels.layouts, own[i][1]);
        const LevelRange distances = levelsMet(design.distance_meets, bands, own[i][2]);
        for (int system = systems.first; system < systems.end; ++system)
            for (int layout = layouts.first; layout < layouts.end; ++layout)
                for (int distance = distances.first; distance < distances.end; ++distance)
                    units.push_back({items[i], system, layout, levels.bands[distance]});
    }

    std::size_t next = static_cast<std::size_t>(design.items);
    for (const AttentionChecks& check : stage.checks) {
        if (check.kind != CheckKind::catch_trial) continue;
        for (const std::vector<int>& level :
             counterbalanceLevels({shown, levels.layouts}, check.count, random)) {
            units.push_back({items[next++], level[0], level[1], bandIndex(study, check.distance)});
            units.back().is_catch = true;
        }
    }
    setBlocks(units, design, levels, row, seed);
    return units;
}

}  // namespace deixis::studies
