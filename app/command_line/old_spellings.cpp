#include "app/command_line/old_spellings.hpp"

#include <algorithm>
#include <array>

namespace deixis::app {

namespace {

struct OldSpelling {
    const char* command;
    const char* option;
    const char* today;  ///< empty: what it asked for is so anyway
};

constexpr std::array old_spellings{
    OldSpelling{"simulate", "--db", "--output"},       OldSpelling{"generate", "--out", "--output"},
    OldSpelling{"clips segment", "--out", "--output"}, OldSpelling{"clips retarget", "--out", "--output"},
    OldSpelling{"clips mirror", "--out", "--output"},  OldSpelling{"targets", "--no-picture", ""},
    OldSpelling{"learn", "--out", "--output"},
};

}  // namespace

std::vector<std::string> inCurrentSpelling(const std::vector<std::string>& words) {
    if (words.empty()) return {};
    const std::string command = words[0] == "clips" && words.size() > 1 ? "clips " + words[1] : words[0];
    std::vector<std::string> out;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--") {  // no option follows
            out.insert(out.end(), words.begin() + static_cast<std::ptrdiff_t>(i), words.end());
            break;
        }
        const std::string name = words[i].substr(0, words[i].find('='));
        const auto old = std::find_if(old_spellings.begin(), old_spellings.end(), [&](const auto& one) {
            return command == one.command && name == one.option;
        });
        if (old == old_spellings.end())
            out.push_back(words[i]);
        else if (*old->today != '\0')
            out.push_back(old->today + words[i].substr(name.size()));
    }
    return out;
}

}  // namespace deixis::app
