#include "app/sound/heard_station.hpp"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "sound_drift.hpp"

namespace deixis::app {

namespace {

// Of silence before each sound: it begins in there, so much before its first sample as the picture needs
// until it is seen. More than any output's delay.
constexpr double lead_s = 0.5;
// A sound that is farther from its picture than this is put where it belongs: a frame was very late.
constexpr double max_apart_s = 0.1;
// The output's name where there is none: OpenAL Soft then plays to nobody.
constexpr const char* nobody = "No Output";

Error noSound(const std::string& why) {
    return {"sound", "this study is heard, and this machine has no sound: " + why,
            "Connect loudspeakers or headphones and see whether other programs are heard; clips are shown "
            "without "
            "their sound where the stage says muted = true"};
}

std::vector<short> pcmWithLead(const speech::Sound& sound) {
    std::vector<short> out(static_cast<std::size_t>(lead_s * sound.rate_hz));
    out.reserve(out.size() + sound.samples.size());
    for (const float sample : sound.samples)
        out.push_back(static_cast<short>(std::lround(32767.0F * std::clamp(sample, -1.0F, 1.0F))));
    return out;
}

}  // namespace

struct SoundOutput::Device {
    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    ALuint source = 0;
    std::map<std::string, ALuint> buffers{};
    LPALGETSOURCEDVSOFT sourceOffsets = nullptr;
    LPALCGETINTEGER64VSOFT clocks = nullptr;
    std::string name{};

    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device() {
        if (context != nullptr) {
            if (source != 0) alDeleteSources(1, &source);
            for (const auto& [id, buffer] : buffers) alDeleteBuffers(1, &buffer);
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context);
        }
        if (device != nullptr) alcCloseDevice(device);
    }
};

SoundOutput::SoundOutput(std::unique_ptr<Device> device) : device_(std::move(device)) {}
SoundOutput::SoundOutput(SoundOutput&&) noexcept = default;
SoundOutput& SoundOutput::operator=(SoundOutput&&) noexcept = default;
SoundOutput::~SoundOutput() = default;

