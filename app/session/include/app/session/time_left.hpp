// The remaining time of a session, estimated from the study's earlier sessions and this one: pure logic.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "studies/session/session.hpp"

namespace deixis::app {

/// What the participant of this session has taken so far, learned by looking on.
class SessionPace {
  public:
    /// To be told often, with times that never go back. While `paused` no time passes for anything.
    void see(const std::vector<studies::StageProgress>& stages, double time_s, bool paused);

    /// Seconds that each unit took, by stage, from the end of what was before it to its own end.
    [[nodiscard]] const std::map<std::string, std::vector<double>>& units_s() const { return units_s_; }
    /// Likewise of the pages that were read.
    [[nodiscard]] const std::vector<double>& pages_s() const { return pages_s_; }
    /// How many units that is.
    [[nodiscard]] int units() const;
    /// Since the last unit or page ended.
    [[nodiscard]] double underWay_s() const { return under_way_s_; }

  private:
    std::map<std::string, int> done_;
    std::map<std::string, std::vector<double>> units_s_;
    std::vector<double> pages_s_;
    double under_way_s_ = 0.0;
    std::optional<double> last_s_;
};

/// Own units of a stage, and of the session, from which on their median is taken for those to come.
constexpr int enough_units = 3;

/// Seconds until the stages are done. A unit takes as long as `history` says (Store::secondsPerUnit()); where
/// that lacks its stage, as this session's median in the stage, else in the session, else the median of
/// `history`. A page takes as long as those read before; the first ones are not counted. None if there is
/// neither history nor enough_units of this session.
[[nodiscard]] std::optional<double> timeLeft_s(const std::vector<studies::StageProgress>& stages,
                                               const std::map<std::string, double>& history,
                                               const SessionPace& own);

}  // namespace deixis::app
