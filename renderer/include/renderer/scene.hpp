// What to draw, as plain data. Knows nothing of studies.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/pose.hpp"

namespace deixis::renderer {

struct Camera {
    Pose stage_from_eye{};  ///< -z looks forward, +y up
    double vertical_fov_rad = radiansFromDegrees(60.0);
    double near_m = 0.05;
    double far_m = 60.0;
};

/// A matte ball. Colours are linear.
struct Ball {
    Vec3 centre{0.0};
    double radius_m = 0.06;
    glm::vec3 colour{0.02F};
    glm::vec3 glow{0.0F};  ///< emitted light, for hover and choice
};

/// A thin glowing tube.
struct Beam {
    Ray ray{};
    double length_m = 5.0;
    glm::vec3 colour{1.0F, 0.1F, 0.05F};
};

/// A board with text in the world; drawn with the text library at a resolution that keeps it sharp on screen.
/// Rectangles are in metres from its lower left corner, y up.
struct BoardRect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    friend bool operator==(const BoardRect&, const BoardRect&) = default;
};
struct BoardText {
    BoardRect box{};
    std::string text;  ///< UTF-8; wrapped to the box's width from its top, shrunk (to 60 %) to fit its height
    double size_m = 0.04;  ///< height of a line
    bool bold = false;
    bool centred = false;  ///< across the box
    bool faint = false;
    friend bool operator==(const BoardText&, const BoardText&) = default;
};
struct BoardButton {
    BoardRect box{};
    std::string label;
    std::string caption{};
    bool enabled = true;
    bool hovered = false;
    friend bool operator==(const BoardButton&, const BoardButton&) = default;
};
struct Board {
    Pose stage_from_board{};  ///< origin at the lower left corner, +x to the reader's right, +z towards the
                              ///< reader
    double width_m = 1.0;
    double height_m = 0.5;
    std::vector<BoardText> texts;
    std::vector<BoardButton> buttons;
    double progress = -1.0;  ///< 0..1 draws a bar along the foot
};

/// Whether two boards look the same, wherever they stand.
[[nodiscard]] inline bool sameContent(const Board& a, const Board& b) {
    return a.width_m == b.width_m && a.height_m == b.height_m && a.texts == b.texts &&
           a.buttons == b.buttons && a.progress == b.progress;
}

struct Scene {
    Camera camera{};
    bool avatar_visible = true;
    std::vector<Pose> avatar_joints;  ///< stage_from_joint, in the avatar's skeleton order
    std::vector<Ball> balls;
    std::optional<Beam> beam;
    std::optional<Board> board;
};

}  // namespace deixis::renderer
