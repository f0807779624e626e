#include "speech/voice/voice_program.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include "child_process.hpp"
#include "core/text.hpp"
#include "speech/sound/wav.hpp"
#include "speech/voice/written_words.hpp"

namespace deixis::speech {

namespace {

/// Half an hour of 48 kHz, 32 bits, two channels.
constexpr std::size_t max_wav_bytes = 720'000'000;

std::string lastLine(std::string_view text) {
    text = trimmed(text);
    const std::size_t start = text.find_last_of('\n');
    return storable(start == std::string_view::npos ? text : text.substr(start + 1));
}

}  // namespace

Result<Sound> speakByProgram(const VoiceProgram& program, std::string_view text) {
    if (auto checked = checkText(text, "text"); !checked) return tl::unexpected(checked.error());
    const std::string where = fmt::format("voice \"{}\"", program.name);
    auto run = runProgram(program.command, text, program.timeout, max_wav_bytes, where);
    if (!run) return tl::unexpected(run.error());
    if (run->status != 0) {
        const std::string how = WIFEXITED(run->status) ? fmt::format("with {}", WEXITSTATUS(run->status))
                                                       : fmt::format("by signal {}", WTERMSIG(run->status));
        const std::string said = lastLine(run->err);
        return fail(where, fmt::format("the program \"{}\" ended {}, expected 0{}{}", program.command.front(),
                                       how, said.empty() ? "" : "; it says: ", said));
    }
    if (run->out.empty())
        return fail(
            where, fmt::format("the program \"{}\" wrote nothing, expected a WAV file on its standard output",
                               program.command.front()));
    return readWavBytes(run->out, where);
}

}  // namespace deixis::speech
