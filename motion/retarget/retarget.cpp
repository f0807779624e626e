#include "motion/retarget/retarget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "assembly.hpp"
#include "core/order_statistics.hpp"
#include "core/parallel.hpp"
#include "feet.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/skeleton/bone_index.hpp"
#include "pointing.hpp"
#include "source.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

constexpr std::size_t frames_worth_a_thread = 2000;

/// The bones whose rotation the source gives. Fingers count where a whole finger is there: single stand-ins
/// for all fingers (CMU) leave the avatar's hand relaxed.
BoneSet givenBones(const HumanoidMap& map) {
    BoneSet given{};
    for (std::size_t b = 0; b < bone_count; ++b) given[b] = map.joint[b] >= 0;
    for (auto b = indexOf(leftThumbMetacarpal); b < bone_count; b += 3) {  // fingers have three bones each
        const bool whole = given[b + 1] && (given[b] || given[b + 2]);
        for (std::size_t i = b; i < b + 3; ++i) given[i] = given[i] && whole;
    }
    given[indexOf(jaw)] = given[indexOf(leftEye)] = given[indexOf(rightEye)] = false;
    return given;
}

/// Whether the source is built as the avatar, up to its size: then rotations carry over as they are.
bool isBuiltAlike(const Skeleton& source, const HumanoidMap& source_map, const AvatarRest& avatar,
                  double scale) {
    const auto world = worldPose(source, restPose(source));
    for (const Joint& joint : source.joints)
        if (joint.parent >= 0 && std::abs(joint.rest.orientation.w) < 1.0 - 1e-12) return false;
    for (std::size_t b = 0; b < bone_count; ++b) {
        const int joint = source_map.joint[b];
        if ((joint >= 0) != (avatar.map.joint[b] >= 0)) return false;
        const int above = avatar.above[b];
        if (joint < 0 || above < 0) continue;
        const Vec3 offset =
            world[static_cast<std::size_t>(joint)].position -
            world[static_cast<std::size_t>(source_map.joint[static_cast<std::size_t>(above)])].position;
        if (glm::length(scale * offset - avatar.offset[b]) > 1e-5) return false;
    }
    return true;
}

class Retargeter {
  public:
    Retargeter(const Source& source, const AvatarRest& avatar, const BoneSet& given, const Neutral& neutral,
               bool alike)
        : source_(source), avatar_(avatar), given_(given) {
        const HumanoidMap& map = source.map();
        for (std::size_t b = 0; b < bone_count; ++b)
            neutral_from_[b] =
                given[b] ? neutral.world[static_cast<std::size_t>(map.joint[b])].orientation : no_rotation;
        source_from_avatar_.fill(no_rotation);
        if (alike) return;
        BoneTwists twist{};
        BoneTurns turns;
        align(neutral, twist);
        // The lower bones' twist hangs on the upper ones', so these are fitted first.
        for (const bool lower : {false, true}) {
            constexpr double prior_of_frame = 0.05;
            HingeFit fit(avatar.shape, prior_of_frame * static_cast<double>(source.looks().size()));
            for (const Source::Look& look : source.looks()) {
                rotations(look.world, turns);
                fit.add(turns, look.shape);
            }
            for (const Hinge& hinge : hinges()) {
                const Bone bone = lower ? hinge.lower : hinge.upper;
                twist[indexOf(bone)] = fit.twist(bone);
            }
            align(neutral, twist);
        }
    }

    /// World rotations of the avatar's bones, in the source's axes. `world`: the source's joints.
    void rotations(const std::vector<Pose>& world, BoneTurns& out) const {
        for (std::size_t b = 0; b < bone_count; ++b)
            out[b] = given_[b] ? world[static_cast<std::size_t>(source_.map().joint[b])].orientation *
                                     source_from_avatar_[b]
                               : no_rotation;
        fillGaps(out);
    }

  private:
    void align(const Neutral& neutral, const BoneTwists& twist) {
        const BoneTurns aligned =
            alignBody(avatar_.shape, avatar_.axes, neutral.shape, standingAxes(neutral.shape), twist);
        for (std::size_t b = 0; b < bone_count; ++b)
            source_from_avatar_[b] = glm::conjugate(neutral_from_[b]) * aligned[b];
    }

