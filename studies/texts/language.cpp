#include "studies/texts/language.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "text_pieces.hpp"

namespace deixis::studies {

std::optional<TextStatus> textStatusFromName(std::string_view name) {
    if (name == "written") return TextStatus::written;
    if (name == "translated") return TextStatus::translated;
    if (name == "reviewed") return TextStatus::reviewed;
    return std::nullopt;
}

std::string_view textStatusText(TextStatus status) {
    switch (status) {
        case TextStatus::written:
            return "written in this language";
        case TextStatus::translated:
            return "translated, not reviewed by a native speaker";
        case TextStatus::reviewed:
            return "translated, reviewed by a native speaker";
        case TextStatus::unstated:
            break;
    }
    return "not stated whether a native speaker reviewed them";
}

LanguageTable::LanguageTable(std::string code, TextStatus status, Texts texts)
    : code_(std::move(code)), status_(status), texts_(std::move(texts)) {
    std::sort(texts_.begin(), texts_.end());
}

const LanguageTable& LanguageTable::english() {
    static const LanguageTable table("en", TextStatus::written,
                                     Texts(languageKeys().begin(), languageKeys().end()));
    return table;
}

const std::string& LanguageTable::operator()(std::string_view key) const {
    const auto at =
        std::lower_bound(texts_.begin(), texts_.end(), key,
                         [](const auto& text, std::string_view wanted) { return text.first < wanted; });
    if (at == texts_.end() || at->first != key)
        throw std::out_of_range(fmt::format("the language table '{}' has no key '{}'", code_, key));
    return at->second;
}

std::string LanguageTable::operator()(
    std::string_view key, const std::vector<std::pair<std::string_view, std::string>>& values) const {
    std::string out;
    for (const Piece& piece : piecesOf((*this)(key))) {
        if (!piece.placeholder) {
            out += piece.text;
            continue;
        }
        const auto value = std::find_if(values.begin(), values.end(),
                                        [&](const auto& one) { return one.first == piece.text; });
        if (value == values.end())
            throw std::invalid_argument(fmt::format("'{}' has no value for '{}'", key, piece.text));
        out += value->second;
    }
    return out;
}

std::string LanguageTable::seconds(std::string_view key, std::string_view one, int seconds) const {
    return seconds == 1 ? (*this)(one) : (*this)(key, {{"seconds", std::to_string(seconds)}});
}

}  // namespace deixis::studies
