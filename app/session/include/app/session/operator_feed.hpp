// What a session reports to its operator: plain data, written by the session's loop and read by the
// station that shows it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/session/session_loop.hpp"
#include "app/session/time_left.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

/// Something that happened, for the operator to see that it did.
struct OperatorEvent {
    double elapsed_s = 0.0;
    studies::NoteKind kind{};
    std::string detail;  ///< Note::detail, the reason of an exclusion, or why nothing more can be kept
};

struct OperatorFeed {
    std::string participant;
    studies::SessionProgress progress{};            ///< of this visit's stages
    double elapsed_s = 0.0;                         ///< since the session's first frame
    std::optional<double> left_s;                   ///< none: not known yet
    std::optional<std::uintmax_t> disk_free_bytes;  ///< where the database lies; none: not known
    double waiting_s = 0.0;                         ///< since when answers wait for the disk; 0: none waits
    std::string failure;                            ///< why answers can no longer be kept; empty: they can
    std::deque<OperatorEvent> events;               ///< the latest, the newest last
};

/// Passes everything on to another recorder, and fills the feed on the way.
class OperatorFeedWriter : public Recorder {
  public:
    /// `progress` is SessionRunner::progress() of the session; `history` Store::secondsPerUnit(), asked for
    /// before the session. `study` and `kept_by` must outlive it.
    OperatorFeedWriter(std::shared_ptr<OperatorFeed> feed, std::string participant,
                       const studies::Study& study, std::function<studies::SessionProgress()> progress,
                       std::map<std::string, double> history, const std::filesystem::path& database,
                       Recorder& kept_by);

    void record(const studies::SessionEvent& event) override;
    void sample(const studies::TrackingSample& sample, int trial_index) override {
        kept_by_.sample(sample, trial_index);
    }
    [[nodiscard]] bool answersKept() const override { return kept_by_.answersKept(); }
    [[nodiscard]] std::string failure() const override { return kept_by_.failure(); }
    void finish() override { kept_by_.finish(); }
    void presented(const studies::InputFrame& input, const studies::PresentedFrame& frame) override;

  private:
    void note(double time_s, studies::NoteKind kind, std::string detail);
    [[nodiscard]] studies::SessionProgress progressOfVisit();

    std::shared_ptr<OperatorFeed> feed_;
    const studies::Study& study_;
    std::function<studies::SessionProgress()> progress_;
    std::map<std::string, double> history_;
    std::filesystem::path folder_;
    Recorder& kept_by_;
    SessionPace pace_;
    int visit_ = 0;  // 0: no stage has been under way
    std::optional<double> start_s_, waiting_since_s_, progress_told_s_, disk_asked_s_;
};

}  // namespace deixis::app
