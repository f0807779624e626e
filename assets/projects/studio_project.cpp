#include "assets/projects/studio_project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "core/base64.hpp"
#include "core/files.hpp"

namespace deixis::assets {

namespace {

using nlohmann::json;

/// What is found of a value, short enough for a message.
std::string foundText(const json& value) {
    constexpr std::size_t longest = 40;
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

/// An object of the project, with where it stands; the first problem is kept.
class Reading {
  public:
    Reading(const json& value, std::string where, std::optional<Error>& problem)
        : value_(value), where_(std::move(where)), problem_(problem) {
        if (!value_.is_object()) note("", value_, "an object");
    }

    [[nodiscard]] Reading object(const char* key) const { return {at(key), place(key), problem_}; }
    [[nodiscard]] std::string text(const char* key) const {
        const json& value = at(key);
        if (value.is_string()) return value.get<std::string>();
        note(key, value, "text");
        return "";
    }
    [[nodiscard]] double number(const char* key, double low, double high) const {
        const json& value = at(key);
        if (value.is_number() && value.get<double>() >= low && value.get<double>() <= high)
            return value.get<double>();
        note(key, value, fmt::format("a number from {} to {}", low, high));
        return low;
    }
    [[nodiscard]] bool flag(const char* key, bool otherwise) const {
        const json& value = at(key);
        if (value.is_boolean()) return value.get<bool>();
        if (!value.is_null()) note(key, value, "true or false");
        return otherwise;
    }
    /// Of objects; empty with a problem where it is none.
    [[nodiscard]] const json& list(const char* key) const {
        static const json none = json::array();
        const json& value = at(key);
        if (value.is_array()) return value;
        note(key, value, "a list");
        return none;
    }
    [[nodiscard]] Reading item(const json& value, const char* key, std::size_t index) const {
        return {value, fmt::format("{}[{}]", place(key), index), problem_};
    }
    [[nodiscard]] bool isList(const char* key) const { return at(key).is_array(); }
    [[nodiscard]] bool has(const char* key) const { return !at(key).is_null(); }
    [[nodiscard]] std::string place(const char* key) const {
        return where_ + (*key == '\0' ? "" : ".") + key;
    }
    void note(const char* key, const json& found, const std::string& expected) const {
        if (!problem_)
            problem_ = Error{place(key), fmt::format("found {}, expected {}", foundText(found), expected)};
    }

  private:
    [[nodiscard]] const json& at(const char* key) const {
        static const json nothing;
        if (!value_.is_object()) return nothing;
        const auto found = value_.find(key);
        return found == value_.end() ? nothing : *found;
    }

    const json& value_;
    std::string where_;
    std::optional<Error>& problem_;
};

constexpr double longest_speech_s = 1800.0;
constexpr double last_frame = longest_speech_s * motion::upper_body_fps;
constexpr std::array style_names{"speed", "space", "handedness"};

/// A frame's 27 numbers; none where they are not.
std::optional<motion::UpperBodyPose> poseOf(const json& frame) {
    std::vector<double> numbers;
    if (frame.is_array())
        for (const json& number : frame)
            if (number.is_number()) numbers.push_back(number.get<double>());
    auto pose = motion::poseFromNumbers(numbers);
    if (!pose) return std::nullopt;
    return *pose;
}

std::vector<motion::UpperBodyPose> readFrames(const Reading& of, const char* key) {
    std::vector<motion::UpperBodyPose> out;
    const json& frames = of.list(key);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const auto pose = poseOf(frames[f]);
        if (!pose) {
            of.note(fmt::format("{}[{}]", key, f).c_str(), frames[f],
                    "27 numbers, the directions of nine bones");
            return out;
        }
        out.push_back(*pose);
    }
    return out;
}

void readAccents(const Reading& speech, Utterance& out) {
    const json& accents = speech.list("accents");
    for (std::size_t i = 0; i < accents.size(); ++i) {
        const Reading accent = speech.item(accents[i], "accents", i);
        const double last_word = static_cast<double>(out.words.size()) - 1.0;
        out.accents.push_back(
            {accent.number("start_s", 0.0, longest_speech_s), accent.number("end_s", 0.0, longest_speech_s),
             accent.number("strength", 0.0, 1.0), static_cast<int>(accent.number("word", 0.0, last_word))});
    }
}

void readSpeech(const Reading& speech, StudioProject& out) {
    out.text = speech.text("text");
    out.utterance.duration_s = speech.number("duration_s", 0.01, longest_speech_s);
    const json& words = speech.list("words");
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Reading word = speech.item(words[i], "words", i);
        out.utterance.words.push_back({word.text("word"), word.number("start_s", 0.0, longest_speech_s),
                                       word.number("end_s", 0.0, longest_speech_s)});
    }
    if (speech.has("accents")) readAccents(speech, out.utterance);
    const std::string wav = speech.text("wav");
    if (auto bytes = decodeBase64(wav))
        out.wav = std::move(*bytes);
    else
        speech.note("wav", "...", "a sound's file in base64");
}

void readMotion(const Reading& motion, StudioProject& out) {
    out.system = motion.text("system");
    out.synthetic = motion.flag("synthetic", true);
    out.motion.frames = readFrames(motion, "frames");
    const std::size_t wanted = motion::frameCountOf(out.utterance.duration_s - 1e-6);
    if (out.motion.frames.size() != wanted &&
        out.motion.frames.size() != motion::frameCountOf(out.utterance.duration_s))
        motion.note("frames", out.motion.frames.size(),
                    fmt::format("{} frames, as the speech lasts", wanted));
}

ProjectPoses posesOf(const Reading& control) {
    ProjectPoses out{static_cast<int>(control.number("start", 0.0, last_frame)),
                     static_cast<int>(control.number("length", 1.0, last_frame)),
                     readFrames(control, "base")};
    if (out.base.empty()) control.note("base", json::array(), "one frame at least");
    if (control.flag("mirrored", false))
        for (motion::UpperBodyPose& pose : out.base) pose = motion::mirrored(pose);
    return out;
}

ProjectStyle styleOf(const Reading& control) {
    constexpr double limit = 3.0;
    ProjectStyle out;
    out.start = static_cast<int>(control.number("start", 0.0, last_frame));
    out.length = static_cast<int>(control.number("length", 1.0, last_frame));
    for (std::size_t s = 0; s < style_names.size(); ++s) {
        const char* name = style_names[s];
        if (!control.has(name)) continue;
        if (!control.isList(name)) {
            out.curves[s] = {{0.0, control.number(name, -limit, limit)}};
            continue;
        }
        const json& points = control.list(name);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Reading point = control.item(points[k], name, k);
            out.curves[s].push_back({point.number("at", 0.0, 1.0), point.number("value", -limit, limit)});
        }
    }
    return out;
}

