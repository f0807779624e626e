// Tracking samples, the trials' tallies and the station's properties, as they lie in the database.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "paths.hpp"
#include "results/database/tracking_blocks.hpp"
#include "skipping.hpp"

using namespace deixis;
using results::Store;
using results::TrackedFrame;
using results::TrialTracking;

namespace {

/// A pose all of whose seven numbers differ from those of every other `seed`; not a unit quaternion, which
/// the store need not care about. All of them can be kept exactly.
Pose numbered(int seed) {
    const double base = 10.0 * seed;
    return {{base + 0.5, base + 1.5, base + 2.5}, Quat(base + 3.5, base + 4.5, base + 5.5, base + 6.5)};
}

/// A database with a session of P01 under way.
struct Begun {
    fixtures::Folder folder;
    studies::Study study = fixtures::study({"direct"});
    studies::StudyPlan plan = fixtures::plan(study, "P01", 1);
    Store store = fixtures::open(folder / "a.sqlite");
    long long session = 0;

    explicit Begun(const results::SessionInfo& info = fixtures::session("P01", false)) {
        fixtures::store(store, study, plan);
        session = store.beginSession(info);
    }
    [[nodiscard]] SQLite::Database reader() const {
        return SQLite::Database((folder / "a.sqlite").string(), SQLite::OPEN_READONLY, 1000);
    }
};

float float32(const unsigned char* bytes) {
    const std::uint32_t bits =
        static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
        static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
    float out = 0.0F;
    std::memcpy(&out, &bits, sizeof out);
    return out;
}

/// The block of Python in docs/database.md that begins with this line.
std::string documentedPython(const std::string& first_line) {
    const auto text = readFile(deixis::tests::sourceDir() / "docs/database.md").value();
    const std::string fence = "```python\n";
    const auto begin = text.find(fence + first_line);
    REQUIRE(begin != std::string::npos);
    const auto end = text.find("```", begin + fence.size());
    return text.substr(begin + fence.size(), end - begin - fence.size());
}

/// What a Python program prints, which gets one argument; nothing where there is no Python.
std::optional<std::string> printed(const std::filesystem::path& script,
                                   const std::filesystem::path& argument) {
    if (std::system("python3 -c 'import sqlite3, zlib' 2>/dev/null") != 0) return std::nullopt;
    const std::string command = fmt::format("python3 '{}' '{}' 2>&1", script.string(), argument.string());
    std::FILE* pipe = ::popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string out;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
        out.append(buffer.data(), n);
    ::pclose(pipe);
    return out;
}

}  // namespace

