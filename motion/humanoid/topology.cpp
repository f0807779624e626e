#include "topology.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

namespace deixis::motion {

namespace {

using enum Bone;

/// Two branches alike, at one joint.
struct Pair {
    int joint, first, second;
    double reach;
};

std::vector<int> limbChain(const FigureTree& tree, int branch) {
    return tree.bonesOf(tree.mainChain(branch));
}

/// Whether a branch has an upper and a lower part and an end, one below the other.
bool isLimb(const FigureTree& tree, int branch) {
    return limbChain(tree, branch).size() >= 3;
}

std::vector<Pair> likeBranches(const FigureTree& tree) {
    constexpr double min_share = 0.15;  // of the figure's own reach: more than fingers or ears
    constexpr std::size_t max_children = 6;
    constexpr std::size_t max_pairs = 100;  // more of them are no person
    const double whole = tree.wholeReach();
    std::vector<Pair> pairs;
    for (int j = 0; j < tree.skeleton().size(); ++j) {
        std::vector<int> branches = tree.children(j);
        std::sort(branches.begin(), branches.end(), [&](int a, int b) {
            return tree.reach(a) != tree.reach(b) ? tree.reach(a) > tree.reach(b) : a < b;
        });
        branches.resize(std::min(branches.size(), max_children));
        for (std::size_t a = 0; a < branches.size(); ++a)
            for (std::size_t b = a + 1; b < branches.size(); ++b) {
                const double longer = tree.reach(branches[a]);
                const double shorter = tree.reach(branches[b]);
                const int joints_a = tree.jointsBelow(branches[a]);
                const int joints_b = tree.jointsBelow(branches[b]);
                const bool alike = longer > min_share * whole && shorter > 0.9 * longer && joints_a >= 3 &&
                                   std::abs(joints_a - joints_b) <= 1 + std::max(joints_a, joints_b) / 8;
                if (alike && isLimb(tree, branches[a]) && isLimb(tree, branches[b]) &&
                    glm::length(tree.tip(tree.mainChain(branches[a]).back()) -
                                tree.tip(tree.mainChain(branches[b]).back())) > 0.05 * whole)
                    pairs.push_back({j, branches[a], branches[b], longer + shorter});
                if (pairs.size() > max_pairs) return {};
            }
    }
    return pairs;
}

/// From the root's side: whether each joint lies above `joint` or is it.
std::vector<char> pathTo(const FigureTree& tree, int joint) {
    std::vector<char> on_path(static_cast<std::size_t>(tree.skeleton().size()), 0);
    for (; joint >= 0; joint = tree.parent(joint)) on_path[static_cast<std::size_t>(joint)] = 1;
    return on_path;
}

int commonAncestor(const FigureTree& tree, int a, int b) {
    const std::vector<char> path = pathTo(tree, b);
    while (a >= 0 && path[static_cast<std::size_t>(a)] == 0) a = tree.parent(a);
    return a;
}

/// The two longest bones in a row of a limb: where its upper part begins. The chain must have three joints.
std::size_t limbStart(const FigureTree& tree, const std::vector<int>& chain) {
    std::size_t best = 0;
    double best_length = -1.0;
    for (std::size_t i = 0; i + 2 < chain.size(); ++i) {
        const double length =
            std::min(tree.wayTo(chain[i + 1], chain[i]), tree.wayTo(chain[i + 2], chain[i + 1]));
        if (length > 1.1 * best_length) {
            best = i;
            best_length = length;
        }
    }
    return best;
}

struct LimbBones {
    Bone collar, upper, lower, end, further;
};
LimbBones limbBones(bool arm, Side side) {
    const LimbBones left = arm ? LimbBones{leftShoulder, leftUpperArm, leftLowerArm, leftHand, leftHand}
                               : LimbBones{hips, leftUpperLeg, leftLowerLeg, leftFoot, leftToes};
    if (side == Side::left) return left;
    return {mirroredBone(left.collar), mirroredBone(left.upper), mirroredBone(left.lower),
            mirroredBone(left.end), mirroredBone(left.further)};
}

/// Maps a limb along a chain of three joints or more, from the trunk outwards.
void mapLimb(const FigureTree& tree, const std::vector<int>& chain, bool arm, Side side, HumanoidMap& map) {
    const LimbBones bones = limbBones(arm, side);
    const std::size_t start = limbStart(tree, chain);
    map[bones.upper] = chain[start];
    map[bones.lower] = chain[start + 1];
    map[bones.end] = chain[start + 2];
    if (arm && start > 0) map[bones.collar] = chain[start - 1];
    if (!arm && start + 3 < chain.size()) map[bones.further] = chain[start + 3];
}

std::optional<Side> sideByName(const FigureTree& tree, int branch) {
    for (const int joint : tree.mainChain(branch))
        if (const auto& side = tree.names()[static_cast<std::size_t>(joint)].side) return side;
    return std::nullopt;
}

/// Where the figure looks: as its toes point; without toes +z, or -y where it rises along z.
Vec3 front(const FigureTree& tree, const Pair& legs, const Vec3& rise, bool& guessed) {
    Vec3 ahead(0.0);
    for (const int leg : {legs.first, legs.second}) {
        const std::vector<int> chain = limbChain(tree, leg);
        const std::size_t foot = limbStart(tree, chain) + 2;
        ahead += tree.tip(chain.back()) - tree.position(chain[foot]);
    }
    ahead -= glm::dot(ahead, rise) * rise;
    guessed = glm::length(ahead) < 0.02 * (legs.reach);
    if (!guessed) return ahead;
    return std::abs(rise.z) > std::abs(rise.y) ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
}

/// Neck and head along a chain.
void mapHead(const FigureTree& tree, int branch, HumanoidMap& map) {
    std::vector<int> chain = tree.mainChain(branch);
    const auto fork =
        std::find_if(chain.begin(), chain.end(), [&](int joint) { return tree.children(joint).size() > 1; });
    if (fork != chain.end())
        chain.erase(fork + 1, chain.end());
    else if (chain.size() > 2 && !tree.skeleton().joints[static_cast<std::size_t>(chain.back())].end_site)
        chain.pop_back();  // the top of the head
    map[head] = chain.back();
    if (chain.size() > 1) map[neck] = chain.front();
}

/// The finger chains of a hand, each of two or three joints.
std::vector<std::vector<int>> fingerChains(const FigureTree& tree, int hand) {
    std::vector<std::vector<int>> chains;
    for (const int child : tree.children(hand)) {
        std::vector<int> chain = tree.mainChain(child);
        const bool tip_joint = !tree.skeleton().joints[static_cast<std::size_t>(chain.back())].end_site;
        if (chain.size() > 3 && tip_joint) chain.pop_back();
        if (chain.size() > 3) chain.erase(chain.begin(), chain.end() - 3);
        if (chain.size() >= 2) chains.push_back(std::move(chain));
    }
    return chains;
}

void mapFingers(const FigureTree& tree, Side side, HumanoidMap& map) {
    const bool left = side == Side::left;
    const Bone hand = left ? leftHand : rightHand;
    const auto first = static_cast<std::size_t>(left ? leftThumbMetacarpal : rightThumbMetacarpal);
    if (!map.has(hand)) return;
    // Names that give the fingers' first bones are right; others are no whole hand.
    if (map.has(left ? leftIndexProximal : rightIndexProximal)) return;
    auto chains = fingerChains(tree, map[hand]);
    if (chains.size() < 3 || chains.size() > 5) return;
    for (std::size_t b = first; b < first + 15; ++b) map.joint[b] = -1;
    const auto direction = [&](const std::vector<int>& chain) {
        return glm::normalize(tree.tip(chain.back()) - tree.position(chain.front()));
    };
    // The thumb points away from the others; they follow by their distance from it.
    std::size_t thumb = 0;
    double min = 2.0;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        Vec3 others(0.0);
        for (std::size_t k = 0; k < chains.size(); ++k)
            if (k != i) others += direction(chains[k]);
        const double along = glm::dot(direction(chains[i]), glm::normalize(others));
        if (along < min) {
            min = along;
            thumb = i;
        }
    }
    std::swap(chains[0], chains[thumb]);
    const Vec3 from = tree.position(chains[0].front());
    std::sort(chains.begin() + 1, chains.end(), [&](const auto& a, const auto& b) {
        return glm::length(tree.position(a.front()) - from) < glm::length(tree.position(b.front()) - from);
    });
    for (std::size_t finger = 0; finger < chains.size(); ++finger)
        for (std::size_t i = 0; i < chains[finger].size(); ++i)
            map.joint[first + 3 * finger + i] = chains[finger][i];
}

/// From below the trunk out to `joint`: the trunk is what has a joint of `other` below it too.
std::vector<int> chainFromTrunk(const FigureTree& tree, int joint, int other) {
    const std::vector<char> trunk = pathTo(tree, other);
    std::vector<int> chain;
    for (; joint >= 0 && trunk[static_cast<std::size_t>(joint)] == 0; joint = tree.parent(joint))
        chain.push_back(joint);
    std::reverse(chain.begin(), chain.end());
    return tree.bonesOf(chain);
}

void mendLimb(const FigureTree& tree, bool arm, Side side, HumanoidMap& map) {
    const LimbBones bones = limbBones(arm, side);
    if (!map.has(bones.end) || (map.has(bones.upper) && map.has(bones.lower))) return;
    if (!map.has(head)) return;
    const auto chain = chainFromTrunk(tree, map[bones.end], map[head]);
    if (chain.size() < 3) return;
    const std::size_t last = chain.size() - 1;
    map[bones.lower] = chain[last - 1];
    map[bones.upper] = chain[last - 2];
    if (arm && map[bones.collar] == map[bones.upper]) map[bones.collar] = -1;
}

}  // namespace

