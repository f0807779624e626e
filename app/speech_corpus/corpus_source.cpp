#include "app/speech_corpus/corpus_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <thread>
#include <utility>

#include "app/program/progress_line.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/data/unit_gestures.hpp"
#include "core/files.hpp"
#include "learning/corpus/corpus_folder.hpp"
#include "learning/corpus/synthetic_corpus.hpp"
#include "speech/sentences/sentence_grammar.hpp"

namespace deixis::app {

namespace {

constexpr std::uint64_t corpus_seed = 1;

unsigned coreCount() {
    return std::max(1U, std::thread::hardware_concurrency());
}

Result<learning::Corpus> readFolder(const CorpusSource& source) {
    auto read = learning::readCorpusFolder(source.folder, {.threads = coreCount()},
                                           progressOnTerminal("reading speeches"));
    if (!read) return tl::unexpected(read.error());
    for (const Error& problem : read->left_out) fmt::print(stderr, "left out: {}\n", problem.text());
    return std::move(read->corpus);
}

Result<learning::Corpus> makeCorpus(const CorpusSource& source) {
    const auto library = assets::loadUnitGestures(assets::dataFile("unit_gestures.toml"));
    if (!library) return tl::unexpected(library.error());
    const auto file = assets::dataFile("speech/sentences.txt");
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const auto grammar = speech::parseSentenceGrammar(*text, file.string());
    if (!grammar) return tl::unexpected(grammar.error());
    learning::SyntheticCorpusSettings settings;
    settings.minutes = source.minutes;
    settings.seed = corpus_seed;
    settings.gesturer = source.rules == "b" ? learning::Gesturer::rules_b : learning::Gesturer::rules_a;
    settings.parts = source.parts;
    settings.threads = coreCount();
    return learning::makeSyntheticCorpus(settings, *grammar, *library,
                                         progressOnTerminal("speaking and gesturing"));
}

}  // namespace

void addCorpusOptions(Parser command, CorpusSource& source) {
    command
        .addOption(
            "--corpus", source.folder,
            "Folder of a lab's recordings: NAME.wav, NAME.bvh and the transcript NAME.csv, NAME.TextGrid or "
            "NAME.txt [a synthetic corpus is made]")
        .valueName("DIR");
    command.addOption("--minutes", source.minutes, "Of speech in a synthetic corpus")
        .showDefault()
        .check(Range(1.0, 6000.0));
}

void addCorpusRules(Parser command, CorpusSource& source) {
    command.addOption("--rules", source.rules, "Rule set that gestures in a synthetic corpus")
        .showDefault()
        .check(OneOf{{"a", "b"}});
}

Result<learning::Corpus> makeOrReadCorpus(const CorpusSource& source) {
    return source.folder.empty() ? makeCorpus(source) : readFolder(source);
}

std::vector<learning::GestureTake> takenFrom(learning::Corpus& corpus, speech::CorpusPart part) {
    std::vector<learning::GestureTake> out;
    for (learning::CorpusTake& take : corpus.takes)
        if (take.part == part)
            out.push_back({std::move(take.samples), std::move(take.utterance), std::move(take.motion)});
    std::erase_if(corpus.takes, [part](const learning::CorpusTake& take) { return take.part == part; });
    return out;
}

double minutesOf(const std::vector<learning::GestureTake>& takes) {
    double seconds = 0.0;
    for (const auto& take : takes) seconds += take.utterance.duration_s;
    return seconds / 60.0;
}

}  // namespace deixis::app
