// Texts with placeholders, such as "Page {page} of {pages}"; private to texts.
#pragma once

#include <string_view>
#include <vector>

namespace deixis::studies {

/// A piece of a text: plain, or the name of a placeholder.
struct Piece {
    std::string_view text;
    bool placeholder = false;
};

/// A brace that is never closed begins a plain piece.
inline std::vector<Piece> piecesOf(std::string_view text) {
    std::vector<Piece> pieces;
    std::size_t from = 0;
    while (from < text.size()) {
        const std::size_t open = text.find('{', from);
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) break;
        if (open > from) pieces.push_back({text.substr(from, open - from)});
        pieces.push_back({text.substr(open + 1, close - open - 1), true});
        from = close + 1;
    }
    if (from < text.size()) pieces.push_back({text.substr(from)});
    return pieces;
}

}  // namespace deixis::studies
