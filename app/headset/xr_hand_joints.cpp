#include "xr_hand_joints.hpp"

#include "xr_input.hpp"

namespace deixis::app {

XrHandJoints::XrHandJoints(const XrRuntime& runtime, XrSession session)
    : destroy_(runtime.function<PFN_xrDestroyHandTrackerEXT>("xrDestroyHandTrackerEXT")),
      locate_(runtime.function<PFN_xrLocateHandJointsEXT>("xrLocateHandJointsEXT")) {
    const auto create = runtime.function<PFN_xrCreateHandTrackerEXT>("xrCreateHandTrackerEXT");
    const bool found = create != nullptr && destroy_ != nullptr && locate_ != nullptr;
    check(found ? XR_SUCCESS : XR_ERROR_FUNCTION_UNSUPPORTED, "xrCreateHandTrackerEXT");
    constexpr std::array hands{XR_HAND_LEFT_EXT, XR_HAND_RIGHT_EXT};
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        auto creation = typed<XrHandTrackerCreateInfoEXT>(XR_TYPE_HAND_TRACKER_CREATE_INFO_EXT);
        creation.hand = hands[hand];
        creation.handJointSet = XR_HAND_JOINT_SET_DEFAULT_EXT;
        check(create(session, &creation, &trackers_[hand]), "xrCreateHandTrackerEXT");
    }
}

XrHandJoints::~XrHandJoints() {
    for (XrHandTrackerEXT tracker : trackers_)
        if (tracker != XR_NULL_HANDLE) destroy_(tracker);
}

std::array<std::vector<studies::HandJoint>, 2> XrHandJoints::read(XrSpace tracking, XrTime time) const {
    std::array<std::vector<studies::HandJoint>, 2> hands;
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        std::array<XrHandJointLocationEXT, XR_HAND_JOINT_COUNT_EXT> joints{};
        auto located = typed<XrHandJointLocationsEXT>(XR_TYPE_HAND_JOINT_LOCATIONS_EXT);
        located.jointCount = XR_HAND_JOINT_COUNT_EXT;
        located.jointLocations = joints.data();
        auto wanted = typed<XrHandJointsLocateInfoEXT>(XR_TYPE_HAND_JOINTS_LOCATE_INFO_EXT);
        wanted.baseSpace = tracking;
        wanted.time = time;
        check(locate_(trackers_[hand], &wanted, &located), "xrLocateHandJointsEXT");
        if (located.isActive != XR_TRUE) continue;
        for (const auto& joint : joints) {
            const XrSpaceLocation place{XR_TYPE_SPACE_LOCATION, nullptr, joint.locationFlags, joint.pose};
            hands[hand].push_back({trackedPose(place), joint.radius});
        }
    }
    return hands;
}

}  // namespace deixis::app
