#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <memory>
#include <system_error>
#include <vector>

#include "assets/bvh.hpp"
#include "bvh_unit.hpp"
#include "core/files.hpp"

namespace deixis::assets {

namespace {

using motion::Clip;
using motion::Joint;
using motion::LocalPose;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool sameWord(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    if (word.empty()) return "the end of the file";
    return "'" + std::string(word.substr(0, longest)) + (word.size() > longest ? "...'" : "'");
}

/// Words and lines of a text, with the number of the line.
class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {
        if (text_.substr(0, 3) == "\xEF\xBB\xBF") text_.remove_prefix(3);
    }

    /// The next word, over line ends; empty at the end. Braces and the colon's right side stand for
    /// themselves.
    std::string_view word() {
        while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '\n')) skip();
        word_line_ = line_;
        return wordHere();
    }

    /// The next word of this line; empty at its end.
    std::string_view wordOfLine() {
        while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
        return wordHere();
    }

    /// What is left of this line up to a brace, without blanks around it.
    std::string_view restOfLine() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '{') ++at_;
        std::string_view rest = text_.substr(begin, at_ - begin);
        while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
        while (!rest.empty() && isBlank(rest.back())) rest.remove_suffix(1);
        return rest;
    }

    [[nodiscard]] int wordLine() const { return word_line_; }  ///< of the latest word()
    [[nodiscard]] int line() const { return line_; }
    [[nodiscard]] std::size_t bytesLeft() const { return text_.size() - at_; }

  private:
    void skip() {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }

    std::string_view wordHere() {
        const std::size_t begin = at_;
        if (at_ < text_.size() && (text_[at_] == '{' || text_[at_] == '}'))
            ++at_;
        else
            while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != '\n' && text_[at_] != '{' &&
                   text_[at_] != '}')
                if (text_[at_++] == ':') break;
        return text_.substr(begin, at_ - begin);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    int word_line_ = 1;
};

struct Channel {
    bool rotation;
    int axis;  ///< 0 x, 1 y, 2 z
};

