#include "xr_bindings.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <string>

using namespace deixis::app;

TEST_SUITE("headset/bindings") {
    TEST_CASE("Every controller's buttons are ones that the specification gives its profile") {
        // OpenXR 1.0, 6.4 "Interaction Profile Paths", and XR_EXT_hand_interaction: the components that a
        // boolean action can use, without the ones that a runtime may keep for itself; left hand, right hand.
        using Components = std::set<std::string>;
        const Components simple{"select/click", "menu/click"};
        const Components vive{"squeeze/click", "menu/click",     "trigger/click",
                              "trigger/value", "trackpad/click", "trackpad/touch"};
        const Components index{"a/click",       "a/touch",          "b/click",          "b/touch",
                               "squeeze/value", "squeeze/force",    "trigger/click",    "trigger/value",
                               "trigger/touch", "thumbstick/click", "thumbstick/touch", "trackpad/force",
                               "trackpad/touch"};
        const Components motion{"menu/click",       "squeeze/click",  "trigger/value",
                                "thumbstick/click", "trackpad/click", "trackpad/touch"};
        const Components touch_left{"x/click",          "x/touch",          "y/click",        "y/touch",
                                    "menu/click",       "squeeze/value",    "trigger/value",  "trigger/touch",
                                    "thumbstick/click", "thumbstick/touch", "thumbrest/touch"};
        const Components touch_right{
            "a/click",       "a/touch",       "b/click",          "b/touch",          "squeeze/value",
            "trigger/value", "trigger/touch", "thumbstick/click", "thumbstick/touch", "thumbrest/touch"};
        const Components hands{"pinch_ext/value", "pinch_ext/ready_ext", "aim_activate_ext/value",
                               "grasp_ext/value", "grasp_ext/ready_ext", "aim_activate_ext/ready_ext"};
        const std::map<std::string, std::array<Components, 2>> specified{
            {"/interaction_profiles/khr/simple_controller", {simple, simple}},
            {"/interaction_profiles/htc/vive_controller", {vive, vive}},
            {"/interaction_profiles/valve/index_controller", {index, index}},
            {"/interaction_profiles/microsoft/motion_controller", {motion, motion}},
            {"/interaction_profiles/oculus/touch_controller", {touch_left, touch_right}},
            {"/interaction_profiles/ext/hand_interaction_ext", {hands, hands}},
        };
        CHECK(controllerBindings().size() == specified.size());
        for (const auto& controller : controllerBindings()) {
            CAPTURE(controller.profile);
            REQUIRE(specified.contains(controller.profile));
            for (std::size_t hand = 0; hand < 2; ++hand) {
                const Components& components = specified.at(controller.profile)[hand];
                CHECK(components.contains(controller.select));
                for (const std::string component : {controller.menu[hand], controller.recentre})
                    CHECK((component.empty() || components.contains(component)));
            }
        }
    }

    TEST_CASE("No button has two meanings") {
        for (const auto& controller : controllerBindings()) {
            CAPTURE(controller.profile);
            for (const char* menu : controller.menu) {
                std::set<std::string> components{controller.select};
                std::size_t count = 1;
                for (const std::string component : {menu, controller.recentre}) {
                    if (component.empty()) continue;
                    components.insert(component.substr(0, component.find('/')));
                    ++count;
                }
                CHECK(components.size() == count);
            }
        }
    }
}
