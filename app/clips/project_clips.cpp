#include "app/clips/project_clips.hpp"

#include <fmt/format.h>

#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "assets/data/data_paths.hpp"
#include "assets/data/unit_gestures.hpp"
#include "assets/joints/bvh.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "motion/authoring/authored_gestures.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "speech/sound/wav.hpp"
#ifdef DEIXIS_STUDIO
#include "speech/prosody/utterance.hpp"
#endif

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

fs::path gestureWeights() {
    return assets::dataFile("weights/speech-gestures.weights");
}

struct SpokenProject {
    speech::Sound sound;
    Utterance utterance;
};

Result<SpokenProject> speak(const std::string& text, const std::string& voice) {
#ifdef DEIXIS_STUDIO
    const speech::Voices voices;
    auto spoken = speech::spokenText(voices, nullptr, text, voice.empty() ? voices.names().front() : voice);
    if (!spoken) return tl::unexpected(spoken.error());
    return SpokenProject{std::move(spoken->sound), std::move(spoken->utterance)};
#else
    return fail("document.speech",
                fmt::format("is not there yet, and this program was built without the studio's voices{}",
                            voice.empty() ? "" : fmt::format(" ({})", voice)),
                fmt::format("A program with the studio (DEIXIS_STUDIO) speaks it: \"{:.40}\"", text));
#endif
}

/// What a motion that a maker makes by itself is.
std::string_view processingOf(const std::string& system, bool synthetic) {
    if (system == motion::gestureMakerName(motion::GestureMaker::rules)) return assets::made_by_rules;
    return synthetic ? assets::learned_from_synthetic : std::string_view();
}

}  // namespace

struct ProjectClips::Parts {
    std::once_flag loading;
    Result<void> loaded{};
    motion::GestureLibrary library{};
    std::optional<motion::SpeechGestureModel> model{};

    using Spoken = std::shared_future<Result<SpokenProject>>;
    std::mutex speaking{};
    std::map<std::pair<std::string, std::string>, Spoken> spoken{};

    Result<void> load() {
        auto read = assets::loadUnitGestures(assets::dataFile("unit_gestures.toml"));
        if (!read) return tl::unexpected(read.error());
        library = std::move(*read);
        std::error_code code;
        if (!fs::exists(gestureWeights(), code)) return {};  // told where a project needs it
        auto weights = motion::SpeechGestureModel::load(gestureWeights());
        if (!weights) return tl::unexpected(weights.error());
        model = std::move(*weights);
        return {};
    }

    const Result<void>& loadOnce() {
        std::call_once(loading, [this] { loaded = load(); });
        return loaded;
    }

    Spoken said(const std::string& text, const std::string& voice) {
        std::promise<Result<SpokenProject>> promise;
        {
            const std::lock_guard lock(speaking);
            const auto [known, is_new] = spoken.try_emplace({text, voice});
            if (!is_new) return known->second;
            known->second = promise.get_future().share();
        }
        promise.set_value(speak(text, voice));
        const std::lock_guard lock(speaking);
        return spoken.at({text, voice});
    }
};

ProjectClips::ProjectClips() : parts_(std::make_unique<Parts>()) {}
ProjectClips::~ProjectClips() = default;

Result<std::string> ProjectClips::sources() {
    std::string out;
    std::error_code code;
    for (const fs::path& file : {assets::dataFile("unit_gestures.toml"), gestureWeights()}) {
        if (!fs::exists(file, code)) continue;
        const auto bytes = readFile(file);
        if (!bytes) return tl::unexpected(bytes.error());
        out += sha256Hex(*bytes) + "\n";
    }
    return out;
}

std::string ProjectClips::processing(const assets::StudioProject& project) {
    if (!project.motion.frames.empty()) return std::string(processingOf(project.system, project.synthetic));
    if (motion::gestureMakerFromName(project.system) != motion::GestureMaker::model)
        return std::string(processingOf(project.system, false));
    const auto& loaded = parts_->loadOnce();
    return std::string(processingOf(project.system, loaded && parts_->model && parts_->model->synthetic()));
}

Result<ProjectClip> ProjectClips::make(const assets::StudioProject& project, const std::string& name) {
    auto made = makeUnnamed(project);
    if (made) return made;
    Error error = made.error();
    error.where = error.where.empty() ? name : name + ": " + error.where;
    return tl::unexpected(std::move(error));
}

Result<ProjectClip> ProjectClips::makeUnnamed(const assets::StudioProject& project) {
    ProjectClip out;
    SpokenProject made;
    if (project.wav.empty()) {
        const Parts::Spoken said = parts_->said(project.text, project.voice);
        if (!said.get()) return tl::unexpected(said.get().error());
        made = *said.get();
        out.wav = speech::wavBytes(made.sound);
    } else {
        out.wav = project.wav;
        made.utterance = project.utterance;
    }
    out.utterance = made.utterance;
    motion::UpperBodyMotion gestures = project.motion;
    if (gestures.frames.empty()) {
        if (const auto& loaded = parts_->loadOnce(); !loaded) return tl::unexpected(loaded.error());
        const auto wanted = assets::wantedOf(project, motion::frameCountOf(out.utterance.duration_s));
        if (!wanted) return tl::unexpected(wanted.error());
        if (made.sound.samples.empty()) {
            auto sound = speech::readWavBytes(out.wav, "document.speech.wav");
            if (!sound) return tl::unexpected(sound.error());
            made.sound = std::move(*sound);
        }
        const speech::Sound heard = speech::resampled(made.sound, motion::speech_rate_hz);
        auto moved =
            motion::gesturesTo({heard.samples, out.utterance},
                               {parts_->library, parts_->model ? &*parts_->model : nullptr}, *wanted);
        if (!moved) return tl::unexpected(moved.error());
        gestures = std::move(*moved);
    }
    out.processing = processing(project);
    out.clip =
        motion::heldFor(motion::avatarClip(gestures, project.relaxed_fingers), out.utterance.duration_s);
    return out;
}

Result<void> addProjectClip(const ProjectClip& made, const std::string& name, OutputFolder& folder,
                            assets::ManifestRow& row) {
    row.clip = name + ".bvh";
    row.sound = name + ".wav";
    row.fps = made.clip.framesPerSecond();
    row.processing = made.processing;
    if (auto added = folder.add(row.clip, assets::writeBvh(made.clip)); !added) return added;
    return folder.add(row.sound, made.wav);
}

}  // namespace deixis::app
