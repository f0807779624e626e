#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "learning/corpus/corpus_statistics.hpp"
#include "learning/corpus/synthetic_corpus.hpp"
#include "library.hpp"

using namespace deixis;
using learning::Gesturer;
using learning::SyntheticCorpusSettings;
using speech::CorpusPart;

namespace {

/// Two and a half minutes, or what is asked for, by the quick voice and one more.
SyntheticCorpusSettings shortCorpus() {
    SyntheticCorpusSettings settings;
    settings.minutes = 2.5;
    settings.voices = {"kal16", "awb"};
    return settings;
}

learning::Corpus made(const SyntheticCorpusSettings& settings) {
    auto corpus = learning::makeSyntheticCorpus(settings, tests::shippedGrammar(), tests::shippedLibrary());
    REQUIRE_MESSAGE(corpus.has_value(), (corpus ? "" : corpus.error().text()));
    return std::move(*corpus);
}

std::string problemOf(const SyntheticCorpusSettings& settings) {
    const auto corpus =
        learning::makeSyntheticCorpus(settings, tests::shippedGrammar(), tests::shippedLibrary());
    return corpus ? "none" : corpus.error().text();
}

}  // namespace

TEST_SUITE("corpus/synthetic_corpus") {
    TEST_CASE("Takes are whole: sound, words and accents in it, a motion of its length") {
        const learning::Corpus corpus = made(shortCorpus());
        CHECK(corpus.synthetic);
        double seconds = 0.0;
        std::set<std::string> names, texts, voices;
        for (const auto& take : corpus.takes) {
            CAPTURE(take.text);
            const double duration_s = take.utterance.duration_s;
            seconds += duration_s;
            names.insert(take.name);
            texts.insert(take.text);
            voices.insert(take.voice);
            CHECK(duration_s >= 5.0);
            CHECK(duration_s <= 24.0);
            CHECK(std::abs(static_cast<double>(take.samples.size()) / learning::corpus_rate_hz - duration_s) <
                  1e-3);
            CHECK(take.motion.frames.size() == motion::frameCountOf(duration_s));
            CHECK(take.utterance.words.size() > 8);
            CHECK(take.utterance.accents.size() > 1);
            CHECK(take.strokes.size() > 1);
            double before_s = 0.0;
            for (const auto& word : take.utterance.words) {
                CHECK(word.start_s >= before_s - 1e-9);
                CHECK(word.end_s > word.start_s);
                before_s = word.end_s;
            }
            CHECK(before_s <= duration_s + 1e-9);
        }
        CHECK(names.size() == corpus.takes.size());
        CHECK(texts.size() == corpus.takes.size());
        CHECK(voices == std::set<std::string>{"kal16", "awb"});
        CHECK(seconds > 100.0);
        CHECK(seconds < 220.0);
    }

    TEST_CASE("The same settings give the same corpus, in one thread and in several") {
        auto settings = shortCorpus();
        settings.minutes = 1.0;
        settings.threads = 3;
        const learning::Corpus corpus = made(settings);
        settings.threads = 1;
        const std::string hash = learning::corpusHash(corpus);
        CHECK(learning::corpusHash(made(settings)) == hash);
        settings.seed = 2;
        CHECK_FALSE(learning::corpusHash(made(settings)) == hash);
        learning::Corpus other = corpus;
        other.takes[1].utterance.words[2].end_s += 1e-9;
        CHECK_FALSE(learning::corpusHash(other) == hash);
    }

    TEST_CASE("Both rule sets gesture to the same speeches, differently; parts can be made alone") {
        auto settings = shortCorpus();
        settings.minutes = 4.0;
        settings.voices = {"kal16"};
        const learning::Corpus a = made(settings);
        settings.gesturer = Gesturer::rules_b;
        settings.parts = {CorpusPart::validation, CorpusPart::test};
        const learning::Corpus b = made(settings);
        std::map<std::string, const learning::CorpusTake*> of_a;
        std::map<CorpusPart, int> parts;
        for (const auto& take : a.takes) {
            of_a[take.name] = &take;
            ++parts[take.part];
        }
        REQUIRE(parts[CorpusPart::test] > 0);
        CHECK(parts[CorpusPart::training] > 6 * parts[CorpusPart::test]);
        CHECK(static_cast<int>(b.takes.size()) == parts[CorpusPart::validation] + parts[CorpusPart::test]);
        for (const auto& take : b.takes) {
            const auto& same = *of_a.at(take.name);
            CHECK(take.part != CorpusPart::training);
            CHECK(take.part == same.part);
            CHECK(take.samples == same.samples);
            CHECK(take.text == same.text);
            CHECK(take.gesturer == Gesturer::rules_b);
            CHECK(same.gesturer == Gesturer::rules_a);
            CHECK_FALSE(take.motion == same.motion);
        }
    }

    TEST_CASE("Speeches that a rate makes too short are spoken slower") {
        auto settings = shortCorpus();
        settings.minutes = 1.0;
        settings.shortest_s = 9.0;
        settings.longest_s = 16.0;
        settings.slowest = settings.fastest = 1.5;
        for (const auto& take : made(settings).takes) {
            CHECK(take.utterance.duration_s >= 9.0);
            CHECK(take.utterance.duration_s <= 16.0);
        }
    }

    TEST_CASE("Settings that make no corpus are told") {
        auto settings = shortCorpus();
        settings.minutes = 0.0;
        CHECK(problemOf(settings).find("found no minutes") != std::string::npos);
        settings = shortCorpus();
        settings.gesturer = Gesturer::person;
        CHECK(problemOf(settings).find("expected rules A or rules B") != std::string::npos);
        settings = shortCorpus();
        settings.voices = {"kal16", "bob"};
        CHECK(problemOf(settings).find("found voice \"bob\", expected slt, rms") != std::string::npos);
        settings.voices = {};
        CHECK(problemOf(settings).find("found no voice") != std::string::npos);
        settings = shortCorpus();
        settings.slowest = 3.0;
        CHECK(problemOf(settings).find("found rates from 3 to") != std::string::npos);
        settings = shortCorpus();
        settings.shortest_s = 30.0;
        CHECK(problemOf(settings).find("found speeches of 30 to 24 s") != std::string::npos);
    }
}
