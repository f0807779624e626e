#include "head_watch.hpp"

namespace deixis::app {

namespace {

constexpr double invalid_s = 0.25;  ///< a shorter loss is a blink of the cameras
constexpr double guessed_s = 1.0;   ///< a shorter guess is a good one

// Since when it is so; whether that is longer ago than `patience_s`.
bool tooLong(bool is, double now_s, double patience_s, std::optional<double>& since_s) {
    if (!is)
        since_s.reset();
    else if (!since_s)
        since_s = now_s;
    return since_s && now_s - *since_s > patience_s;
}

}  // namespace

bool HeadWatch::lost(const studies::TrackedPose& head, double now_s) {
    if (head.valid() && head.tracked) was_tracked_ = true;
    const bool guess = head.valid() && !head.tracked && was_tracked_;
    const bool guessed = tooLong(guess, now_s, guessed_s, guessed_since_s_);
    if (guessed) was_tracked_ = false;
    const bool invalid = tooLong(!head.valid(), now_s, invalid_s, invalid_since_s_);
    return guessed || invalid;
}

}  // namespace deixis::app
