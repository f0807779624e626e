#include "results/analysis/measured_space.hpp"

#include <map>
#include <utility>

namespace deixis::results {

std::vector<MeasuredPlace> measuredSpace(const ResponseTable& table) {
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), table.systems.begin(), table.systems.end());
    std::vector<MeasuredPlace> out;
    for (const Measure& measure : table.measures) {
        if (measure.unit.empty()) continue;
        std::map<std::pair<std::string, std::string>, std::pair<int, double>> sums;  // of a system's target
        for (const ResponseRow& row : table.rows) {
            if (row.measure != measure.name || !table.target_positions.contains(row.target_id)) continue;
            for (const std::string& system : {std::string("all"), row.system}) {
                auto& [n, sum] = sums[{system, row.target_id}];
                ++n;
                sum += row.value;
            }
        }
        for (const std::string& system : systems)
            for (const auto& [target, position] : table.target_positions)
                if (const auto found = sums.find({system, target}); found != sums.end())
                    out.push_back({measure.name, measure.unit, system, target, position, found->second.first,
                                   found->second.second / found->second.first});
    }
    return out;
}

}  // namespace deixis::results
