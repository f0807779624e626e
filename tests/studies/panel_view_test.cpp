// What of the boards a flat screen shows: 60 degrees from top to foot, 16 to 9.
#include <cmath>

#include "panel_fixture.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

constexpr double half_height = 0.57735026919;  // the tangent of 30 degrees
constexpr double half_width = half_height * 16.0 / 9.0;
constexpr double eye_m = 1.65;
const Pose opposite{{0.0, 0.0, 3.4}, no_rotation};

/// Turned from the participant's eyes up by this angle.
Pose viewAt(double pitch_rad) {
    return opposite *
           Pose{{0.0, eye_m, 0.0}, Quat(std::cos(pitch_rad / 2.0), std::sin(pitch_rad / 2.0), 0.0, 0.0)};
}

double pitchOf(const Vec3& point) {
    const Vec3 seen = transformPoint(inverse(viewAt(0.0)), point);
    return std::atan2(seen.y, std::hypot(seen.x, seen.z));
}

bool inView(const Pose& view, const Vec3& point) {
    const Vec3 seen = transformPoint(inverse(view), point);
    return seen.z < 0.0 && std::abs(seen.x) <= -seen.z * half_width &&
           std::abs(seen.y) <= -seen.z * half_height;
}

std::vector<Vec3> cornersOf(const Panel& panel) {
    std::vector<Vec3> corners;
    for (const double x : {0.0, panel.width_m})
        for (const double y : {0.0, panel.height_m})
            corners.push_back(transformPoint(panel.stage_from_panel, {x, y, 0.0}));
    return corners;
}

Vec3 middleOf(const Panel& panel) {
    return transformPoint(panel.stage_from_panel, {panel.width_m / 2.0, panel.height_m / 2.0, 0.0});
}

std::vector<Scale> scales(RandomTexts& texts) {
    std::vector<std::string> five;
    for (int i = 0; i < 5; ++i) five.push_back(texts(1, 2));
    return {{ScaleKind::slider, 0, 100, five},
            {ScaleKind::slider, 0, 100, {texts(1, 3), texts(1, 3)}},
            {ScaleKind::steps, 1, 5, five},
            {ScaleKind::steps, 1, 7, {texts(1, 3), texts(1, 3)}},
            {ScaleKind::steps, 0, 10, {texts(1, 3), texts(1, 3)}}};
}

}  // namespace

TEST_SUITE("studies/panel_view") {
    TEST_CASE(
        "two to six movements are seen with all their sliders, the avatar's head and the sign above it") {
        const Vec3 head(0.0, 1.6, 0.0);
        for (const std::string& code : languageCodes()) {
            const LanguageTable words = languageTable(code);
            RandomTexts texts(words, 9);
            for (std::size_t count = 2; count <= 6; ++count)
                for (const Scale& scale : scales(texts)) {
                    CAPTURE(code);
                    CAPTURE(count);
                    CAPTURE(scale.steps());
                    ParallelBoard content{"How human-like does the gesture motion appear?", scale};
                    content.stimuli.resize(count);
                    content.hint = words("play_all");
                    Panel panel = parallelPanel(content, words);
                    panel.stage_from_panel = benchPose(panel, opposite, eye_m);
                    CAPTURE(panel.height_m);
                    // The desktop looks between straight ahead, a little down, and the board's middle.
                    const Pose view = viewAt(0.5 * (radiansFromDegrees(-6.0) + pitchOf(middleOf(panel))));
                    for (const Vec3& corner : cornersOf(panel)) CHECK(inView(view, corner));
                    CHECK(inView(view, head + Vec3(0.0, 0.15, 0.0)));
                    Panel sign = signPanel(words("attention_number"), "46");
                    sign.stage_from_panel = signPose(sign, head, opposite.position + Vec3(0.0, eye_m, 0.0));
                    CHECK_MESSAGE(inView(view, middleOf(sign)), "the number cannot be read");
                }
        }
    }

    TEST_CASE("pages and ratings are seen whole where their middle is looked at") {
        for (const std::string& code : languageCodes()) {
            const LanguageTable words = languageTable(code);
            RandomTexts texts(words, 13);
            for (int round = 0; round < 60; ++round) {
                CAPTURE(code);
                Panel page = messagePanel(texts(1, 5), texts(1, 120), texts(1, 10), {{texts(1, 3), 1}}, 0.5,
                                          words("station_desktop_controls"));
                page.stage_from_panel = messagePose(page, opposite, eye_m);
                for (const Vec3& corner : cornersOf(page))
                    CHECK(inView(viewAt(pitchOf(middleOf(page))), corner));
                for (const Scale& scale : scales(texts)) {
                    RatingBoard content{texts(3, 12), scale};
                    content.replay = ButtonSpec{words("show_again"), 1, ButtonRole::play};
                    Panel rating = ratingPanel(content);
                    rating.stage_from_panel = lecternPose(rating, opposite, eye_m);
                    for (const Vec3& corner : cornersOf(rating))
                        CHECK(inView(viewAt(pitchOf(middleOf(rating))), corner));
                }
            }
        }
    }
}
