// The progress of a session, for the operator.
#pragma once

#include <string>

namespace deixis::studies {

struct SessionStatus {
    std::string part{};    ///< the stage's name, or what is shown outside of stages; empty: nothing yet
    int trial = 0;         ///< the trial under way, from 1; 0: none is
    int trials = 0;        ///< of this many in the stage; 0 likewise
    std::string remark{};  ///< "paused: focus lost", "4 s"; may be empty
    friend bool operator==(const SessionStatus&, const SessionStatus&) = default;

    /// With one remark more.
    [[nodiscard]] SessionStatus with(const std::string& more) const;
};

/// One line: "game 12/40, paused: focus lost".
[[nodiscard]] std::string sessionStatusText(const SessionStatus& status);

}  // namespace deixis::studies
