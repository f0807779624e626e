#include "studio_work.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "core/text.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion_json.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::server {

namespace {

tl::unexpected<Refusal> refused(const Error& error, const char* field) {
    Refusal refusal = refusalOf(error);
    refusal.field = field;
    return tl::unexpected(std::move(refusal));
}

/// Of a program that is a voice: the request was right.
tl::unexpected<Refusal> voiceFailed(const Error& error) {
    constexpr int bad_gateway = 502;
    return tl::unexpected(Refusal{bad_gateway, storable(error.text()), "voice"});
}

}  // namespace

StudioWork::StudioWork(StudioParts parts) : parts_(std::move(parts)), speeches_(parts_.kept_speech_bytes) {}

OwnMotions StudioWork::ownMotions() const {
    return folder() != nullptr ? server::ownMotions(*folder()) : OwnMotions{};
}

std::vector<std::string> StudioWork::motionIds() const {
    std::vector<std::string> out;
    for (const motion::UnitGesture& one : parts_.library) out.push_back(one.id);
    if (folder() != nullptr)
        for (std::string& id : ownMotionIds(*folder())) out.push_back(std::move(id));
    return out;
}

OwnRules StudioWork::ownRules() const {
    return folder() != nullptr ? server::ownRules(*folder(), motionIds()) : noRules();
}

motion::Clip StudioWork::onAvatar(motion::Clip clip) const {
    if (!parts_.avatar) return clip;
    motion::RetargetOptions options;
    options.plant_feet = false;
    auto drawn = motion::retarget(clip, motion::mapByVrmNames(clip.skeleton), parts_.avatar->skeleton,
                                  parts_.avatar->humanoid, options);
    if (!drawn)
        throw std::logic_error("an avatar that was checked cannot take a motion: " + drawn.error().text());
    return std::move(*drawn);
}

tl::expected<speech::Aligner*, Refusal> StudioWork::aligner() {
    const std::lock_guard lock(aligner_mutex_);
    if (!aligner_) {
        auto loaded = speech::Aligner::load();
        if (!loaded) return tl::unexpected(Refusal{503, loaded.error().text()});
        aligner_ = std::move(*loaded);
    }
    return &*aligner_;
}

StudioWork::Speech StudioWork::speak(const std::string& text, const std::string& voice) {
    const std::string asked = voice + "\n" + text;
    if (auto kept = speeches_.findAsked(asked)) return kept;
    speech::Aligner* listener = nullptr;
    const speech::VoiceProgram* const program = parts_.voices.program(voice);
    if (program != nullptr && speech::isEnglish(program->language) && !program->tells_words) {
        const auto loaded = aligner();
        if (!loaded) return tl::unexpected(loaded.error());
        listener = *loaded;
    }
    auto spoken = speech::spokenText(parts_.voices, listener, text, voice);
    if (!spoken && spoken.error().where.starts_with("text")) return refused(spoken.error(), "text");
    if (!spoken) return voiceFailed(spoken.error());
    auto kept = keptSpeech(std::move(*spoken), asked, parts_.voices.language(voice));
    speeches_.keep(kept);
    return kept;
}

StudioWork::Speech StudioWork::record(std::string_view wav, const std::string& text) {
    auto sound = speech::readWavBytes(wav, "sound");
    if (!sound) return refused(sound.error(), "sound");
    const auto loaded = aligner();
    if (!loaded) return tl::unexpected(loaded.error());
    auto spoken = speech::recordedText(**loaded, std::move(*sound), text, "text");
    if (!spoken) return refused(spoken.error(), "text");
    auto kept = keptSpeech(std::move(*spoken), "");
    speeches_.keep(kept);
    return kept;
}

StudioWork::Speech StudioWork::find(const std::string& id, const std::optional<std::string>& field) {
    if (auto kept = speeches_.find(id)) return kept;
    return tl::unexpected(Refusal{
        404,
        fmt::format("no speech of this id is kept: the server keeps the {} MiB that were used last, while it "
                    "runs. Send the text or the sound again",
                    speeches_.mostBytes() >> 20U),
        field});
}

}  // namespace deixis::server
