// Sounds of clips at a station: they come from the avatar's mouth, in step with its movement. OpenAL Soft.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/error.hpp"
#include "speech/sound/sound.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

/// By studies::ClipSound::id.
using Sounds = std::map<std::string, speech::Sound>;

/// What opens the sound of this machine before anybody sits down.
class SoundOutput {
  public:
    /// Fails where the machine has no sound.
    [[nodiscard]] static Result<SoundOutput> open(const Sounds& sounds);
    SoundOutput(SoundOutput&&) noexcept;
    SoundOutput& operator=(SoundOutput&&) noexcept;
    ~SoundOutput();

    /// The station with sound: as loud from every place, from the direction of the mouth. What a sound was
    /// beside its movement is noted when it ends (NoteKind::sound), by the output's own word on how far it
    /// is.
    [[nodiscard]] std::unique_ptr<studies::Station> withSound(std::unique_ptr<studies::Station> station) &&;

  private:
    struct Device;
    explicit SoundOutput(std::unique_ptr<Device> device);
    friend class HeardStation;
    std::unique_ptr<Device> device_;
};

}  // namespace deixis::app
