// Tracked frames, packed and unpacked.
#include "results/database/tracking_blocks.hpp"

#include <doctest/doctest.h>
#include <zlib.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/random.hpp"

using namespace deixis;
using results::packTracking;
using results::unpackTracking;
using studies::TrackedPose;
using studies::TrackingSample;

namespace {

constexpr double half_microsecond = 0.5001e-6;
constexpr double half_position = 0.5001 / 65536.0;
constexpr double half_turn = 0.5001 / 32768.0;

TrackedPose randomPose(Random& random) {
    TrackedPose out;
    // Numbers stand there whether they are valid or not.
    out.stage_from_device.position = {random.normal(0.0, 2.0), random.normal(1.5, 1.0),
                                      random.normal(0.0, 2.0)};
    const glm::dvec4 q =
        glm::normalize(glm::dvec4(random.normal(), random.normal(), random.normal(), random.normal() + 0.01));
    out.stage_from_device.orientation = Quat(q.w, q.x, q.y, q.z);
    out.position_valid = random.below(4) != 0;
    out.orientation_valid = random.below(4) != 0;
    out.tracked = random.below(4) != 0;
    return out;
}

/// Frames with gaps, jumps in time, and anything valid or not.
std::vector<TrackingSample> randomSamples(Random& random, std::size_t count) {
    std::vector<TrackingSample> out;
    std::uint64_t frame = random.below(1U << 20U);
    double time_s = random.uniform(0.0, 1e6);
    const bool with_gaze = random.below(2) == 0;
    for (std::size_t i = 0; i < count; ++i) {
        frame += 1 + (random.below(8) == 0 ? random.below(5000) : 0);
        time_s += random.uniform(0.0, 0.03);
        TrackingSample& sample = out.emplace_back();
        sample.frame = frame;
        sample.display_time_s = time_s;
        sample.begun_s = time_s - random.uniform(0.0, 0.05);
        sample.submitted_s = time_s + random.uniform(-0.02, 0.02);
        sample.dropped_frames = random.below(10) == 0 ? static_cast<int>(random.below(100)) : 0;
        sample.rendered = random.below(10) != 0;
        sample.off_place_m = random.uniform(0.0, 3.0);
        sample.head = randomPose(random);
        sample.aim = {randomPose(random), randomPose(random)};
        sample.grip = {randomPose(random), randomPose(random)};
        if (with_gaze && random.below(5) != 0) sample.gaze = randomPose(random);
    }
    return out;
}

void checkSame(const TrackedPose& got, const TrackedPose& put) {
    CHECK(got.position_valid == put.position_valid);
    CHECK(got.orientation_valid == put.orientation_valid);
    CHECK(got.tracked == put.tracked);
    const Pose expected{put.position_valid ? put.stage_from_device.position : Vec3(0.0),
                        put.orientation_valid ? put.stage_from_device.orientation : no_rotation};
    const Pose& found = got.stage_from_device;
    for (int i = 0; i < 3; ++i) CHECK(std::abs(found.position[i] - expected.position[i]) <= half_position);
    for (int i = 0; i < 4; ++i) CHECK(std::abs(found.orientation[i] - expected.orientation[i]) <= half_turn);
}

void checkSame(const TrackingSample& got, const TrackingSample& put) {
    CHECK(got.frame == put.frame);
    CHECK(std::abs(got.display_time_s - put.display_time_s) <= half_microsecond);
    CHECK(std::abs(got.begun_s - put.begun_s) <= half_microsecond);
    CHECK(std::abs(got.submitted_s - put.submitted_s) <= half_microsecond);
    CHECK(got.dropped_frames == put.dropped_frames);
    CHECK(got.rendered == put.rendered);
    CHECK(std::abs(got.off_place_m - put.off_place_m) <= half_position);
    checkSame(got.head, put.head);
    for (std::size_t hand = 0; hand < 2; ++hand) {
        checkSame(got.aim[hand], put.aim[hand]);
        checkSame(got.grip[hand], put.grip[hand]);
    }
    REQUIRE(got.gaze.has_value() == put.gaze.has_value());
    if (got.gaze) checkSame(*got.gaze, *put.gaze);
}

std::string deflated(const std::string& raw) {
    uLongf size = compressBound(raw.size());
    std::string out(size, '\0');
    REQUIRE(::compress(reinterpret_cast<Bytef*>(out.data()), &size,
                       reinterpret_cast<const Bytef*>(raw.data()), raw.size()) == Z_OK);
    out.resize(size);
    return out;
}

std::string inflated(const std::string& data) {
    std::string out(100'000, '\0');
    uLongf size = out.size();
    REQUIRE(::uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                         reinterpret_cast<const Bytef*>(data.data()), data.size()) == Z_OK);
    out.resize(size);
    return out;
}

}  // namespace