constexpr std::array<std::string_view, 6> channel_names{"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};

class Parser {
  public:
    Parser(std::string_view text, const std::string& name) : in_(text), name_(name) {}

    Result<Clip> parse() {
        if (auto done = hierarchy(); !done) return tl::unexpected(done.error());
        if (auto done = motion(); !done) return tl::unexpected(done.error());
        if (positionsAreShifts()) addOffsets();
        return std::move(clip_);
    }

    std::vector<std::string> remarks{};

  private:
    tl::unexpected<Error> wrong(int line, std::string message, std::string mend = {}) const {
        return fail(name_ + ":" + std::to_string(line), std::move(message), std::move(mend));
    }

    Result<void> expect(std::string_view word) {
        if (const auto found = in_.word(); !sameWord(found, word))
            return wrong(in_.wordLine(), "found " + quoted(found) + ", expected '" + std::string(word) + "'");
        return {};
    }

    Result<double> number(std::string_view word, int line, const char* what) const {
        double value = 0.0;
        std::string_view digits = word;
        if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') digits.remove_prefix(1);
        const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (problem != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
            return wrong(line, "found " + quoted(word) + ", expected a finite number for " + what);
        return value;
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
                                         [&](std::string_view name) { return sameWord(name, word); });
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
            if (sameWord(word, "}")) {
                open.pop_back();
            } else if (sameWord(word, "OFFSET")) {
                const auto value = offset();
                if (!value) return tl::unexpected(value.error());
                clip_.skeleton.joints[joint].rest.position = *value;
            } else if (sameWord(word, "CHANNELS")) {
                done = channelList(joint);
            } else if (sameWord(word, "JOINT")) {
                done = openJoint(open.back());
                open.push_back(clip_.skeleton.size() - 1);
            } else if (sameWord(word, "End")) {
                done = endSite(joint);
            } else {
                return wrong(in_.wordLine(), "found " + quoted(word) + " in joint '" +
                                                 clip_.skeleton.joints[joint].name +
                                                 "', expected OFFSET, CHANNELS, JOINT, End Site or '}'");
            }
            if (!done) return done;
        }
        const auto word = in_.word();
        if (sameWord(word, "ROOT"))
            return wrong(in_.wordLine(), "found a second ROOT, expected one figure in a file",
                         "Split the file into one file for each figure");
        if (!sameWord(word, "MOTION"))
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
        if (*count < 1 || *count > 1e8 || *count != std::floor(*count))
            return wrong(in_.line(), "found " + quoted(count_word) + " frames, expected at least 1");
        if (auto word = expect("Frame"); !word) return word;
        if (auto word = expect("Time:"); !word) return word;
        const auto time_word = in_.wordOfLine();
        const auto time = number(time_word, in_.line(), "Frame Time");
        if (!time) return tl::unexpected(time.error());
        if (*time <= 0.0)
            return wrong(in_.line(), "found frame time " + quoted(time_word) + ", expected seconds above 0");
        clip_.frame_time_s = *time;
        return frames(static_cast<std::size_t>(*count));
    }

    Result<void> frames(std::size_t count) {
        const std::string declared = std::to_string(count) + " as 'Frames:' says";
        // The declared number may be nonsense; the bytes left bound what there can be.
        clip_.frames.reserve(std::min(count, in_.bytesLeft() / (2 * values_per_frame_) + 1));
        std::vector<double> values(values_per_frame_);
        const LocalPose rest = motion::restPose(clip_.skeleton);
        for (;;) {
            std::string_view word = in_.word();
            if (word.empty()) break;
            const int line = in_.wordLine();
            if (clip_.frames.size() == count)
                return wrong(line, "found more lines of motion, expected " + declared);
            std::size_t read = 0;
            for (; !word.empty(); word = in_.wordOfLine(), ++read) {
                const auto value = number(word, line, "a channel");
                if (!value) return tl::unexpected(value.error());
                if (read < values_per_frame_) values[read] = *value;
            }
            if (read != values_per_frame_)
                return wrong(line, "found " + std::to_string(read) + " values, expected " +
                                       std::to_string(values_per_frame_) + ", one for each channel");
            clip_.frames.push_back(rest);
            fill(values, clip_.frames.back());
        }
        if (clip_.frames.size() != count)
            return wrong(in_.line(), "found the end of the file after " +
                                         std::to_string(clip_.frames.size()) + " frames, expected " +
                                         declared);
        return {};
    }

    void fill(const std::vector<double>& values, LocalPose& pose) const {
        std::size_t next = 0;
        for (std::size_t j = 0; j < channels_.size(); ++j) {
            Pose& joint = pose.joints[j];
            for (const Channel& channel : channels_[j]) {
                const double value = values[next++];
                if (!channel.rotation) {
                    joint.position[channel.axis] = value;
                    continue;
                }
                const double half = 0.5 * radiansFromDegrees(value);
                Quat turn(std::cos(half), 0.0, 0.0, 0.0);
                (channel.axis == 0 ? turn.x : channel.axis == 1 ? turn.y : turn.z) = std::sin(half);
                joint.orientation = joint.orientation * turn;
            }
        }
    }

    [[nodiscard]] bool hasPositions(std::size_t joint) const {
        return std::any_of(channels_[joint].begin(), channels_[joint].end(),
                           [](const Channel& c) { return !c.rotation; });
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
        remarks.emplace_back(
            "positions of joints below the root are close to 0: taken as shifts from OFFSET");
    }

    Reader in_;
    const std::string& name_;
    Clip clip_;
    std::vector<std::vector<Channel>> channels_;  // of each joint, in file order
    std::size_t values_per_frame_ = 0;
    std::map<std::string, int> name_uses_;
};

void scale(Clip& clip, double factor) {
    for (Joint& joint : clip.skeleton.joints) {
        joint.rest.position *= factor;
        if (joint.end_site) *joint.end_site *= factor;
    }
    for (LocalPose& frame : clip.frames)
        for (Pose& pose : frame.joints) pose.position *= factor;
}

Result<std::string> unpack(const std::filesystem::path& path) {
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), &gzclose);
    if (!file) return fail(path.string(), "cannot be opened");
    std::string text;
    std::vector<char> buffer(1 << 16);
    for (;;) {
        const int count = gzread(file.get(), buffer.data(), static_cast<unsigned>(buffer.size()));
        int code = Z_OK;
        const char* problem = gzerror(file.get(), &code);
        if (count < 0 || (code != Z_OK && code != Z_STREAM_END))
            return fail(path.string(),
                        std::string("found damaged gzip data (") + problem + "), expected a whole file");
        if (count == 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

Result<BvhFile> parseBvh(std::string_view text, const std::string& name, const BvhOptions& options) {
    Parser parser(text, name);
    auto clip = parser.parse();
    if (!clip) return tl::unexpected(clip.error());
    const LengthUnit unit =
        options.metres_per_unit ? LengthUnit{*options.metres_per_unit, "as given"} : detectUnit(*clip);
    scale(*clip, unit.metres_per_unit);
    return BvhFile{std::move(*clip), unit.metres_per_unit, unit.words, std::move(parser.remarks)};
}

Result<BvhFile> readBvh(const std::filesystem::path& path, const BvhOptions& options) {
    const auto text = path.extension() == ".gz" ? unpack(path) : readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseBvh(*text, path.string(), options);
}

}  // namespace deixis::assets
