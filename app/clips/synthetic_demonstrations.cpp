#include "app/clips/synthetic_demonstrations.hpp"

#include "assets/data/data_paths.hpp"
#include "assets/data/demonstrations.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

namespace deixis::app {

Result<SyntheticDemonstrations> syntheticDemonstrations() {
    SyntheticDemonstrations out;
    out.parameters = assets::dataFile("demonstrations.toml");
    const auto bytes = readFile(out.parameters);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto parameters = assets::parseDemonstrationParameters(*bytes, out.parameters.string());
    if (!parameters) return tl::unexpected(parameters.error());
    auto made = motion::makeDemonstrations(motion::referenceHumanoid(), *parameters);
    if (!made) return tl::unexpected(made.error());
    out.made = std::move(*made);
    out.sha256 = sha256Hex(*bytes);
    return out;
}

}  // namespace deixis::app
