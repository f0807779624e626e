#include "gltf_skeleton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <unordered_map>
#include <unordered_set>

#include "core/text.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr double even_tolerance = 1e-4;

bool isEven(const Vec3& scale) {
    const double mean = (scale.x + scale.y + scale.z) / 3.0;
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(scale[axis] - mean) <= even_tolerance * std::abs(mean))) return false;
    return mean != 0.0;
}

double mean(const Vec3& v) {
    return (v.x + v.y + v.z) / 3.0;
}

/// The rotation nearest to a linear map (its polar factor, by Newton's iteration: Higham 1986), a mirroring
/// undone; `otherwise` where the map flattens space.
Quat nearestRotation(glm::dmat3 linear, const Quat& otherwise) {
    double size = 0.0;
    for (int c = 0; c < 3; ++c) size = std::max(size, glm::length(linear[c]));
    if (!(size > 1e-100 && size < 1e100)) return otherwise;
    linear /= size;
    const double determinant = glm::determinant(linear);
    if (!(std::abs(determinant) > 1e-9)) return otherwise;
    if (determinant < 0.0) linear = -linear;
    for (int step = 0; step < 60; ++step) {
        const glm::dmat3 next = 0.5 * (linear + glm::transpose(glm::inverse(linear)));
        double change = 0.0;
        for (int c = 0; c < 3; ++c) change = std::max(change, glm::length(next[c] - linear[c]));
        linear = next;
        if (change < 1e-15) break;
    }
    return glm::normalize(glm::quat_cast(linear));
}

class Chooser {
  public:
    Chooser(const Document& document, const std::vector<Track>& tracks, std::vector<std::string>& remarks)
        : doc_(document),
          remarks_(remarks),
          chosen_(document.nodes.size(), 0),
          moves_(document.nodes.size(), 0) {
        for (const Track& track : tracks) moves_[at(track.node)] = 1;
    }

    JointNodes choose() {
        if (doc_.nodes.empty()) reject(doc_.file, "has no nodes, expected a skeleton");
        mark();
        markEndSites();
        std::vector<int> roots;
        for (std::size_t node = 0; node < doc_.nodes.size(); ++node)
            if (doc_.nodes[node].parent < 0 && chosen_[node] != 0) roots.push_back(static_cast<int>(node));
        int top = -1;
        if (roots.size() > 1) {
            top = 0;
            add(-1, -1, "root");
            remarks_.push_back(fmt::format("{} roots are joined under one", roots.size()));
        }
        addAll(roots, top);
        if (renamed_ > 0)
            remarks_.push_back(
                fmt::format("{} nodes have no name or a repeated one; they got a number", renamed_));
        return std::move(joints_);
    }

