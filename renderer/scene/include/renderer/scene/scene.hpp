// What to draw, as plain data. Knows nothing of studies.
#pragma once

#include <cstddef>
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
    int rings = 0;         ///< bright ones around it, up to two, whoever looks: told apart without colours
};

/// A thin glowing tube.
struct Beam {
    Ray ray{};
    double length_m = 5.0;
    glm::vec3 colour{1.0F, 0.1F, 0.05F};
};

/// A way that was gone: a thin glowing line from point to point, oldest first, which fades towards its start.
struct Trail {
    std::vector<Vec3> points;
    glm::vec3 colour{0.20F, 0.55F, 0.95F};
};

/// A participant's head seen from outside: a plain head with a headset on, which shows where it looks.
struct HeadMarker {
    Pose stage_from_head{};  ///< between the eyes; -z looks forward, +y up
    glm::vec3 colour{0.55F, 0.62F, 0.68F};
};

/// A board with text in the world; drawn with the text library at a resolution that keeps it sharp on screen.
/// Rectangles are in metres from its lower left corner, y up.
struct BoardRect {
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    friend bool operator==(const BoardRect&, const BoardRect&) = default;
};
struct BoardText {
    BoardRect box{};
    std::string text;  ///< UTF-8; a line for each line feed, from the box's top; shrunk (to 60 %) to fit it
    double size_m = 0.04;  ///< height of a line
    bool bold = false;
    bool centred = false;  ///< across the box
    bool faint = false;
    bool level = false;  ///< in the middle of the box's height
    friend bool operator==(const BoardText&, const BoardText&) = default;
};
/// What a button does, which its look tells beside its label.
enum class ButtonLook : unsigned char {
    plain,
    go_on,   ///< filled: the way on
    leave,   ///< an outline only
    play,    ///< a triangle beside the label
    option,  ///< one of several
};
struct BoardButton {
    BoardRect box{};
    std::string label;
    std::string caption{};
    bool enabled = true;
    bool hovered = false;
    bool chosen = false;  ///< marked by colour, and by a tick where it is an option
    ButtonLook look = ButtonLook::plain;
    friend bool operator==(const BoardButton&, const BoardButton&) = default;
};
/// A track with a thumb. Each label has a tick: the first at the track's start, the last at its end; its
/// lines are separated by line feeds.
struct BoardSlider {
    BoardRect box{};
    BoardRect track{};
    std::optional<double> value{};  ///< 0..1 along the track; none: no thumb
    std::vector<std::string> labels{};
    double label_size_m = 0.036;  ///< height of a line
    bool enabled = true;
    bool hovered = false;
    friend bool operator==(const BoardSlider&, const BoardSlider&) = default;
};
/// What is typed, in as many lines as fit the box; what is too long loses its beginning.
struct BoardField {
    BoardRect box{};
    std::string text{};
    std::string hint{};   ///< shown while there is no text
    bool active = false;  ///< shows a caret
    bool enabled = true;
    bool hovered = false;
    friend bool operator==(const BoardField&, const BoardField&) = default;
};
struct Board {
    Pose stage_from_board{};  ///< origin at the lower left corner, +x to the reader's right, +z towards the
                              ///< reader
    double width_m = 1.0;
    double height_m = 0.5;
    std::vector<BoardText> texts;
    std::vector<BoardButton> buttons;
    std::vector<BoardSlider> sliders{};
    std::vector<BoardField> fields{};
    double progress = -1.0;  ///< 0..1 draws a bar along the foot
};

/// Whether two boards look the same, wherever they stand.
[[nodiscard]] inline bool sameContent(const Board& a, const Board& b) {
    return a.width_m == b.width_m && a.height_m == b.height_m && a.texts == b.texts &&
           a.buttons == b.buttons && a.sliders == b.sliders && a.fields == b.fields &&
           a.progress == b.progress;
}

/// As many avatars as cast shadows and are drawn.
constexpr std::size_t max_avatars = 2;

struct Scene {
    Camera camera{};
    /// Of each avatar stage_from_joint, in the avatar's skeleton order: one mesh in up to max_avatars poses.
    std::vector<std::vector<Pose>> avatars{};
    std::vector<Ball> balls{};
    std::vector<Beam> beams{};
    std::vector<Trail> trails{};
    std::vector<HeadMarker> heads{};
    std::vector<Board> boards{};
};

}  // namespace deixis::renderer
