// What is asked by a page, as a person at a station would do it: a ray that comes to a button and presses, a
// slider that is set, what is typed. Pure: frames and times are given.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/session/session_desk.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

class PageActs {
  public:
    /// Of each frame that was presented, with the revision under which pages know it.
    void see(const studies::PresentedFrame& frame, std::uint64_t revision, double time_s);

    /// Takes up a request: what it comes to is done in the frames from now on. Else why it cannot be done.
    [[nodiscard]] std::optional<server::Refusal> begin(const server::SessionRequest& request, double time_s);
    [[nodiscard]] bool busy() const { return !steps_.empty(); }
    /// Nothing is done sooner: a board takes no input at once.
    [[nodiscard]] double notBefore_s() const { return not_before_s_; }

    /// Fills in what is done in the frame of that time. True: with it the request is done.
    bool act(studies::InputFrame& input);

  private:
    struct Step {
        std::optional<Ray> pointer{};
        bool select = false;
        std::string typed{};
        int erased = 0;
        std::optional<studies::AuthoredWork> work{};
        std::vector<studies::StationNote> notes{};
        bool pause = false;
    };

    const studies::PresentedFrame* frame_ = nullptr;
    std::uint64_t board_ = 0;           ///< PresentedFrame::board,
    std::uint64_t first_revision_ = 0;  ///< the revision that it came with,
    double board_since_s_ = 0.0;        ///< and when
    double not_before_s_ = 0.0;
    std::deque<Step> steps_;

    [[nodiscard]] std::optional<server::Refusal> onBoard(const server::SessionRequest& request,
                                                         double time_s);
    [[nodiscard]] std::optional<server::Refusal> authored(const server::SessionRequest& request,
                                                          double time_s);
    [[nodiscard]] Ray rayTo(double x_m, double y_m) const;
    void press(const Ray& ray);
};

}  // namespace deixis::app
