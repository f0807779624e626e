// How a simulated participant watches: what moves before it, the signs beside it, the movements it asks to
// see.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>

#include "simulated_boards.hpp"
#include "simulated_observer.hpp"
#include "simulated_rater.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

/// What it thinks of one movement.
struct Impression {
    double judgement = 3.0;       ///< on a scale from 1 to 5
    std::optional<int> number{};  ///< it was asked to give this instead

    [[nodiscard]] int on(int low, int high) const;
};

class Watcher {
  public:
    /// The judge must outlive it.
    Watcher(const motion::Skeleton& avatar, const Reading& reading, SimulatedRater& rater);

    /// What comes now is a new movement.
    void forget();
    void watch(const PresentedFrame& frame, double time_s);
    void readSign(const PresentedFrame& frame);
    /// What it has seen of the avatar alone.
    [[nodiscard]] SeenGesture gesture() const { return observers_[0].gesture(); }
    /// On the movement that it has watched; the same until forget().
    [[nodiscard]] const Impression& impression();

    // Movements shown on demand, by play button.

    /// It has pressed that one.
    void expect(std::size_t play, double time_s);
    [[nodiscard]] bool expecting() const { return play_.has_value(); }
    /// Watches what it has asked for; true when that is over, or has not come.
    bool watchPlay(const PresentedFrame& frame, const BoardReading& board, double time_s);
    /// Another page: nothing of it has been seen.
    void forgetPlays();
    [[nodiscard]] int timesSeen(std::size_t play) const;
    [[nodiscard]] bool sawAll(const BoardReading& board) const;
    [[nodiscard]] const Impression& impressionOf(std::size_t play) const { return impressions_.at(play); }

  private:
    [[nodiscard]] Impression judged(std::size_t avatar);

    SimulatedRater& rater_;
    std::array<GestureObserver, 2> observers_;  ///< of the avatar, and of the right one of a pair
    bool sign_seen_ = false;
    std::optional<int> asked_number_{};  ///< by a sign
    std::optional<Impression> impression_{};
    std::optional<std::size_t> play_{};
    double pressed_s_ = 0.0;
    bool began_ = false;
    std::map<std::size_t, int> seen_{};  ///< how often
    std::map<std::size_t, Impression> impressions_{};
};

}  // namespace deixis::studies