TEST_SUITE("results/tracking") {
    TEST_CASE("A frame is kept with every number that was measured, and whether it was valid") {
        Begun db;
        studies::TrackingSample sample;
        sample.frame = 4242;
        sample.display_time_s = 100.125;
        sample.begun_s = 100.0625;
        sample.submitted_s = 100.09375;
        sample.dropped_frames = 3;
        sample.rendered = false;
        sample.off_place_m = 0.375;
        sample.head = {numbered(1), true, true, true};
        sample.aim[0] = {numbered(2), false, true, true};  // turned, but nobody knows where
        sample.aim[1] = {numbered(3), true, true, false};  // held from before
        sample.grip[0] = {numbered(4), false, false, false};
        sample.grip[1] = {numbered(5), true, false, true};
        sample.gaze = studies::TrackedPose{numbered(6), true, true, true};
        const std::vector<TrackedFrame> frames{{sample, 2}, {fixtures::frame(4243), -1}};
        db.store.recordTracking(frames, {});

        auto reader = db.reader();
        SQLite::Statement row(reader, "SELECT * FROM tracking_blocks ORDER BY first_frame");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("session").getInt64() == db.session);
        CHECK(row.getColumn("trial_index").getInt() == 2);
        CHECK(row.getColumn("first_frame").getInt() == 4242);
        CHECK(row.getColumn("frames").getInt() == 1);
        CHECK(row.getColumn("first_display_time_s").getDouble() == 100.125);
        CHECK(row.getColumn("last_display_time_s").getDouble() == 100.125);
        const auto kept = results::unpackTracking(row.getColumn("data").getString()).value().at(0);
        CHECK(kept.frame == 4242);
        CHECK(kept.display_time_s == 100.125);
        CHECK(kept.begun_s == 100.0625);
        CHECK(kept.submitted_s == 100.09375);
        CHECK(kept.dropped_frames == 3);
        CHECK_FALSE(kept.rendered);
        CHECK(kept.off_place_m == 0.375);
        CHECK(kept.head.stage_from_device.position == numbered(1).position);
        CHECK(kept.head.stage_from_device.orientation == numbered(1).orientation);
        CHECK(kept.aim[0].stage_from_device.orientation == numbered(2).orientation);
        CHECK_FALSE(kept.aim[0].position_valid);
        CHECK_FALSE(kept.aim[1].tracked);
        CHECK_FALSE(kept.grip[0].orientation_valid);
        CHECK(kept.grip[1].stage_from_device.position == numbered(5).position);
        CHECK(kept.gaze.value().stage_from_device.position == numbered(6).position);
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("trial_index").isNull());
        CHECK_FALSE(
            results::unpackTracking(row.getColumn("data").getString()).value().at(0).gaze.has_value());
        CHECK_FALSE(row.executeStep());
        CHECK(reader.execAndGet("SELECT count(*) FROM hand_joints").getInt() == 0);
    }

    TEST_CASE("Blocks are full where they can be, and hold frames of one trial or of none") {
        Begun db;
        std::vector<TrackedFrame> frames;
        for (std::uint64_t i = 1; i <= 300; ++i)
            frames.push_back({fixtures::frame(i), i <= 20 ? -1 : i <= 200 ? 1 : 2});
        db.store.recordTracking(frames, {});
        auto reader = db.reader();
        SQLite::Statement row(reader,
                              "SELECT trial_index, first_frame, frames FROM tracking_blocks ORDER BY id");
        std::string blocks;
        while (row.executeStep())
            blocks += fmt::format("{}:{}+{} ", row.getColumn(0).isNull() ? -1 : row.getColumn(0).getInt(),
                                  row.getColumn(1).getInt(), row.getColumn(2).getInt());
        CHECK(blocks == "-1:1+20 1:21+64 1:85+64 1:149+52 2:201+64 2:265+36 ");
    }

    TEST_CASE("The reader that the documentation gives reads what the store wrote") {
        Begun db;
        std::vector<TrackedFrame> frames;
        Random random(11, "reader");
        for (std::uint64_t i = 1; i <= 100; ++i) {
            auto sample = fixtures::frame(i + (i > 50 ? 3 : 0));
            sample.display_time_s = 70.0 + static_cast<double>(i) / 90.0;
            sample.dropped_frames = i == 51 ? 3 : 0;
            sample.head.stage_from_device.position = {random.uniform(-1.0, 1.0), 1.6, -0.25};
            sample.head.position_valid = i % 10 != 0;
            sample.aim[1] = {{{0.0, 1.0, 0.0}, Quat(0.5, -0.5, 0.5, -0.5)}, true, true, true};
            if (i % 2 == 0) sample.gaze = studies::TrackedPose{numbered(0), true, false, true};
            frames.push_back({sample, 1});
        }
        db.store.recordTracking(frames, {});

        const auto script = db.folder / "read.py";
        std::ofstream(script) << documentedPython("import sqlite3, sys, zlib") << R"python(
for row in db.execute("SELECT data FROM tracking_blocks ORDER BY session, first_frame"):
    for f in frames(row[0]):
        head, aim, gaze = f["head"], f["right_aim"], f["gaze"]
        print(f["frame"], "%.6f" % f["display_time_s"], "%.6f" % f["begun_s"], f["dropped_frames"], f["rendered"],
              head["validity"], "%.5f" % head["position"][0] if head["position"] else None, aim["rotation"],
              gaze["validity"] if gaze else None, f["left_grip"]["position"])
)python";
        const auto told = printed(script, db.folder / "a.sqlite");
        if (!told) {
            tests::tellSkipped("there is no python3 with sqlite3 and zlib");
            return;
        }
        std::string expected;
        for (const auto& frame : frames) {
            const auto& s = frame.sample;
            const double x = std::round(s.head.stage_from_device.position.x * 65536.0) / 65536.0;
            expected +=
                fmt::format("{} {:.6f} {:.6f} {} True {} {} (0.5, -0.5, 0.5, -0.5) {} None\n", s.frame,
                            s.display_time_s, s.begun_s, s.dropped_frames, s.head.position_valid ? 7 : 6,
                            s.head.position_valid ? fmt::format("{:.5f}", x) : "None", s.gaze ? "5" : "None");
        }
        CHECK(*told == expected);
    }

    TEST_CASE("The joints of a hand are kept as little-endian floats, with a byte of flags each") {
        Begun db;
        auto sample = fixtures::frame(1);
        for (int joint = 0; joint < 26; ++joint)
            sample.joints[1].push_back({{numbered(joint), true, joint != 3, joint != 4}, 0.25 + joint});
        const std::vector<TrackedFrame> frames{{sample, -1}};
        db.store.recordTracking(frames, {});

        auto reader = db.reader();
        SQLite::Statement row(reader, "SELECT session, frame, hand, joints, flags FROM hand_joints");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn(0).getInt64() == db.session);
        CHECK(row.getColumn(1).getInt() == 1);
        CHECK(row.getColumn(2).getString() == "right");
        REQUIRE(row.getColumn(3).getBytes() == 26 * 8 * 4);
        REQUIRE(row.getColumn(4).getBytes() == 26);
        const auto* bytes = static_cast<const unsigned char*>(row.getColumn(3).getBlob());
        const auto* flags = static_cast<const unsigned char*>(row.getColumn(4).getBlob());
        for (int joint = 0; joint < 26; ++joint) {
            INFO("joint " << joint);
            CHECK(static_cast<int>(flags[joint]) == (joint == 3 ? 5 : joint == 4 ? 3 : 7));
            for (int i = 0; i < 7; ++i) {
                const float number = float32(bytes + (joint * 8 + i) * 4);
                if (joint == 3 && i >= 3)
                    CHECK(std::isnan(number));
                else
                    CHECK(number == static_cast<float>(10 * joint + i) + 0.5F);
            }
            CHECK(float32(bytes + (joint * 8 + 7) * 4) == static_cast<float>(joint) + 0.25F);
        }
        CHECK_FALSE(row.executeStep());
    }

    TEST_CASE("A trial's tally is kept, added to when the trial goes on, and stands beside its answer") {
        Begun db;
        TrialTracking first{1, 100, 2, 5, 0.25, 7, 10.0, 11.0};
        TrialTracking again{1, 50, 1, 0, 0.125, 3, 20.0, 20.5};
        db.store.recordTracking({}, std::vector<TrialTracking>{first});
        db.store.recordTracking({}, std::vector<TrialTracking>{again});
        db.store.record(fixtures::answer(db.plan.trials[1], 4), db.study, db.plan, fixtures::clips(db.plan));

        auto reader = db.reader();
        SQLite::Statement row(reader, "SELECT * FROM trial_tracking");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("session").getInt64() == db.session);
        CHECK(row.getColumn("trial_index").getInt() == 1);
        CHECK(row.getColumn("frames").getInt() == 150);
        CHECK(row.getColumn("dropped_frames").getInt() == 3);
        CHECK(row.getColumn("samples_missing").getInt() == 5);
        CHECK(row.getColumn("max_off_place_m").getDouble() == 0.25);
        CHECK(row.getColumn("head_untracked_frames").getInt() == 10);
        CHECK(row.getColumn("first_display_time_s").getDouble() == 10.0);
        CHECK(row.getColumn("last_display_time_s").getDouble() == 20.5);
        CHECK_FALSE(row.executeStep());
        SQLite::Statement flat(reader,
                               "SELECT dropped_frames, samples_missing, max_off_place_m FROM responses_flat");
        REQUIRE(flat.executeStep());
        CHECK(flat.getColumn(0).getInt() == 3);
        CHECK(flat.getColumn(1).getInt() == 5);
        CHECK(flat.getColumn(2).getDouble() == 0.25);
    }

    TEST_CASE("What the station says of itself is kept by name") {
        auto info = fixtures::session("P01", false);
        info.station.properties = {{"runtime", "Monado"}, {"refresh_rate_hz", "90"}};
        const Begun db(info);
        auto reader = db.reader();
        SQLite::Statement row(reader, "SELECT session, name, value FROM session_properties ORDER BY name");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn(0).getInt64() == db.session);
        CHECK(row.getColumn(1).getString() == "refresh_rate_hz");
        CHECK(row.getColumn(2).getString() == "90");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn(2).getString() == "Monado");
        CHECK_FALSE(row.executeStep());
    }

    TEST_CASE("A frame number comes once in a session, in order, and no frame without a session") {
        Begun db;
        const std::vector<TrackedFrame> twice{{fixtures::frame(1), -1}, {fixtures::frame(1), -1}};
        CHECK_THROWS_AS(db.store.recordTracking(twice, {}), std::logic_error);
        CHECK(db.reader().execAndGet("SELECT count(*) FROM tracking_blocks").getInt() == 0);
        // A rejected batch leaves the store usable.
        db.store.recordTracking(std::span(twice).first(1), {});
        CHECK(db.reader().execAndGet("SELECT count(*) FROM tracking_blocks").getInt() == 1);
        CHECK_THROWS_AS(db.store.recordTracking(std::span(twice).first(1), {}), std::logic_error);
        db.store.endSession(studies::SessionOutcome::finished, 1.7e9 + 9.0);
        CHECK_THROWS_AS(db.store.recordTracking(std::span(twice).first(1), {}), std::logic_error);
        // The next session counts again.
        db.store.beginSession(fixtures::session("P01", false));
        db.store.recordTracking(std::span(twice).first(1), {});
        CHECK(db.reader().execAndGet("SELECT count(*) FROM tracking_blocks").getInt() == 2);
    }
}
