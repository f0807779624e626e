#include "app/program/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

namespace deixis::app {

std::string clockText(double time_s) {
    const auto seconds = static_cast<long long>(std::llround(std::fmin(time_s, 1e9)));
    if (seconds < 3600) return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
    return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

std::string progressLine(std::string_view what, std::size_t done, std::size_t all, double elapsed_s) {
    constexpr std::size_t width = 24;
    const std::size_t filled = width * done / all;
    constexpr double min_s = 0.5;  // before that, the time left would jump about
    const bool known = done > 0 && (elapsed_s >= min_s || done == all);
    const double left_s =
        known ? elapsed_s * static_cast<double>(all - done) / static_cast<double>(done) : 0.0;
    return fmt::format("{} {:>3} % [{:#<{}}{:.<{}}] {} of {}, {} elapsed, {} left", what, 100 * done / all,
                       "", filled, "", width - filled, done, all, clockText(elapsed_s),
                       known ? clockText(left_s) : "--");
}

Progress progressOnTerminal(std::string what) {
    if (::isatty(STDERR_FILENO) == 0) return [](auto, auto) {};
    // Another piece of work of the same kind begins when the one before was done.
    auto begin = std::make_shared<std::chrono::steady_clock::time_point>(std::chrono::steady_clock::now());
    return [what = std::move(what), begin](std::size_t done, std::size_t all) {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> elapsed = now - *begin;
        // The line before may have been longer.
        fmt::print(stderr, "\r{}\x1b[K{}", progressLine(what, done, all, elapsed.count()),
                   done == all ? "\n" : "");
        std::fflush(stderr);
        if (done == all) *begin = now;
    };
}

StatusLine::StatusLine() : terminal_(::isatty(STDERR_FILENO) != 0) {}

void StatusLine::show(const std::string& text) {
    if (!terminal_) return;
    fmt::print(stderr, "\r{}\x1b[K", text);
    std::fflush(stderr);
}

void StatusLine::clear() {
    show("");
}

std::string elapsedLine(std::string_view what, double elapsed_s) {
    return fmt::format("{}, {} elapsed", what, clockText(elapsed_s));
}

ElapsedOnTerminal::ElapsedOnTerminal(std::string what) {
    if (::isatty(STDERR_FILENO) != 0) thread_ = std::thread([this, what = std::move(what)] { run(what); });
}

ElapsedOnTerminal::~ElapsedOnTerminal() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    ended_.notify_one();
    thread_.join();
}

void ElapsedOnTerminal::run(const std::string& what) {
    constexpr std::chrono::seconds patience{2};
    constexpr std::chrono::milliseconds between{500};
    const auto begin = std::chrono::steady_clock::now();
    std::unique_lock lock(mutex_);
    bool shown = false;
    while (!ended_.wait_until(lock, shown ? std::chrono::steady_clock::now() + between : begin + patience,
                              [this] { return ending_; })) {
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        fmt::print(stderr, "\r\x1b[K{}", elapsedLine(what, elapsed.count()));
        std::fflush(stderr);
        shown = true;
    }
    if (shown) fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
}

}  // namespace deixis::app
