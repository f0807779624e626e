#include "expmap_skeletons.hpp"

#include <array>
#include <string>
#include <vector>

namespace deixis::assets {

namespace {

/// A joint; those whose name ends in "Site" are tips, which have columns but never move.
struct Row {
    const char* name;
    int parent;
    Vec3 offset;
};

// Human3.6M, subject 1's skeleton: parents and offsets as in forward_kinematics.py of Martinez et al.'s
// repository, names as in Human3.6M's own skeleton (asf). The arms' offsets rise along y: their direction is
// all in the rotations.
const std::vector<Row> human36m{{"Hips", -1, {0, 0, 0}},
                                {"RightUpLeg", 0, {-132.948591, 0, 0}},
                                {"RightLeg", 1, {0, -442.894612, 0}},
                                {"RightFoot", 2, {0, -454.206447, 0}},
                                {"RightToeBase", 3, {0, 0, 162.767078}},
                                {"RightToeSite", 4, {0, 0, 74.999437}},
                                {"LeftUpLeg", 0, {132.948826, 0, 0}},
                                {"LeftLeg", 6, {0, -442.894413, 0}},
                                {"LeftFoot", 7, {0, -454.206590, 0}},
                                {"LeftToeBase", 8, {0, 0, 162.767426}},
                                {"LeftToeSite", 9, {0, 0, 74.999948}},
                                {"Spine", 0, {0, 0.1, 0}},
                                {"Spine1", 11, {0, 233.383263, 0}},
                                {"Neck", 12, {0, 257.077681, 0}},
                                {"Head", 13, {0, 121.134938, 0}},
                                {"HeadSite", 14, {0, 115.002227, 0}},
                                {"LeftShoulder", 12, {0, 257.077681, 0}},
                                {"LeftArm", 16, {0, 151.034226, 0}},
                                {"LeftForeArm", 17, {0, 278.882773, 0}},
                                {"LeftHand", 18, {0, 251.733451, 0}},
                                {"LeftHandThumb", 19, {0, 0, 0}},
                                {"LeftThumbSite", 20, {0, 0, 99.999627}},
                                {"LeftWristEnd", 19, {0, 100.000188, 0}},
                                {"LeftWristSite", 22, {0, 0, 0}},
                                {"RightShoulder", 12, {0, 257.077681, 0}},
                                {"RightArm", 24, {0, 151.031437, 0}},
                                {"RightForeArm", 25, {0, 278.892924, 0}},
                                {"RightHand", 26, {0, 251.728680, 0}},
                                {"RightHandThumb", 27, {0, 0, 0}},
                                {"RightThumbSite", 28, {0, 0, 99.999888}},
                                {"RightWristEnd", 27, {0, 137.499922, 0}},
                                {"RightWristSite", 30, {0, 0, 0}}};

// CMU: parents and offsets as in forward_kinematics_cmu.py of Li et al.'s repository, without its factor of
// 70, which the root's position does not have; names as in CMU's own skeletons.
const std::vector<Row> cmu{{"Hips", -1, {0, 0, 0}},
                           {"LHipJoint", 0, {0, 0, 0}},
                           {"LeftUpLeg", 1, {1.65674, -1.80282, 0.62477}},
                           {"LeftLeg", 2, {2.59720, -7.13576, 0}},
                           {"LeftFoot", 3, {2.49236, -6.84770, 0}},
                           {"LeftToeBase", 4, {0.19704, -0.54136, 2.14581}},
                           {"LeftToeSite", 5, {0, 0, 1.11249}},
                           {"RHipJoint", 0, {0, 0, 0}},
                           {"RightUpLeg", 7, {-1.61070, -1.80282, 0.62476}},
                           {"RightLeg", 8, {-2.59502, -7.12977, 0}},
                           {"RightFoot", 9, {-2.46780, -6.78024, 0}},
                           {"RightToeBase", 10, {-0.23024, -0.63258, 2.13368}},
                           {"RightToeSite", 11, {0, 0, 1.11569}},
                           {"LowerBack", 0, {0, 0, 0}},
                           {"Spine", 13, {0.01961, 2.05450, -0.14112}},
                           {"Spine1", 14, {0.01021, 2.06436, -0.05921}},
                           {"Neck", 15, {0, 0, 0}},
                           {"Neck1", 16, {0.00713, 1.56711, 0.14968}},
                           {"Head", 17, {0.03429, 1.56041, -0.10006}},
                           {"HeadSite", 18, {0.01305, 1.62560, -0.05265}},
                           {"LeftShoulder", 15, {0, 0, 0}},
                           {"LeftArm", 20, {3.54205, 0.90436, -0.17364}},
                           {"LeftForeArm", 21, {4.86513, 0, 0}},
                           {"LeftHand", 22, {3.35554, 0, 0}},
                           {"LeftFingerBase", 23, {0, 0, 0}},
                           {"LeftHandIndex1", 24, {0.66117, 0, 0}},
                           {"LeftIndexSite", 25, {0.53306, 0, 0}},
                           {"LThumb", 23, {0, 0, 0}},
                           {"LeftThumbSite", 27, {0.54120, 0, 0.54120}},
                           {"RightShoulder", 15, {0, 0, 0}},
                           {"RightArm", 29, {-3.49802, 0.75994, -0.32616}},
                           {"RightForeArm", 30, {-5.02649, 0, 0}},
                           {"RightHand", 31, {-3.36431, 0, 0}},
                           {"RightFingerBase", 32, {0, 0, 0}},
                           {"RightHandIndex1", 33, {-0.73041, 0, 0}},
                           {"RightIndexSite", 34, {-0.58887, 0, 0}},
                           {"RThumb", 32, {0, 0, 0}},
                           {"RightThumbSite", 36, {-0.59786, 0, 0.59786}}};

motion::Skeleton skeletonOf(const std::vector<Row>& rows) {
    motion::Skeleton skeleton;
    for (const Row& row : rows) {
        motion::Joint joint;
        joint.name = row.name;
        joint.parent = row.parent;
        joint.rest.position = row.offset;
        skeleton.joints.push_back(std::move(joint));
    }
    return skeleton;
}

}  // namespace

const ExpmapSkeleton* expmapSkeleton(std::size_t columns) {
    static const std::array<ExpmapSkeleton, 2> all{
        {{"exponential maps (Human3.6M)", 3 + 3 * human36m.size(), 0.001, "millimetre", 25.0,
          "25 fps, the usual reduced rate of these data; published recordings have 50", skeletonOf(human36m)},
         {"exponential maps (CMU)", 3 + 3 * cmu.size(), 0.0254 / 0.45, "1/0.45 inch", 30.0,
          "30 fps, the usual reduced rate of these data; published recordings have 120", skeletonOf(cmu)}}};
    for (const ExpmapSkeleton& skeleton : all)
        if (skeleton.columns == columns) return &skeleton;
    return nullptr;
}

}  // namespace deixis::assets
