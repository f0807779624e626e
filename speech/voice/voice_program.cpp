#include "speech/voice/voice_program.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "child_process.hpp"
#include "core/number.hpp"
#include "core/text.hpp"
#include "speech/sound/wav.hpp"
#include "speech/voice/written_words.hpp"

namespace deixis::speech {

namespace {

/// Half an hour of 48 kHz, 32 bits, two channels.
constexpr std::size_t max_wav_bytes = 720'000'000;
constexpr std::size_t longest_line = 1000;
constexpr std::size_t most_told_words = 20'000;

std::string lastLine(std::string_view text) {
    text = trimmed(text);
    const std::size_t start = text.find_last_of('\n');
    return storable(start == std::string_view::npos ? text : text.substr(start + 1));
}

std::string nameOf(const VoiceProgram& program) {
    return fmt::format("voice \"{}\"", program.name);
}

Result<std::string> outputOf(const VoiceProgram& program, std::string_view text) {
    if (auto checked = checkText(text, "text"); !checked) return tl::unexpected(checked.error());
    const std::string where = nameOf(program);
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
    return std::move(run->out);
}

/// Of "0.25 0.5 word".
std::optional<SpokenWord> toldWord(std::string_view line) {
    const std::size_t first = line.find(' ');
    if (first == std::string_view::npos) return std::nullopt;
    const std::size_t second = line.find(' ', first + 1);
    if (second == std::string_view::npos) return std::nullopt;
    const auto start_s = finiteNumber(line.substr(0, first));
    const auto end_s = finiteNumber(line.substr(first + 1, second - first - 1));
    const std::string_view text = line.substr(second + 1);
    if (!start_s || !end_s || trimmed(text).empty() || !storableText(text)) return std::nullopt;
    return SpokenWord{std::string(text), *start_s, *end_s};
}

}  // namespace

bool isEnglish(std::string_view language) {
    return language == "en" || language.starts_with("en-");
}

Result<Sound> speakByProgram(const VoiceProgram& program, std::string_view text) {
    auto bytes = outputOf(program, text);
    if (!bytes) return tl::unexpected(bytes.error());
    return readWavBytes(*bytes, nameOf(program));
}

Result<Speech> speechByProgram(const VoiceProgram& program, std::string_view text) {
    auto bytes = outputOf(program, text);
    if (!bytes) return tl::unexpected(bytes.error());
    if (program.tells_words) return readToldSpeech(*bytes, nameOf(program));
    auto sound = readWavBytes(*bytes, nameOf(program));
    if (!sound) return tl::unexpected(sound.error());
    Speech out;
    out.utterance.duration_s = durationOf(*sound);
    out.sound = std::move(*sound);
    return out;
}

Result<Speech> readToldSpeech(std::string_view bytes, const std::string& where) {
    Speech out;
    double last_s = 0.0;
    for (int line_number = 1;; ++line_number) {
        const std::size_t end = bytes.substr(0, longest_line).find('\n');
        if (end == std::string_view::npos)
            return fail(where,
                        fmt::format("line {} of what it wrote does not end, expected a word or an empty line",
                                    line_number));
        const std::string_view line = bytes.substr(0, end);
        bytes.remove_prefix(end + 1);
        if (line.empty()) break;
        const auto word = toldWord(line);
        if (!word || word->start_s < last_s || word->end_s < word->start_s)
            return fail(where, fmt::format("found \"{}\" in line {}, expected START END WORD, in order",
                                           storable(line.substr(0, 60)), line_number));
        if (out.utterance.words.size() >= most_told_words)
            return fail(where, fmt::format("found more than {} words", most_told_words));
        last_s = word->start_s;
        out.utterance.words.push_back(*word);
    }
    auto sound = readWavBytes(bytes, where);
    if (!sound) return tl::unexpected(sound.error());
    out.utterance.duration_s = durationOf(*sound);
    out.sound = std::move(*sound);
    for (std::size_t i = 0; i < out.utterance.words.size(); ++i) {
        SpokenWord& word = out.utterance.words[i];
        if (word.start_s > out.utterance.duration_s)
            return fail(where, fmt::format("found \"{}\" at {} s, expected it before the sound's end, {} s",
                                           word.text, word.start_s, out.utterance.duration_s));
        word.end_s = std::min(word.end_s, out.utterance.duration_s);
        out.syllables.push_back({word.start_s, word.end_s, static_cast<int>(i), true, false});
    }
    return out;
}

}  // namespace deixis::speech
