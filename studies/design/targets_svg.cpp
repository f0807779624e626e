// The picture of the targets: perspective, from above, from the side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

#include "studies/design/targets.hpp"

namespace deixis::studies {

namespace {

constexpr double page_width = 1200.0;
constexpr double page_height = 720.0;
constexpr double avatar_height_m = 1.75;
constexpr std::string_view target_colour = "#d1263c";
constexpr std::string_view edge = "stroke=\"#8a94a0\" stroke-width=\"1\" stroke-dasharray=\"4 3\"";
constexpr std::string_view demonstration_colour = "#2468b2";

struct Point {
    double x = 0.0, y = 0.0;
};

struct Box {
    double left = 0.0, top = 0.0, width = 0.0, height = 0.0;
};

struct Ball {
    Vec3 centre{0.0};
    bool demonstration = false;
};

/// What the picture is of.
struct Scene {
    const TargetSpace& space;
    double ball_radius_m;
    std::vector<Ball> balls;
    Vec3 low{0.0}, high{0.0};  ///< a box around everything, the avatar included
};

Vec3 onCylinder(double radius_m, double azimuth_deg, double height_m) {
    const double azimuth = radiansFromDegrees(azimuth_deg);
    return {radius_m * std::sin(azimuth), height_m, radius_m * std::cos(azimuth)};
}

/// Items that come from a manifest need none.
bool hasRanges(const TargetSpace& space) {
    return space.radius_m.high > 0.0;
}

/// Points along an arc at one height, close enough to look round.
std::vector<Vec3> arcPoints(const TargetSpace& space, double radius_m, double height_m) {
    constexpr double step_deg = 3.0;
    const double span = space.arc_deg.high - space.arc_deg.low;
    const int steps = std::max(1, static_cast<int>(std::ceil(span / step_deg)));
    std::vector<Vec3> out;
    for (int i = 0; i <= steps; ++i)
        out.push_back(onCylinder(radius_m, space.arc_deg.low + span * i / steps, height_m));
    return out;
}

Scene makeScene(const TargetSpace& space, const std::vector<TargetItem>& targets,
                const std::vector<Vec3>& demonstrations) {
    Scene scene{space, space.ball_diameter_m / 2, {}, Vec3(-0.4, 0.0, -0.4), Vec3(0.4, avatar_height_m, 0.4)};
    const auto include = [&](const Vec3& point) {
        const Vec3 margin(scene.ball_radius_m);
        scene.low = glm::min(scene.low, point - margin);
        scene.high = glm::max(scene.high, point + margin);
    };
    if (hasRanges(space))
        for (const double height : {space.height_m.low, space.height_m.high})
            for (const Vec3& point : arcPoints(space, space.radius_m.high, height)) include(point);
    for (const Vec3& position : demonstrations) scene.balls.push_back({position, true});
    for (const TargetItem& item : targets)
        if (item.placed) scene.balls.push_back({item.target, false});
    for (const Ball& ball : scene.balls) include(ball.centre);
    scene.low.y = 0.0;
    return scene;
}

template <typename Project>
std::string polyline(const std::vector<Vec3>& points, const Project& project, std::string_view style) {
    std::string out = "<polyline points=\"";
    for (const Vec3& point : points) {
        const Point at = project(point);
        out += fmt::format("{:.1f},{:.1f} ", at.x, at.y);
    }
    out.back() = '"';
    return out + fmt::format(" fill=\"none\" {}/>\n", style);
}

std::string circle(const Point& at, double radius, std::string_view style) {
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", at.x, at.y, radius, style);
}

std::string text(const Point& at, std::string_view words, std::string_view style = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", at.x, at.y, style, words);
}

/// A camera before the avatar, above and to one side, fitted to a box on the page.
class Camera {
  public:
    Camera(const Scene& scene, const Box& box) {
        constexpr double turn_deg = 17.0;   // to the avatar's left of straight ahead
        constexpr double raise_deg = 25.0;  // above the horizon
        const Vec3 centre = 0.5 * (scene.low + scene.high);
        const double size = glm::length(scene.high - scene.low);
        const double raise = radiansFromDegrees(raise_deg);
        const Vec3 back(std::cos(raise) * std::sin(radiansFromDegrees(turn_deg)), std::sin(raise),
                        std::cos(raise) * std::cos(radiansFromDegrees(turn_deg)));
        back_ = back;
        eye_ = centre + 1.8 * size * back;
        right_ = glm::normalize(glm::cross(up, back));
        up_ = glm::cross(back, right_);

        Point min{1e9, 1e9};
        Point max{-1e9, -1e9};
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 point((corner & 1) != 0 ? scene.high.x : scene.low.x,
                             (corner & 2) != 0 ? scene.high.y : scene.low.y,
                             (corner & 4) != 0 ? scene.high.z : scene.low.z);
            const Point at = (*this)(point);
            min = {std::min(min.x, at.x), std::min(min.y, at.y)};
            max = {std::max(max.x, at.x), std::max(max.y, at.y)};
        }
        scale_ = std::min(box.width / (max.x - min.x), box.height / (max.y - min.y));
        origin_ = {box.left + 0.5 * box.width - scale_ * 0.5 * (min.x + max.x),
                   box.top + 0.5 * box.height - scale_ * 0.5 * (min.y + max.y)};
    }

