#include "speech/voice/helper_voices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <string>
#include <utility>

#include "child_process.hpp"

namespace deixis::speech {

namespace {

constexpr auto list_time = std::chrono::seconds(10);
constexpr std::size_t longest_list = 100'000;

bool isLanguage(const std::string& text) {
    constexpr std::size_t longest = 20;
    return !text.empty() && text.size() <= longest && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    });
}

}  // namespace

Result<std::vector<VoiceProgram>> voicesOfHelper(const std::filesystem::path& helper) {
    const std::string where = helper.string();
    const auto listed = runProgram({where, "--list"}, "", list_time, longest_list, where);
    if (!listed) return tl::unexpected(listed.error());
    if (listed->status != 0)
        return fail(where, "ended otherwise than with 0 when it was asked for its languages");
    std::vector<VoiceProgram> out;
    std::istringstream lines(listed->out);
    for (std::string line; std::getline(lines, line);) {
        std::string language = line.substr(0, line.find(' '));
        if (!isLanguage(language) || isEnglish(language)) continue;
        VoiceProgram voice;
        voice.name = "espeak-" + language;
        voice.command = {where, "--language", language};
        voice.language = std::move(language);
        voice.tells_words = true;
        const auto same = [&](const VoiceProgram& one) { return one.name == voice.name; };
        if (std::none_of(out.begin(), out.end(), same)) out.push_back(std::move(voice));
    }
    if (out.empty()) return fail(where, "told no language");
    return out;
}

}  // namespace deixis::speech
