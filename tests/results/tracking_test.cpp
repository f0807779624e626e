// Tracking samples, the trials' tallies and the station's properties, as they lie in the database.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "fixtures.hpp"

using namespace deixis;
using results::Store;
using results::TrackedFrame;
using results::TrialTracking;

namespace {

/// A pose all of whose seven numbers differ from those of every other `seed`; not a unit quaternion, which
/// the store need not care about.
Pose numbered(int seed) {
    const double base = 10.0 * seed;
    return {{base + 0.5, base + 1.5, base + 2.5}, Quat(base + 3.5, base + 4.5, base + 5.5, base + 6.5)};
}

const std::array<const char*, 7> pose_columns{"x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"};

void checkPose(SQLite::Statement& row, const std::string& name, int validity, int seed, bool position,
               bool orientation) {
    INFO(name);
    CHECK(row.getColumn((name + "_validity").c_str()).getInt() == validity);
    for (int i = 0; i < 7; ++i) {
        const auto column = row.getColumn((name + "_" + pose_columns[static_cast<std::size_t>(i)]).c_str());
        const bool there = i < 3 ? position : orientation;
        CHECK(column.isNull() == !there);
        if (there) CHECK(column.getDouble() == 10.0 * seed + 0.5 + i);
    }
}

/// A database with a session of P01 under way.
struct Begun {
    fixtures::Folder folder;
    studies::Study study = fixtures::study({"direct"});
    studies::StudyPlan plan = fixtures::plan(study, "P01", 1);
    Store store = fixtures::open(folder / "a.sqlite");
    long long session = 0;

    explicit Begun(const results::SessionInfo& info = fixtures::session("P01", false)) {
        REQUIRE(store.storePlan(study, plan));
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

}  // namespace

TEST_SUITE("results/tracking") {
    TEST_CASE("A frame is kept with every number that was measured, and NULL where none was valid") {
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
        SQLite::Statement row(reader, "SELECT * FROM tracking ORDER BY frame");
        REQUIRE(row.executeStep());
        CHECK(row.getColumnCount() == 9 + 6 * 8);
        CHECK(row.getColumn("session").getInt64() == db.session);
        CHECK(row.getColumn("frame").getInt() == 4242);
        CHECK(row.getColumn("trial_index").getInt() == 2);
        CHECK(row.getColumn("display_time_s").getDouble() == 100.125);
        CHECK(row.getColumn("begun_s").getDouble() == 100.0625);
        CHECK(row.getColumn("submitted_s").getDouble() == 100.09375);
        CHECK(row.getColumn("dropped_frames").getInt() == 3);
        CHECK(row.getColumn("rendered").getInt() == 0);
        CHECK(row.getColumn("off_place_m").getDouble() == 0.375);
        checkPose(row, "head", 7, 1, true, true);
        checkPose(row, "left_aim", 6, 2, false, true);
        checkPose(row, "right_aim", 3, 3, true, true);
        checkPose(row, "left_grip", 0, 4, false, false);
        checkPose(row, "right_grip", 5, 5, true, false);
        checkPose(row, "gaze", 7, 6, true, true);
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("trial_index").isNull());
        CHECK(row.getColumn("rendered").getInt() == 1);
        CHECK(row.getColumn("left_aim_validity").getInt() == 0);
        CHECK(row.getColumn("gaze_validity").isNull());
        CHECK(row.getColumn("gaze_qw").isNull());
        CHECK_FALSE(row.executeStep());
        CHECK(reader.execAndGet("SELECT count(*) FROM hand_joints").getInt() == 0);
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
        db.store.record(fixtures::answer(db.plan.trials[1], 4), db.plan, fixtures::clips(db.plan));

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

    TEST_CASE("A frame number comes once in a session, and no frame without one") {
        Begun db;
        const std::vector<TrackedFrame> twice{{fixtures::frame(1), -1}, {fixtures::frame(1), -1}};
        CHECK_THROWS_AS(db.store.recordTracking(twice, {}), SQLite::Exception);
        CHECK(db.reader().execAndGet("SELECT count(*) FROM tracking").getInt() == 0);
        // A refused batch leaves the store usable.
        db.store.recordTracking(std::span(twice).first(1), {});
        CHECK(db.reader().execAndGet("SELECT count(*) FROM tracking").getInt() == 1);
        db.store.endSession("finished", 1.7e9 + 9.0);
        CHECK_THROWS_AS(db.store.recordTracking(std::span(twice).first(1), {}), std::logic_error);
    }
}
