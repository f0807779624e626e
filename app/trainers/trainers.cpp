#include "trainers.hpp"

#include <fmt/format.h>

#include "core/number.hpp"
#include "learning/amp/training.hpp"
#include "learning/flow/training.hpp"
#include "learning/gestures/training.hpp"
#include "learning/moglow/training.hpp"

namespace deixis::app {

namespace {

using learning::TrainingOutcome;

Result<TrainingOutcome> trainMoglow(const TrainingRequest& request, const learning::DemonstrationSets& data,
                                    const learning::TrainingReport& report) {
    learning::MoglowSettings settings;
    settings.seed = request.seed;
    settings.threads = request.threads;
    settings.updates = request.updates.value_or(settings.updates);
    settings.validate_every = request.validate_every.value_or(settings.validate_every);
    return learning::trainMoglow(data, settings, request.provenance, request.file, report);
}

Result<TrainingOutcome> trainFlow(const TrainingRequest& request, const learning::DemonstrationSets& data,
                                  const learning::TrainingReport& report) {
    learning::FlowSettings settings;
    settings.seed = request.seed;
    settings.updates = request.updates.value_or(settings.updates);
    settings.validate_every = request.validate_every.value_or(settings.validate_every);
    return learning::trainFlow(data, settings, request.provenance, request.file, report);
}

Result<learning::AmpClusters> clustersFor(const TrainingRequest& request,
                                          const learning::DemonstrationSets& data) {
    std::optional<double> bandwidth_m;
    if (request.bandwidth == "scott") {
        const auto scott = learning::scottBandwidth_m(data.targets_m);
        if (!scott) return tl::unexpected(scott.error());
        bandwidth_m = *scott;
    } else if (!request.bandwidth.empty())
        bandwidth_m = finiteNumber(request.bandwidth);
    return learning::clustersOf(data, request.clusters, bandwidth_m);
}

Result<TrainingOutcome> trainAmp(const TrainingRequest& request, const learning::DemonstrationSets& data,
                                 const Trainers::Remark& remark, const learning::TrainingReport& report) {
    learning::AmpTraining training{.system = request.system};
    const bool phase_functioned = request.system == "amp-pfnn";
    learning::AmpSettings& settings = training.settings;
    settings = learning::ampSettings(
        {.policy_phase = request.system != "amp-no-runtime", .phase_functioned = phase_functioned});
    const auto task = learning::taskFromName(request.reward);
    if (!task) return tl::unexpected(task.error());
    settings.task = *task;
    settings.stance = request.full_body ? physics::Stance::free : physics::Stance::pinned;
    settings.seed = request.seed;
    settings.iterations = request.updates.value_or(settings.iterations);
    settings.validate_every = request.validate_every.value_or(settings.validate_every);
    for (const std::string& one : request.settings) {
        const auto equals = one.find('=');
        const std::string value = equals == std::string::npos ? "" : one.substr(equals + 1);
        if (const auto changed = learning::changeSetting(settings, one.substr(0, equals), value); !changed)
            return tl::unexpected(changed.error());
    }
    const auto clusters = clustersFor(request, data);
    if (!clusters) return tl::unexpected(clusters.error());
    training.clusters = *clusters;
    if (phase_functioned) training.system += fmt::format("-{}", clusters->count);
    if (clusters->bandwidth_m > 0.0)
        remark(fmt::format("{} clusters of {} targets by a bandwidth of {:.2f} m", clusters->count,
                           data.targets_m.size(), clusters->bandwidth_m));
    if (request.only_cluster && *request.only_cluster >= clusters->count)
        return fail("--cluster",
                    fmt::format("found {}, expected 0 to {}", *request.only_cluster, clusters->count - 1));
    training.only_cluster = request.only_cluster;
    training.threads = request.threads;
    training.rank = request.rank;
    return learning::trainAmp(data, training, request.provenance, request.file, report);
}

Result<TrainingOutcome> train(const TrainingRequest& request, const learning::DemonstrationSets& data,
                              const Trainers::Remark& remark, const learning::TrainingReport& report) {
    if (request.system == "moglow") return trainMoglow(request, data, report);
    if (request.system == "flow") return trainFlow(request, data, report);
    return trainAmp(request, data, remark, report);
}

Result<learning::GestureOutcome> trainSpeechGestures(const GestureTrainingRequest& request,
                                                     const learning::GestureTakes& takes,
                                                     const learning::GestureCallbacks& callbacks) {
    learning::GestureSettings settings;
    settings.shape.controls = request.controls;
    settings.shape.hidden = request.hidden.value_or(settings.shape.hidden);
    settings.shape.word_size = takes.words.size();
    settings.epochs = request.epochs.value_or(settings.epochs);
    settings.seed = request.seed;
    settings.threads = request.threads;
    return learning::trainGestures(takes, settings, request.provenance, request.file, callbacks);
}

}  // namespace

Trainers trainers() {
    return {train, trainSpeechGestures, learning::joinAmp};
}

}  // namespace deixis::app