    /// The avatar has three bones between hips and neck; a source with fewer gives its topmost rotation to
    /// the upper chest, and the others lie between their neighbours. Toes go with the foot.
    void fillGaps(BoneTurns& out) const {
        if (!given_[indexOf(upperChest)])
            out[indexOf(upperChest)] = out[indexOf(given_[indexOf(chest)]   ? chest
                                                   : given_[indexOf(spine)] ? spine
                                                                            : hips)];
        const bool own_chest = given_[indexOf(chest)] && given_[indexOf(upperChest)];
        const bool own_spine = given_[indexOf(spine)] && given_[indexOf(chest)];
        if (!own_spine)
            out[indexOf(spine)] = glm::slerp(out[indexOf(hips)], out[indexOf(upperChest)], 1.0 / 3.0);
        if (!own_chest) out[indexOf(chest)] = glm::slerp(out[indexOf(spine)], out[indexOf(upperChest)], 0.5);
        if (!given_[indexOf(neck)])
            out[indexOf(neck)] = glm::slerp(out[indexOf(upperChest)], out[indexOf(head)], 0.5);
        for (const Bone bone : {leftShoulder, rightShoulder})
            if (!given_[indexOf(bone)]) out[indexOf(bone)] = out[indexOf(upperChest)];
        if (!given_[indexOf(leftToes)]) out[indexOf(leftToes)] = out[indexOf(leftFoot)];
        if (!given_[indexOf(rightToes)]) out[indexOf(rightToes)] = out[indexOf(rightFoot)];
    }

    const Source& source_;
    const AvatarRest& avatar_;
    const BoneSet& given_;
    BoneTurns neutral_from_{};        // world rotation of the source's joint in its neutral pose
    BoneTurns source_from_avatar_{};  // constant rotation from the avatar's bone to the source's joint
};

/// The motion in the avatar's frame, and the sight line of the source there.
struct Moved {
    std::vector<BodyFrame> frames;  // at the avatar's scale
    std::vector<SightLine> lines;   // of the gesture, onset to end; at the source's scale
    double lowest_m = 0.0;          // height of the soles' lowest point
};

class Mover {
  public:
    Mover(const Source& source, const Retargeter& retargeter, const AvatarRest& avatar, double scale,
          const Quat& upright)
        : source_(source), retargeter_(retargeter), avatar_(avatar), scale_(scale), turn_(upright) {}

    /// `first`: the frame that stands at the start, also for those before it. With a target, which is given
    /// in the clip's coordinates, the figure stays where it stands; else it begins at the origin, facing +z.
    Moved move(std::size_t first, const PointingGesture* gesture) {
        const bool stays = gesture != nullptr && gesture->target.has_value();
        BodyFrame start;
        std::vector<Pose> world;
        read(first, start, world);
        const Quat to_front = turnToFront(start);
        const Vec3 begin = hipsPosition(avatar_, start);
        if (!stays) turn_ = to_front * turn_;

        Moved out = frames(gesture);
        for (std::size_t f = 0; f < first; ++f) out.frames[f] = out.frames[first];
        const auto [floor, lowest] = floorHeight(avatar_, out.frames);
        out.lowest_m = lowest - floor;
        const Vec3 from = stays ? begin : to_front * begin;
        // A clip that stays begins where the source does, and its way is scaled from there.
        const Vec3 there = stays ? Vec3(begin.x, 0.0, begin.z) / scale_ : Vec3(0.0);
        for (BodyFrame& frame : out.frames) frame.hip_centre += there - Vec3(from.x, floor, from.z);
        if (stays) return out;
        const Vec3 line_shift = Vec3(from.x, 0.0, from.z) / scale_ + Vec3(0.0, sourceFloor(), 0.0);
        for (SightLine& line : out.lines) line = {line.eye - line_shift, line.fingertip - line_shift};
        return out;
    }

  private:
    /// `world`: filled with the source's joints.
    void read(std::size_t f, BodyFrame& out, std::vector<Pose>& world) const {
        source_.place(f, turn_, world);
        retargeter_.rotations(world, out.rotation);
        out.hip_centre = 0.5 * scale_ * (position(world, leftUpperLeg) + position(world, rightUpperLeg));
    }
    [[nodiscard]] const Vec3& position(const std::vector<Pose>& world, Bone bone) const {
        return world[static_cast<std::size_t>(source_.map()[bone])].position;
    }

