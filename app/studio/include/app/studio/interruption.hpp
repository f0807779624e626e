// Waiting for somebody to end the program.
#pragma once

namespace deixis::app {

/// From here on Ctrl-C and SIGTERM are waited for; made before work begins, one at a time. The second of them
/// ends the program at once.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Returns when one came.
    void wait() const;
    /// Whether one came, without waiting; true once for each.
    [[nodiscard]] bool came() const;
};

}  // namespace deixis::app
