#include "drawn_simulation.hpp"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "frame_scene.hpp"
#include "gl_window.hpp"
#include "renderer/renderer.hpp"

namespace deixis::app {

namespace {

constexpr double draw_period_s =
    0.5;  // of virtual time, besides key moments: a software renderer must keep up
constexpr WindowSize picture_size{1280, 720};

// Order matters: the renderer goes before its context.
struct OffscreenView {
    renderer::OffscreenContext context;
    renderer::Renderer renderer;
};

void takePicture(renderer::Renderer& renderer, const renderer::Scene& scene, WindowSize size,
                 const std::string& file) {
    const auto written = renderer::writePng(file, renderer.capture(scene, size.width, size.height));
    if (!written) throw std::runtime_error(written.error().text());
}

}  // namespace

Result<void> drawSimulation(studies::SimulatedStation& station, const assets::Avatar& avatar,
                            const std::string& size, const std::shared_ptr<Screenshots>& screenshots) {
    WindowSize view_size{480, 270};
    WindowSize pictured_size = picture_size;
    if (!size.empty()) {
        const auto parsed = parseWindowSize(size);
        if (!parsed) return tl::unexpected(parsed.error());
        view_size = pictured_size = *parsed;
    }
    auto context = renderer::OffscreenContext::create();
    if (!context) return tl::unexpected(context.error());
    // Nobody looks at the frames, but the pictures are for people: several samples only for them.
    renderer::Quality quality;
    quality.samples = screenshots->wanted.empty() ? 1 : quality.samples;
    auto made = renderer::Renderer::create(avatar, quality);
    if (!made) return tl::unexpected(made.error());
    const auto view = std::make_shared<OffscreenView>(OffscreenView{std::move(*context), std::move(*made)});

    std::string details =
        fmt::format("off screen, {}x{} pixels, drawn at key moments and every {:g} s of virtual time, {}",
                    view_size.width, view_size.height, draw_period_s, view->renderer.driver());
    station.attachViewer(std::move(details),
                         [view, view_size, pictured_size, screenshots, next_s = 0.0](
                             const studies::PresentedFrame& frame, const studies::InputFrame& input) mutable {
                             if (frame.number <= 1) return;  // the participant has not been placed yet
                             const std::string state = presentedStateName(frame);
                             screenshots->met.insert(state);
                             auto& wanted = screenshots->wanted;
                             const auto picture = wanted.find(state);
                             const bool due = frame.key_moment || input.time_s >= next_s;
                             if (!due && picture == wanted.end()) return;
                             renderer::Scene scene = sceneFromFrame(frame, input.stage_from_head);
                             addNotice(scene, frame.notice);
                             if (due) {
                                 (void)view->renderer.capture(scene, view_size.width, view_size.height);
                                 next_s = input.time_s + draw_period_s;
                             }
                             if (picture != wanted.end()) {
                                 takePicture(view->renderer, scene, pictured_size, picture->second);
                                 wanted.erase(picture);
                             }
                         });
    return {};
}

}  // namespace deixis::app
