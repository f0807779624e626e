// Any bytes as a tree of joints with names and offsets: its map has joints of its own, and what that figure
// plays on the avatar is a pose, or an error.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "motion/humanoid/mapping.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"

using namespace deixis;

namespace {

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

constexpr std::array words{"",      "Left",  "Right", "L",     "R",   "Arm",      "Leg",   "Hips",
                           "Head",  "Neck",  "Foot",  "Hand",  "Up",  "Fore",     "Toe",   "Spine",
                           "Index", "1",     "Thumb", "twist", "__",  "_",        "roll",  "Elbow",
                           "Knee",  "Wrist", "Ankle", "j",     "Hip", "Shoulder", "Chest", "2"};

class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
    [[nodiscard]] bool empty() const { return at_ >= size_; }
    std::uint8_t next() { return empty() ? std::uint8_t{0} : data_[at_++]; }
    double length() { return 0.02 * (static_cast<int>(next()) - 128); }
    std::string word() { return words[next() % words.size()]; }

  private:
    const std::uint8_t* data_;
    std::size_t size_;
    std::size_t at_ = 0;
};

motion::Skeleton skeletonOf(Bytes& in) {
    motion::Skeleton skeleton;
    while (!in.empty() && skeleton.size() < 80) {
        motion::Joint joint;
        joint.name = in.word() + in.word() + "#" + std::to_string(skeleton.size());
        if (const auto mark = in.next(); mark % 4 != 0) joint.name.erase(joint.name.find('#'));
        while (skeleton.find(joint.name) >= 0) joint.name += "'";
        const int back = in.next() % 6;
        joint.parent = skeleton.size() - 1 - back;
        if (joint.parent < 0) joint.parent = skeleton.joints.empty() || back == 5 ? -1 : 0;
        joint.rest.position.x = in.length();
        joint.rest.position.y = in.length();
        joint.rest.position.z = in.length();
        if (in.next() % 3 == 0) joint.end_site = Vec3(in.length(), in.length(), in.length());
        skeleton.joints.push_back(std::move(joint));
    }
    return skeleton;
}

void checkMap(const motion::Skeleton& skeleton, const motion::HumanoidMapping& mapping) {
    for (const int joint : mapping.map.joint)
        require(joint >= -1 && joint < skeleton.size(), "bones that are joints");
    (void)motion::mappingWarnings(skeleton, mapping.map,
                                  motion::worldPose(skeleton, motion::restPose(skeleton)));
    motion::Clip clip;
    clip.skeleton = skeleton;
    clip.frames.assign(2, motion::restPose(skeleton));
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const auto played = motion::retarget(clip, mapping.map, avatar, motion::mapByVrmNames(avatar));
    if (!played) {
        require(!played.error().message.empty(), "an error with words");
        return;
    }
    for (const motion::LocalPose& frame : played->frames)
        for (const Pose& pose : frame.joints)
            require(std::isfinite(pose.position.y) && std::abs(glm::length(pose.orientation) - 1.0) < 1e-6,
                    "a pose in every frame");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes in(data, size);
    motion::HumanoidMap given;
    const bool has_given = in.next() % 4 == 0;
    for (int i = 0; has_given && i < 6; ++i) given.joint[in.next() % motion::bone_count] = in.next() % 8;
    const motion::Skeleton skeleton = skeletonOf(in);
    if (skeleton.joints.empty()) return 0;
    for (int& joint : given.joint)
        if (joint >= skeleton.size()) joint = -1;
    checkMap(skeleton, motion::mapHumanoid(skeleton, has_given ? &given : nullptr));
    return 0;
}
