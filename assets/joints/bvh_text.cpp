#include "bvh_text.hpp"

#include <fmt/format.h>

namespace deixis::assets {

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    if (word.empty()) return "the end of the file";
    return fmt::format("'{}{}'", word.substr(0, longest), word.size() > longest ? "..." : "");
}

Result<double> wholeNumber(std::string_view word, const std::string& where, const char* what) {
    if (const auto value = finiteNumber(word)) return *value;
    return fail(where, "found " + quoted(word) + ", expected a finite number for " + what);
}

std::string_view BvhText::word() {
    while (at_ < text_.size() && (isBlank(text_[at_]) || text_[at_] == '\n')) {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }
    word_line_ = line_;
    return wordHere();
}

std::string_view BvhText::wordOfLine() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
    return wordHere();
}

std::string_view BvhText::restOfLine() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '{') ++at_;
    std::string_view rest = text_.substr(begin, at_ - begin);
    while (!rest.empty() && isBlank(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && isBlank(rest.back())) rest.remove_suffix(1);
    return rest;
}

std::string_view BvhText::wordHere() {
    const std::size_t begin = at_;
    if (at_ < text_.size() && (text_[at_] == '{' || text_[at_] == '}'))
        ++at_;
    else
        while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != '\n' && text_[at_] != '{' &&
               text_[at_] != '}')
            if (text_[at_++] == ':') break;
    return text_.substr(begin, at_ - begin);
}

}  // namespace deixis::assets
