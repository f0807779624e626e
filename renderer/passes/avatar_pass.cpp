#include "renderer/passes/avatar_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <stdexcept>

#include "avatar_shaders.hpp"

namespace deixis::renderer {
namespace {

constexpr int skin_group = 64;

constexpr std::size_t max_joints = assets::max_avatar_joints;
static_assert(max_joints * 3 <= 1020, "as many fit the smallest uniform block that GL promises");

struct BindVertex {
    glm::vec3 position, normal;
    std::array<std::uint16_t, 4> joints, weights;
};
struct SkinnedVertex {
    glm::vec4 position, normal;
};

// How far the vertices that a joint moves lie from it, whatever the pose; -1 for a joint that moves none.
std::vector<double> jointReach(const assets::Avatar& avatar) {
    std::vector<double> reach_m(avatar.joint_from_bind.size(), -1.0);
    for (const assets::SkinnedVertex& v : avatar.vertices)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t joint = v.joints[k];
            if (v.weights[k] < 0.25F || joint >= reach_m.size()) continue;
            const Vec3 in_joint = transformPoint(avatar.joint_from_bind[joint], Vec3(v.position));
            reach_m[joint] = std::max(reach_m[joint], glm::length(in_joint));
        }
    return reach_m;
}

// Heaviest first, the weights as fractions of 65535 whose sum is exactly that.
BindVertex packed(const assets::SkinnedVertex& v) {
    BindVertex out{v.position, v.normal, {}, {}};
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return v.weights[a] > v.weights[b]; });
    int left = 65535;
    for (std::size_t k = 4; k-- > 0;) {
        const int weight =
            k == 0 ? left
                   : std::clamp(static_cast<int>(std::lround(v.weights[order[k]] * 65535.0F)), 0, left);
        out.joints[k] = v.joints[order[k]];
        out.weights[k] = static_cast<std::uint16_t>(weight);
        left -= weight;
    }
    return out;
}

// A shadow map covers a square of this side around its avatar's hips, seen from the light: arms stretched
// out and a step to any side lie within. Its depth runs over as much above and below.
constexpr double shadow_side_m = 2.8;
constexpr double shadow_depth_m = 4.0;

// What casts the shadow is coarser than what is seen: vertices of one joint within a cell of this side become
// one.
constexpr float caster_cell_m = 0.014F;

std::vector<std::uint32_t> coarseTriangles(const assets::Avatar& avatar, float cell_m) {
    std::map<std::array<int, 4>, std::uint32_t> cells;
    std::vector<std::uint32_t> stands_for(avatar.vertices.size());
    for (std::uint32_t i = 0; i < avatar.vertices.size(); ++i) {
        const assets::SkinnedVertex& v = avatar.vertices[i];
        const auto heaviest = std::max_element(v.weights.begin(), v.weights.end()) - v.weights.begin();
        const glm::ivec3 cell(glm::floor(v.position / cell_m));
        const std::array<int, 4> key{cell.x, cell.y, cell.z, v.joints[static_cast<std::size_t>(heaviest)]};
        stands_for[i] = cells.emplace(key, i).first->second;
    }
    std::vector<std::uint32_t> coarse;
    for (std::size_t t = 0; t + 2 < avatar.indices.size(); t += 3) {
        const std::uint32_t a = stands_for[avatar.indices[t]];
        const std::uint32_t b = stands_for[avatar.indices[t + 1]];
        const std::uint32_t c = stands_for[avatar.indices[t + 2]];
        if (a != b && b != c && c != a) coarse.insert(coarse.end(), {a, b, c});
    }
    return coarse;
}

constexpr GLuint base_colour_unit = 2;  // as the shader has it

bool isPlain(const assets::AvatarPart& part) {
    return part.texture < 0 && part.alpha_cutoff <= 0.0F && !part.double_sided;
}

