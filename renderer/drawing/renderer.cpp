#include "renderer/drawing/renderer.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <stdexcept>

#include "mirror_pass.hpp"
#include "renderer/gl/gl.hpp"
#include "renderer/gl/gl_version.hpp"
#include "renderer/gl/targets.hpp"
#include "renderer/passes/hidden_area_pass.hpp"
#include "renderer/scene/stereo_samples.hpp"
#include "scene_passes.hpp"

namespace deixis::renderer {
namespace {

void requirePixels(int width, int height) {
    if (width <= 0 || height <= 0)
        throw std::invalid_argument(
            fmt::format("a picture of {} x {} pixels cannot be drawn", width, height));
}

/// Nothing bound but the framebuffer.
void leave(GLuint framebuffer) {
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

}  // namespace

struct Renderer::Impl {
    Impl(const assets::Avatar& avatar, const Quality& quality, BoardFonts fonts)
        : passes(avatar, quality, std::move(fonts)),
          targets(quality.samples),
          stereo_samples(quality.samples) {}

    void render(const Scene& scene, int width, int height);
    void drawEyes(const Scene& scene, Views views, std::size_t first_eye, int width, int height);

    ScenePasses passes;
    Targets targets;
    StereoSamples stereo_samples;
    HiddenAreaPass hidden_area;
    MirrorPass mirror;
};

void Renderer::Impl::render(const Scene& scene, int width, int height) {
    requirePixels(width, height);
    const std::array<ViewBlock, 1> view{viewBlock(scene.camera, width, height)};
    passes.prepare(scene, view);
    targets.begin(width, height);
    passes.bindView(0);
    passes.draw(scene, Views::one, BoardLook::picture);
    targets.resolve();
}

void Renderer::Impl::drawEyes(const Scene& scene, Views views, std::size_t first_eye, int width, int height) {
    stereo_samples.begin(width, height, views);
    if (views == Views::both)
        passes.bindBothViews();
    else
        passes.bindView(first_eye);
    hidden_area.draw(views);
    passes.draw(scene, views, BoardLook::hole);
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Renderer> Renderer::create(const assets::Avatar& avatar, const Quality& quality) {
    if (Result<void> version = requireGlVersion("drawing"); !version) return tl::unexpected(version.error());
    Result<BoardFonts> fonts = BoardFonts::load();
    if (!fonts) return tl::unexpected(fonts.error());
    gl::watchErrors();
    Renderer renderer(std::make_unique<Impl>(avatar, quality, std::move(*fonts)));
    gl::checkErrors("making the renderer");
    return renderer;
}

void Renderer::draw(const Scene& scene, int width, int height, unsigned int framebuffer) {
    impl_->render(scene, width, height);
    impl_->targets.copyTo(framebuffer);
    leave(framebuffer);
    gl::checkErrors("drawing a frame");
}

Image Renderer::capture(const Scene& scene, int width, int height) {
    impl_->render(scene, width, height);
    const std::size_t row = static_cast<std::size_t>(width) * 3U;
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height));
    impl_->targets.read(upside_down.data());
    leave(0);
    gl::checkErrors("capturing a frame");
    Image image{width, height, {}};
    image.rgb.reserve(upside_down.size());
    for (auto from = upside_down.end(); from != upside_down.begin();) {
        from -= static_cast<std::ptrdiff_t>(row);
        image.rgb.insert(image.rgb.end(), from, from + static_cast<std::ptrdiff_t>(row));
    }
    return image;
}

void Renderer::drawStereo(const Scene& scene, const Eyes& eyes, const StereoTarget& target, StereoMode mode) {
    requirePixels(target.width, target.height);
    if (mode == StereoMode::multiview && !hasMultiview())
        throw std::invalid_argument("multiview was asked for, which this driver has not");
    std::array<ViewBlock, 2> views;
    for (std::uint32_t side = 0; side < views.size(); ++side)
        views[side] = viewBlock(eyes[side], side, scene.camera.near_m, scene.camera.far_m, target.height);
    Impl& impl = *impl_;
    impl.passes.prepare(scene, views);
    if (mode == StereoMode::multiview) {
        impl.drawEyes(scene, Views::both, 0, target.width, target.height);
        for (const int eye : {0, 1}) impl.stereo_samples.resolve(target, eye);
    } else {
        // The left eye last: its samples stay for the mirror.
        for (const int eye : {1, 0}) {
            impl.drawEyes(scene, Views::one, static_cast<std::size_t>(eye), target.width, target.height);
            impl.stereo_samples.resolve(target, eye);
        }
    }
    leave(0);
    gl::checkErrors("drawing both eyes");
}

bool Renderer::hasMultiview() const {
    return impl_->stereo_samples.hasMultiview();
}

void Renderer::setHiddenArea(const std::array<HiddenArea, 2>& areas) {
    impl_->hidden_area.set(areas);
    gl::checkErrors("setting the hidden area");
}

std::array<int, 2> Renderer::boardSize(const Board& board) const {
    return impl_->passes.boards().size(board);
}

void Renderer::copyBoard(const Board& board, unsigned int texture) {
    gl::resetDrawingState();
    impl_->passes.boards().paint(std::span<const Board>(&board, 1));
    impl_->passes.boards().copyTo(board, texture);
    leave(0);
    gl::checkErrors("copying the board");
}

BoardRect Renderer::boardExtent(const Board& board) const {
    const BoardCorners corners = impl_->passes.boards().corners(board);
    return {corners.low.x, corners.low.y, corners.high.x - corners.low.x, corners.high.y - corners.low.y};
}

void Renderer::drawMirror(const Scene& scene, const Eye& left, int width, int height,
                          unsigned int framebuffer) {
    requirePixels(width, height);
    impl_->mirror.draw(impl_->stereo_samples, impl_->passes, scene, left, width, height, framebuffer);
    leave(framebuffer);
    gl::checkErrors("drawing the mirror");
}

int Renderer::boardPaints() const {
    return impl_->passes.boards().paints();
}

const std::string& Renderer::missingCharacters() const {
    return impl_->passes.boards().missingCharacters();
}

std::string Renderer::driver() const {
    const auto words = [](GLenum name) {
        const auto* text = reinterpret_cast<const char*>(glGetString(name));
        return std::string(text != nullptr ? text : "unknown");
    };
    return words(GL_RENDERER) + ", OpenGL " + words(GL_VERSION);
}

}  // namespace deixis::renderer
