#include "motion/retarget.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "retarget_assembly.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

std::size_t index(Bone bone) {
    return static_cast<std::size_t>(bone);
}

double alongUp(const BodyShape& shape, Bone bone, const Vec3& rise) {
    const auto direction = shape.direction(bone);
    return direction ? glm::dot(*direction, rise) : 1.0;
}

/// How well the figure stands: 6 with legs and trunk in one line, the thighs side by side.
double standing(const BodyShape& shape) {
    const TrunkAxes axes = standingAxes(shape);
    if (glm::length(axes.hips_up) < 1e-6 || glm::length(axes.hip_line) < 1e-6 ||
        glm::length(axes.shoulder_line) < 1e-6)
        return -6.0;
    const Vec3 rise = glm::normalize(axes.hips_up);
    const Vec3 hip_centre = 0.5 * (*shape.at(leftUpperLeg) + *shape.at(rightUpperLeg));
    double score = glm::dot(glm::normalize(*shape.at(head) - hip_centre), rise);
    for (const Bone bone : {leftUpperLeg, rightUpperLeg, leftLowerLeg, rightLowerLeg})
        score -= alongUp(shape, bone, rise);
    return score + 1.0 - std::abs(glm::dot(glm::normalize(axes.hip_line), rise));
}

/// A pose of the source in which it stands about upright and straight: what the avatar's T pose is aligned
/// to.
struct Neutral {
    std::vector<Pose> world;
    BodyShape shape;
    bool is_rest;
};

class Source {
  public:
    Source(const Clip& clip, const HumanoidMap& map) : clip_(clip), map_(map) {
        worlds_.resize(clip.frames.size());
        shapes_.reserve(clip.frames.size());
        for (std::size_t f = 0; f < clip.frames.size(); ++f) {
            worldPose(clip.skeleton, clip.frames[f], worlds_[f]);
            shapes_.push_back(shapeOf(clip.skeleton, map, worlds_[f]));
        }
    }

    [[nodiscard]] const BodyShape& shape(std::size_t frame) const { return shapes_[frame]; }
    [[nodiscard]] std::size_t frameCount() const { return shapes_.size(); }
    [[nodiscard]] const Quat& rotation(std::size_t frame, Bone bone) const {
        return worlds_[frame][static_cast<std::size_t>(map_[bone])].orientation;
    }

    /// The rest pose, if it is that of a standing figure. Some rigs' rest is a heap of bones; then the frame
    /// in which the figure stands best.
    [[nodiscard]] Neutral neutral() const {
        constexpr double well_enough = 4.5;
        auto world = worldPose(clip_.skeleton, restPose(clip_.skeleton));
        const BodyShape rest = shapeOf(clip_.skeleton, map_, world);
        if (standing(rest) > well_enough) return {std::move(world), rest, true};
        std::size_t best = 0;
        double best_score = -100.0;
        for (std::size_t f = 0; f < shapes_.size(); ++f)
            if (const double score = standing(shapes_[f]); score > best_score) {
                best = f;
                best_score = score;
            }
        return {worlds_[best], shapes_[best], false};
    }

    /// The axis that is up in the motion: y, unless the figure on the whole rises along another axis, and its
    /// rest too (else it lies down).
    [[nodiscard]] Vec3 upAxis(const Neutral& neutral) const {
        Vec3 mean(0.0);
        for (const BodyShape& shape : shapes_) mean += glm::normalize(standingAxes(shape).hips_up);
        mean = glm::normalize(mean);
        constexpr double clearly = 0.7;
        if (mean.y > 1.0 - clearly) return up;
        if (neutral.is_rest && glm::normalize(standingAxes(neutral.shape).hips_up).y > clearly) return up;
        int axis = 0;
        for (int i = 1; i < 3; ++i)
            if (std::abs(mean[i]) > std::abs(mean[axis])) axis = i;
        Vec3 out(0.0);
        out[axis] = mean[axis] < 0.0 ? -1.0 : 1.0;
        return out;
    }

