#include "simulated_watching.hpp"

#include <algorithm>

namespace deixis::studies {

namespace {

constexpr double play_begins_s = 1.0;  ///< after a play button: no later does anything come of it

}  // namespace

int Impression::on(int low, int high) const {
    return number ? std::clamp(*number, low, high) : onScale(judgement, low, high);
}

Watcher::Watcher(const motion::Skeleton& avatar, const Reading& reading, SimulatedRater& rater)
    : rater_(rater), observers_{GestureObserver(avatar, reading), GestureObserver(avatar, reading)} {}

void Watcher::forget() {
    for (GestureObserver& observer : observers_) observer.forget();
    sign_seen_ = false;
    asked_number_.reset();
    impression_.reset();
}

void Watcher::watch(const PresentedFrame& frame, double time_s) {
    observers_[0].see(frame.avatar_joints, time_s);
    if (!frame.right_avatar_joints.empty()) observers_[1].see(frame.right_avatar_joints, time_s);
}

void Watcher::readSign(const PresentedFrame& frame) {
    if (!frame.sign || sign_seen_) return;
    sign_seen_ = true;
    if (!rater_.overlooks()) asked_number_ = lastNumberOn(*frame.sign);
}

Impression Watcher::judged(std::size_t avatar) {
    return {rater_.naturalness(observers_[avatar].gesture()), asked_number_};
}

const Impression& Watcher::impression() {
    if (!impression_) impression_ = judged(0);
    return *impression_;
}

void Watcher::expect(std::size_t play, double time_s) {
    forget();
    play_ = play;
    pressed_s_ = time_s;
    began_ = false;
}

bool Watcher::watchPlay(const PresentedFrame& frame, const BoardReading& board, double time_s) {
    const bool another_board = board.plays.empty() && (board.open() || board.go_on != nullptr);
    if (!another_board && (board.plays.empty() || board.playing())) {
        began_ = true;
        readSign(frame);
        watch(frame, time_s);
        return false;
    }
    if (began_ && !another_board) {
        const std::size_t avatar = frame.right_avatar_joints.empty() ? 0 : std::min<std::size_t>(*play_, 1);
        impressions_[*play_] = judged(avatar);
        ++seen_[*play_];
    } else if (!another_board && time_s < pressed_s_ + play_begins_s) {
        return false;
    }
    play_.reset();
    return true;
}

void Watcher::forgetPlays() {
    seen_.clear();
    impressions_.clear();
}

int Watcher::timesSeen(std::size_t play) const {
    const auto found = seen_.find(play);
    return found == seen_.end() ? 0 : found->second;
}

bool Watcher::sawAll(const BoardReading& board) const {
    return seen_.size() == board.plays.size();
}

}  // namespace deixis::studies
