// A trace of a running session, line by line, for test rigs and second screens.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "app/session/session_loop.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// The file, open for adding to it. Error: it cannot be opened.
[[nodiscard]] Result<std::ofstream> openTrace(const std::filesystem::path& path);

/// Adds a JSON line to a file whenever what is presented changes in kind (state, stage, place, status,
/// notice, sign, the panel's parts, looks of the balls) or the station notes something, and at least every
/// 0.2 s, so that it can be followed where the participant looks; each line tells all of it, and is flushed.
/// Everything else it leaves to another recorder. docs/database.md describes the lines.
class Trace : public Recorder {
  public:
    /// `session` and `kept_by` must outlive it.
    Trace(std::ofstream file, const studies::SessionRunner& session, Recorder& kept_by)
        : file_(std::move(file)), session_(session), kept_by_(kept_by) {}

    void record(const studies::SessionEvent& event) override { kept_by_.record(event); }
    void sample(const studies::TrackingSample& sample, int trial_index) override {
        kept_by_.sample(sample, trial_index);
    }
    [[nodiscard]] bool answersKept() const override { return kept_by_.answersKept(); }
    [[nodiscard]] std::string failure() const override { return kept_by_.failure(); }
    void finish() override { kept_by_.finish(); }
    /// Throws where the file cannot be written to.
    void presented(const studies::InputFrame& input, const studies::PresentedFrame& frame) override;

  private:
    [[nodiscard]] bool changed(const studies::PresentedFrame& frame) const;
    void remember(const studies::PresentedFrame& frame);

    std::ofstream file_;
    const studies::SessionRunner& session_;
    Recorder& kept_by_;
    // As last told.
    bool begun_ = false;
    double told_s_ = 0.0;
    std::string state_, stage_, place_, notice_, sign_;
    studies::SessionStatus status_;
    std::optional<studies::Panel> panel_;
    std::vector<studies::BallView> balls_;
};

}  // namespace deixis::app
