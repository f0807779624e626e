#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

#include "assets/gltf/glb_writer.hpp"
#include "assets/gltf/gltf_clip.hpp"

namespace deixis::assets {

namespace {

using Json = GltfJson;
using motion::Clip;
using motion::Joint;

constexpr double still_m = 1e-7;  // a joint that leaves its rest by less does not move

void check(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(std::string("writeGlb: ") + what);
}

bool finite(const Pose& pose) {
    return std::isfinite(glm::length(pose.position)) && std::abs(glm::length(pose.orientation) - 1.0) < 1e-3;
}

void checkClip(const Clip& clip) {
    check(!clip.skeleton.joints.empty() && !clip.frames.empty(), "the clip is empty");
    check(clip.frame_time_s > 0.0 && std::isfinite(clip.frame_time_s), "the frame time is not positive");
    for (int j = 0; j < clip.skeleton.size(); ++j) {
        const Joint& joint = clip.skeleton.joints[static_cast<std::size_t>(j)];
        check(joint.parent < j, "a joint comes before its parent");
        check(finite(joint.rest) && (!joint.end_site || std::isfinite(glm::length(*joint.end_site))),
              "a rest pose is not finite or not of unit length");
    }
    for (const auto& frame : clip.frames) {
        check(frame.joints.size() == clip.skeleton.joints.size(), "a frame has another number of joints");
        check(std::all_of(frame.joints.begin(), frame.joints.end(), finite),
              "a frame is not finite or not of unit length");
    }
}

/// -0 becomes 0.
Json numbers(const Vec3& v) {
    return Json::array({v.x + 0.0, v.y + 0.0, v.z + 0.0});
}

class Writer {
  public:
    Writer(const Clip& clip, const GlbOptions& options) : clip_(clip), options_(options) {}

    std::string write() {
        checkClip(clip_);
        Json root;
        root["asset"] = {{"version", "2.0"}, {"generator", "Deixis"}};
        const Json nodes = writeNodes();
        writeHumanoid(root);
        root["scene"] = 0;
        root["scenes"] = Json::array({{{"nodes", roots_}}});
        root["nodes"] = nodes;
        root["skins"] = Json::array({writeSkin(nodes.size())});
        root["animations"] = Json::array({writeAnimation()});
        return glb_.file(std::move(root));
    }

  private:
    [[nodiscard]] std::size_t jointCount() const { return clip_.skeleton.joints.size(); }

    /// The joints in their order, then the end sites.
    Json writeNodes() {
        std::vector<Json> children(jointCount(), Json::array());
        Json ends = Json::array();
        for (std::size_t j = 0; j < jointCount(); ++j) {
            const Joint& joint = clip_.skeleton.joints[j];
            if (joint.parent < 0)
                roots_.push_back(j);
            else
                children[static_cast<std::size_t>(joint.parent)].push_back(j);
        }
        // Several roots get one above them: a skin's joints need it.
        const bool joined = roots_.size() > 1;
        for (std::size_t j = 0; j < jointCount(); ++j) {
            const Joint& joint = clip_.skeleton.joints[j];
            if (!joint.end_site) continue;
            children[j].push_back(jointCount() + ends.size());
            ends.push_back({{"name", joint.name + "_End"}, {"translation", numbers(*joint.end_site)}});
        }
        Json nodes = Json::array();
        for (std::size_t j = 0; j < jointCount(); ++j) {
            const Joint& joint = clip_.skeleton.joints[j];
            Json node{{"name", joint.name}, {"translation", numbers(joint.rest.position)}};
            if (joint.rest.orientation != no_rotation) {
                const Quat q = glm::normalize(joint.rest.orientation);
                node["rotation"] = {q.x + 0.0, q.y + 0.0, q.z + 0.0, q.w + 0.0};
            }
            if (!children[j].empty()) node["children"] = children[j];
            nodes.push_back(std::move(node));
        }
        for (Json& end : ends) nodes.push_back(std::move(end));
        if (joined) {
            nodes.push_back({{"name", "roots"}, {"children", roots_}});
            roots_ = Json::array({nodes.size() - 1});
        }
        return nodes;
    }

    /// All nodes are joints of the skin: a root alone would need none, and a program that makes bones of
    /// joints makes them of end sites too.
    Json writeSkin(std::size_t node_count) {
        Json joints = Json::array();
        std::vector<float> matrices;
        const auto world = motion::worldPose(clip_.skeleton, motion::restPose(clip_.skeleton));
        const auto add = [&](std::size_t node, const Pose& pose) {
            joints.push_back(node);
            const Pose joint_from_world = inverse(pose);
            const glm::dmat3 turn = glm::mat3_cast(glm::normalize(joint_from_world.orientation));
            for (int c = 0; c < 3; ++c) {
                for (int r = 0; r < 3; ++r) matrices.push_back(static_cast<float>(turn[c][r]));
                matrices.push_back(0.0F);
            }
            for (int r = 0; r < 3; ++r) matrices.push_back(static_cast<float>(joint_from_world.position[r]));
            matrices.push_back(1.0F);
        };
        for (std::size_t j = 0; j < jointCount(); ++j) add(j, world[j]);
        std::size_t node = jointCount();
        for (std::size_t j = 0; j < jointCount(); ++j)
            if (const auto& end = clip_.skeleton.joints[j].end_site)
                add(node++, world[j] * Pose{*end, no_rotation});
        while (node < node_count) add(node++, Pose{});
        const std::size_t accessor = glb_.add(matrices, joints.size(), "MAT4");
        return {{"name", "skeleton"}, {"inverseBindMatrices", accessor}, {"joints", joints}};
    }