/// Of what a motion is to be made.
void readWishes(const Reading& document, const Reading& bypass, StudioProject& out) {
    out.system = document.has("system") ? document.text("system") : "model";
    if (!motion::gestureMakerFromName(out.system))
        document.note("system", out.system, "one of model, rules, keyframes");
    if (document.has("seed"))
        out.seed = static_cast<std::uint64_t>(document.number("seed", 0.0, 9007199254740991.0));
    out.exact = document.flag("exact", false);
    if (document.has("variety")) out.variety = document.number("variety", 0.0, 2.0);
    if (document.has("finish")) {
        out.still = document.object("finish").flag("still", false);
        out.fade = document.object("finish").flag("fade", false);
    }
    const auto each = [&](const char* key, const auto& read) {
        const json& controls = document.list(key);
        for (std::size_t i = 0; i < controls.size(); ++i) read(document.item(controls[i], key, i));
    };
    if (!bypass.flag("pose", false))
        each("poseControls", [&](const Reading& control) { out.poses.push_back(posesOf(control)); });
    if (!bypass.flag("style", false))
        each("styleControls", [&](const Reading& control) { out.styles.push_back(styleOf(control)); });
}

/// Of a curve with at least one point.
double valueAt(const std::vector<ProjectStyle::Point>& curve, double share) {
    const auto next =
        std::ranges::find_if(curve, [&](const ProjectStyle::Point& point) { return point.at > share; });
    if (next == curve.begin()) return curve.front().value;
    if (next == curve.end()) return curve.back().value;
    const ProjectStyle::Point &a = *(next - 1), &b = *next;
    return a.value + (b.value - a.value) * (share - a.at) / (b.at - a.at);
}

/// The same poses in `length` frames, the first and the last kept. One pose is held.
std::vector<motion::UpperBodyPose> resampled(const std::vector<motion::UpperBodyPose>& base, int length) {
    std::vector<motion::UpperBodyPose> out;
    const std::size_t last = base.size() - 1;
    for (int k = 0; k < length; ++k) {
        const double at =
            length == 1 ? 0.0 : static_cast<double>(k) * static_cast<double>(last) / (length - 1);
        const auto low = std::min(static_cast<std::size_t>(at), last);
        const double share = at - static_cast<double>(low);
        out.push_back(share <= 0.0 ? base[low]
                                   : motion::interpolate(base[low], base[std::min(low + 1, last)], share));
    }
    return out;
}

}  // namespace