GLint wrapMode(assets::TextureWrap wrap) {
    if (wrap == assets::TextureWrap::clamp) return GL_CLAMP_TO_EDGE;
    return wrap == assets::TextureWrap::mirror ? GL_MIRRORED_REPEAT : GL_REPEAT;
}

gl::Texture uploaded(const assets::AvatarTexture& source) {
    const int longer = std::max(source.width, source.height);
    const int levels = 1 + static_cast<int>(std::floor(std::log2(longer)));
    gl::Texture texture = gl::texture2d(GL_SRGB8_ALPHA8, source.width, source.height, levels);
    const GLuint name = texture.name();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(name, 0, 0, 0, source.width, source.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        source.rgba.data());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glGenerateTextureMipmap(name);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, wrapMode(source.wrap_u));
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, wrapMode(source.wrap_v));
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, source.nearest ? GL_NEAREST : GL_LINEAR);
    return texture;
}

}  // namespace

AvatarPass::AvatarPass(const assets::Avatar& avatar, int shadow_resolution)
    : humanoid_(avatar.humanoid),
      joint_from_bind_(avatar.joint_from_bind),
      joint_reach_m_(jointReach(avatar)),
      vertex_count_(static_cast<int>(avatar.vertices.size())),
      index_count_(static_cast<int>(avatar.indices.size())),
      shadow_resolution_(shadow_resolution),
      skin_program_(gl::computeProgram("skin", {skin_glsl})),
      light_program_(gl::computeProgram("light", {frame_glsl, shadow_glsl, light_glsl})),
      shadow_program_(gl::drawProgram("shadow", {frame_glsl, shadow_vertex_glsl}, {shadow_fragment_glsl})),
      draw_program_("avatar", {draw_vertex_glsl},
                    {frame_glsl, lighting_glsl, plain_surface_glsl, draw_fragment_glsl}) {
    if (joint_from_bind_.size() > max_joints)
        throw std::invalid_argument(fmt::format("the avatar has {} joints, at most {} can be drawn",
                                                joint_from_bind_.size(), max_joints));
    std::vector<BindVertex> vertices;
    std::vector<glm::vec3> colours;
    std::vector<glm::vec2> uvs;
    vertices.reserve(avatar.vertices.size());
    colours.reserve(avatar.vertices.size());
    uvs.reserve(avatar.vertices.size());
    for (const assets::SkinnedVertex& v : avatar.vertices) {
        vertices.push_back(packed(v));
        colours.push_back(v.colour);
        uvs.push_back(v.uv);
    }
    makeParts(avatar);
    if (textured_program_) uvs_ = gl::fixedBuffer(std::span<const glm::vec2>(uvs));
    bind_vertices_ = gl::fixedBuffer(std::span<const BindVertex>(vertices));
    colours_ = gl::fixedBuffer(std::span<const glm::vec3>(colours));
    std::vector<std::uint32_t> indices = avatar.indices;
    const std::vector<std::uint32_t> caster = coarseTriangles(avatar, caster_cell_m);
    caster_index_count_ = static_cast<int>(caster.size());
    indices.insert(indices.end(), caster.begin(), caster.end());
    indices_ = gl::fixedBuffer(std::span<const std::uint32_t>(indices));
    joint_rows_.resize(joint_from_bind_.size() * 12);

    // Layers of one texture: a shader reads them all.
    shadow_maps_ = gl::sampledLayers(GL_DEPTH_COMPONENT16, shadow_resolution_, shadow_resolution_,
                                     static_cast<int>(max_avatars), 1);
    for (const GLenum side : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTextureParameteri(shadow_maps_.name(), side, GL_CLAMP_TO_EDGE);
    glTextureParameteri(shadow_maps_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(shadow_maps_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(shadow_maps_.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTextureParameteri(shadow_maps_.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    // The same texels without comparing, for the search of what shades.
    GLuint view = 0;
    glGenTextures(1, &view);
    glTextureView(view, GL_TEXTURE_2D_ARRAY, shadow_maps_.name(), GL_DEPTH_COMPONENT16, 0, 1, 0,
                  static_cast<GLuint>(max_avatars));
    shadow_depths_view_ = gl::Texture(view);
    glTextureParameteri(view, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(view, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(view, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    for (std::size_t i = 0; i < max_avatars; ++i) makeFigure(static_cast<int>(i));
}

void AvatarPass::makeParts(const assets::Avatar& avatar) {
    parts_ = avatar.parts;
    if (parts_.empty()) parts_.push_back({0, static_cast<std::uint32_t>(avatar.indices.size())});
    const bool plain = std::all_of(parts_.begin(), parts_.end(), isPlain);
    if (plain) return;
    textured_program_.emplace(
        "textured avatar", gl::Parts{textured_vertex_glsl},
        gl::Parts{frame_glsl, lighting_glsl, textured_surface_glsl, draw_fragment_glsl});
    for (const assets::AvatarTexture& texture : avatar.textures) textures_.push_back(uploaded(texture));
    assets::AvatarTexture white;  // for parts without a texture
    white.width = white.height = 1;
    white.rgba.assign(4, 255);
    textures_.push_back(uploaded(white));
}

void AvatarPass::makeFigure(int layer) {
    Figure& figure = figures_[static_cast<std::size_t>(layer)];
    figure.skinned = gl::dynamicBuffer(static_cast<GLsizeiptr>(std::max(vertex_count_, 1)) *
                                       static_cast<GLsizeiptr>(sizeof(SkinnedVertex)));
    figure.joints = gl::dynamicBuffer(static_cast<GLsizeiptr>(max_joints * 12 * sizeof(float)));
    figure.vertices = gl::vertexArray();
    const GLuint vao = figure.vertices.name();
    glVertexArrayVertexBuffer(vao, 0, figure.skinned.name(), 0, sizeof(SkinnedVertex));
    glVertexArrayVertexBuffer(vao, 1, colours_.name(), 0, sizeof(glm::vec3));
    if (textured_program_) {
        glVertexArrayVertexBuffer(vao, 2, uvs_.name(), 0, sizeof(glm::vec2));
        glVertexArrayAttribFormat(vao, 3, 2, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayAttribBinding(vao, 3, 2);
        glEnableVertexArrayAttrib(vao, 3);
    }
    glVertexArrayElementBuffer(vao, indices_.name());
    glVertexArrayAttribFormat(vao, 0, 3, GL_FLOAT, GL_FALSE, offsetof(SkinnedVertex, position));
    glVertexArrayAttribFormat(vao, 1, 4, GL_FLOAT, GL_FALSE, offsetof(SkinnedVertex, normal));
    glVertexArrayAttribFormat(vao, 2, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vao, 0, 0);
    glVertexArrayAttribBinding(vao, 1, 0);
    glVertexArrayAttribBinding(vao, 2, 1);
    for (GLuint attribute = 0; attribute < 3; ++attribute) glEnableVertexArrayAttrib(vao, attribute);

    figure.shadow_target = gl::framebuffer();
    glNamedFramebufferTextureLayer(figure.shadow_target.name(), GL_DEPTH_ATTACHMENT, shadow_maps_.name(), 0,
                                   layer);
    glNamedFramebufferDrawBuffer(figure.shadow_target.name(), GL_NONE);
    gl::requireComplete(figure.shadow_target, "shadow map");
}

void AvatarPass::place(const std::vector<std::vector<Pose>>& avatars, FrameBlock& block) {
    if (avatars.size() > max_avatars)
        throw std::invalid_argument(
            fmt::format("{} avatars were to be drawn, at most {} can be", avatars.size(), max_avatars));
    for (const auto& stage_from_joint : avatars)
        if (stage_from_joint.size() != joint_from_bind_.size())
            throw std::invalid_argument(
                fmt::format("one of Scene::avatars has {} poses, the avatar {} joints",
                            stage_from_joint.size(), joint_from_bind_.size()));
    count_ = avatars.size();
    for (std::size_t i = 0; i < count_; ++i) {
        skin(avatars[i], figures_[i]);
        placeShadow(avatars[i], i, block);
        placeFeet(avatars[i], i, block);
    }
    block.shadow = glm::vec4(1.0 / shadow_side_m, shadow_depth_m, static_cast<double>(count_), 0.0);
}

void AvatarPass::skin(const std::vector<Pose>& stage_from_joint, const Figure& figure) {
    for (std::size_t j = 0; j < stage_from_joint.size(); ++j) {
        const glm::mat4 stage_from_bind = matrixFromPose(stage_from_joint[j] * joint_from_bind_[j]);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                joint_rows_[j * 12 + static_cast<std::size_t>(row * 4 + column)] =
                    stage_from_bind[column][row];
    }
    if (vertex_count_ == 0) return;
    glNamedBufferSubData(figure.joints.name(), 0, static_cast<GLsizeiptr>(joint_rows_.size() * sizeof(float)),
                         joint_rows_.data());
    glUseProgram(skin_program_.name());
    glUniform1ui(0, static_cast<GLuint>(vertex_count_));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, bind_vertices_.name());
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, figure.joints.name());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, figure.skinned.name());
    glDispatchCompute(static_cast<GLuint>((vertex_count_ + skin_group - 1) / skin_group), 1, 1);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void AvatarPass::placeShadow(const std::vector<Pose>& stage_from_joint, std::size_t avatar,
                             FrameBlock& block) const {
    const int hips_joint = std::max(humanoid_[motion::Bone::hips], 0);
    const Vec3 hips = stage_from_joint.empty()
                          ? Vec3(0.0)
                          : stage_from_joint[static_cast<std::size_t>(hips_joint)].position;
    const Vec3 to_light = directionToLight();
    const glm::dmat4 turn = glm::lookAt(Vec3(0.0), -to_light, Vec3(0.0, 0.0, -1.0));
    const auto seen = [&](const Vec3& p) { return Vec3(turn * glm::dvec4(p, 1.0)); };
    // Moves in whole texels, so that the shadow's edge does not crawl while the avatar sways.
    const double texel_m = shadow_side_m / shadow_resolution_;
    Vec3 centre = seen(hips);
    centre.x = std::round(centre.x / texel_m) * texel_m;
    centre.y = std::round(centre.y / texel_m) * texel_m;
    centre.z = std::round(centre.z / 0.25) * 0.25;
    glm::dmat4 shadow(1.0);
    shadow = glm::translate(shadow, Vec3(0.5, 0.5, 0.5));
    shadow = glm::scale(shadow, Vec3(1.0 / shadow_side_m, 1.0 / shadow_side_m, -1.0 / shadow_depth_m));
    shadow = glm::translate(shadow, -centre);
    const glm::dmat4 shadow_from_stage = shadow * turn;
    block.shadow_from_stage[avatar] = glm::mat4(shadow_from_stage);

    glm::dvec2 low(1.0);
    glm::dvec2 high(0.0);
    for (std::size_t j = 0; j < stage_from_joint.size(); ++j) {
        if (joint_reach_m_[j] < 0.0) continue;
        const glm::dvec2 uv(shadow_from_stage * glm::dvec4(stage_from_joint[j].position, 1.0));
        low = glm::min(low, uv - joint_reach_m_[j] / shadow_side_m);
        high = glm::max(high, uv + joint_reach_m_[j] / shadow_side_m);
    }
    block.shadow_box[avatar] = glm::vec4(glm::max(low, glm::dvec2(0.0)), glm::min(high, glm::dvec2(1.0)));
}

void AvatarPass::drawShadows() const {
    const GLfloat farthest = 1.0F;
    glViewport(0, 0, shadow_resolution_, shadow_resolution_);
    glUseProgram(shadow_program_.name());
    // Only what faces away from the light: the lit side then cannot shade itself.
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    for (std::size_t i = 0; i < count_; ++i) {
        glBindFramebuffer(GL_FRAMEBUFFER, figures_[i].shadow_target.name());
        glClearNamedFramebufferfv(figures_[i].shadow_target.name(), GL_DEPTH, 0, &farthest);
        glUniform1i(0, static_cast<GLint>(i));
        glBindVertexArray(figures_[i].vertices.name());
        glDrawElements(
            GL_TRIANGLES, caster_index_count_, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(static_cast<std::uintptr_t>(index_count_) * sizeof(GLuint)));
    }
    glCullFace(GL_BACK);
    glDisable(GL_CULL_FACE);
}

void AvatarPass::placeFeet(const std::vector<Pose>& stage_from_joint, std::size_t avatar,
                           FrameBlock& block) const {
    using motion::Bone;
    const std::array<std::pair<Bone, Bone>, 2> feet{std::pair{Bone::leftFoot, Bone::leftToes},
                                                    std::pair{Bone::rightFoot, Bone::rightToes}};
    for (std::size_t i = 0; i < feet.size(); ++i) {
        const int ankle_joint = humanoid_[feet[i].first];
        const int toes_joint = humanoid_[feet[i].second];
        if (ankle_joint < 0 || toes_joint < 0) continue;
        const Vec3 ankle = stage_from_joint[static_cast<std::size_t>(ankle_joint)].position;
        const Vec3 toes = stage_from_joint[static_cast<std::size_t>(toes_joint)].position;
        // The sole's middle line, from over the heel to the toes' middle.
        const Vec3 along = toes - ankle;
        const Vec3 heel = ankle + Vec3(-0.25 * along.x, 0.75 * along.y, -0.25 * along.z);
        const Vec3 tip = toes + Vec3(0.2 * along.x, 0.0, 0.2 * along.z);
        const std::size_t foot = 2 * avatar + i;
        block.feet[2 * foot] = glm::vec4(glm::vec3(heel), 0.045F);
        block.feet[2 * foot + 1] = glm::vec4(glm::vec3(tip), 0.045F);
    }
}

void AvatarPass::bindShadows() const {
    glBindTextureUnit(shadow_texture_unit, shadow_maps_.name());
    glBindTextureUnit(shadow_texture_unit + 1, shadow_depths_view_.name());
}

void AvatarPass::light() const {
    if (vertex_count_ == 0) return;
    bindShadows();
    glUseProgram(light_program_.name());
    glUniform1ui(0, static_cast<GLuint>(vertex_count_));
    for (std::size_t i = 0; i < count_; ++i) {
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, figures_[i].skinned.name());
        glDispatchCompute(static_cast<GLuint>((vertex_count_ + skin_group - 1) / skin_group), 1, 1);
    }
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
}

void AvatarPass::draw(Views views) {
    if (count_ == 0) return;
    draw_program_.use(views);
    glEnable(GL_CULL_FACE);
    for (const assets::AvatarPart& part : parts_)
        if (isPlain(part)) drawPart(part);
    if (textured_program_) {
        textured_program_->use(views);
        for (const assets::AvatarPart& part : parts_) {
            if (isPlain(part)) continue;
            (part.double_sided ? glDisable : glEnable)(GL_CULL_FACE);
            const auto texture =
                part.texture < 0 ? textures_.size() - 1 : static_cast<std::size_t>(part.texture);
            glBindTextureUnit(base_colour_unit, textures_[texture].name());
            glUniform1f(0, part.alpha_cutoff);
            drawPart(part);
        }
    }
    glDisable(GL_CULL_FACE);
}

void AvatarPass::drawPart(const assets::AvatarPart& part) const {
    for (std::size_t i = 0; i < count_; ++i) {
        glBindVertexArray(figures_[i].vertices.name());
        glDrawElements(
            GL_TRIANGLES, static_cast<GLsizei>(part.index_count), GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(static_cast<std::uintptr_t>(part.first_index) * sizeof(GLuint)));
    }
}

}  // namespace deixis::renderer
