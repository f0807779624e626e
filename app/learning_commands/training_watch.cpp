#include "training_watch.hpp"

#include <fmt/format.h>

#include <csignal>

#include "app/program/progress_line.hpp"

namespace deixis::app {

namespace {

volatile std::sig_atomic_t noted = 0;

void onInterrupt(int) {
    noted = 1;
    (void)std::signal(SIGINT, SIG_DFL);
}

}  // namespace

InterruptWatch::InterruptWatch() {
    noted = 0;
    (void)std::signal(SIGINT, onInterrupt);
}

InterruptWatch::~InterruptWatch() {
    (void)std::signal(SIGINT, SIG_DFL);
}

bool InterruptWatch::interrupted() {
    return noted != 0;
}

std::string TimeLeft::text(double done) {
    constexpr double least_done = 0.01;
    if (!first_done_) first_done_ = done;
    const double made = done - *first_done_;
    if (made < least_done) return "";
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - since_).count();
    return fmt::format("; {} left", clockText(elapsed_s * (1.0 - done) / made));
}

}  // namespace deixis::app
