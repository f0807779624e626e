// The recorders of a session's events.
#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "app/session/session_loop.hpp"
#include "core/error.hpp"
#include "results/store/recording_thread.hpp"
#include "results/store/store.hpp"

namespace deixis::app {

/// Writes each event before the session goes on: for simulated participants, whose virtual time can wait.
class DirectRecorder : public Recorder {
  public:
    /// All references must outlive it; the store's session must have begun.
    DirectRecorder(results::Store& store, const studies::Study& study, const studies::StudyPlan& plan,
                   const results::ClipRecords& clips)
        : store_(store), study_(study), plan_(plan), clips_(clips) {}

    void record(const studies::SessionEvent& event) override;
    void sample(const studies::TrackingSample&, int) override {}
    [[nodiscard]] bool answersKept() const override { return true; }
    /// Units of the plan that were answered: trials, practice and pages.
    [[nodiscard]] int answered() const { return answered_; }

  private:
    results::Store& store_;
    const studies::Study& study_;
    const studies::StudyPlan& plan_;
    const results::ClipRecords& clips_;
    int answered_ = 0;
};

/// Hands everything to a thread that writes it, so that no frame waits for the disk: for people. What still
/// waits when it is destroyed is written then. A failure of the thread is thrown by whichever call comes
/// next.
class BackgroundRecorder : public Recorder {
  public:
    /// `store`, `study` and `plan` must outlive it; the store's session must have begun. While it lives
    /// nobody else uses the store.
    BackgroundRecorder(results::Store& store, const studies::Study& study, const studies::StudyPlan& plan,
                       results::ClipRecords clips, const results::RecordingOptions& options)
        : thread_(store, study, plan, std::move(clips), options) {}

    void record(const studies::SessionEvent& event) override { thread_.record(event); }
    void sample(const studies::TrackingSample& sample, int trial_index) override {
        thread_.sample(sample, trial_index);
    }
    [[nodiscard]] bool answersKept() const override { return thread_.allKept(); }
    void finish() override { thread_.finish(); }

  private:
    results::RecordingThread thread_;
};

/// Passes everything on to a recorder, until that fails (a full disk, a database that was moved): then the
/// failure is kept for finish(), which throws it, and the session hears of it and ends calmly.
class FailSafeRecorder : public Recorder {
  public:
    /// `kept_by` must outlive it.
    explicit FailSafeRecorder(Recorder& kept_by) : kept_by_(kept_by) {}

    void record(const studies::SessionEvent& event) override;
    void sample(const studies::TrackingSample& sample, int trial_index) override;
    [[nodiscard]] bool answersKept() const override;
    [[nodiscard]] std::string failure() const override { return failure_; }
    void finish() override;

  private:
    template <typename Call>
    void unlessFailed(const Call& call) const;

    Recorder& kept_by_;
    mutable std::exception_ptr problem_{};
    mutable std::string failure_{};
};

/// The usual options, except where the environment variable DEIXIS_STORAGE_DELAY_S asks for a slow store
/// (for tests). Error: it is not a number of seconds.
[[nodiscard]] Result<results::RecordingOptions> recordingOptions();

}  // namespace deixis::app