    /// Many CMU conversions carry a T pose in front of the motion.
    [[nodiscard]] bool startsWithAddedPose() const {
        if (frameCount() < 3) return false;
        constexpr double jump_rad = 0.17;
        const double first = meanTurn(0);
        return first > jump_rad && first > 5.0 * meanTurn(1);
    }

  private:
    double meanTurn(std::size_t frame) const {
        double sum = 0.0;
        int count = 0;
        for (const Hinge& hinge : hinges())
            for (const Bone bone : {hinge.upper, hinge.lower}) {
                const auto a = shapes_[frame].direction(bone);
                const auto b = shapes_[frame + 1].direction(bone);
                if (!a || !b) continue;
                sum += angleBetween(*a, *b);
                ++count;
            }
        return count > 0 ? sum / count : 0.0;
    }

    const Clip& clip_;
    const HumanoidMap& map_;
    std::vector<std::vector<Pose>> worlds_;
    std::vector<BodyShape> shapes_;
};

/// The bones whose rotation the source gives. Fingers count where a whole finger is there: single stand-ins
/// for all fingers (CMU) leave the avatar's hand relaxed.
BoneSet givenBones(const HumanoidMap& map) {
    BoneSet given{};
    for (std::size_t b = 0; b < bone_count; ++b) given[b] = map.joint[b] >= 0;
    for (auto b = index(leftThumbMetacarpal); b < bone_count; b += 3) {  // fingers have three bones each
        const bool whole = given[b] && given[b + 1];
        for (std::size_t i = b; i < b + 3; ++i) given[i] = given[i] && whole;
    }
    given[index(jaw)] = given[index(leftEye)] = given[index(rightEye)] = false;
    return given;
}

class Retargeter {
  public:
    Retargeter(const Source& source, const AvatarRest& avatar, const BoneSet& given, const Neutral& neutral,
               const HumanoidMap& map)
        : source_(source), avatar_(avatar), given_(given) {
        for (std::size_t b = 0; b < bone_count; ++b)
            neutral_from_[b] =
                given[b] ? neutral.world[static_cast<std::size_t>(map.joint[b])].orientation : no_rotation;
        BoneTwists twist{};
        align(neutral, twist);
        // The lower bones' twist hangs on the upper ones', so these are fitted first.
        for (const bool lower : {false, true}) {
            constexpr double prior_of_frame = 0.05;
            HingeFit fit(avatar.shape, prior_of_frame * static_cast<double>(source.frameCount()));
            for (std::size_t f = 0; f < source.frameCount(); ++f) fit.add(rotations(f), source.shape(f));
            for (const Hinge& hinge : hinges()) {
                const Bone bone = lower ? hinge.lower : hinge.upper;
                twist[index(bone)] = fit.twist(bone);
            }
            align(neutral, twist);
        }
    }

    /// World rotations of the avatar's bones in a frame, in the source's axes.
    [[nodiscard]] BoneTurns rotations(std::size_t frame) const {
        BoneTurns out;
        out.fill(no_rotation);
        for (std::size_t b = 0; b < bone_count; ++b)
            if (given_[b]) out[b] = source_.rotation(frame, static_cast<Bone>(b)) * source_from_avatar_[b];
        fillTrunk(out);
        return out;
    }

  private:
    void align(const Neutral& neutral, const BoneTwists& twist) {
        const BoneTurns aligned =
            alignBody(avatar_.shape, avatar_.axes, neutral.shape, standingAxes(neutral.shape), twist);
        for (std::size_t b = 0; b < bone_count; ++b)
            source_from_avatar_[b] = glm::conjugate(neutral_from_[b]) * aligned[b];
    }

