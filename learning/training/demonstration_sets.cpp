#include <algorithm>

#include "learning/training/training.hpp"

namespace deixis::learning {

DemonstrationSets splitDemonstrations(std::vector<motion::Demonstration> demonstrations, bool mirrored) {
    constexpr std::size_t share = 13;
    const std::size_t step = std::clamp<std::size_t>(demonstrations.size(), 1, share);
    DemonstrationSets out;
    for (std::size_t i = 0; i < demonstrations.size(); ++i) {
        out.targets_m.push_back(demonstrations[i].target);
        auto& set = demonstrations.size() > 1 && i % step == step / 2 ? out.validation : out.training;
        if (mirrored) set.push_back(motion::mirrored(demonstrations[i]));
        set.insert(set.end() - (mirrored ? 1 : 0), std::move(demonstrations[i]));
    }
    return out;
}

void setProvenance(motion::NetworkWeights& weights, const std::string& sha256, bool synthetic,
                   std::uint64_t seed, const Provenance& provenance) {
    weights.training_data_sha256 = sha256;
    weights.synthetic = synthetic;
    weights.seed = seed;
    weights.program_version = provenance.version;
    weights.commit = provenance.commit;
}

void setProvenance(motion::NetworkWeights& weights, const DemonstrationSets& data, std::uint64_t seed,
                   const Provenance& provenance) {
    setProvenance(weights, data.sha256, data.synthetic, seed, provenance);
}

}  // namespace deixis::learning