    Json writeAnimation() {
        const std::size_t count = clip_.frames.size();
        std::vector<float> times;
        for (std::size_t k = 0; k < count; ++k)
            times.push_back(static_cast<float>(static_cast<double>(k) * clip_.frame_time_s));
        for (std::size_t k = 1; k < count; ++k) check(times[k] > times[k - 1], "frames are too close");
        const std::size_t input = glb_.add(times, count, "SCALAR");
        glb_.setBounds(input, Json::array({times.front()}), Json::array({times.back()}));
        Json samplers = Json::array();
        Json channels = Json::array();
        const auto add = [&](std::size_t joint, const char* path, std::size_t output) {
            channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", joint}, {"path", path}}}});
            samplers.push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
        };
        for (std::size_t j = 0; j < jointCount(); ++j) {
            if (moves(j)) add(j, "translation", glb_.add(positions(j), count, "VEC3"));
            add(j, "rotation", glb_.add(rotations(j), count, "VEC4"));
        }
        return {{"name", options_.animation_name}, {"samplers", samplers}, {"channels", channels}};
    }

    [[nodiscard]] bool moves(std::size_t j) const {
        const Vec3& rest = clip_.skeleton.joints[j].rest.position;
        return std::any_of(clip_.frames.begin(), clip_.frames.end(), [&](const motion::LocalPose& frame) {
            return glm::length(frame.joints[j].position - rest) > still_m;
        });
    }

    [[nodiscard]] std::vector<float> positions(std::size_t j) const {
        std::vector<float> values;
        for (const auto& frame : clip_.frames)
            for (int axis = 0; axis < 3; ++axis)
                values.push_back(static_cast<float>(frame.joints[j].position[axis] + 0.0));
        return values;
    }

    /// Of the two quaternions of each rotation the one nearer to the frame before: programs that blend
    /// numbers go the short way too.
    [[nodiscard]] std::vector<float> rotations(std::size_t j) const {
        std::vector<float> values;
        Quat before = clip_.skeleton.joints[j].rest.orientation;
        for (const auto& frame : clip_.frames) {
            Quat q = glm::normalize(frame.joints[j].orientation);
            if (glm::dot(q, before) < 0.0) q = -q;
            before = q;
            for (const double value : {q.x, q.y, q.z, q.w}) values.push_back(static_cast<float>(value + 0.0));
        }
        return values;
    }

    /// VRM animations tell gaze by a point that is looked at; eyes may not stand among their bones
    /// (Humanoid).
    static bool isEye(motion::Bone bone) {
        return bone == motion::Bone::leftEye || bone == motion::Bone::rightEye;
    }

    void writeHumanoid(Json& root) const {
        if (!options_.humanoid || !whyNoVrmAnimation(clip_, *options_.humanoid).empty()) return;
        Json bones = Json::object();
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            if (const auto bone = static_cast<motion::Bone>(b); options_.humanoid->has(bone) && !isEye(bone))
                bones[std::string(motion::boneName(bone))] = {{"node", (*options_.humanoid)[bone]}};
        root["extensionsUsed"] = Json::array({"VRMC_vrm_animation"});
        root["extensions"]["VRMC_vrm_animation"] = {{"specVersion", "1.0"},
                                                    {"humanoid", {{"humanBones", bones}}}};
    }

    const Clip& clip_;
    const GlbOptions& options_;
    Json roots_ = Json::array();
    GlbWriter glb_;
};

}  // namespace

std::string writeGlb(const Clip& clip, const GlbOptions& options) {
    return Writer(clip, options).write();
}

std::string whyNoVrmAnimation(const Clip& clip, const motion::HumanoidMap& humanoid) {
    using enum motion::Bone;
    auto missing = motion::missingBones(humanoid);
    if (!humanoid.has(spine)) missing.emplace_back(motion::boneName(spine));
    if (!missing.empty()) return fmt::format("the bone {} is missing", missing.front());
    for (std::size_t b = 0; b < motion::bone_count; ++b) {
        const auto bone = static_cast<motion::Bone>(b);
        if (bone == hips || !humanoid.has(bone)) continue;
        const auto joint = static_cast<std::size_t>(humanoid[bone]);
        for (const auto& frame : clip.frames)
            if (glm::length(frame.joints[joint].position - clip.skeleton.joints[joint].rest.position) >
                still_m)
                return fmt::format("the bone {} moves relative to its parent; only the hips may",
                                   motion::boneName(bone));
    }
    const auto rest = motion::worldPose(clip.skeleton, motion::restPose(clip.skeleton));
    const auto points = [&](motion::Bone from, motion::Bone to, const Vec3& direction) {
        const Vec3 bone = rest[static_cast<std::size_t>(humanoid[to])].position -
                          rest[static_cast<std::size_t>(humanoid[from])].position;
        return glm::length(bone) > 0.0 && angleBetween(bone, direction) < radiansFromDegrees(20.0);
    };
    const bool t_pose = points(hips, head, up) && points(leftUpperArm, leftHand, {1, 0, 0}) &&
                        points(rightUpperArm, rightHand, {-1, 0, 0}) && points(leftUpperLeg, leftFoot, -up) &&
                        points(rightUpperLeg, rightFoot, -up);
    return t_pose ? "" : "its rest pose is not a T pose that faces +z";
}

}  // namespace deixis::assets
