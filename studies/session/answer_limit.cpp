#include "answer_limit.hpp"

#include <algorithm>
#include <cmath>

namespace deixis::studies {

namespace {

constexpr int countdown_from = 5;          ///< seconds left at which they are told,
constexpr double longest_untold_s = 10.0;  ///< of a time limit that is longer than this

}  // namespace

bool AnswerLimit::passed(double taken_s) {
    if (limit_s_ <= 0.0) return false;
    const double left_s = limit_s_ - taken_s;
    const int seconds = static_cast<int>(std::ceil(left_s));
    const bool told = limit_s_ > longest_untold_s && seconds <= countdown_from;
    seconds_left_ = told ? std::max(seconds, 0) : 0;
    return left_s <= 0.0;
}

std::string AnswerLimit::notice(const LanguageTable& words, bool done, bool timed_out) const {
    if (done && timed_out) return words("notice_time_up");
    if (done || seconds_left_ == 0) return {};
    return words.seconds("notice_time_left", "notice_second_left", seconds_left_);
}

}  // namespace deixis::studies