  private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }

    void markUp(int node) {
        for (; node >= 0 && chosen_[at(node)] == 0; node = doc_.nodes[at(node)].parent) chosen_[at(node)] = 1;
    }

    void mark() {
        for (const auto& skin : doc_.skins)
            for (const int joint : skin.joints) markUp(joint);
        for (std::size_t node = 0; node < moves_.size(); ++node)
            if (moves_[node] != 0) markUp(static_cast<int>(node));
        if (doc_.humanoid)
            for (const auto& [bone, node] : doc_.humanoid->nodes) markUp(node);
        const bool none = std::find(chosen_.begin(), chosen_.end(), 1) == chosen_.end();
        if (!doc_.skins.empty() && !none) return;
        std::vector<int> stack;
        for (std::size_t node = 0; node < chosen_.size(); ++node)
            if (doc_.nodes[node].parent < 0 && (none || chosen_[node] != 0))
                stack.push_back(static_cast<int>(node));
        while (!stack.empty()) {
            const Node& node = doc_.nodes[at(stack.back())];
            chosen_[at(stack.back())] = 1;
            stack.pop_back();
            stack.insert(stack.end(), node.children.begin(), node.children.end());
        }
    }

    /// Leaves named NAME_End become no joints but end sites, one for each joint.
    void markEndSites() {
        std::vector<char> has_end(doc_.nodes.size(), 0);
        is_end_.assign(doc_.nodes.size(), 0);
        std::unordered_set<int> bones;
        if (doc_.humanoid)
            for (const auto& [bone, node] : doc_.humanoid->nodes) bones.insert(node);
        for (std::size_t node = 0; node < doc_.nodes.size(); ++node) {
            const Node& leaf = doc_.nodes[node];
            if (leaf.parent < 0 || !leaf.children.empty() || moves_[node] != 0 ||
                chosen_[at(leaf.parent)] == 0 || bones.count(static_cast<int>(node)) > 0)
                continue;
            if (has_end[at(leaf.parent)] != 0 ||
                lowerCase(leaf.name) != lowerCase(doc_.nodes[at(leaf.parent)].name) + "_end")
                continue;
            is_end_[node] = has_end[at(leaf.parent)] = 1;
        }
    }

    void add(int node, int parent, const std::string& name) {
        std::string unique = name.empty() ? fmt::format("node_{}", node) : name;
        bool renamed = name.empty();
        while (!names_.insert(unique).second) {
            int& next = uses_[name];
            next = std::max(next + 1, 2);
            unique = fmt::format("{}#{}", name.empty() ? "node" : name, next);
            renamed = true;
        }
        if (renamed) ++renamed_;
        joints_.nodes.push_back(node);
        joints_.parents.push_back(parent);
        joints_.names.push_back(std::move(unique));
    }

    /// Roots first in the file's order; where a child stands before its parent, depth first.
    [[nodiscard]] std::vector<int> order(const std::vector<int>& roots) const {
        std::vector<int> nodes;
        bool parents_first = true;
        for (std::size_t node = 0; node < doc_.nodes.size(); ++node) {
            if (chosen_[node] == 0 || is_end_[node] != 0) continue;
            nodes.push_back(static_cast<int>(node));
            parents_first = parents_first && doc_.nodes[node].parent < nodes.back();
        }
        if (parents_first) return nodes;
        nodes.clear();
        std::vector<int> stack(roots.rbegin(), roots.rend());
        while (!stack.empty()) {
            nodes.push_back(stack.back());
            stack.pop_back();
            const auto& children = doc_.nodes[at(nodes.back())].children;
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                if (chosen_[at(*child)] != 0 && is_end_[at(*child)] == 0) stack.push_back(*child);
        }
        return nodes;
    }

    void addAll(const std::vector<int>& roots, int top) {
        std::vector<int> joint_of(doc_.nodes.size(), -1);
        for (const int node : order(roots)) {
            const int parent = doc_.nodes[at(node)].parent;
            joint_of[at(node)] = static_cast<int>(joints_.nodes.size());
            add(node, parent < 0 ? top : joint_of[at(parent)], doc_.nodes[at(node)].name);
            for (const int child : doc_.nodes[at(node)].children)
                if (is_end_[at(child)] != 0) joints_.end_sites.emplace_back(joint_of[at(node)], child);
        }
    }

    const Document& doc_;
    std::vector<std::string>& remarks_;
    std::vector<char> chosen_, moves_, is_end_;  // of each node
    std::unordered_set<std::string> names_;
    std::unordered_map<std::string, int> uses_;
    std::size_t renamed_ = 0;
    JointNodes joints_;
};

}  // namespace

int JointNodes::jointOf(int node) const {
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    return found == nodes.end() ? -1 : static_cast<int>(found - nodes.begin());
}

JointNodes chooseJoints(const Document& document, const std::vector<Track>& tracks,
                        std::vector<std::string>& remarks) {
    return Chooser(document, tracks, remarks).choose();
}

Poser::Poser(const Document& document, const JointNodes& joints, const std::vector<Track>& tracks,
             double metres, const Quat& turn)
    : document_(document), joints_(joints), metres_(metres), turn_(turn) {
    std::vector<int> joint_of(document.nodes.size(), -1);
    for (std::size_t j = 0; j < joints.nodes.size(); ++j)
        if (joints.nodes[j] >= 0) joint_of[static_cast<std::size_t>(joints.nodes[j])] = static_cast<int>(j);
    for (const Track& track : tracks)
        if (const int joint = joint_of[static_cast<std::size_t>(track.node)]; joint >= 0)
            tracks_.emplace_back(static_cast<std::size_t>(joint), track);
    findScales(tracks);
}

void Poser::findScales(const std::vector<Track>& tracks) {
    const auto nodeName = [&](int node) { return document_.nodes[static_cast<std::size_t>(node)].name; };
    for (const int node : joints_.nodes)
        if (node >= 0 && even_ && !isEven(document_.nodes[static_cast<std::size_t>(node)].scale)) {
            even_ = false;
            uneven_node_ = nodeName(node);
        }
    for (const Track& track : tracks) {
        if (track.path != Path::scale || !even_) continue;
        const Vec3 rest = document_.nodes[static_cast<std::size_t>(track.node)].scale;
        for (const double time : *track.times) {
            const Vec3 scale = track.vector(time, 0.0);
            if (glm::length(scale - rest) <= 2.0 * even_tolerance * glm::length(rest)) continue;
            even_ = false;
            uneven_node_ = nodeName(track.node);
            break;
        }
    }
    if (!even_) return;
    const std::size_t count = joints_.nodes.size();
    scale_above_.assign(count, 1.0);
    scale_below_.assign(count, 1.0);
    for (std::size_t j = 0; j < count; ++j) {
        if (joints_.parents[j] >= 0)
            scale_above_[j] = scale_below_[static_cast<std::size_t>(joints_.parents[j])];
        const int node = joints_.nodes[j];
        const double own = node < 0 ? 1.0 : mean(document_.nodes[static_cast<std::size_t>(node)].scale);
        mirrors_ = mirrors_ || own < 0.0;
        scale_below_[j] = scale_above_[j] * own;
    }
}

