#include "renderer/renderer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <stdexcept>

#include "avatar_pass.hpp"
#include "ball_pass.hpp"
#include "beam_pass.hpp"
#include "board_pass.hpp"
#include "frame.hpp"
#include "gl.hpp"
#include "gl_version.hpp"
#include "room_pass.hpp"
#include "targets.hpp"

namespace deixis::renderer {
namespace {

glm::mat4 perspective(const Camera& camera, int width, int height) {
    return glm::mat4(glm::perspective(camera.vertical_fov_rad,
                                      static_cast<double>(width) / static_cast<double>(height), camera.near_m,
                                      camera.far_m));
}

}  // namespace

struct Renderer::Impl {
    Impl(const assets::Avatar& avatar_model, const Quality& quality, BoardFonts fonts)
        : avatar(avatar_model, quality.shadow_resolution),
          board(std::move(fonts), quality.board_pixels_per_metre),
          targets(quality.samples),
          frame_buffer(gl::dynamicBuffer(sizeof(FrameBlock))) {}

    void render(const Scene& scene, int width, int height);

    AvatarPass avatar;
    RoomPass room;
    BallPass balls;
    BeamPass beam;
    BoardPass board;
    Targets targets;
    gl::Buffer frame_buffer;
};

void Renderer::Impl::render(const Scene& scene, int width, int height) {
    if (width <= 0 || height <= 0)
        throw std::invalid_argument(
            fmt::format("a picture of {} x {} pixels cannot be drawn", width, height));
    FrameBlock block;
    block.eye_from_stage = matrixFromPose(inverse(scene.camera.stage_from_eye));
    block.clip_from_eye = perspective(scene.camera, width, height);
    block.clip_from_stage = block.clip_from_eye * block.eye_from_stage;
    const double pixel_at_1m = 2.0 * std::tan(0.5 * scene.camera.vertical_fov_rad) / height;
    block.eye = glm::vec4(glm::vec3(scene.camera.stage_from_eye.position), static_cast<float>(pixel_at_1m));
    block.to_light = glm::vec4(glm::vec3(directionToLight()), 0.0F);
    BallPass::placeShadows(scene.balls, block);
    if (scene.avatar_visible) {
        avatar.skin(scene.avatar_joints);
        avatar.placeShadow(scene.avatar_joints, block);
        avatar.placeFeet(scene.avatar_joints, block);
    }
    glNamedBufferSubData(frame_buffer.name(), 0, sizeof(FrameBlock), &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, frame_block_binding, frame_buffer.name());

    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    for (GLuint unit = 0; unit < 2; ++unit) glBindSampler(unit, 0);
    if (scene.board) board.paint(*scene.board);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    if (scene.avatar_visible) {
        avatar.drawShadow();
        avatar.light();
    }

    targets.begin(width, height);
    glEnable(GL_MULTISAMPLE);
    avatar.bindShadow();
    if (scene.avatar_visible) avatar.draw();
    balls.draw(scene.balls);
    room.draw();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (scene.board) board.draw(*scene.board);
    if (scene.beam) {
        glDepthMask(GL_FALSE);
        beam.draw(*scene.beam);
        glDepthMask(GL_TRUE);
    }
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    targets.resolve();
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
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl::checkErrors("drawing a frame");
}

Image Renderer::capture(const Scene& scene, int width, int height) {
    impl_->render(scene, width, height);
    const std::size_t row = static_cast<std::size_t>(width) * 3U;
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height));
    impl_->targets.read(upside_down.data());
    glBindVertexArray(0);
    glUseProgram(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::checkErrors("capturing a frame");
    Image image{width, height, {}};
    image.rgb.reserve(upside_down.size());
    for (auto from = upside_down.end(); from != upside_down.begin();) {
        from -= static_cast<std::ptrdiff_t>(row);
        image.rgb.insert(image.rgb.end(), from, from + static_cast<std::ptrdiff_t>(row));
    }
    return image;
}

int Renderer::boardPaints() const {
    return impl_->board.paints();
}

std::string Renderer::driver() const {
    const auto words = [](GLenum name) {
        const auto* text = reinterpret_cast<const char*>(glGetString(name));
        return std::string(text != nullptr ? text : "unknown");
    };
    return words(GL_RENDERER) + ", OpenGL " + words(GL_VERSION);
}

}  // namespace deixis::renderer
