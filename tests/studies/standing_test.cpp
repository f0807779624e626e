#include "studies/study_file/standing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "session_fixture.hpp"
#include "simulated_run.hpp"
#include "studies/design/visibility.hpp"

using namespace deixis;
using namespace deixis::tests;

TEST_SUITE("studies/standing") {
    TEST_CASE("A layout's place for a desktop is used there, not in a headset") {
        Study study;
        study.layouts = {{"across", 0.0, 3.4, 180.0},
                         {"side-by-side", -1.2, 0.0, 30.0, ViewerPlace{-1.2, -1.0, 20.0}}};
        const Study headset = standingAs(study, Standing::headset);
        CHECK(headset.layouts[1].viewer_z_m == 0.0);
        CHECK(headset.layouts[1].heading_deg == 30.0);
        const Study screen = standingAs(study, Standing::desktop);
        CHECK(screen.layouts[0].viewer_z_m == 3.4);
        CHECK(screen.layouts[1].viewer_x_m == -1.2);
        CHECK(screen.layouts[1].viewer_z_m == -1.0);
        CHECK(screen.layouts[1].heading_deg == 20.0);
        CHECK_FALSE(screen.layouts[1].desktop.has_value());
        // The place is what the pose stands on, and -z of it looks along the heading.
        const Pose pose = viewerPose(ViewerPlace{-1.2, -1.0, 90.0});
        CHECK(pose.position.x == -1.2);
        CHECK((pose.orientation * Vec3(0.0, 0.0, -1.0)).x == doctest::Approx(1.0));
    }

    TEST_CASE("In a headset nobody stands where the avatar's body or its pointing arm goes.") {
        constexpr double body_m = 0.25;  // from a participant's middle to chest, back or shoulder
        for (const char* name : {"pointing2023", "distractor-distance", "pointing-style"}) {
            const Study study =
                loadedStudy(source_tree / "assets/data/studies" / (std::string(name) + ".toml"));
            const auto items = sampleTargets(study);
            REQUIRE(items.has_value());
            for (const Layout& layout : study.layouts)
                for (const TargetItem& item : *items)
                    for (const motion::Capsule& part : StandingAvatar::reference().pointing(item.target))
                        for (int i = 0; i <= 20; ++i) {
                            const Vec3 at = part.from + i / 20.0 * (part.to - part.from);
                            CAPTURE(layout.name);
                            CAPTURE(item.id);
                            CHECK(std::hypot(at.x - layout.viewer_x_m, at.z - layout.viewer_z_m) >
                                  part.radius_m + body_m);
                        }
        }
    }

    TEST_CASE("Every answer says where the participant was asked to stand.") {
        Driver driver(2, 0.5, false);
        driver.study.layouts[1].desktop = ViewerPlace{0.9, -1.1, -20.0};
        driver.study = standingAs(driver.study, Standing::desktop);
        driver.start();
        while (driver.running() && driver.frame.number < 20000) {
            if (resting(driver.frame))
                driver.press(button_id::go_on);
            else if (answersOpen(driver.frame) && !driver.frame.balls.empty())
                driver.choose(0);
            else if (answersOpen(driver.frame))
                driver.digit(3);
            else
                driver.step();
        }
        REQUIRE(driver.finished());
        int aside = 0;
        for (const Response& response : driver.responses) {
            const Trial& trial = driver.plan.trials[static_cast<std::size_t>(response.trial_index)];
            const bool beside = trial.layout == "side-by-side";
            aside += beside;
            CHECK(response.viewer.x_m == (beside ? 0.9 : 0.0));
            CHECK(response.viewer.z_m == (beside ? -1.1 : 3.4));
            CHECK(response.viewer.heading_deg == (beside ? -20.0 : 180.0));
        }
        CHECK(aside > 0);
        CHECK(aside < static_cast<int>(driver.responses.size()));
    }
}
