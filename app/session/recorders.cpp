#include "app/session/recorders.hpp"

#include <fmt/core.h>

#include <cstdlib>

#include "core/number.hpp"

namespace deixis::app {

void DirectRecorder::record(const studies::SessionEvent& event) {
    if (std::holds_alternative<studies::Response>(event)) ++answered_;
    store_.record(event, study_, plan_, clips_);
}

template <typename Call>
void FailSafeRecorder::unlessFailed(const Call& call) const {
    if (problem_) return;
    try {
        call();
    } catch (const std::exception& problem) {
        problem_ = std::current_exception();
        failure_ = problem.what();
    }
}

void FailSafeRecorder::record(const studies::SessionEvent& event) {
    unlessFailed([&] { kept_by_.record(event); });
}

void FailSafeRecorder::sample(const studies::TrackingSample& sample, int trial_index) {
    unlessFailed([&] { kept_by_.sample(sample, trial_index); });
}

bool FailSafeRecorder::answersKept() const {
    bool kept = false;
    unlessFailed([&] { kept = kept_by_.answersKept(); });
    return kept || problem_;  // what cannot be kept is not waited for
}

void FailSafeRecorder::finish() {
    unlessFailed([&] { kept_by_.finish(); });
    if (problem_) std::rethrow_exception(problem_);
}

Result<results::RecordingOptions> recordingOptions() {
    results::RecordingOptions options;
    const char* variable = std::getenv("DEIXIS_STORAGE_DELAY_S");
    if (variable == nullptr) return options;
    const auto delay_s = finiteNumber(variable);
    if (!delay_s || *delay_s < 0.0)
        return fail("DEIXIS_STORAGE_DELAY_S",
                    fmt::format("'{}' was found; expected seconds, from 0 on", variable),
                    "Unset it: it is for tests");
    options.delay_s = *delay_s;
    return options;
}

}  // namespace deixis::app
