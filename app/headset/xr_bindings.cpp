#include "xr_bindings.hpp"

namespace deixis::app {

const std::vector<XrControllerBindings>& controllerBindings() {
    // A trigger's value selects part of the way, at the runtime's threshold: pulling it right through to its
    // click would move the aim.
    static const std::vector<XrControllerBindings> bindings{
        {"/interaction_profiles/khr/simple_controller",
         "",
         "select/click",
         {"menu/click", "menu/click"},
         "",
         "",
         true},
        {"/interaction_profiles/oculus/touch_controller",
         "",
         "trigger/value",
         {"menu/click", "b/click"},
         "thumbstick/click",
         "thumbstick/y",
         true},
        {"/interaction_profiles/valve/index_controller",
         "",
         "trigger/value",
         {"b/click", "b/click"},
         "thumbstick/click",
         "thumbstick/y",
         true},
        {"/interaction_profiles/htc/vive_controller",
         "",
         "trigger/value",
         {"menu/click", "menu/click"},
         "trackpad/click",
         "trackpad/y",
         true},
        {"/interaction_profiles/microsoft/motion_controller",
         "",
         "trigger/value",
         {"menu/click", "menu/click"},
         "thumbstick/click",
         "thumbstick/y",
         true},
        {"/interaction_profiles/ext/hand_interaction_ext",
         "XR_EXT_hand_interaction",
         "pinch_ext/value",
         {"", ""},
         "",
         "",
         false},
    };
    return bindings;
}

}  // namespace deixis::app
