// What ships and makes the synthetic corpus.
#pragma once

#include <doctest/doctest.h>

#include "assets/data/unit_gestures.hpp"
#include "core/files.hpp"
#include "paths.hpp"
#include "speech/sentences/sentence_grammar.hpp"

namespace deixis::tests {

inline const motion::GestureLibrary& shippedLibrary() {
    static const motion::GestureLibrary library = [] {
        auto read = assets::loadUnitGestures(sourceDir() / "assets/data/unit_gestures.toml");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        return std::move(*read);
    }();
    return library;
}

inline const speech::SentenceGrammar& shippedGrammar() {
    static const speech::SentenceGrammar grammar = [] {
        const auto text = readFile(sourceDir() / "assets/data/speech/sentences.txt");
        REQUIRE_MESSAGE(text.has_value(), (text ? "" : text.error().text()));
        auto read = speech::parseSentenceGrammar(*text, "sentences.txt");
        REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
        return std::move(*read);
    }();
    return grammar;
}

}  // namespace deixis::tests
