#include "scene_passes.hpp"

#include <algorithm>

#include "renderer/drawing/renderer.hpp"

namespace deixis::renderer {
namespace {

constexpr std::size_t views_offset = offsetof(FrameBlock, views);

}  // namespace

ScenePasses::ScenePasses(const assets::Avatar& avatar, const Quality& quality, BoardFonts fonts)
    : avatar_(avatar, quality.shadow_resolution),
      boards_(std::move(fonts), quality.board_pixels_per_metre),
      frame_buffer_(gl::dynamicBuffer(sizeof(FrameBlock))) {}

void ScenePasses::prepare(const Scene& scene, std::span<const ViewBlock> views) {
    FrameBlock block;
    std::copy(views.begin(), views.end(), block.views.begin());
    block.to_light = glm::vec4(glm::vec3(directionToLight()), 0.0F);
    BallPass::placeShadows(scene.balls, block);
    balls_.place(scene.balls);
    trails_.place(scene.trails);
    avatar_.place(scene.avatars, block);
    glNamedBufferSubData(frame_buffer_.name(), 0, sizeof(FrameBlock), &block);
    glBindBufferRange(GL_UNIFORM_BUFFER, frame_block_binding, frame_buffer_.name(), 0, views_offset);

    gl::resetDrawingState();
    boards_.paint(scene.boards);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    avatar_.drawShadows();
    avatar_.light();
}

void ScenePasses::replaceView(const ViewBlock& view) {
    glNamedBufferSubData(frame_buffer_.name(), views_offset, sizeof(ViewBlock), &view);
    bindView(0);
}

void ScenePasses::bindView(std::size_t index) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, view_block_binding, frame_buffer_.name(),
                      static_cast<GLintptr>(views_offset + index * sizeof(ViewBlock)), sizeof(ViewBlock));
}

void ScenePasses::bindBothViews() const {
    glBindBufferRange(GL_UNIFORM_BUFFER, view_block_binding, frame_buffer_.name(), views_offset,
                      2 * sizeof(ViewBlock));
}

void ScenePasses::draw(const Scene& scene, Views views, BoardLook first_board) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glEnable(GL_MULTISAMPLE);
    avatar_.bindShadows();
    avatar_.draw(views);
    balls_.draw(views);
    heads_.draw(scene.heads, views);
    room_.draw(views);
    glEnable(GL_BLEND);
    for (std::size_t i = 0; i < scene.boards.size(); ++i) {
        const bool hole = i == 0 && first_board == BoardLook::hole;
        glBlendFunc(hole ? GL_ZERO : GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        boards_.draw(scene.boards[i], views);
    }
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    balls_.drawRings(views);
    trails_.draw(views);
    for (const Beam& beam : scene.beams) beam_.draw(beam, views);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
}

}  // namespace deixis::renderer
