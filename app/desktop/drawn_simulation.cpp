#include "app/desktop/drawn_simulation.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "app/window/frame_scene.hpp"
#include "app/window/gl_window.hpp"
#include "renderer/drawing/renderer.hpp"

namespace deixis::app {

namespace {

constexpr WindowSize picture_size{1280, 720};

// Order matters: the renderer goes before its context.
struct OffscreenView {
    renderer::OffscreenContext context;
    renderer::Renderer renderer;
};

/// The pictures of states that are wanted. Each is taken when the participant has turned to what is new: some
/// time after the state began, or of its last frame where it is over before.
class StatePictures {
  public:
    StatePictures(renderer::Renderer& renderer, WindowSize size, std::shared_ptr<Screenshots> screenshots)
        : renderer_(renderer), size_(size), screenshots_(std::move(screenshots)) {}

    /// Whether see() shall be told of this frame. Takes the picture of a state that was over too soon.
    [[nodiscard]] bool wants(const studies::PresentedFrame& frame, double time_s) {
        const std::string state = presentedStateName(frame);
        screenshots_->met.insert(state);
        if (state != state_) {
            if (latest_) take(*latest_);
            state_ = state;
            since_s_ = time_s;
        }
        return screenshots_->wanted.count(state) > 0;
    }

    void see(renderer::Scene scene, const studies::PresentedFrame& frame, double time_s) {
        if (time_s - since_s_ >= settle_s || frame.state == studies::PresentedState::over)
            take(scene);
        else
            latest_ = std::move(scene);
    }

  private:
    static constexpr double settle_s = 0.4;  // of virtual time

    void take(const renderer::Scene& scene) {
        const auto written = renderer::writePng(screenshots_->wanted[state_],
                                                renderer_.capture(scene, size_.width, size_.height));
        if (!written) throw std::runtime_error(written.error().text());
        screenshots_->wanted.erase(state_);
        latest_.reset();
    }

    renderer::Renderer& renderer_;
    WindowSize size_;
    std::shared_ptr<Screenshots> screenshots_;
    std::string state_{};
    double since_s_ = 0.0;
    std::optional<renderer::Scene> latest_{};  ///< of state_, which is wanted
};

}  // namespace

Result<void> drawSimulation(studies::SimulatedStation& station, const assets::Avatar& avatar,
                            const std::string& size, const std::shared_ptr<Screenshots>& screenshots) {
    if (screenshots->wanted.empty()) return {};
    const auto pictured_size = size.empty() ? Result<WindowSize>(picture_size) : parseWindowSize(size);
    if (!pictured_size) return tl::unexpected(pictured_size.error());
    auto context = renderer::OffscreenContext::create();
    if (!context) return tl::unexpected(context.error());
    auto made = renderer::Renderer::create(avatar, renderer::Quality{});
    if (!made) return tl::unexpected(made.error());
    const auto view = std::make_shared<OffscreenView>(OffscreenView{std::move(*context), std::move(*made)});

    std::string details = fmt::format("pictures of {}x{} pixels, drawn off screen, {}", pictured_size->width,
                                      pictured_size->height, view->renderer.driver());
    station.attachViewer(std::move(details),
                         [view, pictures = StatePictures(view->renderer, *pictured_size, screenshots)](
                             const studies::PresentedFrame& frame, const studies::InputFrame& input) mutable {
                             if (frame.number <= 1) return;  // the participant has not been placed yet
                             if (!pictures.wants(frame, input.time_s)) return;
                             renderer::Scene scene = sceneFromFrame(frame, input.stage_from_head);
                             addNotice(scene, frame.notice);
                             pictures.see(std::move(scene), frame, input.time_s);
                         });
    return {};
}

}  // namespace deixis::app
