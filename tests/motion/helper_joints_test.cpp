// Figures with joints beside their bones (twist, roll and leading joints, joints in one place), and figures
// that are none.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/retarget/retarget.hpp"

using namespace deixis;
using motion::Bone;
using motion::Skeleton;

namespace {

int add(Skeleton& skeleton, const std::string& name, int parent, const Vec3& offset) {
    motion::Joint joint;
    joint.name = name;
    joint.parent = parent;
    joint.rest.position = offset;
    skeleton.joints.push_back(joint);
    return skeleton.size() - 1;
}

/// How an upper arm is divided in the Talking With Hands recordings and those of the GENEA challenges.
enum class Twist : unsigned char {
    beside,   ///< a leaf in the upper arm's place, and a twist joint in the middle of the bone
    in_place  ///< the forearm hangs on a twist joint in the upper arm's place
};

/// With the names of those recordings, metres by hand; nothing of theirs.
Skeleton talkingWithHands(Twist twist) {
    Skeleton s;
    const int root = add(s, "b_root", add(s, "body_world", -1, Vec3(0.0)), {0, 0.92, 0});
    int spine = root;
    for (int i = 0; i < 4; ++i) spine = add(s, "b_spine" + std::to_string(i), spine, {0, 0.105, 0});
    const int head = add(s, "b_head", add(s, "b_neck0", spine, {0, 0.13, 0.03}), {0, 0.06, 0.03});
    add(s, "b_head_null", head, {0, 0.2, 0.04});
    for (const double k : {1.0, -1.0}) {
        const std::string side = k > 0.0 ? "b_l_" : "b_r_";
        const int collar = add(s, side + "shoulder", spine, {0.03 * k, 0.14, 0.02});
        const int arm = add(s, side + "arm", collar, {0.15 * k, 0.02, -0.02});
        int above = add(s, side + "arm_twist", arm, Vec3(0.0));
        if (twist == Twist::beside) above = add(s, side + "arm_twist2", arm, {0.14 * k, 0, 0});
        const int forearm =
            add(s, side + "forearm", above, {(twist == Twist::beside ? 0.14 : 0.28) * k, 0, 0});
        const int wrist =
            add(s, side + "wrist", add(s, side + "wrist_twist", forearm, {0.13 * k, 0, 0}), {0.12 * k, 0, 0});
        for (const char* finger : {"thumb", "index", "middle", "ring", "pinky"}) {
            int last = wrist;
            for (int i = 1; i <= 3; ++i)
                last = add(s, side + finger + std::to_string(i), last, {(i == 1 ? 0.08 : 0.03) * k, 0, 0.02});
        }
        const int knee =
            add(s, side + "leg", add(s, side + "upleg", root, {0.09 * k, -0.04, 0}), {0, -0.42, 0});
        const int foot =
            add(s, side + "foot", add(s, side + "foot_twist", knee, {0, -0.2, 0}), {0, -0.2, -0.02});
        add(s, side + "foot_null", foot, {0, -0.06, 0.12});
    }
    return s;
}

/// As MakeHuman's older rigs: joints "__X" lead from a bone's end to where bone X begins, hips carry the legs
/// alone.
Skeleton leadingJoints() {
    Skeleton s;
    const int root = add(s, "Root", -1, {0, 0.95, 0});
    const int chest = add(s, "Spine2", add(s, "Spine1", root, {0, 0.1, 0}), {0, 0.2, 0});
    add(s, "Head", add(s, "Neck", chest, {0, 0.2, 0}), {0, 0.1, 0});
    const int pelvis = add(s, "Hips", root, {0, 0.02, 0});
    for (const double k : {1.0, -1.0}) {
        const std::string side = k > 0.0 ? "_L" : "_R";
        const int collar =
            add(s, "Clavicle" + side, add(s, "__Clavicle" + side, chest, {0, 0.2, 0}), {0.03 * k, -0.05, 0});
        const int elbow =
            add(s, "LoArm" + side, add(s, "UpArm" + side, collar, {0.14 * k, 0, 0}), {0.28 * k, 0, 0});
        add(s, "Hand" + side, elbow, {0.25 * k, 0, 0});
        const int leg =
            add(s, "UpLeg" + side, add(s, "__UpLeg" + side, pelvis, {0, -0.05, 0}), {0.1 * k, 0, 0});
        const int foot = add(s, "Foot" + side, add(s, "LoLeg" + side, leg, {0, -0.42, 0}), {0, -0.4, 0});
        add(s, "Toe" + side, foot, {0, -0.05, 0.12});
    }
    return s;
}

std::string jointName(const Skeleton& skeleton, const motion::HumanoidMap& map, Bone bone) {
    return map.has(bone) ? skeleton.joints[static_cast<std::size_t>(map[bone])].name : "";
}

std::vector<Pose> restWorld(const Skeleton& skeleton) {
    return motion::worldPose(skeleton, motion::restPose(skeleton));
}

/// The reference humanoid under names that say nothing; above each elbow, hand and foot another joint stands
/// in its place.
struct Doubled {
    Skeleton skeleton;
    motion::HumanoidMap truth;
};
Doubled doubledJoints(bool doubled) {
    const Skeleton& reference = motion::referenceHumanoid();
    Doubled out;
    std::vector<int> place;
    for (std::size_t b = 0; b < motion::bone_count; ++b) {
        motion::Joint joint = reference.joints[b];
        if (joint.parent >= 0) joint.parent = place[static_cast<std::size_t>(joint.parent)];
        const auto bone = static_cast<Bone>(b);
        if (doubled && (bone == Bone::leftLowerArm || bone == Bone::rightLowerArm || bone == Bone::leftHand ||
                        bone == Bone::rightHand || bone == Bone::leftFoot || bone == Bone::rightFoot)) {
            joint.parent = add(out.skeleton, "m" + std::to_string(b), joint.parent, joint.rest.position);
            joint.rest.position = Vec3(0.0);
        }
        joint.name = "n" + std::to_string(b);
        place.push_back(out.skeleton.size());
        out.truth.joint[b] = out.skeleton.size();
        out.skeleton.joints.push_back(joint);
    }
    return out;
}

void checkSound(const Skeleton& skeleton) {
    const auto mapping = motion::mapHumanoid(skeleton);
    for (const int joint : mapping.map.joint) REQUIRE((joint >= -1 && joint < skeleton.size()));
    for (const auto& warning : motion::mappingWarnings(skeleton, mapping.map, restWorld(skeleton)))
        REQUIRE(warning.find("nan") == std::string::npos);
}

}  // namespace

