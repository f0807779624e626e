#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>

#include "assets/joints/bvh.hpp"
#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "learning/corpus/corpus_folder.hpp"
#include "learning/corpus/synthetic_corpus.hpp"
#include "learning/corpus/transcript.hpp"
#include "library.hpp"
#include "speech/sound/wav.hpp"

using namespace deixis;
namespace fs = std::filesystem;
using learning::CorpusTake;

namespace {

fs::path emptyFolder(const std::string& name) {
    const fs::path folder = tests::buildDir() / "corpus_folder_test" / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
}

/// Four speeches or a few more, one for the test.
const learning::Corpus& smallCorpus() {
    static const learning::Corpus corpus = [] {
        learning::SyntheticCorpusSettings settings;
        settings.minutes = 2.3;
        settings.voices = {"kal16"};
        settings.gesturer = learning::Gesturer::rules_b;
        auto made = learning::makeSyntheticCorpus(settings, tests::shippedGrammar(), tests::shippedLibrary());
        REQUIRE_MESSAGE(made.has_value(), (made ? "" : made.error().text()));
        learning::Corpus few;
        few.synthetic = true;
        for (CorpusTake& take : made->takes)
            if (take.part != speech::CorpusPart::training || few.takes.size() < 2)
                few.takes.push_back(std::move(take));
        return few;
    }();
    return corpus;
}

learning::CorpusFolder readFolder(const fs::path& folder, const learning::CorpusReadOptions& options = {}) {
    auto read = learning::readCorpusFolder(folder, options);
    REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().text()));
    return std::move(*read);
}

/// The first take alone, its files at the top of the folder.
fs::path oneTake(const std::string& name) {
    const fs::path folder = emptyFolder(name);
    learning::Corpus one;
    one.takes.push_back(smallCorpus().takes.front());
    one.takes.front().name = "take";
    REQUIRE(learning::writeCorpusFolder(one, folder).has_value());
    for (const auto& entry : fs::directory_iterator(folder / "training"))
        fs::rename(entry.path(), folder / entry.path().filename());
    fs::remove_all(folder / "training");
    return folder;
}

std::string problemOf(const fs::path& folder) {
    const auto read = learning::readCorpusFolder(folder);
    return read ? "none" : read.error().text();
}

}  // namespace