std::vector<Poser::Transform> Poser::restTransforms() const {
    std::vector<Transform> transforms;
    transforms.reserve(joints_.nodes.size());
    for (const int index : joints_.nodes) {
        if (index < 0) {
            transforms.emplace_back();
            continue;
        }
        const Node& node = document_.nodes[static_cast<std::size_t>(index)];
        transforms.push_back({node.translation, node.scale, node.rotation});
    }
    return transforms;
}

motion::LocalPose Poser::at(double time_s, double snap_s) const {
    auto transforms = restTransforms();
    for (const auto& [joint, track] : tracks_) {
        Transform& transform = transforms[joint];
        if (track.path == Path::rotation)
            transform.rotation = track.rotation(time_s, snap_s);
        else
            (track.path == Path::scale ? transform.scale : transform.translation) =
                track.vector(time_s, snap_s);
    }
    return pose(transforms);
}

motion::LocalPose Poser::pose(const std::vector<Transform>& transforms) const {
    motion::LocalPose out = even_ ? rigidPose(transforms) : nearestPose(transforms);
    if (turn_ != no_rotation) out.joints.front() = Pose{Vec3(0.0), turn_} * out.joints.front();
    for (const Pose& joint : out.joints)
        if (const double size = glm::length(joint.position); !(size < 1e9))
            reject(document_.file,
                   fmt::format("places a joint {} m from its parent, expected a figure", size));
    return out;
}

motion::LocalPose Poser::rigidPose(const std::vector<Transform>& transforms) const {
    motion::LocalPose out;
    out.joints.reserve(transforms.size());
    for (std::size_t j = 0; j < transforms.size(); ++j)
        out.joints.push_back(
            {transforms[j].translation * (scale_above_[j] * metres_), transforms[j].rotation});
    return out;
}

Poser::Nearest Poser::nearest(const std::vector<Transform>& transforms) const {
    Nearest out{std::vector<glm::dmat3>(transforms.size()), std::vector<Pose>(transforms.size())};
    for (std::size_t j = 0; j < transforms.size(); ++j) {
        const Transform& own = transforms[j];
        const int parent = joints_.parents[j];
        const glm::dmat3 above = parent < 0 ? glm::dmat3(1.0) : out.linear[static_cast<std::size_t>(parent)];
        const Pose parent_pose = parent < 0 ? Pose{} : out.world[static_cast<std::size_t>(parent)];
        glm::dmat3 linear = above * glm::mat3_cast(own.rotation);
        out.world[j].position = parent_pose.position + above * own.translation * metres_;
        out.world[j].orientation = nearestRotation(linear, parent_pose.orientation * own.rotation);
        for (int axis = 0; axis < 3; ++axis) linear[axis] *= own.scale[axis];
        out.linear[j] = linear;
    }
    return out;
}

motion::LocalPose Poser::nearestPose(const std::vector<Transform>& transforms) const {
    const Nearest found = nearest(transforms);
    motion::LocalPose out;
    out.joints.reserve(transforms.size());
    for (std::size_t j = 0; j < transforms.size(); ++j) {
        const int parent = joints_.parents[j];
        Pose local = found.world[j];
        if (parent >= 0) local = inverse(found.world[static_cast<std::size_t>(parent)]) * local;
        local.orientation = glm::normalize(local.orientation);
        out.joints.push_back(local);
    }
    return out;
}

motion::Skeleton Poser::skeleton() const {
    const motion::LocalPose rest = pose(restTransforms());
    motion::Skeleton skeleton;
    skeleton.joints.resize(joints_.nodes.size());
    for (std::size_t j = 0; j < skeleton.joints.size(); ++j) {
        skeleton.joints[j].name = joints_.names[j];
        skeleton.joints[j].parent = joints_.parents[j];
        skeleton.joints[j].rest = rest.joints[j];
    }
    const Nearest found = even_ ? Nearest{} : nearest(restTransforms());
    for (const auto& [joint, node] : joints_.end_sites) {
        const auto j = static_cast<std::size_t>(joint);
        Vec3 tip = document_.nodes[static_cast<std::size_t>(node)].translation * metres_;
        tip = even_ ? tip * scale_below_[j]
                    : glm::conjugate(found.world[j].orientation) * (found.linear[j] * tip);
        if (const double size = glm::length(tip); !(size < 1e9))
            reject(document_.file, fmt::format("places an end {} m from its joint, expected a figure", size));
        skeleton.joints[j].end_site = tip;
    }
    return skeleton;
}

std::string Poser::scaleRemark() const {
    if (!even_)
        return fmt::format(
            "node \"{}\" scales by different amounts along its axes or over time: positions are kept, bones "
            "may "
            "change in length, rotations are the nearest",
            uneven_node_);
    if (mirrors_)
        return "a node mirrors (its scale is negative): positions are kept, rotations are unmirrored";
    return {};
}

}  // namespace deixis::assets::gltf
