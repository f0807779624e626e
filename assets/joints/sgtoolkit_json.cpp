#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "assets/joints/joint_positions.hpp"
#include "motion/upper_body/upper_body.hpp"
#include "position_import.hpp"
#include "up_axis.hpp"

namespace deixis::assets {

namespace {

using Json = nlohmann::json;
using motion::Bone;
using motion::UpperJoint;

constexpr std::size_t position_numbers = 3 * motion::upper_joint_count;
constexpr const char* expected_frames =
    "expected frames of 30 numbers (x y z of 10 joints) or 27 (directions of 9 bones)";

using Pose10 = motion::UpperBodyJoints;

/// Numbers of a frame: flat, or x y z of each joint in an array of its own.
Result<std::vector<double>> numbersOf(const Json& frame, const std::string& where) {
    std::vector<double> numbers;
    const auto add = [&](const Json& value) {
        if (!value.is_number() || !std::isfinite(value.get<double>())) return false;
        numbers.push_back(value.get<double>());
        return true;
    };
    const auto wrong = [&] {
        return fail(where, std::string("found something other than numbers, ") + expected_frames);
    };
    if (!frame.is_array()) return wrong();
    for (const Json& item : frame) {
        if (item.is_array()) {
            for (const Json& number : item)
                if (!add(number)) return wrong();
        } else if (!add(item)) {
            return wrong();
        }
    }
    return numbers;
}

Result<Pose10> poseOf(const Json& frame, const std::string& where) {
    const auto numbers = numbersOf(frame, where);
    if (!numbers) return tl::unexpected(numbers.error());
    const auto triple = [&](std::size_t i) {
        return Vec3((*numbers)[3 * i], (*numbers)[3 * i + 1], (*numbers)[3 * i + 2]);
    };
    Pose10 pose{};
    if (numbers->size() == position_numbers) {
        for (std::size_t j = 0; j < motion::upper_joint_count; ++j) pose[j] = triple(j);
        return pose;
    }
    if (numbers->size() != motion::upper_body_numbers)
        return fail(where, fmt::format("found {} numbers, {}", numbers->size(), expected_frames));
    const auto directions = motion::poseFromNumbers(*numbers);
    if (!directions) return fail(where, fmt::format("{}, {}", directions.error().message, expected_frames));
    return motion::jointsOf(*directions);
}

/// The object of an array that options.animation chooses, by its name or index.
Result<const Json*> chosenOf(const Json& gestures, const std::string& name, const std::string& animation) {
    std::string names;
    std::size_t index = 0;
    for (const Json& gesture : gestures) {
        const std::string own = gesture.is_object() && gesture.contains("name") && gesture["name"].is_string()
                                    ? gesture["name"].get<std::string>()
                                    : std::string();
        if (!animation.empty() && (animation == own || animation == std::to_string(index))) return &gesture;
        if (index++ < 10)
            names += (names.empty() ? "" : ", ") + (own.empty() ? std::to_string(index - 1) : own);
    }
    if (animation.empty() && gestures.size() == 1) return &gestures[0];
    return fail(name,
                animation.empty() ? fmt::format("has {} gestures: {}; expected one to be named", index, names)
                                  : fmt::format("has no gesture '{}', only: {}", animation, names),
                "Name one with --animation, or its number from 0");
}

Result<const Json*> framesOf(const Json& file, const std::string& name, const std::string& animation) {
    const Json* at = &file;
    if (at->is_array() && !at->empty() && at->front().is_object()) {
        const auto chosen = chosenOf(*at, name, animation);
        if (!chosen) return chosen;
        at = *chosen;
    }
    if (at->is_object()) {
        for (const char* key : {"output-data", "motion"})
            if (at->contains(key)) {
                at = &(*at)[key];
                break;
            }
        if (at->is_object())
            return fail(name,
                        "found neither 'output-data' nor 'motion', expected a gesture of the SGToolkit");
    }
    if (!at->is_array() || at->empty()) return fail(name, std::string("found no frames, ") + expected_frames);
    return at;
}

/// Whether the figure, turned to y up, is its own mirror image: its left lies where up and the way that it
/// faces put the right.
bool isMirrored(const std::vector<Pose10>& poses, const Quat& turn) {
    using enum UpperJoint;
    double left = 0.0;
    for (const Pose10& pose : poses) {
        const auto at = [&](UpperJoint joint) { return pose[static_cast<std::size_t>(joint)]; };
        const Vec3 face = turn * (at(nose) - 0.5 * (at(neck) + at(head_top)));
        left += glm::dot(turn * (at(left_shoulder) - at(right_shoulder)), glm::cross(up, face));
    }
    return left < 0.0;
}

motion::BonePositions bonePositions(const Pose10& p) {
    motion::BonePositions out;
    constexpr std::array<std::pair<UpperJoint, Bone>, 9> joints{
        {{UpperJoint::spine, Bone::spine},
         {UpperJoint::neck, Bone::neck},
         {UpperJoint::nose, Bone::head},
         {UpperJoint::left_shoulder, Bone::leftUpperArm},
         {UpperJoint::left_elbow, Bone::leftLowerArm},
         {UpperJoint::left_wrist, Bone::leftHand},
         {UpperJoint::right_shoulder, Bone::rightUpperArm},
         {UpperJoint::right_elbow, Bone::rightLowerArm},
         {UpperJoint::right_wrist, Bone::rightHand}}};
    for (const auto& [joint, bone] : joints) out[bone] = p[static_cast<std::size_t>(joint)];
    return out;
}

}  // namespace

Result<ImportedClip> parseSgToolkitJson(std::string_view text, const std::string& name,
                                        const ImportOptions& options) {
    Json file;
    try {
        file = Json::parse(text);
    } catch (const Json::exception& problem) {  // its words begin with a code in brackets
        const std::string words = problem.what();
        return fail(name, "is not JSON: " + words.substr(std::min(words.find("] ") + 2, words.size())));
    }
    const auto frames = framesOf(file, name, options.animation);
    if (!frames) return tl::unexpected(frames.error());
    std::vector<Pose10> poses;
    for (const Json& frame : **frames) {
        auto pose = poseOf(frame, fmt::format("{}: frame {}", name, poses.size()));
        if (!pose) return tl::unexpected(pose.error());
        poses.push_back(*pose);
    }
    PositionRecording out;
    out.format = "SGToolkit joint positions";
    out.rate = options.fps ? FoundRate{*options.fps, Origin::given}
                           : FoundRate{motion::upper_body_fps, Origin::declared};
    for (const Pose10& pose : poses) out.frames.push_back(bonePositions(pose));
    const FoundUp rise = findUp(out.frames, options.up_axis);
    if (isMirrored(poses, yFromUp(rise.axis))) {
        const bool along_x = rise.axis == UpAxis::x || rise.axis == UpAxis::minus_x;
        const Vec3 mirror = along_x ? Vec3(1, 1, -1) : Vec3(-1, 1, 1);
        for (auto& frame : out.frames)
            for (auto& position : frame.at)
                if (position) *position *= mirror;
        out.remarks.emplace_back("left-handed coordinates, as in the toolkit's window, are mirrored");
    }
    out.remarks.emplace_back("upper body only: hips and legs stay at rest");
    return clipOfPositions(std::move(out), name, options);
}

}  // namespace deixis::assets