    [[nodiscard]] double depth(const Vec3& point) const { return glm::dot(eye_ - point, back_); }
    [[nodiscard]] double pixelsPerMetre(const Vec3& point) const { return scale_ / depth(point); }
    [[nodiscard]] Point operator()(const Vec3& point) const {
        const double by = pixelsPerMetre(point);
        return {origin_.x + by * glm::dot(point - eye_, right_),
                origin_.y - by * glm::dot(point - eye_, up_)};
    }

  private:
    Vec3 eye_{0.0}, right_{0.0}, up_{0.0}, back_{0.0};
    double scale_ = 1.0;
    Point origin_{};
};

std::string floorGrid(const Scene& scene, const Camera& camera) {
    constexpr double step_m = 0.5;
    const auto steps = [&](double value) { return static_cast<int>(std::lround(value / step_m)); };
    const int x0 = steps(std::floor(scene.low.x / step_m) * step_m);
    const int x1 = steps(std::ceil(scene.high.x / step_m) * step_m);
    const int z0 = steps(std::floor(scene.low.z / step_m) * step_m);
    const int z1 = steps(std::ceil(scene.high.z / step_m) * step_m);
    std::string out;
    constexpr std::string_view style = "stroke=\"#d9dde2\" stroke-width=\"1\"";
    for (int x = x0; x <= x1; ++x)
        out += polyline({{x * step_m, 0.0, z0 * step_m}, {x * step_m, 0.0, z1 * step_m}}, camera, style);
    for (int z = z0; z <= z1; ++z)
        out += polyline({{x0 * step_m, 0.0, z * step_m}, {x1 * step_m, 0.0, z * step_m}}, camera, style);
    return out;
}

/// A standing figure that faces +z, and an arrow on the floor that says so.
std::string avatarFigure(const Camera& camera) {
    constexpr std::string_view limb =
        "stroke=\"#6b7480\" stroke-width=\"9\" stroke-linecap=\"round\" stroke-linejoin=\"round\"";
    constexpr std::string_view arrow = "stroke=\"#6b7480\" stroke-width=\"2.5\" stroke-linecap=\"round\"";
    std::string out = polyline({{0.0, 0.0, 0.2}, {0.0, 0.0, 0.8}}, camera, arrow);
    out += polyline({{-0.1, 0.0, 0.66}, {0.0, 0.0, 0.8}, {0.1, 0.0, 0.66}}, camera, arrow);
    for (const double side : {-1.0, 1.0}) {
        out += polyline({{side * 0.1, 0.0, 0.0}, {side * 0.1, 0.9, 0.0}}, camera, limb);
        out += polyline({{side * 0.2, 1.4, 0.0}, {side * 0.24, 0.8, 0.0}}, camera, limb);
    }
    out += polyline({{-0.2, 1.4, 0.0}, {0.2, 1.4, 0.0}, {0.1, 0.9, 0.0}, {-0.1, 0.9, 0.0}, {-0.2, 1.4, 0.0}},
                    camera,
                    "stroke=\"#6b7480\" stroke-width=\"9\" stroke-linejoin=\"round\" style=\"fill:#6b7480\"");
    const Vec3 head(0.0, 1.62, 0.0);
    return out + circle(camera(head), 0.12 * camera.pixelsPerMetre(head), "fill=\"#6b7480\"");
}

/// The edges of the half-cylinder.
std::string limits(const TargetSpace& space, const Camera& camera) {
    std::string out;
    for (const double height : {space.height_m.low, space.height_m.high})
        for (const double radius : {space.radius_m.low, space.radius_m.high})
            out += polyline(arcPoints(space, radius, height), camera, edge);
    for (const double azimuth : {space.arc_deg.low, space.arc_deg.high})
        for (const double radius : {space.radius_m.low, space.radius_m.high})
            out += polyline({onCylinder(radius, azimuth, space.height_m.low),
                             onCylinder(radius, azimuth, space.height_m.high)},
                            camera, edge);
    return out;
}

std::string perspectiveView(const Scene& scene, const Box& box) {
    const Camera camera(scene, box);
    std::string out = "<g id=\"perspective\">\n" + floorGrid(scene, camera);
    if (hasRanges(scene.space)) out += limits(scene.space, camera);
    for (const Ball& ball : scene.balls) {
        const Vec3 shadow(ball.centre.x, 0.0, ball.centre.z);
        const Point at = camera(shadow);
        const double radius = scene.ball_radius_m * camera.pixelsPerMetre(shadow);
        out += fmt::format(
            "<ellipse cx=\"{:.1f}\" cy=\"{:.1f}\" rx=\"{:.1f}\" ry=\"{:.1f}\" fill=\"#000\" "
            "fill-opacity=\"0.13\"/>\n",
            at.x, at.y, radius, 0.45 * radius);
    }
    std::vector<Ball> balls = scene.balls;  // the farthest first, so that near ones cover them
    std::stable_sort(balls.begin(), balls.end(), [&](const Ball& a, const Ball& b) {
        return camera.depth(a.centre) > camera.depth(b.centre);
    });
    bool avatar_drawn = false;
    for (const Ball& ball : balls) {
        if (!avatar_drawn && camera.depth(ball.centre) < camera.depth(Vec3(0.0, 1.0, 0.0))) {
            out += avatarFigure(camera);
            avatar_drawn = true;
        }
        out += circle(camera(ball.centre), scene.ball_radius_m * camera.pixelsPerMetre(ball.centre),
                      ball.demonstration ? "fill=\"url(#demonstration)\"" : "fill=\"url(#target)\"");
    }
    if (!avatar_drawn) out += avatarFigure(camera);
    return out + "</g>\n";
}

/// One flat view: which axis runs right and which up the page, in which direction, and what they are called.
struct FlatView {
    std::string id, title;
    int across_axis = 0, up_axis = 0;
    double across_sign = 1.0;
    std::string across_label, up_label;
};

std::string axes(const Scene& scene, const FlatView& view, const Box& box, double scale) {
    constexpr double tick_m = 0.5;
    const double a0 = view.across_sign > 0 ? scene.low[view.across_axis] : -scene.high[view.across_axis];
    const double b1 = scene.high[view.up_axis];
    const double step_m = tick_m * std::max(1.0, std::ceil(28.0 / (tick_m * scale)));  // room for the numbers
    std::string out = fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#fbfcfd\" "
        "stroke=\"#b8c0c9\"/>\n",
        box.left, box.top, box.width, box.height);
    const auto tick = [&](double value) { return fmt::format("{:.1f}", value == 0.0 ? 0.0 : value); };
    for (double i = std::ceil(a0 / step_m); i * step_m <= a0 + box.width / scale; ++i) {
        const double x = box.left + scale * (i * step_m - a0);
        out += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\" "
            "stroke=\"#e6e9ed\"/>\n",
            x, box.top, box.top + box.height);
        out += text({x, box.top + box.height + 16}, tick(view.across_sign * i * step_m),
                    "text-anchor=\"middle\" class=\"tick\"");
    }
    for (double i = std::ceil((b1 - box.height / scale) / step_m); i * step_m <= b1; ++i) {
        const double y = box.top + scale * (b1 - i * step_m);
        out += fmt::format(
            "<line x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" "
            "stroke=\"#e6e9ed\"/>\n",
            box.left, box.left + box.width, y);
        out += text({box.left - 6, y + 4}, tick(i * step_m), "text-anchor=\"end\" class=\"tick\"");
    }
    out += text({box.left, box.top - 10}, view.title, "class=\"title\"");
    out += text({box.left + box.width / 2, box.top + box.height + 34}, view.across_label,
                "text-anchor=\"middle\"");
    const Point side{box.left - 40, box.top + box.height / 2};
    return out + text(side, view.up_label,
                      fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:.1f} {:.1f})\"", side.x,
                                  side.y));
}

