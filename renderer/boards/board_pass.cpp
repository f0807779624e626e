#include "renderer/boards/board_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>

#include "board_painter.hpp"
#include "renderer/scene/frame.hpp"

namespace deixis::renderer {
namespace {

constexpr int max_texture_pixels = 2048;
constexpr std::size_t kept_cards = 3;  // a page, a sign and a notice; more only where one scene has more

/// Makes the board's own ImGui context current, and the caller's again at the end: the program may have one
/// for its window.
class ContextScope {
  public:
    explicit ContextScope(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    ~ContextScope() { ImGui::SetCurrentContext(before_); }
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

  private:
    ImGuiContext* before_;
};

const std::string_view text_vertex_glsl = R"(
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 srgb;
layout(location = 0) uniform vec2 size;
out vec2 font_uv;
out vec4 premultiplied;
out float thinness;
void main() {
    font_uv = uv;
    // Blended in linear light, dark letters on a light ground look thinner than light ones on a dark ground.
    thinness = mix(0.55, 1.0, smoothstep(0.1, 0.6, srgb.g));
    vec3 linear = mix(srgb.rgb / 12.92, pow((srgb.rgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb.rgb));
    premultiplied = vec4(linear * srgb.a, srgb.a);
    gl_Position = vec4(position / size * 2.0 - 1.0, 0.0, 1.0);
}
)";

const std::string_view text_fragment_glsl = R"(
layout(binding = 0) uniform sampler2D font;
in vec2 font_uv;
in vec4 premultiplied;
in float thinness;
out vec4 colour;
void main() { colour = premultiplied * pow(texture(font, font_uv).r, thinness); }
)";

// The texture's first row is the board's top.
const std::string_view card_vertex_glsl = R"(
layout(location = 0) uniform mat4 stage_from_board;
layout(location = 1) uniform vec4 rect;  // low and high corner on the board, margin included, metres
out vec2 card_uv;
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    card_uv = vec2(corner.x, 1.0 - corner.y);
    gl_Position = this_view.clip_from_stage * stage_from_board * vec4(mix(rect.xy, rect.zw, corner), 0.0, 1.0);
}
)";

const std::string_view card_fragment_glsl = R"(
layout(binding = 0) uniform sampler2D card;
in vec2 card_uv;
out vec4 colour;
void main() {
    colour = texture(card, card_uv);
    if (colour.a < 0.01) discard;
}
)";

}  // namespace

void BoardPass::ContextDeleter::operator()(ImGuiContext* context) const {
    ImGui::DestroyContext(context);
}

