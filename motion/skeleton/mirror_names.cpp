#include "mirror_names.hpp"

#include <array>
#include <unordered_map>
#include <utility>

namespace deixis::motion {

namespace {

using Indices = std::unordered_map<std::string, int>;

bool isLower(char c) {
    return c >= 'a' && c <= 'z';
}
bool isUpper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool isLetter(char c) {
    return isLower(c) || isUpper(c);
}
bool isLetterOrDigit(char c) {
    return isLetter(c) || (c >= '0' && c <= '9');
}

/// "left" in "left_arm", "armLeft" and "arm_left", not in "cleft".
bool wordBegins(std::string_view name, std::size_t i) {
    return i == 0 || !isLetter(name[i - 1]) || (isLower(name[i - 1]) && isUpper(name[i]));
}

bool standsAlone(std::string_view name, std::size_t i) {
    return (i == 0 || !isLetterOrDigit(name[i - 1])) &&
           (i + 1 == name.size() || !isLetterOrDigit(name[i + 1]));
}

/// The other side's letter; 0 where it tells none.
char otherSide(char c) {
    switch (c) {
        case 'L':
            return 'R';
        case 'R':
            return 'L';
        case 'l':
            return 'r';
        case 'r':
            return 'l';
        default:
            return 0;
    }
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 6> side_words{{{"left", "right"},
                                                                                   {"right", "left"},
                                                                                   {"Left", "Right"},
                                                                                   {"Right", "Left"},
                                                                                   {"LEFT", "RIGHT"},
                                                                                   {"RIGHT", "LEFT"}}};

const std::pair<std::string_view, std::string_view>* sideWordAt(std::string_view name, std::size_t i) {
    if (!wordBegins(name, i)) return nullptr;
    for (const auto& word : side_words)
        if (name.substr(i, word.first.size()) == word.first) return &word;
    return nullptr;
}

/// The name's counterpart: by its words wherever they tell a side, by a first or last letter only where the
/// counterpart is among the names; else the name itself.
std::string counterpart(const std::string& name, const Indices& names) {
    std::string other = withSideWordsSwapped(name);
    if (other != name || name.empty()) return other;
    for (const std::size_t at : {std::size_t{0}, name.size() - 1}) {
        const char letter = otherSide(name[at]);
        if (letter == 0) continue;
        other[at] = letter;
        if (names.count(other) > 0) return other;
        other = name;
    }
    return name;
}

}  // namespace

std::string withSideWordsSwapped(std::string_view name) {
    std::string out;
    for (std::size_t i = 0; i < name.size();) {
        if (const auto* word = sideWordAt(name, i)) {
            out += word->second;
            i += word->first.size();
            continue;
        }
        const char other = standsAlone(name, i) ? otherSide(name[i]) : '\0';
        out += other != 0 ? other : name[i];
        ++i;
    }
    return out;
}

std::vector<int> pairedNames(const std::vector<std::string>& names) {
    Indices indices;
    for (std::size_t i = 0; i < names.size(); ++i) indices.emplace(names[i], static_cast<int>(i));
    std::vector<int> out;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string other = counterpart(names[i], indices);
        const auto found = indices.find(other);
        // A pair is one only if each is the other's counterpart ("left" and "reft" are not).
        const bool pair = found != indices.end() && counterpart(other, indices) == names[i];
        out.push_back(pair ? found->second : static_cast<int>(i));
    }
    return out;
}

}  // namespace deixis::motion