FigureTree::FigureTree(const Skeleton& skeleton, const std::vector<PlainName>& names)
    : skeleton_(skeleton),
      names_(names),
      world_(worldPose(skeleton, restPose(skeleton))),
      children_(skeleton.joints.size()),
      reach_(skeleton.joints.size(), 0.0),
      below_(skeleton.joints.size(), 1) {
    for (int j = skeleton.size() - 1; j >= 0; --j) {
        double farthest = 0.0;
        if (const auto& end = skeleton.joints[at(j)].end_site) farthest = glm::length(*end);
        for (const int child : children_[at(j)]) farthest = std::max(farthest, reach_[at(child)]);
        reach_[at(j)] = farthest + boneLength(j);
        if (const int up_there = parent(j); up_there >= 0) {
            children_[at(up_there)].push_back(j);
            below_[at(up_there)] += below_[at(j)];
        }
    }
    for (auto& children : children_) std::reverse(children.begin(), children.end());
    for (int j = 0; j < skeleton.size(); ++j)
        if (parent(j) < 0) whole_ = std::max(whole_, reach(j));
}

std::vector<int> FigureTree::mainChain(int joint) const {
    std::vector<int> chain{joint};
    while (!children(chain.back()).empty()) {
        const auto& below = children(chain.back());
        chain.push_back(
            *std::max_element(below.begin(), below.end(), [&](int a, int b) { return reach(a) < reach(b); }));
    }
    return chain;
}

