#include "app/studio/studio_options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "assets/avatar/avatar.hpp"
#include "assets/avatar/avatar_glb.hpp"
#include "assets/data/data_paths.hpp"
#include "core/text.hpp"
#include "speech/voice/helper_voices.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

/// Of the environment; relative ones do not count.
std::optional<fs::path> absolutePath(const char* variable) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || !fs::path(value).is_absolute()) return std::nullopt;
    return fs::path(value);
}

constexpr const char* voice_option = "--voice";

/// As a shell finds it; none: it does not.
std::optional<fs::path> findProgram(const std::string& name) {
    const auto usable = [](const fs::path& path) {
        std::error_code code;
        return fs::is_regular_file(path, code) && ::access(path.c_str(), X_OK) == 0;
    };
    if (name.find('/') != std::string::npos)
        return usable(name) ? std::optional(fs::absolute(name)) : std::nullopt;
    const char* const folders = std::getenv("PATH");
    std::istringstream list(folders == nullptr ? "/usr/local/bin:/usr/bin:/bin" : folders);
    for (std::string folder; std::getline(list, folder, ':');)
        if (!folder.empty() && usable(fs::path(folder) / name)) return fs::path(folder) / name;
    return std::nullopt;
}

bool isPlainName(std::string_view text) {
    constexpr std::size_t longest = 64;
    return !text.empty() && text.size() <= longest && std::all_of(text.begin(), text.end(), [](char c) {
        return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' ||
               c == '.';
    });
}

Result<speech::VoiceProgram> namedVoice(const std::string& text) {
    const auto parts = nameAndValue(text);
    const std::string name = parts ? parts->first.substr(0, parts->first.find(':')) : "";
    const std::string language =
        parts && name.size() < parts->first.size() ? parts->first.substr(name.size() + 1) : "en";
    if (!isPlainName(name) || !isPlainName(language))
        return fail(
            voice_option,
            fmt::format(
                "found '{}', expected NAME=PROGRAM or NAME:LANGUAGE=PROGRAM, of letters, digits and ._-",
                text));
    const auto program = findProgram(parts->second);
    if (!program)
        return fail(voice_option,
                    fmt::format("found '{}', which is no program that can be run", parts->second),
                    "Where it needs arguments, name a script that gives them");
    speech::VoiceProgram voice;
    voice.name = name;
    voice.command = {program->string()};
    voice.language = lowerCase(language);
    return voice;
}

/// Beside this program.
std::optional<fs::path> languageHelper() {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    const fs::path helper = program.parent_path() / "deixis-espeak";
    if (code || !fs::exists(helper, code)) return std::nullopt;
    return helper;
}

}  // namespace

void addStudioOptions(Parser command, StudioOptions& options) {
    command
        .addOption(
            "--folder", options.folder,
            "Folder that keeps projects, gestures and rules that are added; several servers may share it")
        .valueName("DIR")
        .showDefault("$XDG_DATA_HOME/deixis/studio, else ~/.local/share/deixis/studio");
    command
        .addOption(
            "--voice", options.voices,
            "Voice of your own: a program that reads a text and writes a WAV file, run without a shell. "
            "Other languages than English: NAME:LANGUAGE=PROGRAM, such as anna:de=./anna")
        .valueName("NAME=PROGRAM")
        .oneValueEachTime();
    command
        .addOption(
            "--avatar", options.avatar,
            "Avatar to draw instead of Deixis's own: a humanoid .glb, .vrm or .gltf, 1.2 to 2.2 m tall")
        .valueName("FILE");
    command
        .addOption("--gestures", options.gestures,
                   "Weights of the gesture model, as deixis learn gestures writes them")
        .valueName("FILE")
        .showDefault("those that ship");
}

std::optional<fs::path> usualFolder() {
    const fs::path within = fs::path("deixis") / "studio";
    if (const auto data = absolutePath("XDG_DATA_HOME")) return *data / within;
    if (const auto home = absolutePath("HOME")) return *home / ".local" / "share" / within;
    return std::nullopt;
}

Result<std::optional<server::KeptFolder>> openFolder(const StudioOptions& options) {
    using server::KeptFolder;
    if (!options.folder.empty()) {
        auto folder = KeptFolder::open(options.folder, KeptFolder::Make::now);
        if (!folder) return tl::unexpected(folder.error());
        return std::optional(std::move(*folder));
    }
    const auto usual = usualFolder();
    auto folder = usual ? KeptFolder::open(*usual, KeptFolder::Make::when_something_is_kept)
                        : Result<KeptFolder>(fail("", "HOME is not set"));
    if (folder) return std::optional(std::move(*folder));
    fmt::print(stderr, "nothing is kept on the disk: {}; name another folder by --folder\n",
               folder.error().text());
    return std::nullopt;
}

Result<speech::Voices> studioVoices(const StudioOptions& options) {
    std::vector<speech::VoiceProgram> programs;
    for (const std::string& text : options.voices) {
        auto voice = namedVoice(text);
        if (!voice) return tl::unexpected(voice.error());
        programs.push_back(std::move(*voice));
    }
    if (const auto helper = languageHelper()) {
        auto others = speech::voicesOfHelper(*helper);
        if (!others)
            fmt::print(stderr, "there are no voices of other languages: {}\n", others.error().text());
        if (others) std::move(others->begin(), others->end(), std::back_inserter(programs));
    }
    auto voices = speech::Voices::with(std::move(programs));
    if (!voices) return fail(voice_option, voices.error().text());
    return voices;
}

Result<std::optional<StudioAvatar>> studioAvatar(const StudioOptions& options) {
    if (options.avatar.empty()) return std::nullopt;
    auto avatar = assets::loadAvatar(options.avatar);
    if (!avatar) return tl::unexpected(avatar.error());
    std::string glb = assets::writeAvatarGlb(*avatar);
    if (glb.size() > largest_avatar_bytes)
        return fail(options.avatar,
                    fmt::format("found {} MiB of mesh and textures, expected at most {}", glb.size() >> 20U,
                                largest_avatar_bytes >> 20U),
                    "Take one with fewer or smaller textures");
    return StudioAvatar{{std::move(avatar->skeleton), avatar->humanoid}, std::move(glb)};
}

Result<std::optional<motion::SpeechGestureModel>> gestureModel(const StudioOptions& options) {
    const fs::path shipped = assets::dataFile("weights/speech-gestures.weights");
    std::error_code code;
    if (options.gestures.empty() && !fs::exists(shipped, code)) return std::nullopt;
    auto model =
        motion::SpeechGestureModel::load(options.gestures.empty() ? shipped : fs::path(options.gestures));
    if (!model) return tl::unexpected(model.error());
    return std::optional(std::move(*model));
}

}  // namespace deixis::app
