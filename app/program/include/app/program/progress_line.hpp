// The progress of long work, as a line for a terminal.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace deixis::app {

/// "0:07", "12:30", "3:05:00".
[[nodiscard]] std::string clockText(double time_s);

/// "clips  45 % [#####......]  450 of 1000, 0:12 elapsed, 0:15 left". The time left is that of the work so
/// far, in proportion; "--" until there is something to tell it from. `all` is at least 1; `elapsed_s` is not
/// negative.
[[nodiscard]] std::string progressLine(std::string_view what, std::size_t done, std::size_t all,
                                       double elapsed_s);

/// Called now and then, from the caller's thread.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// Writes that line to stderr, over the one before. Nothing where stderr is not a terminal: it would fill a
/// log.
[[nodiscard]] Progress progressOnTerminal(std::string what);

/// A line on stderr that the next one replaces. Nothing where stderr is not a terminal.
class StatusLine {
  public:
    StatusLine();
    ~StatusLine() { clear(); }
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;
    void show(const std::string& text);
    /// Before something else is printed.
    void clear();

  private:
    bool terminal_;
};

/// "checking study.sqlite, 0:07 elapsed", for work whose end is not known.
[[nodiscard]] std::string elapsedLine(std::string_view what, double elapsed_s);

/// Writes that line to stderr while it lives, from the third second on, and takes it away at the end. Nothing
/// where stderr is not a terminal.
class ElapsedOnTerminal {
  public:
    explicit ElapsedOnTerminal(std::string what);
    ~ElapsedOnTerminal();
    ElapsedOnTerminal(const ElapsedOnTerminal&) = delete;
    ElapsedOnTerminal& operator=(const ElapsedOnTerminal&) = delete;

  private:
    void run(const std::string& what);

    std::mutex mutex_;
    std::condition_variable ended_;
    bool ending_ = false;
    std::thread thread_;
};

}  // namespace deixis::app