/// From above, the ring in which the targets lie; from the side, smallest and largest height.
template <typename Project>
std::string limits(const Scene& scene, bool above, const Project& project) {
    const TargetSpace& space = scene.space;
    if (above) {
        std::vector<Vec3> ring = arcPoints(space, space.radius_m.high, 0.0);
        const std::vector<Vec3> inner = arcPoints(space, space.radius_m.low, 0.0);
        std::copy(inner.rbegin(), inner.rend(), std::back_inserter(ring));
        ring.push_back(ring.front());
        return polyline(ring, project, edge);
    }
    std::string out;
    for (const double height : {space.height_m.low, space.height_m.high})
        out += polyline({{0.0, height, scene.low.z}, {0.0, height, scene.high.z}}, project, edge);
    return out;
}

std::string flatView(const Scene& scene, const FlatView& view, const Point& corner, double scale) {
    const int across = view.across_axis;
    const int upward = view.up_axis;
    const Box box{corner.x, corner.y, scale * (scene.high[across] - scene.low[across]),
                  scale * (scene.high[upward] - scene.low[upward])};
    const double a0 = view.across_sign > 0 ? scene.low[across] : -scene.high[across];
    const auto project = [&](const Vec3& point) -> Point {
        return {box.left + scale * (view.across_sign * point[across] - a0),
                box.top + scale * (scene.high[upward] - point[upward])};
    };
    std::string out = fmt::format("<g id=\"{}\">\n", view.id) + axes(scene, view, box, scale);
    if (hasRanges(scene.space)) out += limits(scene, upward == 2, project);
    for (const Ball& ball : scene.balls)
        out += circle(project(ball.centre), std::max(2.0, scale * scene.ball_radius_m),
                      fmt::format("fill=\"{}\" fill-opacity=\"0.75\" stroke=\"#fff\" stroke-width=\"0.6\"",
                                  ball.demonstration ? demonstration_colour : target_colour));
    constexpr std::string_view body = "stroke=\"#6b7480\" stroke-width=\"6\" stroke-linecap=\"round\"";
    if (upward == 2) {
        out += polyline({{-0.22, 0.0, 0.0}, {0.22, 0.0, 0.0}}, project, body);
        out += polyline({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.24}}, project,
                        "stroke=\"#6b7480\" stroke-width=\"3\" stroke-linecap=\"round\"");
        out += circle(project(Vec3(0.0)), scale * 0.11, "fill=\"#6b7480\"");
    } else {
        const Vec3 head(0.0, 1.62, 0.0);
        out += polyline({{0.0, 0.05, 0.0}, {0.0, 1.5, 0.0}}, project, body);
        out += polyline({head, head + Vec3(0.0, 0.0, 0.17)}, project,
                        "stroke=\"#6b7480\" stroke-width=\"3\" stroke-linecap=\"round\"");
        out += circle(project(head), scale * 0.12, "fill=\"#6b7480\"");
    }
    return out + "</g>\n";
}