Result<SoundOutput> SoundOutput::open(const Sounds& sounds) {
    auto device = std::make_unique<Device>();
    device->device = alcOpenDevice(nullptr);
    if (device->device == nullptr) return tl::unexpected(noSound("no output can be opened"));
    const bool all = alcIsExtensionPresent(nullptr, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
    const ALCchar* name =
        alcGetString(device->device, all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
    device->name = name != nullptr ? name : "";
    if (device->name == nobody) return tl::unexpected(noSound("no output was found"));
    device->context = alcCreateContext(device->device, nullptr);
    if (device->context == nullptr || alcMakeContextCurrent(device->context) == ALC_FALSE)
        return tl::unexpected(noSound(device->name + " cannot be used"));
    if (alIsExtensionPresent("AL_SOFT_source_latency") == AL_TRUE)
        device->sourceOffsets = reinterpret_cast<LPALGETSOURCEDVSOFT>(alGetProcAddress("alGetSourcedvSOFT"));
    if (alcIsExtensionPresent(device->device, "ALC_SOFT_device_clock") == ALC_TRUE)
        device->clocks = reinterpret_cast<LPALCGETINTEGER64VSOFT>(
            alcGetProcAddress(device->device, "alcGetInteger64vSOFT"));
    if (device->sourceOffsets == nullptr || device->clocks == nullptr)
        return fail("sound", "this OpenAL does not tell how late its sound is",
                    "OpenAL Soft 1.17 and later do (AL_SOFT_source_latency, ALC_SOFT_device_clock)");
    // As loud from wherever: how loud speech is must not differ between places.
    alDistanceModel(AL_NONE);
    alGenSources(1, &device->source);
    for (const auto& [id, sound] : sounds) {
        const std::vector<short> pcm = pcmWithLead(sound);
        ALuint buffer = 0;
        alGenBuffers(1, &buffer);
        device->buffers[id] = buffer;
        alBufferData(buffer, AL_FORMAT_MONO16, pcm.data(), static_cast<ALsizei>(pcm.size() * sizeof(short)),
                     sound.rate_hz);
    }
    if (const ALenum error = alGetError(); error != AL_NO_ERROR)
        return fail("sound", fmt::format("{} took a sound badly: OpenAL error {:#x}", device->name, error));
    return SoundOutput(std::move(device));
}

class HeardStation : public studies::Station {
  public:
    HeardStation(std::unique_ptr<studies::Station> station, SoundOutput output)
        : station_(std::move(station)), output_(std::move(output)), device_(*output_.device_) {}

    [[nodiscard]] studies::StationInfo info() const override {
        studies::StationInfo info = station_->info();
        info.properties.emplace_back("sound", device_.name);
        return info;
    }

    [[nodiscard]] studies::InputFrame beginFrame() override {
        studies::InputFrame input = station_->beginFrame();
        display_time_s_ = input.time_s;
        read_s_ = input.input_time_s.value_or(input.time_s);
        read_at_ = std::chrono::steady_clock::now();
        head_ = input.stage_from_head;
        for (studies::StationNote& note : notes_) input.notes.push_back(std::move(note));
        notes_.clear();
        return input;
    }

    studies::FrameReport present(const studies::PresentedFrame& frame) override {
        hear(frame.sound);
        return station_->present(frame);
    }

    std::vector<studies::StationNote> close() override {
        stop();
        std::vector<studies::StationNote> notes = std::exchange(notes_, {});
        for (auto& note : station_->close()) notes.push_back(std::move(note));
        return notes;
    }

    [[nodiscard]] std::optional<Error> failure() const override { return station_->failure(); }

  private:
    [[nodiscard]] double now_s() const {
        return read_s_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - read_at_).count();
    }

    void hear(const std::optional<studies::SoundView>& sound) {
        if (!sound) return stop();
        place(*sound);
        // The first frame of a clip again: it was not shown.
        const bool again = sound->time_s == 0.0 || sound->time_s < last_time_s_;
        if (playing_ != sound->id || again) {
            stop();
            start(*sound);
        } else {
            follow(*sound);
        }
        last_time_s_ = sound->time_s;
    }

    /// The source where the mouth is, the listener where the head is.
    void place(const studies::SoundView& sound) const {
        const Vec3 ahead = head_.orientation * Vec3(0, 0, -1);
        const Vec3 up = head_.orientation * Vec3(0, 1, 0);
        const std::array<ALfloat, 6> facing{static_cast<ALfloat>(ahead.x), static_cast<ALfloat>(ahead.y),
                                            static_cast<ALfloat>(ahead.z), static_cast<ALfloat>(up.x),
                                            static_cast<ALfloat>(up.y),    static_cast<ALfloat>(up.z)};
        alListener3f(AL_POSITION, static_cast<ALfloat>(head_.position.x),
                     static_cast<ALfloat>(head_.position.y), static_cast<ALfloat>(head_.position.z));
        alListenerfv(AL_ORIENTATION, facing.data());
        alSource3f(device_.source, AL_POSITION, static_cast<ALfloat>(sound.mouth.x),
                   static_cast<ALfloat>(sound.mouth.y), static_cast<ALfloat>(sound.mouth.z));
    }

    /// Into the buffer, at which the sound must be now to be where the picture is when it is seen.
    [[nodiscard]] double offsetNow(const studies::SoundView& sound, double latency_s) const {
        return std::max(0.0, lead_s + sound.time_s + now_s() + latency_s - display_time_s_);
    }

    /// How long what is mixed now takes until it is heard.
    [[nodiscard]] double outputLatency_s() const {
        ALCint64SOFT latency_ns = 0;
        device_.clocks(device_.device, ALC_DEVICE_LATENCY_SOFT, 1, &latency_ns);
        return 1e-9 * static_cast<double>(latency_ns);
    }

    void start(const studies::SoundView& sound) {
        const auto buffer = device_.buffers.find(sound.id);
        if (buffer == device_.buffers.end())
            throw std::logic_error(fmt::format("the sound {} was not loaded", sound.id));
        alSourcei(device_.source, AL_BUFFER, static_cast<ALint>(buffer->second));
        alSourcef(device_.source, AL_SEC_OFFSET, static_cast<ALfloat>(offsetNow(sound, outputLatency_s())));
        alSourcePlay(device_.source);
        playing_ = sound.id;
        drift_ = {};
        started_s_ = now_s();
    }

    void follow(const studies::SoundView& sound) {
        // The first part mixed is not told of before it is.
        if (now_s() - started_s_ < settles_s) return;
        ALint state = 0;
        alGetSourcei(device_.source, AL_SOURCE_STATE, &state);
        if (state != AL_PLAYING) return;  // its last part is on its way to the ear
        std::array<ALdouble, 2> at{};     // offset, and how long until it is heard
        device_.sourceOffsets(device_.source, AL_SEC_OFFSET_LATENCY_SOFT, at.data());
        const double belongs_s = offsetNow(sound, at[1]);
        const double ahead_s = at[0] - belongs_s;
        if (std::abs(ahead_s) > max_apart_s)
            alSourcef(device_.source, AL_SEC_OFFSET, static_cast<ALfloat>(belongs_s));
        drift_.add(ahead_s);
    }

    void stop() {
        if (playing_.empty()) return;
        alSourceStop(device_.source);
        if (std::string told = drift_.text(playing_); !told.empty())
            notes_.push_back({studies::NoteKind::sound, std::move(told), now_s()});
        playing_.clear();
        last_time_s_ = 0.0;
    }

    static constexpr double settles_s = 0.1;

    std::unique_ptr<studies::Station> station_;
    SoundOutput output_;
    SoundOutput::Device& device_;
    double display_time_s_ = 0.0;  ///< of the frame under way
    double read_s_ = 0.0;          ///< when its input was read, on the station's clock, and on ours
    std::chrono::steady_clock::time_point read_at_{};
    Pose head_{};
    std::string playing_{};  ///< empty: nothing
    double last_time_s_ = 0.0;
    double started_s_ = 0.0;
    SoundDrift drift_{};
    std::vector<studies::StationNote> notes_{};
};

std::unique_ptr<studies::Station> SoundOutput::withSound(std::unique_ptr<studies::Station> station) && {
    return std::make_unique<HeardStation>(std::move(station), std::move(*this));
}

}  // namespace deixis::app