std::vector<int> FigureTree::bonesOf(const std::vector<int>& chain) const {
    constexpr double one_place = 1e-4;  // of the figure's reach
    std::vector<int> bones;
    for (const int joint : chain) {
        if (names_[at(joint)].helper) continue;
        if (!bones.empty() && wayTo(joint, bones.back()) < one_place * whole_) bones.pop_back();
        bones.push_back(joint);
    }
    return bones;
}

double FigureTree::wayTo(int joint, int ancestor) const {
    double length = 0.0;
    for (; joint >= 0 && joint != ancestor; joint = parent(joint)) length += boneLength(joint);
    return length;
}

bool FigureTree::isAbove(int ancestor, int joint) const {
    while (joint > ancestor) joint = parent(joint);
    return joint == ancestor;
}

double FigureTree::boneLength(int joint) const {
    return parent(joint) < 0 ? 0.0 : glm::length(skeleton_.joints[at(joint)].rest.position);
}

std::optional<HumanoidMap> mapByShape(const FigureTree& tree, bool& guessed_front) {
    const std::vector<Pair> pairs = likeBranches(tree);
    const Pair* legs = nullptr;
    const Pair* arms = nullptr;
    for (const Pair& low : pairs)
        for (const Pair& high : pairs) {
            if (&low == &high || !tree.isAbove(low.joint, high.joint) ||
                tree.isAbove(low.first, high.joint) || tree.isAbove(low.second, high.joint) ||
                low.first == high.first || low.second == high.second)
                continue;
            if (legs == nullptr || low.reach + high.reach > legs->reach + arms->reach) {
                legs = &low;
                arms = &high;
            }
        }
    if (legs == nullptr) return std::nullopt;

    HumanoidMap map;
    map[hips] = commonAncestor(tree, legs->joint, arms->joint);
    int neck_branch = -1;
    for (const int child : tree.children(arms->joint))
        if (child != arms->first && child != arms->second && child != legs->first && child != legs->second &&
            (neck_branch < 0 || tree.reach(child) > tree.reach(neck_branch)))
            neck_branch = child;
    if (neck_branch < 0) return std::nullopt;
    mapHead(tree, neck_branch, map);

    const Vec3 way = tree.position(map[head]) - tree.position(map[hips]);
    if (glm::length(way) < 1e-6) return std::nullopt;
    const Vec3 rise = glm::normalize(way);
    const Vec3 to_left = glm::cross(rise, front(tree, *legs, rise, guessed_front));
    bool by_place = false;
    for (const bool is_arm : {false, true}) {
        const Pair& pair = is_arm ? *arms : *legs;
        const std::vector<int> first = limbChain(tree, pair.first);
        const std::vector<int> second = limbChain(tree, pair.second);
        auto side = sideByName(tree, pair.first);
        if (!side) {
            by_place = true;
            const Vec3 apart = tree.position(first[2]) - tree.position(second[2]);
            side = glm::dot(apart, to_left) > 0.0 ? Side::left : Side::right;
        }
        mapLimb(tree, first, is_arm, *side, map);
        mapLimb(tree, second, is_arm, opposite(*side), map);
    }
    guessed_front = guessed_front && by_place;
    return map;
}

void addByPlace(const FigureTree& tree, HumanoidMap& map) {
    for (const Side side : {Side::left, Side::right}) {
        mendLimb(tree, true, side, map);
        mendLimb(tree, false, side, map);
        mapFingers(tree, side, map);
        const bool left = side == Side::left;
        const Bone foot = left ? leftFoot : rightFoot;
        const Bone toes = left ? leftToes : rightToes;
        if (map.has(foot) && !map.has(toes) && tree.children(map[foot]).size() == 1)
            map[toes] = tree.children(map[foot]).front();
        const Bone upper = left ? leftUpperArm : rightUpperArm;
        const Bone collar = left ? leftShoulder : rightShoulder;
        if (map.has(upper) && !map.has(collar) && map.has(head)) {
            const auto chain = chainFromTrunk(tree, map[upper], map[head]);
            if (chain.size() > 1) map[collar] = chain.front();
        }
    }
    if (map.has(head) && !map.has(neck) && map.has(leftUpperArm))
        if (const int above = tree.parent(map[head]);
            above >= 0 && above != map[hips] && !tree.isAbove(above, map[leftUpperArm]))
            map[neck] = above;
}

}  // namespace deixis::motion
