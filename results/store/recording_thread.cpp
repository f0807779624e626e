#include "results/store/recording_thread.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <utility>

#include "results/database/tracking_blocks.hpp"

namespace deixis::results {

namespace {

constexpr std::size_t samples_together = max_frames_in_block;  ///< in one transaction
/// Of a sample, unless the disk is slow: long enough for a block to fill at 72 frames per second.
constexpr std::chrono::milliseconds longest_wait{1000};
constexpr std::size_t usual_events = 64;

void add(TrialTracking& trial, const studies::TrackingSample& sample) {
    if (trial.frames == 0) trial.first_display_time_s = sample.display_time_s;
    trial.last_display_time_s = sample.display_time_s;
    ++trial.frames;
    trial.dropped_frames += sample.dropped_frames;
    trial.max_off_place_m = std::max(trial.max_off_place_m, sample.off_place_m);
    if (!sample.head.tracked || !sample.head.valid()) ++trial.head_untracked_frames;
}

}  // namespace

struct RecordingThread::Impl {
    /// What is handed over, and what the thread has taken to write: the two are swapped.
    struct Batch {
        std::vector<studies::SessionEvent> events;
        std::vector<TrackedFrame> samples;
        std::vector<TrialTracking> trials;
    };

    Impl(Store& store_in, const studies::Study& study_in, const studies::StudyPlan& plan_in,
         ClipRecords clips_in, RecordingOptions options_in)
        : store(store_in), study(study_in), plan(plan_in), clips(std::move(clips_in)), options(options_in) {
        for (Batch* batch : {&handed_over, &taken}) {
            batch->events.reserve(usual_events);
            batch->samples.reserve(options.max_waiting_samples);
            batch->trials.reserve(usual_events);
        }
        thread = std::thread([this] { run(); });
    }

    Store& store;
    const studies::Study& study;
    const studies::StudyPlan& plan;
    const ClipRecords clips;
    const RecordingOptions options;

    // The session's side only.
    std::optional<TrialTracking> under_way;

    // Held only to move things into and out of what is handed over, never while the store writes.
    std::mutex mutex;
    std::condition_variable work;     ///< tells the thread
    std::condition_variable written;  ///< tells finish()
    Batch handed_over;
    std::size_t samples_waiting = 0;  ///< handed over and not yet written
    bool hurry = false;               ///< finish() waits
    bool ending = false;
    bool idle = true;  ///< the thread has written all that it had taken
    std::exception_ptr failure;

    std::atomic<std::size_t> events_waiting{0};
    std::atomic<bool> failed{false};

    // The thread's side only.
    Batch taken;
    std::thread thread;

    void throwFailure() {
        if (!failed.load(std::memory_order_acquire)) return;
        const std::lock_guard lock(mutex);
        std::rethrow_exception(failure);
    }

    [[nodiscard]] bool allWritten() const {
        return idle && handed_over.events.empty() && handed_over.samples.empty() &&
               handed_over.trials.empty();
    }

    // The session's side.

    void handOver(studies::SessionEvent event) {
        events_waiting.fetch_add(1, std::memory_order_relaxed);
        {
            const std::lock_guard lock(mutex);
            handed_over.events.push_back(std::move(event));
        }
        work.notify_one();
    }

    void handOver(studies::TrackingSample sample, int trial_index) {
        if (under_way && under_way->trial_index != trial_index) closeTrial();
        if (trial_index >= 0) {
            if (!under_way) under_way = TrialTracking{trial_index};
            add(*under_way, sample);
        }
        bool full = false;
        bool enough = false;
        {
            const std::lock_guard lock(mutex);
            full = samples_waiting >= options.max_waiting_samples;
            if (!full) {
                ++samples_waiting;
                handed_over.samples.push_back({std::move(sample), trial_index});
                enough = handed_over.samples.size() == samples_together;
            }
        }
        if (full && under_way) ++under_way->samples_missing;
        if (enough) work.notify_one();
    }

    void closeTrial() {
        if (!under_way) return;
        const std::lock_guard lock(mutex);
        handed_over.trials.push_back(*under_way);
        under_way.reset();
    }

    void finish() {
        closeTrial();
        {
            std::unique_lock lock(mutex);
            hurry = true;
            work.notify_one();
            written.wait(lock, [&] { return failure || allWritten(); });
            hurry = false;
        }
        throwFailure();
    }

    // The thread's side.

    void run() {
        std::unique_lock lock(mutex);
        while (!failure) {
            work.wait_for(lock, longest_wait, [&] {
                return ending || hurry || !handed_over.events.empty() ||
                       handed_over.samples.size() >= samples_together;
            });
            if (allWritten()) {
                if (ending) return;
                hurry = false;
                continue;
            }
            std::swap(handed_over, taken);
            idle = false;
            lock.unlock();
            std::exception_ptr met;
            try {
                write();
            } catch (...) {
                met = std::current_exception();
            }
            lock.lock();
            if (met) {
                failure = met;
                failed.store(true, std::memory_order_release);
            }
            idle = true;
            written.notify_all();
        }
    }

    void write() {
        writeEvents();
        std::span<const TrackedFrame> rest(taken.samples);
        while (!rest.empty() || !taken.trials.empty()) {
            const auto some = rest.first(std::min(rest.size(), samples_together));
            rest = rest.subspan(some.size());
            // A trial's tally goes with the last of the samples that were handed over before it.
            const bool last = rest.empty();
            beginTransaction();
            store.recordTracking(
                some, last ? std::span<const TrialTracking>(taken.trials) : std::span<const TrialTracking>());
            if (last) taken.trials.clear();
            {
                const std::lock_guard lock(mutex);
                samples_waiting -= some.size();
                std::swap(handed_over.events, taken.events);
            }
            writeEvents();
        }
        taken.samples.clear();
    }

    void writeEvents() {
        for (const studies::SessionEvent& event : taken.events) {
            beginTransaction();
            store.record(event, study, plan, clips);
            events_waiting.fetch_sub(1, std::memory_order_release);
        }
        taken.events.clear();
    }

    void beginTransaction() const {
        if (options.delay_s > 0.0)
            std::this_thread::sleep_for(std::chrono::duration<double>(options.delay_s));
    }
};

RecordingThread::RecordingThread(Store& store, const studies::Study& study, const studies::StudyPlan& plan,
                                 ClipRecords clips, RecordingOptions options)
    : impl_(std::make_unique<Impl>(store, study, plan, std::move(clips), options)) {}

RecordingThread::~RecordingThread() {
    try {
        impl_->finish();
    } catch (...) {  // said in the header: failures are lost here
    }
    {
        const std::lock_guard lock(impl_->mutex);
        impl_->ending = true;
    }
    impl_->work.notify_one();
    impl_->thread.join();
}

void RecordingThread::record(studies::SessionEvent event) {
    impl_->throwFailure();
    impl_->handOver(std::move(event));
}

void RecordingThread::sample(studies::TrackingSample sample, int trial_index) {
    impl_->throwFailure();
    impl_->handOver(std::move(sample), trial_index);
}

bool RecordingThread::allKept() const {
    impl_->throwFailure();
    return impl_->events_waiting.load(std::memory_order_acquire) == 0;
}

void RecordingThread::finish() {
    impl_->throwFailure();
    impl_->finish();
}

}  // namespace deixis::results
