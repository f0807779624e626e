#include "motion/skeleton/clip_edit.hpp"

#include <string>
#include <utility>

#include "mirror_names.hpp"

namespace deixis::motion {

namespace {

/// Whether the image of each joint's parent is the parent of its image, so that joints may change places in
/// the list and each keep its parent.
bool sidesAlike(const Skeleton& skeleton, const std::vector<int>& partners,
                const std::vector<std::string>& image_names) {
    for (std::size_t i = 0; i < partners.size(); ++i) {
        const auto partner = static_cast<std::size_t>(partners[i]);
        const int parent = skeleton.joints[i].parent;
        const int image_parent = parent < 0 ? -1 : partners[static_cast<std::size_t>(parent)];
        if (skeleton.joints[partner].parent != image_parent) return false;
        if (partner == i && image_names[i] != skeleton.joints[i].name) return false;
    }
    return true;
}

Joint mirroredJoint(const Joint& joint) {
    Joint out = joint;
    out.rest = mirrored(joint.rest);
    if (joint.end_site) out.end_site = mirrored(*joint.end_site);
    return out;
}

}  // namespace

Vec3 mirrored(const Vec3& point) {
    return {-point.x, point.y, point.z};
}

Pose mirrored(const Pose& pose) {
    const Quat& q = pose.orientation;
    return {mirrored(pose.position), Quat(q.w, q.x, -q.y, -q.z)};
}

std::vector<int> mirrorPartners(const Skeleton& skeleton, const HumanoidMap& map) {
    std::vector<std::string> names;
    names.reserve(skeleton.joints.size());
    for (const Joint& joint : skeleton.joints) names.push_back(joint.name);
    std::vector<int> partners = pairedNames(names);
    const auto single = [&](int joint) {
        return joint >= 0 && partners[static_cast<std::size_t>(joint)] == joint;
    };
    for (std::size_t b = 0; b < bone_count; ++b) {
        const int here = map.joint[b];
        const int there = map[mirroredBone(static_cast<Bone>(b))];
        if (here == there || !single(here) || !single(there)) continue;
        partners[static_cast<std::size_t>(here)] = there;
        partners[static_cast<std::size_t>(there)] = here;
    }
    return partners;
}

Clip mirrored(const Clip& clip, const HumanoidMap& map) {
    const auto& joints = clip.skeleton.joints;
    const std::vector<int> partners = mirrorPartners(clip.skeleton, map);
    // What the image of each joint is called, its partner's name or, alone, its own on the other side.
    std::vector<std::string> image_names;
    for (std::size_t i = 0; i < joints.size(); ++i)
        image_names.push_back(partners[i] == static_cast<int>(i)
                                  ? withSideWordsSwapped(joints[i].name)
                                  : joints[static_cast<std::size_t>(partners[i])].name);
    const bool swapped = sidesAlike(clip.skeleton, partners, image_names);
    const auto source = [&](std::size_t i) { return swapped ? static_cast<std::size_t>(partners[i]) : i; };

    Clip out;
    out.frame_time_s = clip.frame_time_s;
    for (std::size_t i = 0; i < joints.size(); ++i) {
        Joint joint = mirroredJoint(joints[source(i)]);
        joint.name = swapped ? joints[i].name : image_names[i];
        joint.parent = joints[i].parent;
        out.skeleton.joints.push_back(std::move(joint));
    }
    out.frames.resize(clip.frames.size());
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        out.frames[f].joints.reserve(joints.size());
        for (std::size_t i = 0; i < joints.size(); ++i)
            out.frames[f].joints.push_back(mirrored(clip.frames[f].joints[source(i)]));
    }
    return out;
}

LocalPose mirrored(const Skeleton& skeleton, const std::vector<int>& partners, const LocalPose& pose) {
    LocalPose out;
    out.joints.reserve(pose.joints.size());
    for (std::size_t i = 0; i < pose.joints.size(); ++i) {
        Pose image = mirrored(pose.joints[static_cast<std::size_t>(partners[i])]);
        if (skeleton.joints[i].parent >= 0) image.position = pose.joints[i].position;
        out.joints.push_back(image);
    }
    return out;
}

Result<Clip> trimmed(const Clip& clip, int first, int last) {
    const auto frame = [](int f) { return std::to_string(f); };
    if (first < 0 || last >= clip.frameCount())
        return fail("",
                    "found the frames " + frame(first) + " to " + frame(last) +
                        ", expected frames from 0 to " + frame(clip.frameCount() - 1),
                    "The clip has " + frame(clip.frameCount()) + " frames, counted from 0");
    if (first > last)
        return fail("", "found a first frame (" + frame(first) + ") after the last (" + frame(last) + ")");
    Clip out;
    out.skeleton = clip.skeleton;
    out.frame_time_s = clip.frame_time_s;
    out.frames.assign(clip.frames.begin() + first, clip.frames.begin() + last + 1);
    return out;
}

Clip moved(const Clip& clip, const Pose& new_from_old) {
    Clip out = clip;
    for (LocalPose& frame : out.frames)
        for (std::size_t i = 0; i < frame.joints.size(); ++i)
            if (clip.skeleton.joints[i].parent < 0) frame.joints[i] = new_from_old * frame.joints[i];
    return out;
}

void makeContinuous(std::vector<LocalPose>& frames) {
    for (std::size_t f = 0; f < frames.size(); ++f)
        for (std::size_t j = 0; j < frames[f].joints.size(); ++j) {
            Quat& q = frames[f].joints[j].orientation;
            q = glm::normalize(q);
            if (f > 0 && glm::dot(frames[f - 1].joints[j].orientation, q) < 0.0) q = -q;
        }
}

}  // namespace deixis::motion