std::string legend(const Scene& scene, const Point& corner) {
    const auto demonstrations =
        std::count_if(scene.balls.begin(), scene.balls.end(), [](const Ball& b) { return b.demonstration; });
    const auto targets = static_cast<std::ptrdiff_t>(scene.balls.size()) - demonstrations;
    const TargetSpace& space = scene.space;
    std::string out = "<g id=\"legend\">\n";
    double y = corner.y;
    const auto line = [&](std::string_view words) {
        out += text({corner.x + 18, y + 4}, words);
        y += 22;
    };
    out += circle({corner.x, y}, 6, "fill=\"url(#target)\"");
    line(fmt::format("{} targets", targets));
    if (demonstrations > 0) {
        out += circle({corner.x, y}, 6, "fill=\"url(#demonstration)\"");
        line(fmt::format("{} demonstrations", demonstrations));
    }
    out += circle({corner.x, y}, 6, "fill=\"#6b7480\"");
    line("avatar, at the origin");
    if (!hasRanges(space)) return out + "</g>\n";
    out += fmt::format(
        "<line x1=\"{:.1f}\" x2=\"{:.1f}\" y1=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#8a94a0\" "
        "stroke-dasharray=\"4 3\"/>\n",
        corner.x - 8, corner.x + 8, y, y);
    line("limits of the ranges");
    y += 8;
    const auto range = [&](std::string_view name, const Range& r, std::string_view unit) {
        line(fmt::format("{}: {:.4g} to {:.4g}{}", name, r.low, r.high, unit));
    };
    range("height", space.height_m, " m");
    range("arc", space.arc_deg, "°");
    range("radius", space.radius_m, " m");
    return out + "</g>\n";
}

}  // namespace

