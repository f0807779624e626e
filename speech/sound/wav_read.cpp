#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "core/files.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::speech {

namespace {

constexpr unsigned pcm = 1, floating = 3, extensible = 0xFFFE;
/// Programs that cannot go back to write a size leave one from here on.
constexpr std::uint32_t unknown_size = 0x7FFFF000U;
constexpr double loudest = 4.0;

template <typename T>
T numberAt(std::string_view bytes, std::size_t at) {
    T out{};
    for (std::size_t i = 0; i < sizeof(T); ++i)
        out = static_cast<T>(
            out | static_cast<T>(static_cast<T>(static_cast<unsigned char>(bytes[at + i])) << (8U * i)));
    return out;
}

std::string formatName(unsigned tag) {
    switch (tag) {
        case 2:
            return "ADPCM";
        case 6:
            return "A-law";
        case 7:
            return "mu-law";
        case 0x11:
            return "IMA ADPCM";
        case 0x31:
            return "GSM";
        case 0x50:
            return "MPEG";
        case 0x55:
            return "MP3";
        default:
            return fmt::format("format 0x{:04X}", tag);
    }
}

struct WavFormat {
    unsigned tag = 0;  ///< pcm or floating
    unsigned channels = 0;
    unsigned rate_hz = 0;
    unsigned frame_bytes = 0;
    unsigned sample_bytes = 0;
};

Result<WavFormat> formatOf(std::string_view chunk, const std::string& name) {
    if (chunk.size() < 16)
        return fail(name, fmt::format("found a chunk 'fmt ' of {} bytes, expected 16 or more", chunk.size()));
    WavFormat out;
    out.tag = numberAt<std::uint16_t>(chunk, 0);
    out.channels = numberAt<std::uint16_t>(chunk, 2);
    out.rate_hz = numberAt<std::uint32_t>(chunk, 4);
    out.frame_bytes = numberAt<std::uint16_t>(chunk, 12);
    const unsigned bits = numberAt<std::uint16_t>(chunk, 14);
    if (out.tag == extensible) {
        if (chunk.size() < 40)
            return fail(
                name,
                fmt::format("found a chunk 'fmt ' of {} bytes, expected 40 or more in the extensible form",
                            chunk.size()));
        // The form's last 14 bytes tell that the two before are a tag.
        constexpr std::string_view rest("\x00\x00\x00\x00\x10\x00\x80\x00\x00\xAA\x00\x38\x9B\x71", 14);
        out.tag = numberAt<std::uint16_t>(chunk, 24);
        if (chunk.substr(26, 14) != rest)
            return fail(
                name,
                "found a sub-format that is not of the extensible form, expected PCM or floating point");
    }
    if (out.tag != pcm && out.tag != floating)
        return fail(name, fmt::format("found {}, expected PCM or floating point", formatName(out.tag)),
                    "Save it as WAV with 16-bit PCM");
    const bool known =
        out.tag == pcm ? bits == 8 || bits == 16 || bits == 24 || bits == 32 : bits == 32 || bits == 64;
    if (!known)
        return fail(name,
                    fmt::format("found {} of {} bits, expected {}", out.tag == pcm ? "PCM" : "floating point",
                                bits, out.tag == pcm ? "8, 16, 24 or 32" : "32 or 64"));
    if (out.channels == 0) return fail(name, "found 0 channels, expected 1 or more");
    if (out.rate_hz < min_rate_hz || out.rate_hz > max_rate_hz)
        return fail(name, fmt::format("found {} samples a second, expected {} to {}", out.rate_hz,
                                      min_rate_hz, max_rate_hz));
    out.sample_bytes = bits / 8;
    if (out.frame_bytes != out.channels * out.sample_bytes)
        return fail(name, fmt::format("found frames of {} bytes, expected {}: {} channels of {} bits",
                                      out.frame_bytes, out.channels * out.sample_bytes, out.channels, bits));
    return out;
}

/// One sample, -1 to 1; of floating point what is there.
double sampleAt(std::string_view data, std::size_t at, const WavFormat& format) {
    if (format.tag == floating) {
        if (format.sample_bytes == 4) {
            const auto word = numberAt<std::uint32_t>(data, at);
            float out = 0.0F;
            std::memcpy(&out, &word, sizeof out);
            return static_cast<double>(out);
        }
        const auto word = numberAt<std::uint64_t>(data, at);
        double out = 0.0;
        std::memcpy(&out, &word, sizeof out);
        return out;
    }
    switch (format.sample_bytes) {
        case 1:
            return (static_cast<unsigned char>(data[at]) - 128) / 128.0;
        case 2:
            return static_cast<std::int16_t>(numberAt<std::uint16_t>(data, at)) / 32768.0;
        case 3: {
            const auto low = numberAt<std::uint16_t>(data, at);
            const auto high = static_cast<signed char>(data[at + 2]);
            return (high * 65536 + low) / 8388608.0;
        }
        default:
            return static_cast<std::int32_t>(numberAt<std::uint32_t>(data, at)) / 2147483648.0;
    }
}

Result<Sound> soundOf(std::string_view data, const WavFormat& format, const std::string& name) {
    const std::size_t frames = data.size() / format.frame_bytes;
    if (frames == 0) return fail(name, "found a sound of 0 samples, expected some");
    const double duration_s = static_cast<double>(frames) / format.rate_hz;
    if (duration_s > max_sound_s)
        return fail(name, fmt::format("found a sound of {:.1f} minutes, expected {:.0f} at the most",
                                      duration_s / 60.0, max_sound_s / 60.0));
    Sound out{static_cast<int>(format.rate_hz), std::vector<float>(frames)};
    double peak = 0.0;
    for (std::size_t i = 0; i < frames; ++i) {
        double sum = 0.0;
        for (unsigned c = 0; c < format.channels; ++c) {
            const double sample = sampleAt(data, i * format.frame_bytes + c * format.sample_bytes, format);
            // Not by comparing with `loudest` alone: a number that is none compares as false.
            if (!std::isfinite(sample) || std::abs(sample) > loudest)
                return fail(name, fmt::format("found the sample {} at {:.3f} s, expected -1 to 1", sample,
                                              static_cast<double>(i) / format.rate_hz));
            sum += sample;
        }
        const double mean = sum / format.channels;
        peak = std::max(peak, std::abs(mean));
        out.samples[i] = static_cast<float>(mean);
    }
    if (peak > 1.0)
        for (float& sample : out.samples) sample = static_cast<float>(static_cast<double>(sample) / peak);
    return out;
}

}  // namespace