    /// The avatar has three bones between hips and neck; a source with fewer gives its topmost rotation to
    /// the upper chest, and the others lie between their neighbours.
    void fillTrunk(BoneTurns& out) const {
        if (!given_[index(upperChest)])
            out[index(upperChest)] = out[index(given_[index(chest)]   ? chest
                                               : given_[index(spine)] ? spine
                                                                      : hips)];
        const bool own_chest = given_[index(chest)] && given_[index(upperChest)];
        const bool own_spine = given_[index(spine)] && given_[index(chest)];
        if (!own_spine) out[index(spine)] = glm::slerp(out[index(hips)], out[index(upperChest)], 1.0 / 3.0);
        if (!own_chest) out[index(chest)] = glm::slerp(out[index(spine)], out[index(upperChest)], 0.5);
        if (!given_[index(neck)])
            out[index(neck)] = glm::slerp(out[index(upperChest)], out[index(head)], 0.5);
        for (const Bone bone : {leftShoulder, rightShoulder})
            if (!given_[index(bone)]) out[index(bone)] = out[index(upperChest)];
    }

    const Source& source_;
    const AvatarRest& avatar_;
    const BoneSet& given_;
    BoneTurns neutral_from_{};        // world rotation of the source's joint in its neutral pose
    BoneTurns source_from_avatar_{};  // constant rotation from the avatar's bone to the source's joint
};

}  // namespace

Result<Clip> retarget(const Clip& source_clip, const HumanoidMap& source_map, const Skeleton& avatar_skeleton,
                      const HumanoidMap& avatar_map, RetargetReport* report) {
    BoneSet given = givenBones(source_map);
    if (const auto missing = missingBones(given); !missing.empty())
        return fail("", "no joint was found for " + missing + ", expected the bones of a humanoid",
                    "Name the joints as VRM, Mixamo, CMU or another common rig does");
    if (const auto missing = missingBones(givenBones(avatar_map)); !missing.empty())
        return fail("", "the avatar has no " + missing + ", expected the bones of a humanoid");

    const Source source(source_clip, source_map);
    const Neutral neutral = source.neutral();
    if (standing(neutral.shape) < 0.0)
        return fail("", "the figure's bones lie in one another, expected a figure that can stand");
    const AvatarRest avatar = avatarRest(avatar_skeleton, avatar_map);
    const Retargeter retargeter(source, avatar, given, neutral, source_map);

    const Vec3 up_axis = source.upAxis(neutral);
    const Quat upright = rotationBetween(up_axis, up);
    const double scale = avatar.leg_length_m / legLength(neutral.shape);
    std::vector<BodyFrame> frames;
    frames.reserve(source.frameCount());
    for (std::size_t f = 0; f < source.frameCount(); ++f) {
        BodyFrame frame{retargeter.rotations(f), {}};
        for (Quat& rotation : frame.rotation) rotation = upright * rotation;
        const BodyShape& shape = source.shape(f);
        frame.hip_centre = upright * (0.5 * scale * (*shape.at(leftUpperLeg) + *shape.at(rightUpperLeg)));
        frames.push_back(frame);
    }
    const bool added = source.startsWithAddedPose();
    if (added) frames[0] = frames[1];

    // What fillTrunk derives is driven too.
    for (const Bone bone : {spine, chest, upperChest, neck, leftShoulder, rightShoulder})
        given[index(bone)] = true;
    if (report) {
        report->scale = scale;
        if (!neutral.is_rest)
            report->remarks.emplace_back("the rest pose is no standing figure: aligned to a frame instead");
        if (up_axis != up) report->remarks.emplace_back("turned so that the figure's up axis is y");
        if (added) report->remarks.emplace_back("frame 0 is an added pose: frame 1 stands in for it");
        if (!given[index(leftIndexProximal)])
            report->remarks.emplace_back("no fingers in the source: the hands are relaxed");
    }
    return assemble(avatar, std::move(frames), given, Ground::clip, source_clip.frame_time_s);
}

}  // namespace deixis::motion
