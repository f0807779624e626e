#include "app/clips/clip_problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "assets/tables/humanoid_file.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;
using enum motion::Bone;

constexpr std::array<std::pair<motion::Bone, motion::Bone>, 9> limbs{{{leftUpperArm, leftLowerArm},
                                                                      {leftLowerArm, leftHand},
                                                                      {rightUpperArm, rightLowerArm},
                                                                      {rightLowerArm, rightHand},
                                                                      {leftUpperLeg, leftLowerLeg},
                                                                      {leftLowerLeg, leftFoot},
                                                                      {rightUpperLeg, rightLowerLeg},
                                                                      {rightLowerLeg, rightFoot},
                                                                      {hips, head}}};

class Inspection {
  public:
    Inspection(const assets::ImportedClip& imported, const fs::path& file, const motion::HumanoidMap& map)
        : clip_(imported.clip), map_(map) {
        for (const motion::LocalPose& frame : clip_.frames)
            world_.push_back(motion::worldPose(clip_.skeleton, frame));
        findMissingBones(file);
        findEmptyLimbs();
        findJumps();
        findSunkFeet();
        findOddSize(imported.unit);
        for (const std::string& text : motion::mappingWarnings(clip_.skeleton, map_, world_.front()))
            warning(text);
        if (clip_.frameCount() == 1) warning("has one frame: a pose, not a motion");
        for (const std::string& remark : imported.remarks) warning(remark);
    }

    std::vector<ClipProblem> problems{};

  private:
    void fatal(std::string text) { problems.push_back({true, std::move(text)}); }
    void warning(std::string text) { problems.push_back({false, std::move(text)}); }

    [[nodiscard]] Vec3 at(std::size_t frame, motion::Bone bone) const {
        return world_[frame][static_cast<std::size_t>(map_[bone])].position;
    }

    void findMissingBones(const fs::path& file) {
        if (const auto missing = motion::missingBones(map_); !missing.empty())
            fatal(fmt::format(
                "has no joint for {}. If it has one by another name, say so in {} beside it, with "
                "a line such as {} = \"NAME OF THE JOINT\"; 'deixis clips joints' lists them",
                fmt::join(missing, ", "), assets::humanoidFileOf(file).filename().string(), missing.front()));
        for (const auto& [side, bone] : {std::pair{"left", leftIndexProximal}, {"right", rightIndexProximal}})
            if (!map_.has(bone)) warning(fmt::format("has no {} index finger: the hand is relaxed", side));
    }

    void findEmptyLimbs() {
        constexpr double shortest_m = 1e-3;
        for (const auto& [from, to] : limbs) {
            if (!map_.has(from) || !map_.has(to)) continue;
            std::size_t frame = 0;
            while (frame < world_.size() && glm::length(at(frame, to) - at(frame, from)) >= shortest_m)
                ++frame;
            if (frame < world_.size())
                fatal(fmt::format("frame {}: {} and {} are in one place", frame, motion::boneName(from),
                                  motion::boneName(to)));
        }
    }

    void findJumps() {
        constexpr double fastest_m_s = 20.0;  // hands of people who throw reach 10 to 15
        for (std::size_t b = 0; b < motion::bone_count; ++b) {
            const auto bone = static_cast<motion::Bone>(b);
            if (!map_.has(bone) || bone >= leftThumbMetacarpal) continue;
            const auto speed = motion::magnitudes(motion::jointTrajectory(world_, map_[bone]),
                                                  clip_.frame_time_s, motion::Derivative::speed);
            const auto jump = [](double m_s) { return m_s > fastest_m_s; };
            const auto first = std::find_if(speed.begin(), speed.end(), jump);
            if (first == speed.end()) continue;
            const auto jumps = std::count_if(first, speed.end(), jump);
            const auto frame = first - speed.begin();
            warning(fmt::format("{} jumps by {:.2f} m from frame {} to {} ({:.0f} m/s){}",
                                motion::boneName(bone), *first * clip_.frame_time_s, frame, frame + 1, *first,
                                jumps > 1 ? fmt::format(", and {} times more", jumps - 1) : ""));
        }
    }

    void findSunkFeet() {
        constexpr double deepest_m = 0.05;
        double lowest = 0.0;
        int frames = 0;
        for (std::size_t f = 0; f < world_.size(); ++f) {
            double here = 0.0;
            for (const motion::Bone bone : {leftFoot, rightFoot, leftToes, rightToes})
                if (map_.has(bone)) here = std::min(here, at(f, bone).y);
            frames += here < -deepest_m ? 1 : 0;
            lowest = std::min(lowest, here);
        }
        if (frames > 0)
            warning(fmt::format(
                "feet are up to {:.2f} m below the floor (y = 0) in {} of {} frames; on the avatar "
                "they are put on it",
                -lowest, frames, world_.size()));
    }

    /// A unit that nobody told, and that makes no ordinary person of the figure.
    void findOddSize(const assets::FoundUnit& unit) {
        constexpr double leg_of_stature = 0.491;  // thigh and shin (Drillis & Contini 1966)
        constexpr double smallest_m = 0.8, tallest_m = 2.3;
        if (unit.origin == assets::Origin::assumed) {
            warning(
                fmt::format("the unit is taken to be the {}: where it is another, give --unit", unit.name));
            return;
        }
        for (const motion::Bone bone : {leftUpperLeg, leftLowerLeg, leftFoot})
            if (!map_.has(bone)) return;
        const double leg = glm::length(at(0, leftLowerLeg) - at(0, leftUpperLeg)) +
                           glm::length(at(0, leftFoot) - at(0, leftLowerLeg));
        if (const double stature = leg / leg_of_stature; stature < smallest_m || stature > tallest_m)
            warning(
                fmt::format("by its legs the figure is {:.2f} m tall: is its unit really the {}? --unit "
                            "gives another",
                            stature, unit.name));
    }

    const motion::Clip& clip_;
    motion::HumanoidMap map_;
    std::vector<std::vector<Pose>> world_{};
};

}  // namespace

std::vector<ClipProblem> clipProblems(const assets::ImportedClip& imported, const fs::path& file,
                                      const motion::HumanoidMap& map) {
    return Inspection(imported, file, map).problems;
}

}  // namespace deixis::app
