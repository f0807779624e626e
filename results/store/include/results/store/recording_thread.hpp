// Stores what happens in a session without delaying a frame: events and tracking samples are handed over
// in microseconds and written by a separate thread.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "results/store/store.hpp"
#include "studies/session/events.hpp"
#include "studies/station/station.hpp"

namespace deixis::results {

struct RecordingOptions {
    /// Samples that may wait to be written: at 90 Hz about 45 s. Further ones are counted as missing.
    std::size_t max_waiting_samples = 4096;
    /// For tests: each transaction takes this much longer.
    double delay_s = 0.0;
};

/// While it lives only it uses the store. All calls come from one thread. The first failure (a full disk, a
/// lock that is not given back) ends the writing; from then on record(), sample(), allKept() and finish()
/// throw it.
class RecordingThread {
  public:
    /// The store's session must have begun. `store`, `study` and `plan` must outlive it.
    RecordingThread(Store& store, const studies::Study& study, const studies::StudyPlan& plan,
                    ClipRecords clips, RecordingOptions options);
    /// Does what finish() does, then ends. Failures are lost here: call finish() first.
    ~RecordingThread();
    RecordingThread(const RecordingThread&) = delete;
    RecordingThread& operator=(const RecordingThread&) = delete;

    /// Hands an event over; events are never dropped. Answers go to the disk at once, before waiting samples.
    void record(studies::SessionEvent event);
    /// Hands a sample over, or counts it as missing in this trial where too many wait. `trial_index` -1: none
    /// under way.
    void sample(studies::TrackingSample sample, int trial_index);
    /// Whether every event handed over is kept as Store::record() says: answers are on the disk.
    [[nodiscard]] bool allKept() const;
    /// Waits until all is written, samples and the tally of the trial under way too.
    void finish();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace deixis::results
