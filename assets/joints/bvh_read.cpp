#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "bvh_motion.hpp"
#include "bvh_text.hpp"
#include "core/text.hpp"
#include "length_unit.hpp"
#include "packed_file.hpp"

namespace deixis::assets {

namespace {

using motion::Clip;
using motion::Joint;
using motion::LocalPose;

constexpr std::array<std::string_view, 6> channel_names{"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};

/// Longer than the slowest frame rate, and shorter than the fastest, of any recording: from 1 to 10,000
/// frames per second.
constexpr double longest_frame_s = 1.0;
constexpr double shortest_frame_s = 1e-4;

/// A person with fingers and face has some 200.
constexpr std::size_t max_joints = 10000;

class Parser {
  public:
    Parser(std::string_view text, const std::string& name, const std::optional<double>& fps)
        : in_(text), name_(name), fps_(fps) {}

    Result<Clip> parse() {
        if (auto done = hierarchy(); !done) return tl::unexpected(done.error());
        if (auto done = motion(); !done) return tl::unexpected(done.error());
        if (positionsAreShifts()) addOffsets();
        return std::move(clip_);
    }

    std::vector<std::string> remarks{};

  private:
    tl::unexpected<Error> wrong(int line, std::string message, std::string hint = {}) const {
        return fail(name_ + ":" + std::to_string(line), std::move(message), std::move(hint));
    }

    Result<void> expect(std::string_view word) {
        if (const auto found = in_.word(); !sameLetters(found, word))
            return wrong(in_.wordLine(), "found " + quoted(found) + ", expected '" + std::string(word) + "'");
        return {};
    }

    [[nodiscard]] Result<double> number(std::string_view word, int line, const char* what) const {
        return wholeNumber(word, name_ + ":" + std::to_string(line), what);
    }

    Result<Vec3> offset() {
        Vec3 value{0.0};
        for (int axis = 0; axis < 3; ++axis) {
            const auto word = in_.word();
            const auto parsed = number(word, in_.wordLine(), "OFFSET");
            if (!parsed) return tl::unexpected(parsed.error());
            value[axis] = *parsed;
        }
        return value;
    }

    std::string uniqueName(std::string_view given) {
        std::string name(given);
        int& uses = name_uses_[name];
        if (++uses == 1) return name;
        const std::string fresh = uniqueName(name + "#" + std::to_string(uses));
        remarks.push_back("a second joint named '" + name + "' is called '" + fresh + "'");
        return fresh;
    }

    Result<void> openJoint(int parent) {
        const int line = in_.wordLine();
        const auto name = in_.restOfLine();
        if (name.empty()) return wrong(line, "found no name, expected the joint's name");
        if (auto brace = expect("{"); !brace) return brace;
        if (clip_.skeleton.joints.size() == max_joints)
            return wrong(line, "found more than " + std::to_string(max_joints) +
                                   " joints, expected a figure of a person");
        Joint joint;
        joint.name = uniqueName(name);
        joint.parent = parent;
        clip_.skeleton.joints.push_back(std::move(joint));
        channels_.emplace_back();
        return {};
    }

    Result<void> channelList(std::size_t joint) {
        const int line = in_.wordLine();
        const auto count_word = in_.wordOfLine();
        const auto count = number(count_word, line, "CHANNELS");
        if (!count) return tl::unexpected(count.error());
        if (*count < 0 || *count > 6 || *count != std::floor(*count))
            return wrong(line, "found " + quoted(count_word) + " channels, expected 0 to 6");
        std::array<bool, 6> seen{};
        for (int i = 0; i < static_cast<int>(*count); ++i) {
            const auto word = in_.word();
            const auto at = std::find_if(channel_names.begin(), channel_names.end(),
                                         [&](std::string_view name) { return sameLetters(name, word); });
            if (at == channel_names.end())
                return wrong(in_.wordLine(), "found channel " + quoted(word) +
                                                 ", expected Xposition, Yposition, Zposition, Xrotation, "
                                                 "Yrotation or Zrotation");
            const auto index = static_cast<std::size_t>(at - channel_names.begin());
            if (seen[index])
                return wrong(in_.wordLine(),
                             "found channel " + quoted(word) + " twice in one joint, expected it once");
            seen[index] = true;
            channels_[joint].push_back({index >= 3, static_cast<int>(index % 3)});
            ++values_per_frame_;
        }
        return {};
    }

    Result<void> endSite(std::size_t joint) {
        if (auto site = expect("Site"); !site) return site;
        (void)in_.restOfLine();
        if (auto brace = expect("{"); !brace) return brace;
        if (auto word = expect("OFFSET"); !word) return word;
        const auto value = offset();
        if (!value) return tl::unexpected(value.error());
        clip_.skeleton.joints[joint].end_site = *value;
        return expect("}");
    }

    Result<void> hierarchy() {
        if (auto word = expect("HIERARCHY"); !word) return word;
        if (auto word = expect("ROOT"); !word) return word;
        if (auto root = openJoint(-1); !root) return root;
        std::vector<int> open{0};
        while (!open.empty()) {
            const auto word = in_.word();
            const auto joint = static_cast<std::size_t>(open.back());
            Result<void> done{};
            if (sameLetters(word, "}")) {
                open.pop_back();
            } else if (sameLetters(word, "OFFSET")) {
                const auto value = offset();
                if (!value) return tl::unexpected(value.error());
                clip_.skeleton.joints[joint].rest.position = *value;
            } else if (sameLetters(word, "CHANNELS")) {
                done = channelList(joint);
            } else if (sameLetters(word, "JOINT")) {
                done = openJoint(open.back());
                open.push_back(clip_.skeleton.size() - 1);
            } else if (sameLetters(word, "End")) {
                done = endSite(joint);
            } else {
                return wrong(in_.wordLine(), "found " + quoted(word) + " in joint '" +
                                                 clip_.skeleton.joints[joint].name +
                                                 "', expected OFFSET, CHANNELS, JOINT, End Site or '}'");
            }
            if (!done) return done;
        }
        const auto word = in_.word();
        if (sameLetters(word, "ROOT"))
            return wrong(in_.wordLine(), "found a second ROOT, expected one figure in a file",
                         "Split the file into one file for each figure");
        if (!sameLetters(word, "MOTION"))
            return wrong(in_.wordLine(), "found " + quoted(word) + ", expected 'MOTION'");
        if (values_per_frame_ == 0)
            return wrong(in_.wordLine(), "found no channels, expected a figure that can move");
        return {};
    }

    Result<void> motion() {
        if (auto word = expect("Frames:"); !word) return word;
        const auto count_word = in_.wordOfLine();
        const auto count = number(count_word, in_.line(), "Frames");
        if (!count) return tl::unexpected(count.error());
        if (*count < 1 || *count > 1e15 || *count != std::floor(*count))
            return wrong(in_.line(), "found " + quoted(count_word) + " frames, expected at least 1");
        if (auto word = expect("Frame"); !word) return word;
        if (auto word = expect("Time:"); !word) return word;
        if (auto time = frameTime(); !time) return time;
        return readBvhMotion({in_.rest(), in_.line(), name_, static_cast<std::size_t>(*count)}, channels_,
                             clip_);
    }

    Result<void> frameTime() {
        const auto word = in_.wordOfLine();
        if (fps_) {
            clip_.frame_time_s = 1.0 / *fps_;
            return {};
        }
        const auto time = number(word, in_.line(), "Frame Time");
        if (!time) return tl::unexpected(time.error());
        if (*time < shortest_frame_s || *time > longest_frame_s)
            return wrong(in_.line(),
                         "found frame time " + quoted(word) + ", expected seconds from " +
                             fmt::format("{:g} to {:g}", shortest_frame_s, longest_frame_s),
                         *time > longest_frame_s
                             ? "30 frames per second are 0.0333333: is it in milliseconds, or the number of "
                               "frames per second? Correct it, or give the rate with --fps"
                             : "30 frames per second are 0.0333333: correct it, or give the rate with --fps");
        clip_.frame_time_s = *time;
        return {};
    }

    [[nodiscard]] bool hasPositions(std::size_t joint) const {
        return std::any_of(channels_[joint].begin(), channels_[joint].end(),
                           [](const BvhChannel& c) { return !c.rotation; });
    }

    /// Blender can write the positions of joints below the root as shifts from OFFSET. Told by their size:
    /// where they replace OFFSET they are as long as the bones, as shifts they are next to nothing.
    [[nodiscard]] bool positionsAreShifts() const {
        double positions = 0.0;
        double offsets = 0.0;
        for (std::size_t j = 1; j < channels_.size(); ++j) {
            if (!hasPositions(j)) continue;
            for (const LocalPose& frame : clip_.frames) {
                positions += glm::length(frame.joints[j].position);
                offsets += glm::length(clip_.skeleton.joints[j].rest.position);
            }
        }
        return positions < 0.1 * offsets;
    }

    void addOffsets() {
        for (std::size_t j = 1; j < channels_.size(); ++j)
            if (hasPositions(j))
                for (LocalPose& frame : clip_.frames)
                    frame.joints[j].position += clip_.skeleton.joints[j].rest.position;
        remarks.emplace_back("positions of joints below the root are close to 0: read as shifts from OFFSET");
    }

    BvhText in_;
    const std::string& name_;
    const std::optional<double>& fps_;
    Clip clip_;
    BvhChannels channels_;
    std::size_t values_per_frame_ = 0;
    std::map<std::string, int> name_uses_;
};

void scale(Clip& clip, double factor) {
    if (factor == 1.0) return;
    for (Joint& joint : clip.skeleton.joints) {
        joint.rest.position *= factor;
        if (joint.end_site) *joint.end_site *= factor;
    }
    for (LocalPose& frame : clip.frames)
        for (Pose& pose : frame.joints) pose.position *= factor;
}

}  // namespace

Result<BvhFile> parseBvh(std::string_view text, const std::string& name, const BvhOptions& options) {
    Parser parser(text, name, options.fps);
    auto clip = parser.parse();
    if (!clip) return tl::unexpected(clip.error());
    const FoundUnit unit = options.metres_per_unit ? FoundUnit{*options.metres_per_unit, Origin::given,
                                                               givenUnitName(*options.metres_per_unit)}
                                                   : detectUnit(*clip);
    scale(*clip, unit.metres);
    return BvhFile{std::move(*clip), unit, std::move(parser.remarks)};
}

Result<BvhFile> readBvh(const std::filesystem::path& path, const BvhOptions& options) {
    const auto text = readUnpacked(path);
    if (!text) return tl::unexpected(text.error());
    return parseBvh(*text, path.string(), options);
}

}  // namespace deixis::assets
