// What is authored in the trial under way, on the disk: a killed program loses two seconds of it at most.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/session_loop.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// What a broken-off session left in the file (results::workFile()); none: there is none, or its trial has
/// been answered. Error: the file cannot be read.
[[nodiscard]] Result<std::optional<studies::UnfinishedWork>> readUnfinishedWork(
    const std::filesystem::path& file, const studies::Resume& resume);

/// Keeps the work in a file, until its trial's answer is kept. Everything else it leaves to another recorder.
class WorkInProgress : public Recorder {
  public:
    /// `session` and `kept_by` must outlive it.
    WorkInProgress(std::filesystem::path file, const studies::SessionRunner& session, Recorder& kept_by)
        : file_(std::move(file)), session_(session), kept_by_(kept_by) {}

    void record(const studies::SessionEvent& event) override;
    void sample(const studies::TrackingSample& sample, int trial_index) override {
        kept_by_.sample(sample, trial_index);
    }
    [[nodiscard]] bool answersKept() const override { return kept_by_.answersKept(); }
    [[nodiscard]] std::string failure() const override {
        return failure_.empty() ? kept_by_.failure() : failure_;
    }
    /// Throws what kept the work from being written.
    void finish() override;
    void presented(const studies::InputFrame& input, const studies::PresentedFrame& frame) override;

  private:
    std::filesystem::path file_;
    const studies::SessionRunner& session_;
    Recorder& kept_by_;
    int trial_ = -1;                                ///< whose work the file has; -1: there is none
    bool answered_ = false;                         ///< that trial
    std::optional<studies::AuthoringTask> last_{};  ///< as written, and as it is now
    std::optional<studies::AuthoringTask> now_{};
    double written_s_ = 0.0;
    std::string failure_{};

    void write();
    void remove();
};

}  // namespace deixis::app