    /// Height of the floor that the source stands on, metres at its own scale.
    double sourceFloor() {
        constexpr double ankle_of_leg = 0.104;  // as in the reference humanoid
        return orderStatistic(ankles_, ankles_.size() / 10) - ankle_of_leg * avatar_.leg_length_m / scale_;
    }

    Moved frames(const PointingGesture* gesture) {
        std::optional<SightLineFinder> finder;
        if (gesture != nullptr)
            finder.emplace(source_.clip().skeleton, source_.map(), gesture->hand, avatar_, scale_);
        Moved out;
        out.frames.resize(source_.clip().frames.size());
        ankles_.resize(out.frames.size());
        if (finder) out.lines.resize(static_cast<std::size_t>(gesture->end_frame - gesture->onset_frame) + 1);
        forRanges(out.frames.size(), frames_worth_a_thread, [&](std::size_t from, std::size_t to) {
            std::vector<Pose> world;
            for (std::size_t f = from; f < to; ++f) {
                read(f, out.frames[f], world);
                ankles_[f] = std::min(position(world, leftFoot).y, position(world, rightFoot).y);
                const int number = static_cast<int>(f);
                if (finder && number >= gesture->onset_frame && number <= gesture->end_frame)
                    out.lines[static_cast<std::size_t>(number - gesture->onset_frame)] =
                        finder->find(world, out.frames[f].rotation[indexOf(head)]);
            }
        });
        return out;
    }

    const Source& source_;
    const Retargeter& retargeter_;
    const AvatarRest& avatar_;
    double scale_;
    Quat turn_;                   // avatar's frame from the source's
    std::vector<double> ankles_;  // of each frame the lower one's height, at the source's scale
};

constexpr const char* name_the_joints =
    "Name the joints as VRM, Mixamo, CMU or another common rig does, or say in NAME.humanoid.toml beside the "
    "clip which joint is which bone";

/// Why a figure cannot stand, by the bones and joints that are in one place.
std::string unableToStand(const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world) {
    constexpr std::pair<Bone, Bone> apart[] = {
        {leftUpperLeg, rightUpperLeg}, {leftUpperArm, rightUpperArm}, {leftFoot, head}, {rightFoot, head}};
    for (const auto& [a, b] : apart) {
        const auto i = static_cast<std::size_t>(map[a]);
        const auto j = static_cast<std::size_t>(map[b]);
        if (glm::length(world[i].position - world[j].position) < 1e-6)
            return std::string(boneName(a)) + " ('" + skeleton.joints[i].name + "') and " +
                   std::string(boneName(b)) + " ('" + skeleton.joints[j].name +
                   "') are in one place, expected a figure that can stand";
    }
    return "hips, legs and head ('" + skeleton.joints[static_cast<std::size_t>(map[hips])].name + "', '" +
           skeleton.joints[static_cast<std::size_t>(map[leftUpperLeg])].name + "', '" +
           skeleton.joints[static_cast<std::size_t>(map[head])].name +
           "' and the others) are above the feet in no frame, expected a figure that can stand";
}

std::vector<SightLine> linesOfClip(const Clip& clip, const HumanoidMap& map, const PointingGesture& gesture) {
    std::vector<SightLine> lines;  // peak to hold
    std::vector<Pose> world;
    for (int f = gesture.peak_frame; f <= gesture.hold_frame; ++f) {
        worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(f)], world);
        lines.push_back(
            {eyePosition(map, world), fingertipPosition(clip.skeleton, map, world, gesture.hand)});
    }
    return lines;
}

}  // namespace

std::string_view keepName(Keep keep) {
    return keep == Keep::joint_angles ? "joint-angles" : "pointing-ray";
}

std::optional<Keep> keepFromName(std::string_view name) {
    for (const Keep keep : {Keep::joint_angles, Keep::pointing_ray})
        if (keepName(keep) == name) return keep;
    return std::nullopt;
}

std::optional<PointingError> pointingError(const Clip& clip, const HumanoidMap& map,
                                           const PointingGesture& gesture) {
    if (!gesture.target || !checkPhases(gesture, clip.frameCount())) return std::nullopt;
    return pointingError(linesOfClip(clip, map, gesture), *gesture.target);
}

