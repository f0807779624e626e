// Ways to look at a part of a board in a picture.
#pragma once

#include "gl_fixture.hpp"

namespace deixis::tests {

constexpr int board_picture_width = 640;
constexpr int board_picture_height = 360;

struct Region {
    int darkest = 255, brightest = 0;
    double mean = 0.0;
    double yellow = 0.0;  ///< mean of red less blue
};

/// Green bytes over a rectangle of one of the scene's boards.
inline Region region(const renderer::Image& image, const renderer::Scene& scene,
                     const renderer::BoardRect& box, std::size_t board = 0) {
    const Pose& pose = scene.boards.at(board).stage_from_board;
    const auto [x0, y1] =
        project(scene.camera, transformPoint(pose, {box.x, box.y, 0.0}), image.width, image.height);
    const auto [x1, y0] =
        project(scene.camera, transformPoint(pose, {box.x + box.width, box.y + box.height, 0.0}), image.width,
                image.height);
    Region found;
    int count = 0;
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
            const Bytes bytes = pixel(image, x, y);
            found.darkest = std::min(found.darkest, bytes.g);
            found.brightest = std::max(found.brightest, bytes.g);
            found.mean += bytes.g;
            found.yellow += bytes.r - bytes.b;
            ++count;
        }
    found.mean /= count;
    found.yellow /= count;
    return found;
}

/// One bare board of 1 x 0.5 m, upright before the camera.
inline renderer::Scene bareBoardScene() {
    renderer::Scene scene = emptyScene();
    scene.camera = lookingFrom({0.0, 1.2, 2.3}, {0.0, 1.2, 0.0});
    renderer::Board board;
    board.stage_from_board.position = Vec3(-0.5, 0.95, 1.6);
    scene.boards = {board};
    return scene;
}

inline renderer::Image boardPicture(Gl& gl, const renderer::Scene& scene) {
    return gl.renderer->capture(scene, board_picture_width, board_picture_height);
}

}  // namespace deixis::tests