TEST_SUITE("corpus/folder") {
    TEST_CASE("What is written is read again: parts, sounds, words and motions") {
        const fs::path folder = emptyFolder("written");
        REQUIRE(learning::writeCorpusFolder(smallCorpus(), folder).has_value());
        const auto read = readFolder(folder);
        CHECK(read.left_out.empty());
        REQUIRE(read.corpus.takes.size() == smallCorpus().takes.size());
        CHECK_FALSE(read.corpus.synthetic);
        for (const CorpusTake& take : read.corpus.takes) {
            const auto found = std::ranges::find(smallCorpus().takes, take.name, &CorpusTake::name);
            REQUIRE(found != smallCorpus().takes.end());
            CHECK(take.part == found->part);
            REQUIRE(take.samples.size() == found->samples.size());
            float apart = 0.0F;
            for (std::size_t i = 0; i < take.samples.size(); ++i)
                apart = std::max(apart, std::abs(take.samples[i] - found->samples[i]));
            CHECK(apart < 1e-4F);
            REQUIRE(take.utterance.words.size() == found->utterance.words.size());
            for (std::size_t w = 0; w < take.utterance.words.size(); ++w) {
                CHECK(take.utterance.words[w].text == found->utterance.words[w].text);
                CHECK(std::abs(take.utterance.words[w].start_s - found->utterance.words[w].start_s) < 1e-3);
            }
            CHECK_FALSE(take.utterance.accents.empty());
            REQUIRE(take.motion.frames.size() == found->motion.frames.size());
            double most = 0.0, sum = 0.0;
            for (std::size_t f = 0; f < take.motion.frames.size(); ++f)
                for (std::size_t b = 0; b < motion::upper_bone_count; ++b) {
                    const double degrees = degreesFromRadians(angleBetween(
                        take.motion.frames[f].directions[b], found->motion.frames[f].directions[b]));
                    most = std::max(most, degrees);
                    sum += degrees;
                }
            CHECK(sum / static_cast<double>(take.motion.frames.size() * motion::upper_bone_count) < 0.2);
            CHECK(most < 8.0);
        }
        // In files the motion reaches the sound's end.
        for (const CorpusTake& take : smallCorpus().takes) {
            const auto bvh =
                assets::readBvh(folder / speech::corpusPartName(take.part) / (take.name + ".bvh"));
            REQUIRE(bvh.has_value());
            CHECK(bvh->clip.duration_s() >= take.utterance.duration_s - 1e-6);
            CHECK(bvh->clip.duration_s() < take.utterance.duration_s + motion::upper_body_frame_time_s);
        }
        const auto list = readFile(folder / "corpus.csv");
        REQUIRE(list.has_value());
        const auto sheet = parseCsvSheet(*list, "corpus.csv");
        REQUIRE(sheet.has_value());
        CHECK(sheet->rows.size() == smallCorpus().takes.size());
        CHECK(sheet->rows.front().fields[5] == "yes");
    }

    TEST_CASE("A text alone is aligned, a TextGrid is taken as it is") {
        const fs::path folder = oneTake("text");
        const CorpusTake& original = smallCorpus().takes.front();
        fs::remove(folder / "take.csv");
        fs::rename(folder / "take.spoken", folder / "take.txt");
        const auto aligned = readFolder(folder);
        REQUIRE(aligned.corpus.takes.size() == 1);
        const auto& words = aligned.corpus.takes.front().utterance.words;
        REQUIRE(words.size() == original.utterance.words.size());
        double late_s = 0.0;
        for (std::size_t w = 0; w < words.size(); ++w)
            late_s += std::abs(words[w].start_s - original.utterance.words[w].start_s);
        CHECK(late_s / static_cast<double>(words.size()) < 0.08);
        CHECK(aligned.corpus.takes.front().text == original.text);

        fs::remove(folder / "take.txt");
        REQUIRE(writeFile(folder / "take.TextGrid",
                          "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n0 4 <exists> 1 "
                          "\"IntervalTier\" \"words\" 0 4 1 1 2 \"hello\"\n")
                    .has_value());
        const auto grid = readFolder(folder);
        CHECK(grid.corpus.takes.front().utterance.words.size() == 1);
        CHECK(grid.corpus.takes.front().text == "hello");
    }

    TEST_CASE("Sounds of other rates and motions of another length are brought to the sound's") {
        const fs::path folder = oneTake("rates");
        const CorpusTake& original = smallCorpus().takes.front();
        auto sound = speech::readWav(folder / "take.wav");
        REQUIRE(sound.has_value());
        REQUIRE(speech::writeWav(folder / "take.wav", speech::resampled(*sound, 44100)).has_value());
        auto bvh = assets::readBvh(folder / "take.bvh");
        REQUIRE(bvh.has_value());
        for (int i = 0; i < 4; ++i) bvh->clip.frames.pop_back();  // 0.27 s
        REQUIRE(writeFile(folder / "take.bvh", assets::writeBvh(bvh->clip)).has_value());
        const auto read = readFolder(folder);
        const CorpusTake& take = read.corpus.takes.front();
        CHECK(std::abs(static_cast<double>(take.samples.size()) -
                       static_cast<double>(original.samples.size())) <= 1.0);
        REQUIRE(take.motion.frames.size() == original.motion.frames.size());
        CHECK(take.motion.frames.back() == take.motion.frames[take.motion.frames.size() - 2]);

        for (int i = 0; i < 8; ++i) bvh->clip.frames.pop_back();
        REQUIRE(writeFile(folder / "take.bvh", assets::writeBvh(bvh->clip)).has_value());
        CHECK(problemOf(folder).find("s of sound, expected at most 0.5 s between them") != std::string::npos);
    }

    TEST_CASE("What lacks or cannot be read is told, by file; other takes are read") {
        CHECK(problemOf(tests::buildDir() / "no such folder").find("found no such folder") !=
              std::string::npos);
        CHECK(problemOf(emptyFolder("empty")).find("found no take, expected NAME.wav") != std::string::npos);

        const fs::path folder = oneTake("lacks");
        for (const char* name :
             {"no_sound.bvh", "no_motion.wav", "no_words.wav", "no_words.bvh", "bad_sound.wav",
              "bad_sound.bvh", "bad_sound.csv", "bad_motion.wav", "bad_motion.bvh", "bad_motion.csv",
              "two.wav", "two.bvh", "two.csv", "two.TextGrid", "late.wav", "late.bvh", "late.csv"}) {
            const std::string ending = fs::path(name).extension().string();
            if (fs::exists(folder / ("take" + ending))) fs::copy(folder / ("take" + ending), folder / name);
        }
        REQUIRE(writeFile(folder / "two.TextGrid", "x").has_value());
        REQUIRE(writeFile(folder / "bad_sound.wav", "RIFF").has_value());
        REQUIRE(writeFile(folder / "bad_motion.bvh", "HIERARCHY\nROOT hips\n{\n").has_value());
        REQUIRE(writeFile(folder / "late.csv", "word,start_s,end_s\nlate,1,90\n").has_value());
        REQUIRE(writeFile(folder / "list.csv", "not,a,take\n").has_value());
        const auto read = readFolder(folder);
        CHECK(read.corpus.takes.size() == 1);
        REQUIRE(read.left_out.size() == 7);
        const auto told = [&](std::string_view file, std::string_view what) {
            return std::ranges::any_of(read.left_out, [&](const Error& error) {
                return error.text().find(file) != std::string::npos &&
                       error.text().find(what) != std::string::npos;
            });
        };
        CHECK(told("no_sound.bvh", "found no sound no_sound.wav beside it"));
        CHECK(told("no_motion.wav", "found no motion no_motion.bvh beside it"));
        CHECK(told("no_words.wav", "found no transcript beside it"));
        CHECK(told("two.csv", "found two.TextGrid beside it, too"));
        CHECK(told("bad_sound.wav", ""));
        CHECK(told("bad_motion.bvh", ""));
        CHECK(told("late.csv", "found words up to 90.00 s, but the sound is over at"));
    }

    TEST_CASE("Without folders of parts takes are parted by their names") {
        const fs::path folder = oneTake("parts");
        for (int i = 0; i < 11; ++i)
            for (const char* ending : {".wav", ".bvh", ".csv"})
                fs::copy(folder / (std::string("take") + ending),
                         folder / (std::string("t") + static_cast<char>('a' + i) + ending));
        for (const char* ending : {".wav", ".bvh", ".csv"})
            fs::remove(folder / (std::string("take") + ending));
        std::string parts;
        for (const auto& take : readFolder(folder).corpus.takes)
            parts += speech::corpusPartName(take.part).substr(0, 2);
        CHECK(parts == "trtrtrtrvatrtrtrtrtetr");
    }
}
