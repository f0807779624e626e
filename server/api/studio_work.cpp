#include "studio_work.hpp"

#include <fmt/format.h>

#include <utility>

#include "speech/sound/wav.hpp"

namespace deixis::server {

namespace {

tl::unexpected<Refusal> refused(const Error& error, const char* field) {
    Refusal refusal = refusalOf(error);
    refusal.field = field;
    return tl::unexpected(std::move(refusal));
}

}  // namespace

StudioWork::StudioWork(StudioParts parts) : parts_(std::move(parts)), speeches_(parts_.kept_speech_bytes) {}

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
    if (parts_.voices.program(voice) != nullptr) {
        const auto loaded = aligner();
        if (!loaded) return tl::unexpected(loaded.error());
        listener = *loaded;
    }
    auto spoken = speech::spokenText(parts_.voices, listener, text, voice);
    if (!spoken) return refused(spoken.error(), spoken.error().where.starts_with("text") ? "text" : "voice");
    auto kept = keptSpeech(std::move(*spoken), asked);
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
