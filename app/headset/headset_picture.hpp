// What a frame shows in the headset: the eyes' picture, the board as a sharp layer beneath it, a notice above
// it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "renderer/drawing/renderer.hpp"
#include "studies/design/placement.hpp"
#include "xr_session.hpp"

namespace deixis::app {

class HeadsetPicture {
  public:
    /// The window's context must be current while it lives, and it must go before the session.
    [[nodiscard]] static Result<std::unique_ptr<HeadsetPicture>> create(const assets::Avatar& avatar,
                                                                        XrSessionLoop& session);

    /// Where the eyes are at the frame's display time; none where it is not known.
    using LocateEyes = std::function<std::optional<XrEyes>()>;
    /// Draws the scene for the eyes, which are located when all else is ready. Boards are painted only where
    /// they have changed. No layers where the eyes are not known.
    [[nodiscard]] XrLayers draw(const renderer::Scene& scene, const LocateEyes& locate_eyes,
                                const studies::Placement& placement);
    /// Nothing but a sentence that hangs before the face: needs no pose.
    [[nodiscard]] XrLayers drawUnplaced(const std::string& text);
    /// A calm sentence before the participant from now on; empty: none.
    void setNotice(const std::string& text, const Pose& tracking_from_head);
    /// What the left eye saw last, into the window.
    void drawMirror(const renderer::Scene& scene, int width, int height);
    /// Draws once all that a session may show, without showing it: drivers compile at the first use, and that
    /// must not fall into a trial.
    void warmUp(const assets::Avatar& avatar);
    /// Asks the session again what the lenses hide.
    void updateHiddenArea();

    [[nodiscard]] std::string driver() const { return renderer_.driver(); }
    [[nodiscard]] bool multiview() const { return mode_ == renderer::StereoMode::multiview; }

  private:
    /// A board's picture as the runtime has it.
    struct Shown {
        XrGlSwapchain chain;
        renderer::Board board{};
        bool painted = false;
        int width = 0, height = 0;
    };
    HeadsetPicture(renderer::Renderer renderer, XrSessionLoop& session);
    [[nodiscard]] XrBoardLayer layerOf(const renderer::Board& board, Shown& shown,
                                       const studies::Placement& placement);

    renderer::Renderer renderer_;
    XrSessionLoop& session_;
    renderer::StereoMode mode_;
    Shown page_, notice_picture_;
    std::string notice_text_{};
    std::optional<renderer::Board> notice_;  ///< its pose is in the tracking space
    renderer::Eye left_{};
};

}  // namespace deixis::app
