#include "simulated_author.hpp"

#include <algorithm>
#include <utility>

namespace deixis::studies {

namespace {

// Assumptions, as all of a simulated participant: an edit every so often, and an end before the limit by
// most.
constexpr double edit_mean_s = 20.0;
constexpr double finish_mean_share = 0.65;
constexpr double finish_sd_share = 0.22;
constexpr double shortest_share = 0.05;
constexpr double generates_rate = 0.3;  ///< of the edits, where there is a model

}  // namespace

void SimulatedAuthor::see(const PresentedFrame& frame, double time_s) {
    if (!frame.authoring) {
        task_.reset();
        return;
    }
    const bool begins = !task_;
    task_ = frame.authoring;
    if (!begins) return;
    next_edit_s_ = time_s + edit_mean_s * random_.uniform(0.2, 1.0);
    finish_at_share_ = std::max(shortest_share, finish_mean_share + finish_sd_share * random_.normal());
}

std::optional<AuthoredWork> SimulatedAuthor::tell(double time_s) {
    if (!task_) return std::nullopt;
    AuthoredWork work{task_->trial, task_->so_far};
    work.now.edits = work.now.generated = 0;
    const double used_s = task_->limit_s - task_->left_s;
    work.finished = task_->may_end_early && used_s >= finish_at_share_ * task_->limit_s;
    const bool edits = task_->left_s > 0.0 && time_s >= next_edit_s_;
    if (!edits && !work.finished) return std::nullopt;
    if (edits) {
        next_edit_s_ = time_s + edit_mean_s * random_.uniform(0.5, 1.5);
        work.now.edits = 1;
        work.now.generated = !task_->keyframes_only && random_.uniform() < generates_rate ? 1 : 0;
        notes_.push_back({NoteKind::edit, R"({"what":"simulated edit"})", time_s});
    }
    if (work.finished) task_.reset();
    return work;
}

std::vector<StationNote> SimulatedAuthor::takeNotes() {
    return std::exchange(notes_, {});
}

}  // namespace deixis::studies