Result<motion::WantedGestures> wantedOf(const StudioProject& project, std::size_t frames) {
    const auto fits = [frames](const auto& control, const char* list, std::size_t place) -> Result<void> {
        if (static_cast<std::size_t>(control.start) + static_cast<std::size_t>(control.length) <= frames)
            return {};
        return fail(fmt::format("{}[{}]", list, place),
                    fmt::format("ends at frame {}, expected at most {}, the speech's end",
                                control.start + control.length, frames));
    };
    motion::WantedGestures out;
    const auto maker = motion::gestureMakerFromName(project.system);
    if (!maker)
        return fail("system",
                    fmt::format("found \"{}\", expected one of model, rules, keyframes", project.system));
    out.maker = *maker;
    out.seed = project.seed;
    out.exact = project.exact;
    if (out.maker == motion::GestureMaker::model) out.variety = project.variety;
    out.still = project.still;
    out.fade = project.fade;
    for (std::size_t i = 0; i < project.poses.size(); ++i) {
        const ProjectPoses& control = project.poses[i];
        if (auto inside = fits(control, "poseControls", i); !inside) return tl::unexpected(inside.error());
        int frame = control.start;
        for (const motion::UpperBodyPose& pose : resampled(control.base, control.length))
            out.poses.push_back({frame++, pose});
    }
    if (const auto checked = motion::checkPoses(out.poses, frames); !checked)
        return fail("poseControls", checked.error().text());
    if (project.styles.empty() || out.maker == motion::GestureMaker::keyframes) return out;
    out.styles.resize(frames);
    for (std::size_t i = 0; i < project.styles.size(); ++i) {
        const ProjectStyle& control = project.styles[i];
        if (auto inside = fits(control, "styleControls", i); !inside) return tl::unexpected(inside.error());
        for (int k = 0; k < control.length; ++k) {
            const double share = control.length == 1 ? 0.5 : static_cast<double>(k) / (control.length - 1);
            motion::StyleControl& at =
                out.styles[static_cast<std::size_t>(control.start) + static_cast<std::size_t>(k)];
            for (const auto& [curve, value] :
                 {std::pair(&control.curves[0], &at.speed), std::pair(&control.curves[1], &at.space),
                  std::pair(&control.curves[2], &at.handedness)})
                // As the page asks for it.
                if (!curve->empty()) *value = std::round(1000.0 * valueAt(*curve, share)) / 1000.0;
        }
    }
    return out;
}

std::string withoutControls(std::string_view bytes) {
    json file = json::parse(bytes);
    json& document = file.at("document");
    document["poseControls"] = json::array();
    document["styleControls"] = json::array();
    document["motion"] = nullptr;
    document["range"] = nullptr;
    for (const char* key : {"about", "author"}) file.erase(key);  // it becomes somebody else's
    return file.dump(1) + "\n";
}

Result<StudioProject> parseStudioProject(std::string_view bytes, const std::string& name) {
    const json file = json::parse(bytes, nullptr, false);
    if (file.is_discarded() || !file.is_object() || file.value("format", json()) != "deixis-studio")
        return fail(name, "found no project of the studio, expected a file that the studio's page saved");
    std::optional<Error> problem;
    const Reading whole(file, name, problem);
    const double version = whole.number("version", 1.0, 1e9);
    if (!problem && version > studio_project_version)
        return fail(name + ".version",
                    fmt::format("found {}, expected at most {}", version, studio_project_version),
                    "A newer Deixis reads it");
    const Reading document = whole.object("document");
    StudioProject out;
    out.name = document.text("name");
    if (whole.has("author")) out.author = whole.text("author");
    if (document.has("speech")) {
        readSpeech(document.object("speech"), out);
    } else {
        out.text = document.text("text");
        if (!problem &&
            (out.text.find_first_not_of(" \n\t") == std::string::npos || document.has("recording")))
            return fail(document.place("speech"),
                        "is not there yet, expected a speech, or a text for a voice",
                        "Press Generate in the studio, and save the project again");
    }
    if (document.has("voice")) out.voice = document.text("voice");
    const Reading bypass = document.object("bypass");
    if (document.has("motion") && document.has("speech")) {
        if (!problem) readMotion(document.object("motion"), out);
    } else {
        readWishes(document, bypass, out);
    }
    if (!bypass.flag("pose", false))
        out.pose_controls = static_cast<int>(document.list("poseControls").size());
    if (!bypass.flag("style", false))
        out.style_controls = static_cast<int>(document.list("styleControls").size());
    if (document.has("finish")) out.relaxed_fingers = document.object("finish").flag("relaxedFingers", true);
    if (problem) return tl::unexpected(*problem);
    return out;
}

Result<StudioProject> readStudioProject(const std::filesystem::path& file) {
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    return parseStudioProject(*bytes, file.string());
}

}  // namespace deixis::assets
