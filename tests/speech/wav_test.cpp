#include "speech/sound/wav.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "core/files.hpp"
#include "core/random.hpp"
#include "sounds.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using doctest::Approx;
using speech::readWavBytes;

namespace {

std::string little(std::uint64_t number, unsigned bytes) {
    std::string out;
    for (unsigned i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xFF);
    return out;
}

std::string chunk(const std::string& id, const std::string& content) {
    return id + little(content.size(), 4) + content + (content.size() % 2 == 1 ? std::string(1, '\0') : "");
}

std::string format(unsigned tag, unsigned channels, unsigned rate, unsigned bits) {
    const unsigned frame = channels * bits / 8;
    return little(tag, 2) + little(channels, 2) + little(rate, 4) + little(std::uint64_t{rate} * frame, 4) +
           little(frame, 2) + little(bits, 2);
}

std::string riff(const std::string& chunks) {
    return "RIFF" + little(chunks.size() + 4, 4) + "WAVE" + chunks;
}

std::string wav(unsigned tag, unsigned channels, unsigned rate, unsigned bits, const std::string& data) {
    return riff(chunk("fmt ", format(tag, channels, rate, bits)) + chunk("data", data));
}

std::string float32(float value) {
    return little(std::bit_cast<std::uint32_t>(value), 4);
}

std::string errorOf(const std::string& bytes) {
    const auto sound = readWavBytes(bytes, "f.wav");
    REQUIRE_FALSE(sound.has_value());
    CHECK(contains(sound.error().text(), "f.wav: "));
    return sound.error().text();
}

}  // namespace

