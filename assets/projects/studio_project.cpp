#include "assets/projects/studio_project.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

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

void readSpeech(const Reading& speech, StudioProject& out) {
    out.text = speech.text("text");
    out.utterance.duration_s = speech.number("duration_s", 0.01, longest_speech_s);
    const json& words = speech.list("words");
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Reading word = speech.item(words[i], "words", i);
        out.utterance.words.push_back({word.text("word"), word.number("start_s", 0.0, longest_speech_s),
                                       word.number("end_s", 0.0, longest_speech_s)});
    }
    const std::string wav = speech.text("wav");
    if (auto bytes = decodeBase64(wav))
        out.wav = std::move(*bytes);
    else
        speech.note("wav", "...", "a sound's file in base64");
}

void readMotion(const Reading& motion, StudioProject& out) {
    out.system = motion.text("system");
    out.synthetic = motion.flag("synthetic", true);
    const json& frames = motion.list("frames");
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const std::string key = fmt::format("frames[{}]", f);
        std::vector<double> numbers;
        if (frames[f].is_array())
            for (const json& number : frames[f])
                if (number.is_number()) numbers.push_back(number.get<double>());
        const auto pose = motion::poseFromNumbers(numbers);
        if (!pose) return motion.note(key.c_str(), frames[f], "27 numbers, the directions of nine bones");
        out.motion.frames.push_back(*pose);
    }
    const std::size_t wanted = motion::frameCountOf(out.utterance.duration_s - 1e-6);
    if (out.motion.frames.size() != wanted &&
        out.motion.frames.size() != motion::frameCountOf(out.utterance.duration_s))
        motion.note("frames", out.motion.frames.size(),
                    fmt::format("{} frames, as the speech lasts", wanted));
}

}  // namespace

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
    for (const char* part : {"speech", "motion"})
        if (!problem && !document.has(part))
            return fail(document.place(part), "is not there yet, expected a speech with generated gestures",
                        "Press Generate in the studio, and save the project again");
    StudioProject out;
    out.name = document.text("name");
    readSpeech(document.object("speech"), out);
    if (!problem) readMotion(document.object("motion"), out);
    const Reading bypass = document.object("bypass");
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
