#include "speech/voice/voice_program.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "core/files.hpp"
#include "sounds.hpp"
#include "speech/sound/wav.hpp"
#include "speech/voice/voices.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using speech::speakByProgram;
using namespace std::chrono_literals;

namespace {

namespace fs = std::filesystem;

/// A folder with a WAV file of half a second, removed at the end.
class WithWav {
  public:
    WithWav() : folder_(fs::temp_directory_path() / ("deixis_voice_test_" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        REQUIRE(speech::writeWav(wav(), deixis::tests::sine(8000, 0.5, 200.0)).has_value());
    }
    ~WithWav() { fs::remove_all(folder_); }
    [[nodiscard]] std::string wav() const { return (folder_ / "a.wav").string(); }
    [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }

  private:
    fs::path folder_;
};

speech::VoiceProgram shell(const std::string& script, std::chrono::milliseconds timeout = 10s) {
    return {"lab", {"sh", "-c", script}, timeout};
}

std::string errorOf(const speech::VoiceProgram& program, const std::string& text = "hello") {
    const auto sound = speakByProgram(program, text);
    REQUIRE_FALSE(sound.has_value());
    return sound.error().text();
}

}  // namespace

TEST_SUITE("speech/voice_program") {
    TEST_CASE("the text goes in as it is, the sound comes out") {
        const WithWav files;
        const std::string text =
            "Gr\xC3\xBC\xC3\x9F"
            "e; $(rm) \"quoted\" 'too'\n";
        const auto sound =
            speakByProgram(shell("cat > '" + files.file("text") + "'; cat '" + files.wav() + "'"), text);
        REQUIRE(sound.has_value());
        CHECK(sound->rate_hz == 8000);
        CHECK(sound->samples.size() == 4000);
        CHECK(*readFile(files.file("text")) == text);
    }

    TEST_CASE("arguments are not read by a shell") {
        const WithWav files;
        const std::string odd = files.file("a b$(touch x);.wav");
        fs::copy_file(files.wav(), odd);
        CHECK(speakByProgram({"lab", {"cat", odd}}, "hello").has_value());
    }

    TEST_CASE("a program that reads nothing, or writes much before it reads, is no trouble") {
        const WithWav files;
        const std::string text(150'000, 'a');
        CHECK(speakByProgram({"lab", {"cat", files.wav()}}, text).has_value());
        REQUIRE(speech::writeWav(files.wav(), deixis::tests::sine(48000, 20.0, 200.0)).has_value());
        CHECK(speakByProgram(shell("cat '" + files.wav() + "'; cat >/dev/null"), text).has_value());
    }

    TEST_CASE("failures are told by the voice's name") {
        CHECK(contains(errorOf({"lab", {"/nowhere/voice"}}),
                       "voice \"lab\": the program \"/nowhere/voice\" cannot be started"));
        CHECK(contains(errorOf(shell("echo one >&2; echo no model >&2; exit 3")),
                       "ended with 3, expected 0; it says: no model"));
        CHECK(contains(errorOf(shell("kill -9 $$")), "by signal 9"));
        CHECK(contains(errorOf(shell("true")), "wrote nothing"));
        CHECK(contains(errorOf(shell("echo this is no sound at all")), "voice \"lab\": found no WAV file"));
        CHECK(contains(errorOf(shell("true"), ""), "empty text"));
        CHECK(contains(errorOf(shell("true"), "a\x01"), "control character"));
    }

    TEST_CASE("a program that takes too long is stopped, with those that it started") {
        const WithWav files;
        const auto start = std::chrono::steady_clock::now();
        CHECK(contains(errorOf(shell("(sleep 2; touch '" + files.file("alive") + "') & sleep 30", 300ms)),
                       "has not ended after 0.3 s"));
        // Its output is closed, and it goes on.
        CHECK(contains(errorOf(shell("exec >&- 2>&-; sleep 30", 300ms)), "has not ended"));
        CHECK(std::chrono::steady_clock::now() - start < 2s);
        std::this_thread::sleep_for(2200ms);
        CHECK_FALSE(fs::exists(files.file("alive")));
    }

    TEST_CASE("it gets the three standard streams only, and leaves none open here") {
        const WithWav files;
        const int leaked = ::open("/dev/null", O_RDONLY);  // NOLINT: without O_CLOEXEC
        const int here = static_cast<int>(std::distance(fs::directory_iterator("/proc/self/fd"), {}));
        // The fourth is the folder that `ls` reads.
        CHECK(errorOf(shell("ls /proc/self/fd | tr '\\n' ' ' >&2; exit 1")).ends_with("it says: 0 1 2 3"));
        CHECK(static_cast<int>(std::distance(fs::directory_iterator("/proc/self/fd"), {})) == here);
        ::close(leaked);
    }

    TEST_CASE("the voices' list has flite's and the programs'; names are said where one is wrong") {
        const WithWav files;
        const auto voices = speech::Voices::with({{"lab", {"cat", files.wav()}}});
        REQUIRE(voices.has_value());
        CHECK(voices->names() == std::vector<std::string>{"slt", "rms", "awb", "kal16", "lab"});
        const auto speech = voices->speak("hello", "lab");
        REQUIRE(speech.has_value());
        CHECK(speech->utterance.duration_s == 0.5);
        CHECK(speech->utterance.words.empty());
        CHECK(voices->speak("hello", "slt")->utterance.words.size() == 1);
        CHECK(contains(voices->speak("hello", "lba").error().text(),
                       "expected one of slt, rms, awb, kal16, lab"));
        CHECK(contains(voices->speak("hello", "lab", {1.5}).error().text(), "rate: found 1.5, expected 1"));
        CHECK(contains(speech::Voices::with({{"slt", {"x"}}}).error().text(), "twice"));
        CHECK(contains(speech::Voices::with({{"", {"x"}}}).error().text(), "without a name"));
        CHECK(contains(speech::Voices::with({{"lab", {}}}).error().text(), "no command"));
    }
}

TEST_SUITE("speech/told_words") {
    using speech::readToldSpeech;

    TEST_CASE("Words stand before the sound, each a syllable that can be accented") {
        const WithWav files;
        const auto wav = readFile(files.wav());
        REQUIRE(wav);
        const auto told = readToldSpeech("0 0.2 Gr\xC3\xBC\xC3\x9F\n0.2 0.45 zwei drei\n\n" + *wav, "voice");
        REQUIRE_MESSAGE(told.has_value(), (told ? "" : told.error().text()));
        CHECK(told->utterance.duration_s == doctest::Approx(0.5));
        REQUIRE(told->utterance.words.size() == 2);
        CHECK(told->utterance.words[0].text == "Gr\xC3\xBC\xC3\x9F");
        CHECK(told->utterance.words[1].text == "zwei drei");
        CHECK(told->utterance.words[1].start_s == doctest::Approx(0.2));
        REQUIRE(told->syllables.size() == 2);
        CHECK(told->syllables[1].word == 1);
        CHECK(told->syllables[1].stressed);
        // The last word may go on a little behind the sound, which it is cut to.
        CHECK(readToldSpeech("0 0.7 a\n\n" + *wav, "voice")->utterance.words[0].end_s ==
              doctest::Approx(0.5));
        CHECK(readToldSpeech("\n" + *wav, "voice")->utterance.words.empty());
    }

    TEST_CASE("What is not told in this way names its line") {
        const WithWav files;
        const std::string wav = *readFile(files.wav());
        const auto problem = [&](const std::string& words) {
            const auto told = readToldSpeech(words + wav, "voice");
            return told ? std::string() : told.error().text();
        };
        for (const char* line :
             {"a b c", "0 0.1", "0 0.1 ", "-1 0.1 a", "0.1 0.05 a", "0 nan a", "0  0.1 a", "0 0.1 \xff"})
            CHECK_MESSAGE(contains(problem("0 0.1 first\n" + std::string(line) + "\n\n"), "in line 2"), line);
        CHECK(contains(problem("0.2 0.3 a\n0.1 0.3 b\n\n"), "in line 2"));
        CHECK(contains(problem("0.6 0.7 a\n\n"), "before the sound's end"));
        CHECK(!problem("").empty());
        CHECK(!problem("0 0.1 a\n").empty());
        CHECK(!readToldSpeech("", "voice"));
        CHECK(!readToldSpeech("0 0.1 a\n\n", "voice"));
        CHECK(contains(problem(std::string(2000, 'x')), "does not end"));
        std::string many;
        for (int i = 0; i < 30'000; ++i) many += "0 0.1 a\n";
        CHECK(contains(problem(many + "\n"), "more than"));
    }
}
