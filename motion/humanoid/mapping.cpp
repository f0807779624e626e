#include "motion/humanoid/mapping.hpp"

#include <algorithm>

#include "names.hpp"
#include "schemes.hpp"
#include "topology.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

/// The joints between hips and neck, from below, shared out over the three bones of the spine; in figures
/// whose hips carry the legs alone, the joints up to where both hang. False where there are none.
bool mapSpine(const FigureTree& tree, HumanoidMap& map) {
    std::vector<int> chain;
    int joint = map.has(neck) ? map[neck] : map[head];
    if (joint < 0 || !map.has(hips)) return false;
    for (joint = tree.parent(joint); joint >= 0 && !tree.isAbove(joint, map[hips]);
         joint = tree.parent(joint))
        chain.push_back(joint);
    if (joint < 0 || chain.empty()) return false;
    std::reverse(chain.begin(), chain.end());
    map[spine] = chain.front();
    map[chest] = chain.size() > 1 ? chain[chain.size() / 2] : -1;
    map[upperChest] = chain.size() > 2 ? chain.back() : -1;
    return true;
}

/// Takes bones out that do not hang where such a bone must, so that a joint whose name misleads is looked for
/// again.
void dropMisplaced(const FigureTree& tree, HumanoidMap& map, std::vector<std::string>& remarks) {
    for (std::size_t b = 0; b < bone_count; ++b) {
        const auto bone = static_cast<Bone>(b);
        const auto above = parentBone(bone);
        const bool in_limb = bone != leftShoulder && bone != rightShoulder && bone != leftUpperLeg &&
                             bone != rightUpperLeg && bone > rightEye;
        if (!in_limb || !map.has(bone) || !map.has(*above) || tree.isAbove(map[*above], map[bone])) continue;
        remarks.push_back("'" + tree.skeleton().joints[static_cast<std::size_t>(map[bone])].name +
                          "' has the name of " + std::string(boneName(bone)) + ", but is not attached to " +
                          std::string(boneName(*above)) + ": ignored");
        map[bone] = -1;
    }
}

class Mapper {
  public:
    explicit Mapper(const Skeleton& skeleton)
        : skeleton_(skeleton), names_(plainNames(skeleton)), tree_(skeleton, names_) {}

    HumanoidMapping run(const HumanoidMap* given) {
        HumanoidMap map;
        if (given != nullptr) {
            map = *given;
            note(map, FoundBy::file);
            out_.scheme = "VRM";
            if (missingBones(map).empty()) return finish(map);
        }
        const auto scheme = matchScheme(skeleton_);
        if (scheme) {
            fill(map, scheme->map);
            note(map, FoundBy::scheme);
        }
        if (out_.scheme.empty()) out_.scheme = scheme ? scheme->scheme : "by name and topology";
        addByName(names_, map);
        if (!isFlat()) dropMisplaced(tree_, map, out_.remarks);
        forgetDropped(map);
        note(map, FoundBy::name);
        addByPlace(tree_, map);
        if (!missingBones(map).empty()) mapShape(map);
        if (!keepsOwnSpine(scheme, given)) {
            const HumanoidMap before = map;
            if (mapSpine(tree_, map))
                for (const Bone bone : {spine, chest, upperChest})
                    if (map[bone] != before[bone])
                        out_.found[static_cast<std::size_t>(bone)] = FoundBy::nothing;
        }
        note(map, FoundBy::place);
        return finish(map);
    }

  private:
    /// Whether it is a mere list of joints, where nothing hangs from anything.
    [[nodiscard]] bool isFlat() const {
        return std::all_of(skeleton_.joints.begin(), skeleton_.joints.end(),
                           [](const Joint& joint) { return joint.parent < 0; });
    }

    /// VRM and Unity say themselves which joint is the chest.
    [[nodiscard]] static bool keepsOwnSpine(const std::optional<SchemeMatch>& scheme,
                                            const HumanoidMap* given) {
        return given != nullptr || (scheme && (scheme->scheme == "VRM" || scheme->scheme == "Unity"));
    }

    static void fill(HumanoidMap& map, const HumanoidMap& other) {
        for (std::size_t b = 0; b < bone_count; ++b) {
            const bool used =
                std::find(map.joint.begin(), map.joint.end(), other.joint[b]) != map.joint.end();
            if (map.joint[b] < 0 && !used) map.joint[b] = other.joint[b];
        }
    }

    /// Bones that are there and were not before have been found so.
    void note(const HumanoidMap& map, FoundBy by) {
        for (std::size_t b = 0; b < bone_count; ++b)
            if (map.joint[b] >= 0 && out_.found[b] == FoundBy::nothing) out_.found[b] = by;
    }

    void mapShape(HumanoidMap& map) {
        bool guessed_front = false;
        auto shape = mapByShape(tree_, guessed_front);
        if (!shape) return;
        addByPlace(tree_, *shape);
        // Where names tell less than half of a humanoid, they are no help; else they fill the shape's gaps.
        const auto required = requiredBones();
        const auto named =
            std::count_if(required.begin(), required.end(), [&](Bone bone) { return map.has(bone); });
        if (static_cast<std::size_t>(2 * named) > required.size()) {
            fill(map, *shape);
        } else {
            map = *shape;
            out_.found.fill(FoundBy::nothing);
        }
        out_.remarks.emplace_back(
            "the joints' names do not identify the bones: they were found from the figure's shape");
        if (guessed_front)
            out_.remarks.emplace_back(
                "neither names nor toes tell left from right: the figure is assumed to face +z");
    }

    void forgetDropped(const HumanoidMap& map) {
        for (std::size_t b = 0; b < bone_count; ++b)
            if (map.joint[b] < 0) out_.found[b] = FoundBy::nothing;
    }

    HumanoidMapping finish(const HumanoidMap& map) {
        out_.map = map;
        forgetDropped(map);
        return std::move(out_);
    }

    const Skeleton& skeleton_;
    const std::vector<PlainName> names_;
    const FigureTree tree_;
    HumanoidMapping out_;
};

}  // namespace

std::string_view foundByName(FoundBy found) {
    switch (found) {
        case FoundBy::nothing:
            return "";
        case FoundBy::file:
            return "file";
        case FoundBy::scheme:
            return "scheme";
        case FoundBy::name:
            return "name";
        case FoundBy::place:
            return "place";
        case FoundBy::override_:
            return "override";
    }
    return "";
}

std::vector<Bone> HumanoidMapping::missing() const {
    std::vector<Bone> out;
    for (std::size_t b = 0; b < bone_count; ++b)
        if (map.joint[b] < 0) out.push_back(static_cast<Bone>(b));
    return out;
}

HumanoidMapping mapHumanoid(const Skeleton& skeleton, const HumanoidMap* given) {
    return Mapper(skeleton).run(given);
}

HumanoidMap detectHumanoid(const Skeleton& skeleton) {
    return mapHumanoid(skeleton).map;
}

}  // namespace deixis::motion
