// Textures for two eyes, what was drawn into them, and where a point of the stage lies in an eye's picture.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <stdexcept>
#include <string>

#include "gl_fixture.hpp"
#include "skipping.hpp"

namespace deixis::tests {

/// One layer, rows from the top.
struct EyePicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
    std::vector<float> depth;

    [[nodiscard]] std::size_t at(int x, int y) const {
        if (x < 0 || x >= width || y < 0 || y >= height) throw std::out_of_range("beside the picture");
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] Bytes colour(int x, int y) const {
        const std::size_t i = at(x, y) * 4;
        return {rgba[i], rgba[i + 1], rgba[i + 2]};
    }
    [[nodiscard]] int alpha(int x, int y) const { return rgba[at(x, y) * 4 + 3]; }
    [[nodiscard]] renderer::Image image() const {
        renderer::Image image{width, height, {}};
        for (std::size_t i = 0; i < rgba.size(); ++i)
            if (i % 4 != 3) image.rgb.push_back(rgba[i]);
        return image;
    }
};

template <typename T>
std::vector<T> flipped(const std::vector<T>& rows, std::size_t row_length) {
    std::vector<T> out;
    out.reserve(rows.size());
    for (std::size_t end = rows.size(); end > 0; end -= row_length)
        out.insert(out.end(), rows.begin() + static_cast<std::ptrdiff_t>(end - row_length),
                   rows.begin() + static_cast<std::ptrdiff_t>(end));
    return out;
}

/// The textures that a headset's runtime would lend. The context must outlive them.
class StereoTextures {
  public:
    StereoTextures(int width, int height) : target_{{}, {}, width, height} {
        glCreateTextures(GL_TEXTURE_2D, 2, target_.colour.data());
        glCreateTextures(GL_TEXTURE_2D, 2, target_.depth.data());
        for (std::size_t eye = 0; eye < 2; ++eye) {
            glTextureStorage2D(target_.colour[eye], 1, GL_SRGB8_ALPHA8, width, height);
            glTextureStorage2D(target_.depth[eye], 1, GL_DEPTH_COMPONENT32F, width, height);
        }
    }
    StereoTextures(const StereoTextures&) = delete;
    StereoTextures& operator=(const StereoTextures&) = delete;
    ~StereoTextures() {
        glDeleteTextures(2, target_.colour.data());
        glDeleteTextures(2, target_.depth.data());
    }
    [[nodiscard]] const renderer::StereoTarget& target() const { return target_; }

    /// 0: left.
    [[nodiscard]] EyePicture read(int eye) const {
        const int width = target_.width;
        const int height = target_.height;
        const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        std::vector<std::uint8_t> rgba(pixels * 4);
        std::vector<float> depth(pixels);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        const auto side = static_cast<std::size_t>(eye);
        glGetTextureImage(target_.colour[side], 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(rgba.size()), rgba.data());
        glGetTextureImage(target_.depth[side], 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                          static_cast<GLsizei>(pixels * sizeof(float)), depth.data());
        REQUIRE(glGetError() == static_cast<GLenum>(GL_NO_ERROR));
        const auto row = static_cast<std::size_t>(width);
        return {width, height, flipped(rgba, row * 4), flipped(depth, row)};
    }

  private:
    renderer::StereoTarget target_;
};

/// Calls `test` for every way of drawing that the driver has: with four samples and with one, in two passes
/// and with multiview (which some drivers have for one sample only). Says where that is left out.
template <typename Test>
void inEachWay(const Test& test, const assets::Avatar& avatar = postAvatar()) {
    for (const int samples : {4, 1}) {
        Gl gl(samples, avatar);
        CAPTURE(samples);
        for (const renderer::StereoMode mode :
             {renderer::StereoMode::two_passes, renderer::StereoMode::multiview}) {
            const bool multiview = mode == renderer::StereoMode::multiview;
            if (multiview && !gl.renderer->hasMultiview()) {
                deixis::tests::tellSkipped("no multiview with " + std::to_string(samples) + " samples from " +
                                           gl.renderer->driver());
                continue;
            }
            CAPTURE(multiview);
            test(*gl.renderer, mode);
        }
    }
}

/// A texture for the board's copy, x from the left, y from the foot.
class BoardTexture {
  public:
    static constexpr int untouched = 77;
    BoardTexture(int width, int height) : width_(width), height_(height) {
        glCreateTextures(GL_TEXTURE_2D, 1, &name_);
        glTextureStorage2D(name_, 1, GL_SRGB8_ALPHA8, width, height);
        const std::array<std::uint8_t, 4> fill{untouched, untouched, untouched, untouched};
        glClearTexImage(name_, 0, GL_RGBA, GL_UNSIGNED_BYTE, fill.data());
    }
    BoardTexture(const BoardTexture&) = delete;
    BoardTexture& operator=(const BoardTexture&) = delete;
    ~BoardTexture() { glDeleteTextures(1, &name_); }
    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] Bytes at(int x, int y) const {
        const std::array<std::uint8_t, 4> p = texel(x, y);
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] int alpha(int x, int y) const { return texel(x, y)[3]; }

  private:
    [[nodiscard]] std::array<std::uint8_t, 4> texel(int x, int y) const {
        if (x < 0 || x >= width_ || y < 0 || y >= height_) throw std::out_of_range("beside the texture");
        std::array<std::uint8_t, 4> out{};
        glGetTextureSubImage(name_, 0, x, y, 0, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, out.size(), out.data());
        return out;
    }
    int width_;
    int height_;
    GLuint name_ = 0;
};