TEST_SUITE("speech/wav") {
    TEST_CASE("every format has half of full loudness where the specification says") {
        const std::string half64 = little(std::bit_cast<std::uint64_t>(0.5), 8);
        const std::string quarter64 = little(std::bit_cast<std::uint64_t>(-0.25), 8);
        const std::string files[]{
            wav(1, 1, 8000, 8, {static_cast<char>(192), static_cast<char>(96)}),
            wav(1, 1, 8000, 16, little(0x4000, 2) + little(0xE000, 2)),
            wav(1, 1, 8000, 24, little(0x400000, 3) + little(0xE00000, 3)),
            wav(1, 1, 8000, 32, little(0x40000000, 4) + little(0xE0000000, 4)),
            wav(3, 1, 8000, 32, float32(0.5F) + float32(-0.25F)),
            wav(3, 1, 8000, 64, half64 + quarter64),
        };
        for (const std::string& file : files) {
            CAPTURE(static_cast<int>(file[34]));
            const auto sound = readWavBytes(file, "f.wav");
            REQUIRE(sound.has_value());
            CHECK(sound->rate_hz == 8000);
            REQUIRE(sound->samples.size() == 2);
            CHECK(sound->samples[0] == 0.5F);
            CHECK(sound->samples[1] == -0.25F);
        }
    }

    TEST_CASE("channels are averaged, and the extensible form is read") {
        const std::string data = little(0x2000, 2) + little(0x4000, 2) + little(0x6000, 2);
        const std::string guid("\x01\x00\x00\x00\x00\x00\x10\x00\x80\x00\x00\xAA\x00\x38\x9B\x71", 16);
        const std::string fmt = format(0xFFFE, 3, 48000, 16) + little(22, 2) + little(16, 2) + little(7, 4);
        const auto sound = readWavBytes(riff(chunk("fmt ", fmt + guid) + chunk("data", data)), "f.wav");
        REQUIRE(sound.has_value());
        REQUIRE(sound->samples.size() == 1);
        CHECK(sound->samples[0] == 0.5F);

        std::string odd = guid;
        odd[9] = 'x';
        CHECK(contains(errorOf(riff(chunk("fmt ", fmt + odd) + chunk("data", data))), "sub-format"));
        CHECK(contains(errorOf(riff(chunk("fmt ", fmt) + chunk("data", data))), "40 or more"));
    }

    TEST_CASE("other chunks, odd ones and a wrong size of the whole are passed over") {
        const std::string fmt = chunk("fmt ", format(1, 1, 16000, 16));
        const std::string data = chunk("data", little(0x4000, 2));
        std::string file =
            riff(chunk("LIST", "INFOISFT\x05") + fmt + chunk("odd ", "abc") + data + chunk("id3 ", "x"));
        CHECK(readWavBytes(file, "f.wav")->samples == std::vector<float>{0.5F});
        for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{9}, std::uint64_t{0xFFFFFFFF}}) {
            file.replace(4, 4, little(size, 4));
            CHECK(readWavBytes(file, "f.wav")->samples == std::vector<float>{0.5F});
        }
    }

    TEST_CASE("a sound written into a pipe has no size and goes on to the end") {
        const std::string fmt = chunk("fmt ", format(1, 1, 16000, 16));
        for (const std::uint64_t size : {std::uint64_t{0x7FFFF000}, std::uint64_t{0xFFFFFFFF}}) {
            const std::string file = riff(fmt + "data" + little(size, 4) + little(0x4000, 2) + "x");
            CHECK(readWavBytes(file, "f.wav")->samples == std::vector<float>{0.5F});
        }
        std::string file = riff(fmt + "data" + little(0, 4) + little(0x4000, 2));
        CHECK(contains(errorOf(file), "0 samples"));
        file.replace(4, 4, little(0, 4));
        CHECK(readWavBytes(file, "f.wav")->samples == std::vector<float>{0.5F});
    }

    TEST_CASE("what cannot be read is said, with what was found and expected") {
        const std::string two = little(0x4000, 2) + little(0, 2);
        const std::string fmt = chunk("fmt ", format(1, 1, 16000, 16));
        CHECK(contains(errorOf(""), "found no WAV file"));
        CHECK(contains(errorOf("RIFF"), "found no WAV file"));
        CHECK(contains(errorOf("ID3 and more of an MP3 file"), "found no WAV file"));
        CHECK(contains(errorOf("RF64" + riff("").substr(4)), "form RF64"));
        CHECK(contains(errorOf(riff("")), "no chunk 'fmt '"));
        CHECK(contains(errorOf(riff(fmt)), "no chunk 'data'"));
        CHECK(contains(errorOf(riff(chunk("data", two) + fmt)), "'data' first"));
        CHECK(contains(errorOf(riff(chunk("fmt ", "abc") + chunk("data", two))), "3 bytes, expected 16"));
        CHECK(contains(errorOf(wav(1, 1, 16000, 16, "")), "0 samples"));
        CHECK(contains(errorOf(wav(1, 2, 16000, 16, two + "xy")),
                       "6 bytes of sound, expected a multiple of 4"));
        CHECK(contains(errorOf(wav(1, 0, 16000, 16, two)), "0 channels"));
        CHECK(contains(errorOf(wav(1, 1, 16000, 12, two)), "PCM of 12 bits, expected 8, 16, 24 or 32"));
        CHECK(contains(errorOf(wav(3, 1, 16000, 16, two)), "floating point of 16 bits"));
        CHECK(contains(errorOf(wav(7, 1, 8000, 8, two)), "found mu-law"));
        CHECK(contains(errorOf(wav(0x55, 1, 16000, 16, two)), "found MP3"));
        CHECK(contains(errorOf(wav(0x1234, 1, 16000, 16, two)), "format 0x1234"));
        CHECK(contains(errorOf(wav(1, 1, 3999, 16, two)), "3999 samples a second"));
        CHECK(contains(errorOf(wav(1, 1, 192001, 16, two)), "192001 samples a second"));
        std::string frames = format(1, 2, 16000, 16);
        frames[12] = 2;
        CHECK(contains(errorOf(riff(chunk("fmt ", frames) + chunk("data", two))),
                       "frames of 2 bytes, expected 4"));
        const std::string whole = wav(1, 1, 16000, 16, two + two);
        CHECK(contains(errorOf(whole.substr(0, whole.size() - 3)),
                       "5 bytes of sound, expected 8: the file is cut off"));
        CHECK(contains(errorOf(whole.substr(0, 30)), "cut off"));
    }

    TEST_CASE("samples that are none are refused, those a little too loud are made softer") {
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const std::string good = float32(0.5F);
        CHECK(contains(errorOf(wav(3, 1, 4000, 32, good + good + float32(nan))),
                       "nan at 0.001 s, expected -1 to 1"));
        CHECK(contains(errorOf(wav(3, 1, 4000, 32, float32(std::numeric_limits<float>::infinity()))), "inf"));
        CHECK(contains(errorOf(wav(3, 1, 4000, 32, float32(20000.0F))), "20000"));
        const auto loud = readWavBytes(wav(3, 1, 4000, 32, float32(2.0F) + float32(-1.0F)), "f.wav");
        REQUIRE(loud.has_value());
        CHECK(loud->samples == std::vector<float>{1.0F, -0.5F});
    }

    TEST_CASE("half an hour is read, not more") {
        const std::string half_hour(std::size_t{4000} * 1800, static_cast<char>(128));
        CHECK(readWavBytes(wav(1, 1, 4000, 8, half_hour), "f.wav").has_value());
        CHECK(contains(errorOf(wav(1, 1, 4000, 8, half_hour + half_hour)), "60.0 minutes, expected 30"));
    }

    TEST_CASE("what is written is read again, to the sample, and files are whole") {
        speech::Sound sound{22050, {}};
        Random random(1);
        for (int i = 0; i < 1000; ++i)
            sound.samples.push_back(static_cast<float>(static_cast<int>(random.below(65536)) - 32768) /
                                    32768.0F);
        CHECK(readWavBytes(speech::wavBytes(sound), "f.wav")->samples == sound.samples);
        const auto path = std::filesystem::temp_directory_path() / "deixis_wav_test.wav";
        REQUIRE(speech::writeWav(path, sound).has_value());
        const auto read = speech::readWav(path);
        REQUIRE(read.has_value());
        CHECK(read->rate_hz == 22050);
        CHECK(read->samples == sound.samples);
        std::filesystem::remove(path);
        CHECK(contains(speech::readWav(path).error().text(), "deixis_wav_test.wav"));
        sound.samples = {2.0F, -2.0F, 1.0F};
        CHECK(readWavBytes(speech::wavBytes(sound), "f.wav")->samples ==
              std::vector<float>{32767 / 32768.0F, -1.0F, 32767 / 32768.0F});
    }
}
