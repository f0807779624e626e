// Clips that are heard: what is wrong with their sounds, a machine without sound, and sound in step with
// movement.
#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <vector>

#include "display.hpp"
#include "lab_study.hpp"

using namespace deixis::tests;

namespace {

constexpr int rate_hz = 16000;
constexpr double click_at_s = 0.5;

template <typename Number>
void put(std::string& to, Number value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    to.append(bytes, sizeof value);
}

/// A WAV file of so many seconds: silence, and 10 ms of a high tone half a second from its start.
std::string clickingWav(double seconds) {
    const auto count = static_cast<std::uint32_t>(seconds * rate_hz);
    std::string out = "RIFF";
    put(out, 36 + 2 * count);
    out += "WAVEfmt ";
    put(out, std::uint32_t{16});
    put(out, std::uint16_t{1});
    put(out, std::uint16_t{1});
    put(out, std::uint32_t{rate_hz});
    put(out, std::uint32_t{2 * rate_hz});
    put(out, std::uint16_t{2});
    put(out, std::uint16_t{16});
    out += "data";
    put(out, 2 * count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / rate_hz - click_at_s;
        const double tone = t >= 0.0 && t < 0.01 ? std::sin(2.0 * std::numbers::pi * 2000.0 * t) : 0.0;
        put(out, static_cast<std::int16_t>(30000.0 * tone));
    }
    return out;
}

/// The lab's study, whose own system is heard.
class HeardFolder : public LabFolder {
  public:
    HeardFolder() {
        write("clips/said.wav", clickingWav(3.5));
        std::string manifest = read("clips/manifest.csv");
        std::string out;
        for (std::size_t at = 0, line = 0; at < manifest.size(); ++line) {
            const std::size_t end = manifest.find('\n', at);
            out += manifest.substr(at, end - at) + (line == 0 ? ",sound\n" : ",said.wav\n");
            at = end + 1;
        }
        write("clips/manifest.csv", out);
        change("study.toml", "kind = \"rating\"\nitems = 2",
               "kind = \"rating\"\nitems = 2\nsystems = [\"ours\"]");
    }
};

/// What OpenAL Soft plays goes into a file.
std::string intoFile(const LabFolder& lab) {
    lab.write("alsoft.conf",
              "[general]\ndrivers = wave\nfrequency = 48000\n[wave]\nfile = " + lab.path("heard.wav") + "\n");
    return "ALSOFT_CONF=" + lab.path("alsoft.conf");
}

/// When something begins to be heard in a 16-bit WAV file, after half a second of quiet; seconds from its
/// start.
std::vector<double> clicksIn(const std::string& wav) {
    REQUIRE(wav.size() > 44);
    std::uint16_t channels = 0;
    std::uint16_t bits = 0;
    std::uint32_t rate = 0;
    std::memcpy(&channels, wav.data() + 22, sizeof channels);
    std::memcpy(&rate, wav.data() + 24, sizeof rate);
    std::memcpy(&bits, wav.data() + 34, sizeof bits);
    const std::size_t data = wav.find("data") + 8;
    std::vector<double> out;
    double last_s = -1.0;
    const std::size_t step = channels * bits / 8U;
    for (std::size_t i = 0; data + (i + 1) * step <= wav.size(); ++i) {
        bool loud = false;
        for (std::size_t c = 0; c < channels; ++c) {
            const char* at = wav.data() + data + i * step + c * bits / 8U;
            double value = 0.0;
            if (bits == 16) {
                std::int16_t sample = 0;
                std::memcpy(&sample, at, sizeof sample);
                value = sample / 32768.0;
            } else {
                float sample = 0.0F;
                std::memcpy(&sample, at, sizeof sample);
                value = static_cast<double>(sample);
            }
            loud = loud || std::abs(value) > 0.05;
        }
        if (!loud) continue;
        const double now_s = static_cast<double>(i) / rate;
        if (now_s - last_s > 0.5) out.push_back(now_s);
        last_s = now_s;
    }
    return out;
}

}  // namespace

