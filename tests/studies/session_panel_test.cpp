#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "session_fixture.hpp"
#include "studies/texts/text_layout.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

bool overlap(const PanelRect& a, const PanelRect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/// Everything inside the panel, nothing on top of anything else, nothing too small.
void checkTidy(const Panel& panel) {
    std::vector<PanelRect> boxes;
    for (const PanelText& text : panel.texts) {
        boxes.push_back(text.box);
        CHECK(text.size_m >= 0.035);
    }
    for (const PanelButton& button : panel.buttons) {
        boxes.push_back(button.box);
        CHECK(button.box.width >= 0.13);
        CHECK(button.box.height >= 0.13 - 1e-12);
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        CHECK(boxes[i].x >= 0.05);
        CHECK(boxes[i].y >= 0.05);
        CHECK(boxes[i].x + boxes[i].width <= panel.width_m - 0.05);
        CHECK(boxes[i].y + boxes[i].height <= panel.height_m - 0.05);
        for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(boxes[i], boxes[j]));
    }
}

Vec3 centreOf(const Panel& panel) {
    return transformPoint(panel.stage_from_panel, {panel.width_m / 2.0, panel.height_m / 2.0, 0.0});
}

bool hides(const Panel& panel, const Vec3& eye, const Vec3& point) {
    const Pose panel_from_stage = inverse(panel.stage_from_panel);
    const Vec3 a = transformPoint(panel_from_stage, eye);
    const Vec3 b = transformPoint(panel_from_stage, point);
    if (a.z * b.z > 0.0) return false;
    const Vec3 met = a + (b - a) * (a.z / (a.z - b.z));
    return met.x >= 0.0 && met.y >= 0.0 && met.x <= panel.width_m && met.y <= panel.height_m;
}

}  // namespace

TEST_SUITE("studies/session_panel") {
    TEST_CASE(
        "pages stand upright at reading distance before the participant and hold short and long texts") {
        for (const int sentences : {1, 8, 30}) {
            CAPTURE(sentences);
            Driver driver(1);
            driver.stage("welcome").text.clear();
            for (int i = 0; i < sentences; ++i) driver.stage("welcome").text += "Twenty-two characters. ";
            driver.start();
            driver.step();
            REQUIRE(driver.frame.panel.has_value());
            const Panel& panel = *driver.frame.panel;
            checkTidy(panel);
            // Room for the whole text, set on one line.
            const PanelText& body = panel.texts[1];
            const double area_m2 = textWidth(unwrapped(body.text), body.size_m) * body.size_m;
            CHECK(body.box.width * body.box.height >= area_m2);
            const Vec3 eye = driver.frame.stage_from_viewer.position + Vec3(0.0, 1.65, 0.0);
            const double distance_m = glm::length(centreOf(panel) - eye);
            CHECK(distance_m >= 1.2);
            CHECK(distance_m <= 1.6);
            const Vec3 towards_reader = panel.stage_from_panel.orientation * Vec3(0.0, 0.0, 1.0);
            CHECK(glm::dot(towards_reader, glm::normalize(eye - centreOf(panel))) > 0.95);
        }
    }

    TEST_CASE("a page is never covered by the avatar, also where the participant stands at its shoulder") {
        for (const double x_m : {-0.9, -0.6, 0.6, 0.9})
            for (const double z_m : {-1.2, -0.95, -0.3, 0.0, 2.0, 3.4})
                for (const double heading_deg : {-15.0, 0.0, 15.0, 165.0, 180.0}) {
                    CAPTURE(x_m);
                    CAPTURE(z_m);
                    CAPTURE(heading_deg);
                    Driver driver(1);
                    driver.study.layouts.front() = {"across", x_m, z_m, heading_deg};
                    driver.start();
                    driver.step();
                    REQUIRE(driver.frame.panel.has_value());
                    const Panel& panel = *driver.frame.panel;
                    // The avatar is an upright post at the origin: no line of sight to the page meets it.
                    const Vec3 eye(x_m, 0.0, z_m);
                    for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                        Vec3 seen = transformPoint(panel.stage_from_panel, {u * panel.width_m, 0.3, 0.0});
                        seen.y = 0.0;
                        const Vec3 along = seen - eye;
                        const double nearest =
                            std::clamp(-glm::dot(eye, along) / glm::dot(along, along), 0.0, 1.0);
                        CHECK(glm::length(eye + nearest * along) > 0.25);
                    }
                }
    }

    TEST_CASE("the rating panel leaves the avatar's face and chest free and faces the eyes") {
        for (const std::size_t steps : {std::size_t{2}, std::size_t{5}, std::size_t{9}}) {
            CAPTURE(steps);
            Driver driver(1, 0.5, false);
            driver.stage("naturalness").max_replays = 1;
            driver.stage("naturalness").scale = {ScaleKind::steps, 1, static_cast<int>(steps),
                                                 std::vector<std::string>(steps, "rather natural")};
            driver.start();
            REQUIRE(driver.toAnswer());
            const Panel& panel = *driver.frame.panel;
            checkTidy(panel);
            CHECK(panel.buttons.size() == steps + 1);
            const Vec3 eye = driver.frame.stage_from_viewer.position + Vec3(0.0, 1.65, 0.0);
            for (const char* name : {"head", "upperChest", "leftUpperArm", "rightUpperArm"}) {
                const auto joint = static_cast<std::size_t>(driver.avatar.find(name));
                CHECK_FALSE(hides(panel, eye, driver.frame.avatar_joints[joint].position));
            }
            // Every button is within the lower half of a 60 degree view that looks straight ahead.
            for (const PanelButton& button : panel.buttons) {
                const Vec3 centre = buttonCentre(panel, button.id);
                CHECK(std::atan2(eye.y - centre.y, eye.z - centre.z) < radiansFromDegrees(30.0));
            }
            const Vec3 towards_reader = panel.stage_from_panel.orientation * Vec3(0.0, 0.0, 1.0);
            CHECK(glm::dot(towards_reader, glm::normalize(eye - centreOf(panel))) > 0.98);
        }
    }
}