Result<Clip> retarget(const Clip& source_clip, const HumanoidMap& source_map, const Skeleton& avatar_skeleton,
                      const HumanoidMap& avatar_map, const RetargetOptions& options, RetargetReport* report) {
    BoneSet given = givenBones(source_map);
    if (const auto missing = missingBones(source_map); !missing.empty())
        return fail("",
                    fmt::format("no joint was found for {}, expected the bones of a humanoid",
                                fmt::join(missing, ", ")),
                    name_the_joints);
    if (const auto missing = missingBones(avatar_map); !missing.empty())
        return fail("", fmt::format("the avatar has no {}, expected the bones of a humanoid",
                                    fmt::join(missing, ", ")));
    const PointingGesture* gesture = options.gesture ? &*options.gesture : nullptr;
    if (gesture != nullptr)
        if (const auto checked = checkPhases(*gesture, source_clip.frameCount()); !checked)
            return tl::unexpected(checked.error());

    const Source source(source_clip, source_map);
    const Neutral neutral = source.neutral();
    if (standing(neutral.shape) < 0.0)
        return fail("", unableToStand(source_clip.skeleton, source_map, neutral.world), name_the_joints);
    const AvatarRest avatar = avatarRest(avatar_skeleton, avatar_map);
    const double scale = avatar.leg_length_m / legLength(neutral.shape);
    const bool alike = isBuiltAlike(source_clip.skeleton, source_map, avatar, scale);
    if (alike)
        for (const Bone bone : {jaw, leftEye, rightEye}) given[indexOf(bone)] = source_map.has(bone);
    const Retargeter retargeter(source, avatar, given, neutral, alike);
    const Vec3 up_axis = source.upAxis(neutral);
    const bool has_target = gesture != nullptr && gesture->target.has_value();

    RetargetReport made;
    made.scale = scale;
    made.remarks = mappingWarnings(source_clip.skeleton, source_map, neutral.world);
    if (!neutral.is_rest)
        made.remarks.emplace_back("the rest pose is not a standing figure: aligned to a frame instead");
    if (up_axis != up) made.remarks.emplace_back("turned so that the figure's up axis is y");
    const bool added = source.startsWithAddedPose();
    if (added) made.remarks.emplace_back("frame 0 is an added pose: replaced by frame 1");
    Moved moved =
        Mover(source, retargeter, avatar, scale, rotationBetween(up_axis, up)).move(added ? 1 : 0, gesture);
    const Side pointing = gesture != nullptr ? gesture->hand : Side::right;
    const bool fingers = given[indexOf(armBones(pointing).index_proximal)];
    const bool closes = options.close_hand && gesture != nullptr && !fingers;
    if (!fingers)
        made.remarks.emplace_back(closes ? "no fingers in the source: the hand closes while it points"
                                         : "no fingers in the source: the hands are relaxed");

    // What fillGaps derives is driven too.
    for (const Bone bone : {spine, chest, upperChest, neck, leftShoulder, rightShoulder, leftToes, rightToes})
        given[indexOf(bone)] = true;
    if (options.plant_feet) {
        made.feet = plantFeet(avatar, moved.frames, source_clip.frame_time_s);
        made.feet.lowest_before_m = moved.lowest_m;
    }
    const BodyPoser poser(avatar, given, closes ? gesture : nullptr);
    if (gesture != nullptr && options.keep == Keep::pointing_ray)
        keepPointingRay(avatar, poser, given, *gesture, moved.lines, moved.frames);

    Clip clip;
    clip.skeleton = avatar.skeleton;
    clip.frame_time_s = source_clip.frame_time_s;
    clip.frames.resize(moved.frames.size());
    forRanges(clip.frames.size(), frames_worth_a_thread, [&](std::size_t from, std::size_t to) {
        BodyPoser::Workspace workspace;
        for (std::size_t f = from; f < to; ++f)
            clip.frames[f] = poser.pose(moved.frames[f], static_cast<int>(f), workspace);
    });
    if (has_target) {
        const auto from = moved.lines.begin() + (gesture->peak_frame - gesture->onset_frame);
        const auto to = moved.lines.begin() + (gesture->hold_frame - gesture->onset_frame + 1);
        made.source_error = pointingError({from, to}, *gesture->target);
        made.avatar_error = pointingError(clip, avatar_map, *gesture);
    }
    if (report != nullptr) *report = std::move(made);
    return clip;
}

}  // namespace deixis::motion
