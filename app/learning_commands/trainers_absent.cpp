#include "trainers.hpp"

namespace deixis::app {

namespace {

tl::unexpected<Error> absent() {
    return fail("learn", "this program was built without what trains",
                "Run scripts/install.sh learning, and build with the preset learning (docs/learning.md)");
}

}  // namespace

bool canTrain() {
    return false;
}

Result<learning::TrainingOutcome> train(const TrainingRequest&, const learning::DemonstrationSets&,
                                        const std::function<void(const std::string&)>&,
                                        const learning::TrainingReport&) {
    return absent();
}

Result<void> joinTrained(const std::vector<std::filesystem::path>&, const std::filesystem::path&) {
    return absent();
}

}  // namespace deixis::app
