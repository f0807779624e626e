#include "recorders.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>

namespace deixis::app {

void DirectRecorder::record(const studies::SessionEvent& event) {
    if (const auto* response = std::get_if<studies::Response>(&event)) {
        const studies::Trial& trial = plan_.trials.at(static_cast<std::size_t>(response->trial_index));
        answers_ += !trial.practice && !trial.stimuli.empty();
    }
    store_.record(event, study_, plan_, clips_);
}

Result<results::RecordingOptions> recordingOptions() {
    results::RecordingOptions options;
    const char* variable = std::getenv("DEIXIS_STORAGE_DELAY_S");
    if (variable == nullptr) return options;
    const std::string_view text(variable);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), options.delay_s);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(options.delay_s) ||
        options.delay_s < 0.0)
        return fail("DEIXIS_STORAGE_DELAY_S",
                    fmt::format("'{}' was found; expected seconds, from 0 on", text),
                    "Unset it: it is for tests");
    return options;
}

}  // namespace deixis::app
