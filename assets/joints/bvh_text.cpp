#include "bvh_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "assets/joints/decimal.hpp"

namespace deixis::assets {

namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

bool sameWord(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    if (word.empty()) return "the end of the file";
    return fmt::format("'{}{}'", word.substr(0, longest), word.size() > longest ? "..." : "");
}

Result<double> wholeNumber(std::string_view word, const std::string& where, const char* what) {
    double value = 0.0;
    std::string_view digits = word;
    if (digits.size() > 1 && digits.front() == '+' && digits[1] != '-') digits.remove_prefix(1);
    const char* end = digits.data() + digits.size();
    if (digits.empty() || readDecimal(digits.data(), end, value) != end || !std::isfinite(value))
        return fail(where, "found " + quoted(word) + ", expected a finite number for " + what);
    return value;
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