BoardPass::BoardPass(BoardFonts fonts, double pixels_per_metre)
    : fonts_(std::move(fonts)),
      wanted_pixels_per_metre_(pixels_per_metre),
      text_program_(gl::drawProgram("board text", {text_vertex_glsl}, {text_fragment_glsl})),
      card_program_("board", {card_vertex_glsl}, {card_fragment_glsl}),
      text_vertices_(gl::vertexArray()),
      no_vertices_(gl::vertexArray()),
      copy_target_(gl::framebuffer()) {
    const ContextScope scope(ImGui::GetCurrentContext());  // making one may change the current one
    context_.reset(ImGui::CreateContext(&fonts_.atlas()));
    ImGui::SetCurrentContext(context_.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;

    const GLuint vao = text_vertices_.name();
    glVertexArrayAttribFormat(vao, 0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
    glVertexArrayAttribFormat(vao, 1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
    glVertexArrayAttribFormat(vao, 2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
    for (GLuint attribute = 0; attribute < 3; ++attribute) {
        glVertexArrayAttribBinding(vao, attribute, 0);
        glEnableVertexArrayAttrib(vao, attribute);
    }
}

std::size_t BoardPass::find(const Board& board) const {
    const auto same = [&](const Card& card) { return sameContent(card.content, board); };
    return static_cast<std::size_t>(std::find_if(cards_.begin(), cards_.end(), same) - cards_.begin());
}

const BoardPass::Card& BoardPass::painted(const Board& board) const {
    const std::size_t place = find(board);
    if (place == cards_.size()) throw std::logic_error("a board that was not painted cannot be shown");
    return cards_[place];
}

// One that this call of paint() has not asked for: rather of the wanted size (what a slider's board looked
// like before it was dragged on) than the one that has not been asked for for longest.
BoardPass::Card& BoardPass::freeCard(const Resolution& wanted) {
    Card* best = nullptr;
    const auto fits = [&](const Card& card) {
        return card.at.width == wanted.width && card.at.height == wanted.height;
    };
    for (Card& card : cards_) {
        if (card.last_paint == calls_) continue;
        const bool better = best == nullptr || (fits(card) && !fits(*best)) ||
                            (fits(card) == fits(*best) && card.last_paint < best->last_paint);
        if (better) best = &card;
    }
    const bool replaces = best != nullptr && (fits(*best) || cards_.size() >= kept_cards);
    return replaces ? *best : cards_.emplace_back();
}

void BoardPass::paint(std::span<const Board> boards) {
    ++calls_;
    for (const Board& board : boards)
        if (const std::size_t place = find(board); place < cards_.size()) cards_[place].last_paint = calls_;
    for (const Board& board : boards)
        if (find(board) == cards_.size()) paint(board, freeCard(resolution(board)));
}

void BoardPass::paint(const Board& board, Card& card) {
    const ContextScope scope(context_.get());
    makeTexture(resolution(board), card);
    const bool fonts_are_new = requireBoardFonts(board, card.at.pixels_per_metre, fonts_);
    if (fonts_are_new || font_texture_.name() == 0U) uploadFonts();  // plain shapes are drawn with it too

    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(card.at.width), static_cast<float>(card.at.height));
    ImGui::NewFrame();
    paintBoard(board, card.at.pixels_per_metre, fonts_, *ImGui::GetBackgroundDrawList());
    ImGui::Render();
    drawLists(*ImGui::GetDrawData(), card);
    glGenerateTextureMipmap(card.picture.name());
    card.content = board;
    card.last_paint = calls_;
    ++paints_;
}

BoardPass::Resolution BoardPass::resolution(const Board& board) const {
    const double larger_m = std::max({board.width_m, board.height_m, 0.01});
    Resolution found;
    found.pixels_per_metre =
        std::min(wanted_pixels_per_metre_, (max_texture_pixels - 2 * card_margin_px) / larger_m);
    const auto pixels = [&](double metres) {
        return std::max(1, static_cast<int>(std::ceil(metres * found.pixels_per_metre))) + 2 * card_margin_px;
    };
    found.width = pixels(board.width_m);
    found.height = pixels(board.height_m);
    return found;
}

BoardCorners BoardPass::corners(const Board& board) const {
    const Resolution picture = resolution(board);
    const double margin_m = card_margin_px / picture.pixels_per_metre;
    // The texture ends on whole pixels: its lower edge may lie a part of one below the board's.
    return {{-margin_m, board.height_m + margin_m - picture.height / picture.pixels_per_metre},
            {picture.width / picture.pixels_per_metre - margin_m, board.height_m + margin_m}};
}

std::array<int, 2> BoardPass::size(const Board& board) const {
    const Resolution picture = resolution(board);
    return {picture.width, picture.height};
}

void BoardPass::makeTexture(const Resolution& wanted, Card& card) {
    const bool same_size = wanted.width == card.at.width && wanted.height == card.at.height;
    card.at = wanted;
    if (same_size) return;
    const auto [pixels_per_metre, width, height] = wanted;
    const int levels = 1 + static_cast<int>(std::log2(std::max(width, height)));
    card.picture = gl::texture2d(GL_SRGB8_ALPHA8, width, height, levels);
    const GLuint picture = card.picture.name();
    glTextureParameteri(picture, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(picture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    GLfloat max = 1.0F;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &max);
    glTextureParameterf(picture, GL_TEXTURE_MAX_ANISOTROPY, std::min(max, 8.0F));
    card.target = gl::framebuffer();
    glNamedFramebufferTexture(card.target.name(), GL_COLOR_ATTACHMENT0, picture, 0);
    gl::requireComplete(card.target, "board");
}

void BoardPass::uploadFonts() {
    unsigned char* coverage = nullptr;
    int width = 0;
    int height = 0;
    fonts_.atlas().GetTexDataAsAlpha8(&coverage, &width, &height);
    font_texture_ = gl::texture2d(GL_R8, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(font_texture_.name(), 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, coverage);
    glTextureParameteri(font_texture_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(font_texture_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

void BoardPass::drawLists(const ImDrawData& data, const Card& card) {
    const std::array<GLfloat, 4> clear{0.0F, 0.0F, 0.0F, 0.0F};
    glClearNamedFramebufferfv(card.target.name(), GL_COLOR, 0, clear.data());
    glBindFramebuffer(GL_FRAMEBUFFER, card.target.name());
    glViewport(0, 0, card.at.width, card.at.height);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(text_program_.name());
    glUniform2f(0, static_cast<float>(card.at.width), static_cast<float>(card.at.height));
    glBindTextureUnit(0, font_texture_.name());
    glBindVertexArray(text_vertices_.name());
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        const gl::Buffer vertices = gl::fixedBuffer(
            std::span<const ImDrawVert>(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size)));
        const gl::Buffer indices = gl::fixedBuffer(
            std::span<const ImDrawIdx>(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size)));
        glVertexArrayVertexBuffer(text_vertices_.name(), 0, vertices.name(), 0, sizeof(ImDrawVert));
        glVertexArrayElementBuffer(text_vertices_.name(), indices.name());
        for (const ImDrawCmd& command : list.CmdBuffer)
            glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                     sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                     reinterpret_cast<const void*>(
                                         static_cast<std::uintptr_t>(command.IdxOffset) * sizeof(ImDrawIdx)),
                                     static_cast<GLint>(command.VtxOffset));
    }
    glDisable(GL_BLEND);
}

void BoardPass::draw(const Board& board, Views views) {
    const Card& card = painted(board);
    const glm::mat4 stage_from_board = matrixFromPose(board.stage_from_board);
    const BoardCorners rect = corners(board);
    card_program_.use(views);
    glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(stage_from_board));
    glUniform4f(1, static_cast<float>(rect.low.x), static_cast<float>(rect.low.y),
                static_cast<float>(rect.high.x), static_cast<float>(rect.high.y));
    glBindTextureUnit(0, card.picture.name());
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void BoardPass::copyTo(const Board& board, GLuint texture) const {
    const Card& card = painted(board);
    const auto [pixels_per_metre, width, height] = card.at;
    glNamedFramebufferTexture(copy_target_.name(), GL_COLOR_ATTACHMENT0, texture, 0);
    gl::requireComplete(copy_target_, "board's copy");
    // The card's first row is the board's top. With conversion off the bytes go over as they are.
    glDisable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(card.target.name(), copy_target_.name(), 0, 0, width, height, 0, height, width, 0,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glNamedFramebufferTexture(copy_target_.name(), GL_COLOR_ATTACHMENT0, 0, 0);
}

}  // namespace deixis::renderer