TEST_SUITE("results/tracking blocks") {
    TEST_CASE("What is packed comes back to the stated precision, gaps, invalid poses and gaze included") {
        for (std::uint64_t seed = 1; seed <= 150; ++seed) {
            Random random(seed, "round trip");
            const auto samples = randomSamples(random, 1 + random.below(results::max_frames_in_block));
            const auto back = unpackTracking(packTracking(samples));
            REQUIRE(back);
            REQUIRE(back->size() == samples.size());
            for (std::size_t i = 0; i < samples.size(); ++i) checkSame((*back)[i], samples[i]);
        }
    }

    TEST_CASE("Packing what was unpacked gives the same bytes") {
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            Random random(seed, "fixed point");
            const std::string data = packTracking(randomSamples(random, 40));
            CHECK(packTracking(unpackTracking(data).value()) == data);
        }
    }

    TEST_CASE("A pose that cannot be kept is kept as not valid") {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        TrackingSample sample;
        sample.head = {{{nan, 1.0, 0.0}, no_rotation}, true, true, true};
        sample.aim[0] = {{{0.0, 1.0, 0.0}, Quat(1.0, 0.0, nan, 0.0)}, true, true, false};
        sample.aim[1] = {{{0.0, 1e30, 0.0}, no_rotation}, true, true, true};
        const auto back = unpackTracking(packTracking(std::span(&sample, 1))).value();
        CHECK_FALSE(back[0].head.position_valid);
        CHECK(back[0].head.orientation_valid);
        CHECK(back[0].head.tracked);
        CHECK(back[0].aim[0].position_valid);
        CHECK_FALSE(back[0].aim[0].orientation_valid);
        CHECK_FALSE(back[0].aim[1].position_valid);
    }

    TEST_CASE("No block holds none or too many frames, or one at no time") {
        std::vector<TrackingSample> samples(results::max_frames_in_block + 1);
        CHECK_THROWS_AS(static_cast<void>(packTracking({})), std::invalid_argument);
        CHECK_THROWS_AS(static_cast<void>(packTracking(samples)), std::invalid_argument);
        samples.resize(1);
        samples[0].begun_s = std::numeric_limits<double>::infinity();
        CHECK_THROWS_AS(static_cast<void>(packTracking(samples)), std::invalid_argument);
    }

    TEST_CASE("Bytes that were cut or changed give an error") {
        Random random(7, "damage");
        const std::string data = packTracking(randomSamples(random, 64));
        for (std::size_t length = 0; length < data.size(); length += 7) {
            const auto cut = unpackTracking(std::string_view(data).substr(0, length));
            REQUIRE_FALSE(cut);
            CHECK_FALSE(cut.error().message.empty());
        }
        CHECK_FALSE(unpackTracking(data + "x"));
        // zlib's own checksum tells, whatever the changed bit was.
        for (int i = 0; i < 3000; ++i) {
            std::string changed = data;
            changed[random.below(data.size())] ^= static_cast<char>(1U << random.below(8));
            const auto read = unpackTracking(changed);
            // A bit of the header that says how hard the compressor tried may change nothing.
            if (read) CHECK(packTracking(*read) == data);
        }
    }

    TEST_CASE("Whatever was deflated, reading it gives frames or an error") {
        Random random(8, "fuzz");
        const std::string raw = inflated(packTracking(randomSamples(random, 20)));
        int rejected = 0;
        for (int i = 0; i < 20'000; ++i) {
            std::string changed = raw;
            for (std::uint64_t n = random.below(6); n > 0; --n)
                changed[random.below(changed.size())] = static_cast<char>(random.below(256));
            if (random.below(4) == 0) changed.resize(random.below(changed.size() + 1));
            if (random.below(8) == 0) changed += static_cast<char>(random.below(256));
            const auto read = unpackTracking(deflated(changed));
            if (!read) ++rejected;
            if (changed == raw) CHECK(read.has_value());
        }
        CHECK(rejected > 5000);
        CHECK(rejected < 20'000);
        // A small stream that grows too large, and numbers longer than 64 bits.
        CHECK_FALSE(unpackTracking(deflated(std::string(10'000'000, '\0'))));
        CHECK_FALSE(unpackTracking(deflated(std::string("\x01\x01") + std::string(600, '\xFF'))));
        CHECK_FALSE(unpackTracking(deflated(std::string("\x02\x01") + std::string(55, '\0'))));
        CHECK(unpackTracking(deflated(std::string("\x01\x01") + std::string(55, '\0'))));
        CHECK_FALSE(unpackTracking(deflated(std::string("\x01\x01") + std::string(54, '\0'))));
        CHECK_FALSE(unpackTracking(deflated(std::string("\x01\x41") + std::string(55 * 65, '\0'))));
    }
}