/// A framebuffer like a window's: bytes without a colour space, no alpha.
class Window {
  public:
    Window(int width, int height) : width_(width), height_(height) {
        glCreateRenderbuffers(1, &pixels_);
        glNamedRenderbufferStorage(pixels_, GL_RGB8, width, height);
        glCreateFramebuffers(1, &name_);
        glNamedFramebufferRenderbuffer(name_, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_);
        const std::array<GLfloat, 4> grey{0.5F, 0.5F, 0.5F, 1.0F};
        glClearNamedFramebufferfv(name_, GL_COLOR, 0, grey.data());
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window() {
        glDeleteFramebuffers(1, &name_);
        glDeleteRenderbuffers(1, &pixels_);
    }
    [[nodiscard]] GLuint name() const { return name_; }
    [[nodiscard]] renderer::Image read() const {
        const std::size_t row = static_cast<std::size_t>(width_) * 3;
        std::vector<std::uint8_t> rgb(row * static_cast<std::size_t>(height_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, name_);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        return {width_, height_, flipped(rgb, row)};
    }

  private:
    int width_;
    int height_;
    GLuint name_ = 0;
    GLuint pixels_ = 0;
};

/// The view of a symmetric camera for pictures of this shape.
inline renderer::EyeFov fovOf(const renderer::Camera& camera, int width, int height) {
    const double up_rad = 0.5 * camera.vertical_fov_rad;
    const double right_rad = std::atan(std::tan(up_rad) * width / height);
    return {-right_rad, right_rad, up_rad, -up_rad};
}

/// Two eyes beside the camera's place, half of `distance_m` to each side.
inline renderer::Eyes eyesOf(const renderer::Camera& camera, const renderer::EyeFov& fov, double distance_m) {
    const Vec3 right = camera.stage_from_eye.orientation * Vec3(0.5 * distance_m, 0.0, 0.0);
    renderer::Eyes eyes{renderer::Eye{camera.stage_from_eye, fov}, renderer::Eye{camera.stage_from_eye, fov}};
    eyes[0].stage_from_eye.position -= right;
    eyes[1].stage_from_eye.position += right;
    return eyes;
}

/// Where a point of the stage lies in an eye's picture, pixels from the top left corner; from the tangents
/// alone.
inline glm::dvec2 project(const renderer::Eye& eye, const Vec3& point, int width, int height) {
    const Vec3 seen = transformPoint(inverse(eye.stage_from_eye), point);
    const double left = std::tan(eye.fov.left_rad);
    const double right = std::tan(eye.fov.right_rad);
    const double up = std::tan(eye.fov.up_rad);
    const double down = std::tan(eye.fov.down_rad);
    return {width * (seen.x / -seen.z - left) / (right - left),
            height * (up - seen.y / -seen.z) / (up - down)};
}

/// The middle of the pixels that are clearly green and not grey.
inline glm::dvec2 middleOfGreen(const EyePicture& picture) {
    glm::dvec2 sum(0.0);
    int count = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Bytes c = picture.colour(x, y);
            if (c.g < 2 * std::max(c.r, c.b) || c.g < 100) continue;
            sum += glm::dvec2(x + 0.5, y + 0.5);
            ++count;
        }
    REQUIRE(count > 0);
    return sum / static_cast<double>(count);
}

/// A ball that middleOfGreen() finds.
inline renderer::Ball greenBall(const Vec3& centre, double radius_m) {
    return {centre, radius_m, glm::vec3(0.0F), {0.0F, 0.6F, 0.0F}};
}

/// Avatars, balls, a ring, a beam, a trail and a head.
inline renderer::Scene fullScene() {
    renderer::Scene scene = emptyScene();
    scene.avatars = {postPose(), postPose()};
    for (Pose& joint : scene.avatars[1]) joint.position += Vec3(-0.9, 0.0, -0.4);
    scene.trails = {{{{-0.7, 1.6, 0.9}, {-0.3, 1.7, 0.8}, {0.2, 1.6, 0.7}}, {0.1F, 0.3F, 1.0F}}};
    scene.heads = {{{{0.75, 1.5, 0.3}, yawRotation(0.6)}, glm::vec3(0.5F)}};
    scene.balls = {{{0.5, 1.3, 0.4}, 0.1, glm::vec3(0.9F), {}},
                   {{-0.4, 1.1, 0.9}, 0.08, glm::vec3(0.02F), {}, true}};
    scene.beams = {{{{0.3, 1.2, 2.4}, glm::normalize(Vec3(0.2, 0.1, -2.0))}, 1.9, {1.0F, 0.1F, 0.05F}}};
    return scene;
}

struct Difference {
    double mean = 0.0;       ///< of all bytes
    double off_share = 0.0;  ///< of bytes that differ by more than 4
};

inline Difference difference(const renderer::Image& a, const renderer::Image& b) {
    REQUIRE(a.rgb.size() == b.rgb.size());
    Difference found;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        const int off = std::abs(int{a.rgb[i]} - int{b.rgb[i]});
        found.mean += off;
        if (off > 4) found.off_share += 1.0;
    }
    found.mean /= static_cast<double>(a.rgb.size());
    found.off_share /= static_cast<double>(a.rgb.size());
    return found;
}

}  // namespace deixis::tests
