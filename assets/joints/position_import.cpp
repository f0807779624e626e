#include "position_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/text.hpp"
#include "length_unit.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "up_axis.hpp"

namespace deixis::assets {

using motion::Bone;
using motion::BonePositions;

namespace {

/// Far away positions are a wrong unit or damaged data, and make nonsense of every sum.
Result<void> checkPlaces(const std::vector<BonePositions>& frames, const FoundUnit& unit,
                         const std::string& name) {
    constexpr double farthest_m = 1e5;
    for (std::size_t f = 0; f < frames.size(); ++f)
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            if (const auto& p = frames[f].at[b];
                p &&
                !(std::abs(p->x) < farthest_m && std::abs(p->y) < farthest_m && std::abs(p->z) < farthest_m))
                return fail(name, "frame " + std::to_string(f) + ": found " +
                                      std::string(motion::boneName(static_cast<Bone>(b))) +
                                      " more than 100 km away, in unit " + unitWords(unit) +
                                      "; expected the motion of a person");
    return {};
}

}  // namespace

Vec3 JointTrack::at(double t) const {
    const auto after = std::upper_bound(time_s.begin(), time_s.end(), t);
    if (after == time_s.begin()) return position.front();
    if (after == time_s.end()) return position.back();
    const auto i = static_cast<std::size_t>(after - time_s.begin());
    const double part = (t - time_s[i - 1]) / (time_s[i] - time_s[i - 1]);
    return position[i - 1] + (position[i] - position[i - 1]) * part;
}

Vec3 JointTrack::smoothAt(double t, double step_s) const {
    constexpr std::array<double, 5> weight{1.0, 2.0, 3.0, 2.0, 1.0};
    Vec3 sum(0.0);
    for (std::size_t i = 0; i < 5; ++i)
        sum += weight[i] / 9.0 * at(t + (static_cast<double>(i) - 2.0) * step_s);
    return sum;
}

Result<void> checkStep(double step_s, const std::string& name, std::string hint) {
    constexpr double shortest_s = 1e-4, longest_s = 1.0;
    if (step_s >= shortest_s && step_s <= longest_s) return {};
    return fail(name,
                fmt::format("found lines that are {:.4g} s apart, expected {:g} to {:g} s", step_s,
                            shortest_s, longest_s),
                std::move(hint));
}

Result<std::size_t> framesOver(const std::vector<double>& times_s, double step_s, const std::string& name,
                               std::vector<std::string>& remarks) {
    const double steps = (times_s.back() - times_s.front()) / step_s;
    if (!(steps < 10.0 * static_cast<double>(times_s.size()) + 1000.0))
        return fail(name, fmt::format("found {} lines spread over {:.0f} s, with gaps many times as long as "
                                      "the recording; expected times of one recording",
                                      times_s.size(), times_s.back() - times_s.front()));
    constexpr double noticed_s = 0.5;
    double longest_s = 0.0;
    double begin_s = 0.0;
    for (std::size_t i = 1; i < times_s.size(); ++i)
        if (const double gap_s = times_s[i] - times_s[i - 1]; gap_s > longest_s) {
            longest_s = gap_s;
            begin_s = times_s[i - 1] - times_s.front();
        }
    if (longest_s > noticed_s)
        remarks.push_back(
            fmt::format("{:.2f} s from {:.2f} s on have no lines (the longest gap): interpolated linearly",
                        longest_s, begin_s));
    return static_cast<std::size_t>(std::floor(steps + 1e-6)) + 1;
}

Result<ImportedClip> clipOfPositions(PositionRecording recording, const std::string& name,
                                     const ImportOptions& options) {
    ImportedClip out;
    out.format = std::move(recording.format);
    out.rate = recording.rate;
    out.remarks = std::move(recording.remarks);
    if (options.metres_per_unit)
        out.unit = {*options.metres_per_unit, Origin::given, givenUnitName(*options.metres_per_unit)};
    else
        out.unit = recording.unit ? *recording.unit : detectUnit(recording.frames);
    if (recording.up && !options.up_axis)
        out.up = {*recording.up, Origin::declared};
    else
        out.up = findUp(recording.frames, options.up_axis);
    const Quat turn = yFromUp(out.up.axis);
    const double scale = out.unit.metres;
    for (BonePositions& frame : recording.frames)
        for (auto& position : frame.at)
            if (position) position = turn * (scale * *position);
    if (auto places = checkPlaces(recording.frames, out.unit, name); !places)
        return tl::unexpected(places.error());
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const motion::HumanoidMap map = motion::mapByVrmNames(avatar);
    auto clip = motion::clipFromPositions(recording.frames, 1.0 / out.rate.fps, avatar, map);
    if (!clip) return fail(name, clip.error().message, clip.error().hint);
    out.clip = std::move(*clip);
    out.humanoid = map;
    return out;
}

motion::HumanoidMap bonesByName(const std::vector<std::string>& joint_names) {
    motion::Skeleton flat;  // names alone tell: positions come without a tree
    for (const std::string& name : joint_names) {
        motion::Joint joint;
        joint.name = name;
        flat.joints.push_back(std::move(joint));
    }
    motion::HumanoidMap map = motion::detectHumanoid(flat);
    // What only a tree tells the detection, such as the spine, is told by VRM's own name.
    for (std::size_t b = 0; b < motion::bone_count; ++b)
        for (std::size_t j = 0; j < joint_names.size() && map.joint[b] < 0; ++j)
            if (sameLetters(joint_names[j], motion::boneName(static_cast<Bone>(b))))
                map.joint[b] = static_cast<int>(j);
    return map;
}

void standInForTrunk(BonePositions& frame) {
    const auto between = [&](Bone middle, Bone left, Bone right) {
        if (!frame[middle] && frame[left] && frame[right])
            frame[middle] = 0.5 * (*frame[left] + *frame[right]);
    };
    between(Bone::neck, Bone::leftUpperArm, Bone::rightUpperArm);
    between(Bone::hips, Bone::leftUpperLeg, Bone::rightUpperLeg);
}

}  // namespace deixis::assets