Result<Sound> readWavBytes(std::string_view bytes, const std::string& name) {
    const std::string_view form = bytes.substr(0, 4);
    if (form == "RIFX" || form == "RF64" || form == "BW64")
        return fail(name, fmt::format("found a file of the form {}, expected RIFF", form),
                    "Save it as a plain WAV file");
    if (form != "RIFF" || bytes.size() < 12 || bytes.substr(8, 4) != "WAVE")
        return fail(name, "found no WAV file, expected one that begins with RIFF and WAVE");

    std::optional<WavFormat> format;
    for (std::size_t at = 12; at + 8 <= bytes.size();) {
        const std::string_view id = bytes.substr(at, 4);
        const std::size_t size = numberAt<std::uint32_t>(bytes, at + 4);
        const std::string_view rest = bytes.substr(at + 8);
        if (id == "data") {
            if (!format) return fail(name, "found the chunk 'data' first, expected 'fmt ' before it");
            const bool unknown =
                size >= unknown_size || (size == 0 && numberAt<std::uint32_t>(bytes, 4) == 0);
            if (unknown) return soundOf(rest, *format, name);
            if (size > rest.size())
                return fail(name, fmt::format("found {} bytes of sound, expected {}: the file is cut off",
                                              rest.size(), size));
            if (size % format->frame_bytes != 0)
                return fail(
                    name, fmt::format("found {} bytes of sound, expected a multiple of {}, which a sample of "
                                      "all channels takes",
                                      size, format->frame_bytes));
            return soundOf(rest.substr(0, size), *format, name);
        }
        if (size > rest.size())
            return fail(name,
                        fmt::format("found {} bytes of the chunk '{}', expected {}: the file is cut off",
                                    rest.size(), id == "fmt " ? "fmt " : "before the sound", size));
        if (id == "fmt ") {
            auto read = formatOf(rest.substr(0, size), name);
            if (!read) return tl::unexpected(read.error());
            format = *read;
        }
        at += 8 + size + size % 2;
    }
    return fail(name, fmt::format("found no chunk '{}', expected one", format ? "data" : "fmt "));
}

Result<Sound> readWav(const std::filesystem::path& path) {
    auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return readWavBytes(*bytes, path.string());
}

}  // namespace deixis::speech
