// Who keeps what happens in a session.
#pragma once

#include <string>
#include <vector>

#include "results/store.hpp"
#include "session_loop.hpp"

namespace deixis::app {

/// Writes each event before the session goes on: for simulated participants, whose virtual time can wait.
class DirectRecorder : public Recorder {
  public:
    /// All references must outlive it; the store's session must have begun.
    DirectRecorder(results::Store& store, const studies::StudyPlan& plan,
                   const std::vector<results::ClipRecord>& clips_by_trial)
        : store_(store), plan_(plan), clips_by_trial_(clips_by_trial) {}

    void record(const studies::SessionEvent& event) override;
    void sample(const studies::TrackingSample&, int) override {}
    [[nodiscard]] bool answersKept() const override { return true; }
    [[nodiscard]] int answers() const { return answers_; }

  private:
    results::Store& store_;
    const studies::StudyPlan& plan_;
    const std::vector<results::ClipRecord>& clips_by_trial_;
    int answers_ = 0;
};

}  // namespace deixis::app