TEST_SUITE("motion/humanoid_helpers") {
    TEST_CASE("Twist joints, beside the bones or in their chain, are no bones") {
        const std::map<Bone, std::string> truth{{Bone::hips, "b_root"},
                                                {Bone::spine, "b_spine0"},
                                                {Bone::upperChest, "b_spine3"},
                                                {Bone::neck, "b_neck0"},
                                                {Bone::head, "b_head"},
                                                {Bone::leftShoulder, "b_l_shoulder"},
                                                {Bone::leftUpperArm, "b_l_arm"},
                                                {Bone::leftLowerArm, "b_l_forearm"},
                                                {Bone::leftHand, "b_l_wrist"},
                                                {Bone::rightUpperArm, "b_r_arm"},
                                                {Bone::rightHand, "b_r_wrist"},
                                                {Bone::leftUpperLeg, "b_l_upleg"},
                                                {Bone::leftLowerLeg, "b_l_leg"},
                                                {Bone::rightFoot, "b_r_foot"},
                                                {Bone::rightToes, "b_r_foot_null"},
                                                {Bone::leftIndexProximal, "b_l_index1"},
                                                {Bone::rightLittleDistal, "b_r_pinky3"}};
        for (const Twist twist : {Twist::beside, Twist::in_place}) {
            const Skeleton skeleton = talkingWithHands(twist);
            const auto mapping = motion::mapHumanoid(skeleton);
            for (const auto& [bone, name] : truth) CHECK(jointName(skeleton, mapping.map, bone) == name);
            CHECK(motion::mappingWarnings(skeleton, mapping.map, restWorld(skeleton)).empty());
            // Without the names of the bones, those of the helpers still tell what they are not.
            Skeleton nameless = skeleton;
            for (std::size_t j = 0; j < nameless.joints.size(); ++j)
                if (nameless.joints[j].name.find("twist") == std::string::npos)
                    nameless.joints[j].name = "n" + std::to_string(j);
            const auto by_shape = motion::detectHumanoid(nameless);
            for (const Bone bone : {Bone::leftUpperArm, Bone::leftLowerArm, Bone::leftHand, Bone::rightFoot})
                CHECK(by_shape[bone] == mapping.map[bone]);
        }
    }

    TEST_CASE("Joints that only lead to a bone give their name to it") {
        const Skeleton skeleton = leadingJoints();
        const auto mapping = motion::mapHumanoid(skeleton);
        for (const auto& [bone, name] : std::map<Bone, std::string>{{Bone::hips, "Hips"},
                                                                    {Bone::spine, "Spine1"},
                                                                    {Bone::chest, "Spine2"},
                                                                    {Bone::leftShoulder, "Clavicle_L"},
                                                                    {Bone::rightShoulder, "Clavicle_R"},
                                                                    {Bone::leftUpperLeg, "UpLeg_L"},
                                                                    {Bone::rightUpperLeg, "UpLeg_R"},
                                                                    {Bone::rightToes, "Toe_R"}})
            CHECK(jointName(skeleton, mapping.map, bone) == name);
        // Where it has the name alone, it is the bone.
        Skeleton alone = skeleton;
        for (auto& joint : alone.joints)
            if (joint.name == "UpLeg_L" || joint.name == "UpLeg_R") joint.name += "x";
        CHECK(jointName(alone, motion::detectHumanoid(alone), Bone::leftUpperLeg) == "__UpLeg_L");
    }

    TEST_CASE("Of nameless joints in one place the lowest, which moves the next, is the bone") {
        const Doubled plain = doubledJoints(false);
        const Doubled doubled = doubledJoints(true);
        const auto of_plain = motion::detectHumanoid(plain.skeleton);
        const auto of_doubled = motion::detectHumanoid(doubled.skeleton);
        for (const Bone bone :
             {Bone::leftUpperArm, Bone::leftLowerArm, Bone::rightLowerArm, Bone::leftHand,
              Bone::leftIndexProximal, Bone::leftUpperLeg, Bone::rightFoot, Bone::rightToes}) {
            CHECK(of_plain[bone] == plain.truth[bone]);
            CHECK(of_doubled[bone] == doubled.truth[bone]);
        }
    }

    TEST_CASE("Limbs that fork once are no limbs, and no fault") {
        Skeleton star;
        add(star, "j0", -1, Vec3(0.0));
        const auto fork = [&](int from, const Vec3& to, const Vec3& ends) {
            const int limb = add(star, "j" + std::to_string(star.size()), from, to);
            for (const double k : {0.0, 0.1})
                star.joints[static_cast<std::size_t>(
                                add(star, "j" + std::to_string(star.size()), limb, ends + Vec3(0, 0, k)))]
                    .end_site = 0.1 * ends;
        };
        fork(0, {0.1, -0.05, 0}, {0, -0.85, 0});
        fork(0, {-0.1, -0.05, 0}, {0, -0.85, 0});
        const int chest = add(star, "chest", 0, {0, 0.4, 0});
        fork(chest, {0.2, 0, 0}, {0.6, 0, 0});
        fork(chest, {-0.2, 0, 0}, {-0.6, 0, 0});
        add(star, "top", add(star, "throat", chest, {0, 0.1, 0}), {0, 0.2, 0});
        const auto map = motion::detectHumanoid(star);
        for (const Bone bone : motion::requiredBones())
            if (bone != Bone::hips && bone != Bone::head) CHECK_FALSE(map.has(bone));
    }

    TEST_CASE("Any tree of joints has a map of its own joints") {
        const std::vector<std::string> words{"Left", "Right", "Arm", "Leg",  "Hips", "Head", "twist", "__",
                                             "Foot", "Hand",  "j",   "Neck", "_",    "1",    "Index", "roll"};
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            CAPTURE(seed);
            Random random(seed);
            Skeleton s;
            const auto count = 1 + random.below(40);
            for (std::uint64_t j = 0; j < count; ++j) {
                std::string name;
                for (std::uint64_t i = random.below(3); i > 0; --i) name += words[random.below(words.size())];
                // Few lengths, so that limbs are alike; some none.
                const auto part = [&] { return 0.2 * (static_cast<double>(random.below(5)) - 2.0); };
                const int parent =
                    j == 0 ? -1 : static_cast<int>(j - 1 - random.below(std::min<std::uint64_t>(j, 4)));
                const int made = add(s, name + "#" + std::to_string(j), parent, {part(), part(), part()});
                if (random.below(3) == 0)
                    s.joints[static_cast<std::size_t>(made)].end_site = Vec3(part(), part(), part());
            }
            checkSound(s);
        }
    }

    TEST_CASE("A map that makes shoulders or arms less than half as large as the figure's is doubted") {
        const Skeleton skeleton = talkingWithHands(Twist::beside);
        motion::HumanoidMap map = motion::detectHumanoid(skeleton);
        const auto world = restWorld(skeleton);
        motion::HumanoidMap collars = map;
        collars[Bone::leftUpperArm] = skeleton.find("b_l_shoulder");
        collars[Bone::rightUpperArm] = skeleton.find("b_r_shoulder");
        const auto warnings = motion::mappingWarnings(skeleton, collars, world);
        REQUIRE(warnings.size() == 1);
        // Legs of 0.42 and 0.4 m; the reference humanoid's shoulders are 0.35 m apart and its legs 0.815 m.
        CHECK(warnings[0].find(
                  "the shoulders are apart by 0.06 m, less than half of what is usual with legs of "
                  "0.82 m (0.35 m): is 'b_l_shoulder' really leftUpperArm") == 0);
        motion::HumanoidMap twist = map;
        twist[Bone::leftLowerArm] = skeleton.find("b_l_arm_twist");
        twist[Bone::rightLowerArm] = skeleton.find("b_r_arm_twist");
        twist[Bone::leftHand] = skeleton.find("b_l_arm_twist2");
        twist[Bone::rightHand] = skeleton.find("b_r_arm_twist2");
        REQUIRE(motion::mappingWarnings(skeleton, twist, world).size() == 1);
        // A retargeted clip says so, too.
        motion::Clip clip;
        clip.skeleton = skeleton;
        clip.frames.assign(3, motion::restPose(skeleton));
        const Skeleton& avatar = motion::referenceHumanoid();
        motion::RetargetReport report;
        REQUIRE(
            motion::retarget(clip, collars, avatar, motion::mapByVrmNames(avatar), {}, &report).has_value());
        CHECK(std::find(report.remarks.begin(), report.remarks.end(), warnings[0]) != report.remarks.end());
        map[Bone::rightUpperLeg] = map[Bone::leftUpperLeg];
        map[Bone::rightLowerLeg] = map[Bone::leftLowerLeg];
        map[Bone::rightFoot] = map[Bone::leftFoot];
        const auto rejected = motion::retarget(clip, map, avatar, motion::mapByVrmNames(avatar));
        REQUIRE_FALSE(rejected.has_value());
        CHECK(
            rejected.error().message.find("leftUpperLeg ('b_l_upleg') and rightUpperLeg ('b_l_upleg') are in "
                                          "one place") == 0);
        CHECK(rejected.error().hint.find("NAME.humanoid.toml") != std::string::npos);
    }
}
