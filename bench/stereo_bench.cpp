// Drawing both eyes of a headset: against one eye drawn twice, in one pass against two, and what the
// processor does for a frame before any GL driver.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "clocks.hpp"
#include "idle_gl.hpp"
#include "renderer/drawing/renderer.hpp"
#include "scenes.hpp"

namespace {

using namespace deixis;

/// One eye, 100 by 96 degrees, as headsets have it.
renderer::Eyes headsetEyes(const Pose& stage_from_head) {
    const auto rad = [](double deg) { return radiansFromDegrees(deg); };
    renderer::Eyes eyes{renderer::Eye{stage_from_head, {rad(-52.0), rad(48.0), rad(47.0), rad(-49.0)}},
                        renderer::Eye{stage_from_head, {rad(-48.0), rad(52.0), rad(47.0), rad(-49.0)}}};
    const Vec3 right = stage_from_head.orientation * Vec3(0.032, 0.0, 0.0);
    eyes[0].stage_from_eye.position -= right;
    eyes[1].stage_from_eye.position += right;
    return eyes;
}

/// A renderer, the textures that a headset's runtime would lend, and a framebuffer for one eye alone.
class Headset {
  public:
    Headset(int width, int height, int samples) : target_{{}, {}, width, height} {
        auto context = renderer::OffscreenContext::create();
        context_.emplace(bench::valueOf(std::move(context)));
        renderer::Quality quality;
        quality.samples = samples;
        drawing_.emplace(
            bench::valueOf(renderer::Renderer::create(bench::valueOf(app::loadShippedAvatar()), quality)));
        glCreateTextures(GL_TEXTURE_2D, 2, target_.colour.data());
        glCreateTextures(GL_TEXTURE_2D, 2, target_.depth.data());
        for (std::size_t eye = 0; eye < 2; ++eye) {
            glTextureStorage2D(target_.colour[eye], 1, GL_SRGB8_ALPHA8, width, height);
            glTextureStorage2D(target_.depth[eye], 1, GL_DEPTH_COMPONENT32F, width, height);
        }
        glCreateTextures(GL_TEXTURE_2D, 1, &one_eye_);
        glTextureStorage2D(one_eye_, 1, GL_SRGB8_ALPHA8, width, height);
        glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, one_eye_, 0);
    }
    Headset(const Headset&) = delete;
    Headset& operator=(const Headset&) = delete;
    ~Headset() {
        const std::array<GLuint, 5> textures{target_.colour[0], target_.colour[1], target_.depth[0],
                                             target_.depth[1], one_eye_};
        glDeleteFramebuffers(1, &framebuffer_);
        glDeleteTextures(static_cast<GLsizei>(textures.size()), textures.data());
    }
    renderer::Renderer& drawing() { return *drawing_; }

    /// The left eye alone, with a camera that sees as much.
    void drawOne(renderer::Scene& scene, const renderer::Eyes& eyes) {
        scene.camera.stage_from_eye = eyes[0].stage_from_eye;
        scene.camera.vertical_fov_rad = eyes[0].fov.up_rad - eyes[0].fov.down_rad;
        drawing_->draw(scene, target_.width, target_.height, framebuffer_);
    }
    void drawBoth(const renderer::Scene& scene, const renderer::Eyes& eyes, renderer::StereoMode mode) {
        drawing_->drawStereo(scene, eyes, target_, mode);
    }

  private:
    renderer::StereoTarget target_;
    GLuint one_eye_ = 0;
    GLuint framebuffer_ = 0;
    std::optional<renderer::OffscreenContext> context_;
    std::optional<renderer::Renderer> drawing_;
};

/// Seconds on the wall, and of all the processor's threads (software GL draws with several), which other work
/// on the machine does not lengthen.
struct Cost {
    double real_s = 0.0;
    double processor_s = 0.0;
};

template <typename Call>
Cost costOf(const Call& call) {
    const auto begin = std::chrono::steady_clock::now();
    const double processor_begin = bench::processorSeconds();
    call();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
            bench::processorSeconds() - processor_begin};
}

/// Arguments: width, height, samples. Time: both eyes in two passes. The counters are medians over frames
/// that take turns, so that other work on the machine meets all alike.
void stereo(benchmark::State& state) {
    const auto width = static_cast<int>(state.range(0));
    const auto height = static_cast<int>(state.range(1));
    Headset headset(width, height, static_cast<int>(state.range(2)));
    renderer::Scene scene = bench::sceneOf(bench::gameFrame());
    const renderer::Eyes eyes = headsetEyes(scene.camera.stage_from_eye);
    const bool multiview = headset.drawing().hasMultiview();
    const auto one = [&] {
        headset.drawOne(scene, eyes);
        glFinish();
    };
    const auto both = [&](renderer::StereoMode mode) {
        headset.drawBoth(scene, eyes, mode);
        glFinish();
    };
    const auto in_two = [&] { both(renderer::StereoMode::two_passes); };
    const auto in_one = [&] { both(renderer::StereoMode::multiview); };
    std::vector<double> real_ratios;
    std::vector<double> processor_ratios;
    one();
    in_two();
    for (auto _ : state) {
        const Cost first = costOf(one);
        const Cost second = costOf(one);
        const Cost passes = costOf(in_two);
        state.SetIterationTime(passes.real_s);
        real_ratios.push_back(passes.real_s / (first.real_s + second.real_s));
        processor_ratios.push_back(passes.processor_s / (first.processor_s + second.processor_s));
    }
    state.counters["over_twice_one_eye"] = bench::median(real_ratios);
    state.counters["over_twice_one_eye_cpu"] = bench::median(processor_ratios);
    if (multiview) {
        // Apart from the rest, since the samples' textures are made again where the way of drawing changes.
        constexpr int frames = 15;
        std::vector<double> passes_s(frames);
        std::vector<double> together_s(frames);
        for (double& s : passes_s) s = costOf(in_two).real_s;
        in_one();
        for (double& s : together_s) s = costOf(in_one).real_s;
        state.counters["multiview_over_two_passes"] = bench::median(together_s) / bench::median(passes_s);
    }
    state.SetLabel(headset.drawing().driver());
}
BENCHMARK(stereo)
    ->Name("renderer/stereo")
    ->Args({640, 640, 4})
    ->Args({1024, 1024, 4})
    ->Args({640, 640, 1})
    ->Args({2064, 2208, 4})
    ->ArgNames({"width", "height", "samples"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

/// From what the session presents to the last GL call of both eyes, where these do nothing.
void record(benchmark::State& state) {
    Headset headset(64, 64, 4);
    const studies::PresentedFrame frame = bench::gameFrame();
    const renderer::Eyes eyes = headsetEyes(bench::sceneOf(frame).camera.stage_from_eye);
    const auto both = [&] {
        headset.drawBoth(bench::sceneOf(frame), eyes, renderer::StereoMode::two_passes);
    };
    both();
    std::vector<double> times_ms;
    {
        const bench::IdleGl idle;
        const long calls_before = bench::IdleGl::calls();
        for (auto _ : state) {
            const double real_s = costOf(both).real_s;
            state.SetIterationTime(real_s);
            times_ms.push_back(real_s * 1e3);
        }
        state.counters["gl_calls"] =
            static_cast<double>(bench::IdleGl::calls() - calls_before) / static_cast<double>(times_ms.size());
    }
    state.counters["median_ms"] = bench::median(times_ms);
    state.counters["slowest_ms"] = *std::max_element(times_ms.begin(), times_ms.end());
}
BENCHMARK(record)->Name("renderer/record_stereo_frame")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
