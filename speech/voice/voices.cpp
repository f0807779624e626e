#include "speech/voice/voices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace deixis::speech {

Result<Voices> Voices::with(std::vector<VoiceProgram> programs) {
    Voices out;
    for (VoiceProgram& program : programs) {
        const auto names = out.names();
        if (program.name.empty()) return fail("voice", "found a program without a name, expected one");
        if (program.command.empty() || program.command.front().empty())
            return fail(fmt::format("voice \"{}\"", program.name),
                        "found no command, expected a program and its arguments");
        if (std::find(names.begin(), names.end(), program.name) != names.end())
            return fail(fmt::format("voice \"{}\"", program.name),
                        "found the name twice, expected different ones");
        out.programs_.push_back(std::move(program));
    }
    return out;
}

std::vector<std::string> Voices::names() const {
    std::vector<std::string> out = fliteVoices();
    for (const VoiceProgram& program : programs_) out.push_back(program.name);
    return out;
}

std::string Voices::language(std::string_view name) const {
    const VoiceProgram* const by_program = program(name);
    return by_program == nullptr ? "en" : by_program->language;
}

const VoiceProgram* Voices::program(std::string_view name) const {
    const auto found = std::find_if(programs_.begin(), programs_.end(),
                                    [&](const VoiceProgram& program) { return program.name == name; });
    return found == programs_.end() ? nullptr : &*found;
}

Result<Speech> Voices::speak(std::string_view text, std::string_view name,
                             const SpeakOptions& options) const {
    const VoiceProgram* const by_program = program(name);
    if (by_program == nullptr) {
        const auto all = names();
        if (std::find(all.begin(), all.end(), name) == all.end())
            return fail("voice", fmt::format("found \"{}\", expected one of {}", name, fmt::join(all, ", ")));
        return speakByFlite(text, name, options);
    }
    if (options.rate != 1.0)
        return fail("rate", fmt::format("found {}, expected 1: the voice \"{}\" is a program of its own",
                                        options.rate, name));
    return speechByProgram(*by_program, text);
}

}  // namespace deixis::speech
