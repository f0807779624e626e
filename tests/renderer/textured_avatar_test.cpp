// Avatars with textures, holes and sides.
#include "stereo_fixture.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

/// A board of 1 x 1 m before the origin, 1.2 m up at its middle, facing +z: texels red, green; blue and a
/// hole in the lower right. Beside it to the left (+x) a plain yellow board.
assets::Avatar signAvatar(bool double_sided) {
    assets::Avatar avatar;
    avatar.skeleton.joints.push_back({"hips", -1, {}, {}});
    avatar.humanoid[motion::Bone::hips] = 0;
    avatar.joint_from_bind = {{}};
    for (const float left : {-0.5F, 0.6F})
        for (const float y : {1.0F, 0.0F})
            for (const float x : {0.0F, 1.0F}) {
                assets::SkinnedVertex v;
                v.position = {left + x, 0.7F + y, 0.0F};
                v.normal = {0.0F, 0.0F, 1.0F};
                v.colour = left > 0.0F ? glm::vec3(0.6F, 0.6F, 0.02F) : glm::vec3(1.0F);
                v.weights[0] = 1.0F;
                v.uv = {x, 1.0F - y};
                avatar.vertices.push_back(v);
            }
    for (const std::uint32_t first : {0U, 4U})
        for (const std::uint32_t i : {0U, 2U, 1U, 1U, 2U, 3U}) avatar.indices.push_back(first + i);
    avatar.parts = {{0, 6, 0, 0.5F, double_sided}, {6, 6, -1, 0.0F, false}};
    assets::AvatarTexture texture;
    texture.width = texture.height = 2;
    texture.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 0};
    texture.wrap_u = texture.wrap_v = assets::TextureWrap::clamp;
    texture.nearest = true;
    avatar.textures.push_back(texture);
    return avatar;
}

const Vec3 red(-0.25, 1.45, 0.0), green(0.25, 1.45, 0.0), blue(-0.25, 0.95, 0.0), hole(0.25, 0.95, 0.0),
    yellow(1.1, 1.2, 0.0);

bool isColour(const Bytes& c, bool r, bool g, bool b) {
    const auto strong = [](int value, bool wanted) { return wanted ? value > 90 : value < 70; };
    return strong(c.r, r) && strong(c.g, g) && strong(c.b, b);
}

Scene signScene(const Vec3& from) {
    Scene scene;
    scene.camera = lookingFrom(from, {0.3, 1.2, 0.0});
    return scene;
}

}  // namespace

TEST_SUITE("renderer/textured_avatar") {
    TEST_CASE("Texels lie where their coordinates say, and one of no alpha is a hole") {
        Gl gl(1, signAvatar(false));
        Scene scene = signScene({0.3, 1.2, 3.0});
        const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
        scene.avatars = {{Pose{}}};
        const Image image = gl.renderer->capture(scene, picture_width, picture_height);
        const auto at = [&](const Vec3& p) { return pixelAt(image, scene.camera, p); };
        CHECK(isColour(at(red), true, false, false));
        CHECK(isColour(at(green), false, true, false));
        CHECK(isColour(at(blue), false, false, true));
        CHECK(isColour(at(yellow), true, true, false));
        CHECK(std::abs(at(hole).sum() - pixelAt(empty, scene.camera, hole).sum()) < 60);
        CHECK(at(hole).b > 70);
    }

    TEST_CASE(
        "From behind, a board is seen where it has two sides, lit on that side, and not where it has one") {
        for (const bool double_sided : {false, true}) {
            CAPTURE(double_sided);
            Gl gl(1, signAvatar(double_sided));
            Scene scene = signScene({0.3, 1.2, -3.0});
            const Image empty = gl.renderer->capture(scene, picture_width, picture_height);
            scene.avatars = {{Pose{}}};
            const Image image = gl.renderer->capture(scene, picture_width, picture_height);
            CHECK(isColour(pixelAt(image, scene.camera, red), true, false, false) == double_sided);
            // The plain board has one side.
            CHECK(std::abs(pixelAt(image, scene.camera, yellow).sum() -
                           pixelAt(empty, scene.camera, yellow).sum()) < 60);
        }
    }

    TEST_CASE("Both eyes see the texture, in either way of drawing") {
        inEachWay(
            [](Renderer& drawing, StereoMode mode) {
                Scene scene = signScene({0.3, 1.2, 3.0});
                scene.avatars = {{Pose{}}};
                const Eyes eyes =
                    eyesOf(scene.camera, fovOf(scene.camera, picture_width, picture_height), 0.064);
                const StereoTextures textures(picture_width, picture_height);
                drawing.drawStereo(scene, eyes, textures.target(), mode);
                for (int eye = 0; eye < 2; ++eye) {
                    CAPTURE(eye);
                    Scene alone = scene;
                    alone.camera.stage_from_eye = eyes[static_cast<std::size_t>(eye)].stage_from_eye;
                    const Image expected = drawing.capture(alone, picture_width, picture_height);
                    CHECK(isColour(pixelAt(expected, alone.camera, green), false, true, false));
                    const Difference off = difference(textures.read(eye).image(), expected);
                    CHECK(off.mean < 0.05);
                    CHECK(off.off_share < 0.001);
                }
            },
            signAvatar(true));
    }
}
