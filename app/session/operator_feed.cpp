#include "app/session/operator_feed.hpp"

#include <algorithm>
#include <array>
#include <system_error>
#include <variant>
#include <vector>

namespace deixis::app {

namespace {

constexpr std::size_t events_told = 20;
constexpr double between_progress_s = 0.1;
constexpr double between_disk_s = 1.0;

// What an operator wants to see: nothing that comes with every trial, and nothing that tells its conditions.
bool isTold(studies::NoteKind kind) {
    using enum studies::NoteKind;
    constexpr std::array told{session_start,     pause,         resume,          trial_repeated,
                              check_failed,      warned,        practice_met,    practice_failed,
                              operator_skip,     operator_note, operator_repeat, operator_abort,
                              operator_saw_trial};
    return std::find(told.begin(), told.end(), kind) != told.end();
}

bool due(std::optional<double>& last_s, double now_s, double between_s) {
    if (last_s && now_s - *last_s < between_s) return false;
    last_s = now_s;
    return true;
}

std::filesystem::path folderOf(const std::filesystem::path& database) {
    std::error_code code;
    const std::filesystem::path whole = std::filesystem::absolute(database, code);
    return (code ? database : whole).parent_path();
}

}  // namespace

OperatorFeedWriter::OperatorFeedWriter(std::shared_ptr<OperatorFeed> feed, std::string participant,
                                       const studies::Study& study,
                                       std::function<studies::SessionProgress()> progress,
                                       std::map<std::string, double> history,
                                       const std::filesystem::path& database, Recorder& kept_by)
    : feed_(std::move(feed)),
      study_(study),
      progress_(std::move(progress)),
      history_(std::move(history)),
      folder_(folderOf(database)),
      kept_by_(kept_by) {
    feed_->participant = std::move(participant);
}

void OperatorFeedWriter::record(const studies::SessionEvent& event) {
    kept_by_.record(event);
    if (const auto* note_of = std::get_if<studies::Note>(&event)) {
        if (isTold(note_of->kind)) note(note_of->at.time_s, note_of->kind, note_of->detail);
    } else if (const auto* exclusion = std::get_if<studies::Exclusion>(&event)) {
        note(exclusion->at.time_s, studies::NoteKind::excluded, exclusion->reason);
    } else if (const auto* response = std::get_if<studies::Response>(&event)) {
        if (!response->exclusion.empty())
            note(response->answered.time_s, studies::NoteKind::excluded, response->exclusion);
    }
}

void OperatorFeedWriter::note(double time_s, studies::NoteKind kind, std::string detail) {
    if (!start_s_) start_s_ = time_s;
    feed_->events.push_back({std::max(0.0, time_s - *start_s_), kind, std::move(detail)});
    if (feed_->events.size() > events_told) feed_->events.pop_front();
}

// The stages of other visits are neither ahead nor behind.
studies::SessionProgress OperatorFeedWriter::progressOfVisit() {
    studies::SessionProgress progress = progress_();
    const auto visitOf = [this](const studies::StageProgress& stage) {
        const studies::Stage* found = study_.findStage(stage.name);
        return found == nullptr ? 1 : found->session;
    };
    for (const studies::StageProgress& stage : progress.stages)
        if (stage.current) visit_ = visitOf(stage);
    if (visit_ == 0) return progress;
    std::erase_if(progress.stages,
                  [&](const studies::StageProgress& stage) { return visitOf(stage) != visit_; });
    return progress;
}

void OperatorFeedWriter::presented(const studies::InputFrame& input, const studies::PresentedFrame& frame) {
    kept_by_.presented(input, frame);
    const double now_s = input.time_s;
    if (!start_s_) start_s_ = now_s;
    OperatorFeed& feed = *feed_;
    if (input.recording_failed && feed.failure.empty()) {
        feed.failure = kept_by_.failure();
        note(now_s, studies::NoteKind::recording_failed, feed.failure);
    }
    feed.elapsed_s = std::max(0.0, now_s - *start_s_);
    if (input.answers_kept)
        waiting_since_s_.reset();
    else if (!waiting_since_s_)
        waiting_since_s_ = now_s;
    feed.waiting_s = waiting_since_s_ ? now_s - *waiting_since_s_ : 0.0;
    if (due(progress_told_s_, now_s, between_progress_s)) {
        feed.progress = progressOfVisit();
        pace_.see(feed.progress.stages, now_s, frame.state == studies::PresentedState::paused);
        feed.left_s = timeLeft_s(feed.progress.stages, history_, pace_);
    }
    if (due(disk_asked_s_, now_s, between_disk_s)) {
        std::error_code code;
        const auto space = std::filesystem::space(folder_, code);
        feed.disk_free_bytes = code ? std::nullopt : std::optional<std::uintmax_t>(space.available);
    }
}

}  // namespace deixis::app
