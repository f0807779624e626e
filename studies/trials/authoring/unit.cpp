// Authoring: the page makes the gestures; what it tells is kept here, with the time that is left.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "session_unit.hpp"

namespace deixis::studies {

namespace {

/// After the limit the page's last word may come, about what was done before.
constexpr double last_word_s = 2.0;

class AuthoringTrial : public TrialUnit {
  public:
    AuthoringTrial(SessionCore& core, const TimelineItem& item) : TrialUnit(core, item) {
        const Stimulus& stimulus = trial_.stimuli.at(0);
        const AuthoringLimits& limits = stage_.authoring;
        const auto& keyframes = limits.keyframes_only;
        AuthoringTask& task = made_;
        task.trial = item.status.trial;
        task.of = item.status.trials;
        task.practice = trial_.practice;
        task.system = stimulus.system;
        task.keyframes_only =
            std::find(keyframes.begin(), keyframes.end(), stimulus.system) != keyframes.end();
        task.question = stage_.question;
        task.limit_s = trial_.practice ? limits.practice_limit_s : limits.limit_s;
        task.may_end_early = trial_.practice ? limits.practice_may_end_early : limits.may_end_early;
        const UnfinishedWork* before = core.unfinishedWork(trial_.index);
        if (before != nullptr) {
            task.so_far = before->project;
            used_before_s_ = std::clamp(before->used_s, 0.0, task.limit_s);
        } else {
            const std::string* project = core.clips.project(stimulus);
            if (project == nullptr)
                throw std::invalid_argument(
                    fmt::format("there is no project of system '{}' for item '{}' to author", stimulus.system,
                                stimulus.item));
            task.so_far.project = *project;
        }
        task.left_s = task.limit_s - used_before_s_;
        status_ = item.status;
    }

    void enter(const InputFrame& /*input*/, bool /*moved*/) override {
        core_.standAlone();
        core_.poser.blendTo(core_.idle, core_.now.time_s);
        present();
    }

    void step(const InputFrame& input) override {
        made_.left_s = std::max(0.0, made_.limit_s - used_s());
        const bool by_limit = made_.left_s <= 0.0;
        if (!finished_ && by_limit && !up_since_s_) up_since_s_ = core_.now.time_s;
        const bool last_word =
            up_since_s_ && (told_since_up_ || core_.now.time_s - *up_since_s_ >= last_word_s);
        present();
        if (onset_known_ && (finished_ || last_word)) finish(input);
    }

    void takeWork(const AuthoredWork& work) override {
        if (done_ || work.trial != made_.trial) return;
        shown(0, core_.now);  // who works on it has it
        AuthoredProject& so_far = made_.so_far;
        const int edits = so_far.edits + work.now.edits;
        const int generated = so_far.generated + work.now.generated;
        so_far = work.now;
        so_far.edits = edits;
        so_far.generated = generated;
        told_since_up_ = up_since_s_.has_value();
        finished_ = finished_ || (work.finished && made_.may_end_early);
        core_.view.frame.authoring = made_;
    }

    void shown(std::uint64_t /*frame*/, const Moment& at) override {
        if (onset_known_) return;
        draft_.onset = draft_.motion_end = at;
        onset_known_ = true;
        since_s_ = at.time_s;
        core_.noteAt(at, NoteKind::stimulus_onset, used_before_s_ > 0.0 ? "continued" : "");
    }

    /// The work goes on where it was, whatever the study wants of interrupted clips.
    void resume(const InputFrame& /*input*/, double away_s) override {
        if (onset_known_) draft_.paused_s += away_s;
        ++draft_.pauses;
        since_s_ = std::min(since_s_ + away_s, core_.now.time_s);
        if (up_since_s_) *up_since_s_ += away_s;
        present();
    }

    bool skip(const InputFrame& input, const std::string& reason) override {
        core_.view.frame.authoring.reset();
        return TrialUnit::skip(input, reason);
    }

    [[nodiscard]] bool wantsPointer() const override { return false; }
    [[nodiscard]] bool begun() const override { return onset_known_; }
    [[nodiscard]] bool showsPage() const override { return true; }

  private:
    AuthoringTask made_{};
    SessionStatus status_{};
    double used_before_s_ = 0.0;  ///< in earlier sessions
    double since_s_ = 0.0;        ///< when it was first shown, later by what was paused
    bool finished_ = false;
    std::optional<double> up_since_s_{};  ///< the time is up
    bool told_since_up_ = false;

    [[nodiscard]] double used_s() const {
        return used_before_s_ + (onset_known_ ? core_.now.time_s - since_s_ : 0.0);
    }

    void present() {
        core_.view.show(PresentedState::authoring);
        core_.view.frame.authoring = made_;
        const int minutes = static_cast<int>(std::ceil(made_.left_s / 60.0));
        core_.view.frame.status = status_.with(fmt::format("{} min", minutes));
    }

    void finish(const InputFrame& input) {
        const double time_s = std::round(std::min(used_s(), made_.limit_s) * 1e3) / 1e3;
        give(input, core_.now.time_s, finished_ ? "ray" : "");
        const AuthoredProject& work = made_.so_far;
        const auto number = [](int value) { return std::optional<double>(value); };
        draft_.values = {{"project", {}, work.project},
                         {"edits", number(work.edits), {}},
                         {"poses", number(work.poses), {}},
                         {"styles", number(work.styles), {}},
                         {"generated", number(work.generated), {}}};
        draft_.answers = {{"time", 0, time_s, {}}};
        core_.view.frame.authoring.reset();
        complete();
    }
};

}  // namespace

extern const UnitDeclaration authoring_unit{makeUnitOf<AuthoringTrial>};

}  // namespace deixis::studies