std::string targetsSvg(const TargetSpace& space, const std::vector<TargetItem>& targets,
                       const std::vector<Vec3>& demonstrations) {
    const Scene scene = makeScene(space, targets, demonstrations);
    const Vec3 size = scene.high - scene.low;
    // The two flat views share a scale, so that they can be compared.
    const double scale = std::min(430.0 / size.x, 520.0 / (size.z + size.y));
    const FlatView above{"above",       "From above", 0, 2, -1.0, "x (m), the avatar's left is positive",
                         "z (m), ahead"};
    const FlatView side{"side", "From the side", 2, 1, 1.0, "z (m), ahead", "y (m), height"};
    const Point above_corner{740.0, 60.0};
    const Point side_corner{740.0, above_corner.y + scale * size.z + 90.0};

    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" font-family=\"Inter, 'DejaVu Sans', Arial, sans-serif\" font-size=\"13\" "
        "fill=\"#2d343c\">\n<title>Targets in front of the avatar</title>\n"
        "<style>.tick{{font-size:11px;fill:#5b6570}}.title{{font-size:15px;font-weight:600}}</"
        "style>\n<defs>\n",
        page_width, page_height);
    const auto gradient = [&](std::string_view id, std::string_view light, std::string_view colour) {
        out += fmt::format(
            "<radialGradient id=\"{}\" cx=\"0.36\" cy=\"0.32\" r=\"0.75\"><stop offset=\"0\" "
            "stop-color=\"{}\"/><stop offset=\"1\" stop-color=\"{}\"/></radialGradient>\n",
            id, light, colour);
    };
    gradient("target", "#f4707f", target_colour);
    gradient("demonstration", "#74aee8", demonstration_colour);
    out += "</defs>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
    out += perspectiveView(scene, {20.0, 50.0, 640.0, 640.0});
    out += text({30.0, 50.0}, "Targets in front of the avatar", "class=\"title\"");
    out += flatView(scene, above, above_corner, scale);
    out += flatView(scene, side, side_corner, scale);
    out += legend(scene, {side_corner.x + scale * size.z + 40.0, side_corner.y + 12.0});
    return out + "</svg>\n";
}

}  // namespace deixis::studies