TEST_SUITE("app/desktop_sound") {
    TEST_CASE("sounds that are missing, broken or of another length are named with their row") {
        const HeardFolder lab;
        const std::string check = "check " + lab.path("study.toml");
        CHECK_MESSAGE(program(check).status == 0, program(check).err);
        const auto saysOfRow2 = [&](const std::string& what) {
            const auto checked = program(check);
            CHECK(checked.status == 1);
            const std::size_t row = checked.err.find("manifest.csv:2: sound: ");
            REQUIRE_MESSAGE(row != std::string::npos, checked.err);
            const std::string line = checked.err.substr(row, checked.err.find('\n', row) - row);
            CHECK_MESSAGE(line.find(what) != std::string::npos, line);
        };
        const std::string manifest = lab.read("clips/manifest.csv");
        lab.write("clips/manifest.csv", replaced(manifest, "said.wav", "gone.wav"));
        saysOfRow2("gone.wav");
        lab.write("clips/manifest.csv", manifest);
        lab.write("clips/said.wav", "this is no sound");
        saysOfRow2("said.wav: found no WAV file");
        lab.write("clips/said.wav", clickingWav(30.0));
        saysOfRow2("said.wav lasts 30.00 s");
    }

    TEST_CASE("a changed sound is told like a changed clip, and simulated participants hear nothing") {
        const HeardFolder lab;
        const auto simulated = lab.simulate();
        REQUIRE_MESSAGE(simulated.status == 0, simulated.err);
        lab.write("clips/said.wav", clickingWav(3.6));
        CHECK_FAILS_SAYING(lab.run("P02"), "clips/said.wav has changed");
    }

    TEST_CASE("a machine without sound is refused before a window opens, and nothing is kept") {
        const HeardFolder lab;
        const std::string run = "run " + lab.path("study.toml") +
                                " --station desktop --participant P01 --db " + lab.path("study.sqlite");
        CHECK_FAILS_SAYING(program(run, "env -u DISPLAY ALSOFT_DRIVERS=null"), "no sound", "muted = true");
        CHECK(countIn(lab.path("study.sqlite"), "select count(*) from participants") == 0);
        lab.change("study.toml", "kind = \"rating\"", "kind = \"rating\"\nmuted = true");
        lab.change("study.toml", "kind = \"referential-game\"", "kind = \"referential-game\"\nmuted = true");
        const auto muted = program(run + "2", "env -u DISPLAY ALSOFT_DRIVERS=null");
        CHECK_FAILS_SAYING(muted, "display");
    }

    TEST_CASE("what is heard goes with what is seen") {
        const HeardFolder lab;
        const Display display;
        const std::string database = lab.path("study.sqlite");
        Background session(Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1 " + intoFile(lab) + " " +
                           programFile() + " run " + lab.path("study.toml") +
                           " --participant P01 --size 320x240 --db " + database + " >" + lab.path("out") +
                           " 2>&1");
        const auto press = [&](const std::string& key) {
            shell(Display::environment() + " xdotool search --name P01 windowfocus key " + key);
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
        };
        const std::string ended = "select count(*) from events where kind = 'sound'";
        const bool heard = eventually(240.0, [&] {
            press("4");
            return countIn(database, ended) >= 2 || !session.running();
        });
        INFO(slurp(lab.path("out")));
        REQUIRE(heard);
        session.kill(SIGTERM);
        eventually(20.0, [&] { return !session.running(); });
        SQLite::Database db(database, SQLite::OPEN_READONLY);
        std::vector<double> onsets;
        SQLite::Statement rows(db, "select time_s from events where kind = 'stimulus_onset' order by time_s");
        while (rows.executeStep()) onsets.push_back(rows.getColumn(0).getDouble());
        const std::vector<double> clicks = clicksIn(lab.read("heard.wav"));
        REQUIRE(onsets.size() >= 2);
        REQUIRE(clicks.size() >= 2);
        // The file and the session have different clocks' zero, but the same seconds. What is farther off
        // than a tenth is put right; a busy machine that draws slowly stays within that.
        CHECK(std::abs((clicks[1] - clicks[0]) - (onsets[1] - onsets[0])) < 0.1);
        SQLite::Statement told(db, "select detail from events where kind = 'sound'");
        while (told.executeStep()) {
            const std::string detail = told.getColumn(0).getText();
            INFO(detail);
            CHECK(detail.find("clips/ours/") == 0);
            const std::size_t said = detail.find(": ");
            REQUIRE(said != std::string::npos);
            CHECK(std::stod(detail.substr(said + 2)) < 100.0);
        }
    }
}
