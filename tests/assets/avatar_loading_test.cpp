#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "paths.hpp"

using namespace deixis;

namespace {

std::string goodFile() {
    const auto bytes = readFile(deixis::tests::buildDir() / "share/deixis/avatar.glb");
    REQUIRE(bytes.has_value());
    return *bytes;
}

/// Loads bytes by way of a file.
Result<assets::Avatar> load(const std::string& bytes) {
    const auto path = deixis::tests::buildDir() / "avatar_loading_test.glb";
    REQUIRE(writeFile(path, bytes).has_value());
    return assets::loadAvatar(path);
}

std::uint32_t number(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// Where the binary chunk's content starts (glTF 2.0, section 4.4).
std::size_t binaryStart(const std::string& bytes) {
    return 12 + 8 + number(bytes, 12) + 8;
}

/// Replaces text of the JSON chunk by text of the same length.
std::string edited(std::string bytes, const std::string& from, const std::string& to) {
    REQUIRE(from.size() == to.size());
    const std::size_t at = bytes.find(from);
    REQUIRE(at < binaryStart(bytes));
    return bytes.replace(at, from.size(), to);
}

void checkError(const Result<assets::Avatar>& result, const std::string& words) {
    REQUIRE_FALSE(result.has_value());
    INFO(result.error().text());
    CHECK(result.error().text().find(words) != std::string::npos);
    CHECK(result.error().where.find(".glb") != std::string::npos);
}

}  // namespace

TEST_SUITE("assets/avatar_loading") {
    TEST_CASE("a missing file is named") {
        const auto result = assets::loadAvatar("/nowhere/avatar.glb");
        REQUIRE_FALSE(result.has_value());
        CHECK(result.error().text().find("/nowhere/avatar.glb") != std::string::npos);
    }

    TEST_CASE("a file of another kind is rejected by its first letters") {
        checkError(load("HIERARCHY\nROOT hips\n{\n}\n"), "neither a glTF binary nor glTF text");
        checkError(load(""), "neither a glTF binary nor glTF text");
    }

    TEST_CASE("broken JSON is an error, not an exception") {
        std::string bytes = goodFile();
        bytes[20] = '!';
        checkError(load(bytes), "no readable JSON");
    }

    TEST_CASE("a mesh without a skin is rejected") {
        checkError(load(edited(goodFile(), R"("mesh":0,"skin":0)", R"("mesh":0,"skim":0)")), "skin");
        checkError(load(edited(goodFile(), R"("mesh":0,"skin":0)", R"("mesh":0,"skin":7)")), "7");
    }

    TEST_CASE("a mesh without weights is rejected") {
        checkError(load(edited(goodFile(), "WEIGHTS_0", "WEIGHTS_7")), "WEIGHTS_0");
    }

    TEST_CASE("a scaled bone is rejected") {
        std::string bytes = goodFile();
        const std::string from = R"("name":"head","translation")";
        const std::string to = R"("name":"head","scale"      )";
        checkError(load(edited(bytes, from, to)), "head");
    }

    TEST_CASE("places and weights that are no numbers, and joints and indices out of range, are found") {
        const std::string good = goodFile();
        const auto avatar = load(good);
        REQUIRE(avatar.has_value());
        const std::size_t start = binaryStart(good);
        const std::size_t count = avatar->vertices.size();
        const std::size_t joints = start + 36 * count;  // after positions, normals and colours
        const std::size_t weights = joints + 4 * count;
        const std::size_t indices = weights + 16 * count;
        const float no_number = std::numeric_limits<float>::quiet_NaN();

        std::string bytes = good;
        std::memcpy(bytes.data() + start + 24, &no_number, sizeof no_number);
        checkError(load(bytes), "POSITION");

        bytes = good;
        bytes[joints + 8] = 55;
        checkError(load(bytes), "joint 55");

        bytes = good;
        const float half = 0.5F;
        for (std::size_t i = 0; i < 4; ++i) std::memcpy(bytes.data() + weights + 4 * i, &half, sizeof half);
        checkError(load(bytes), "sum to 2");

        bytes = good;
        const auto beyond = static_cast<std::uint32_t>(count);
        std::memcpy(bytes.data() + indices, &beyond, sizeof beyond);
        checkError(load(bytes), "out of range");
    }

    TEST_CASE("a file cut short anywhere is an error") {
        const std::string good = goodFile();
        Random random(1);
        for (int i = 0; i < 40; ++i) {
            const std::size_t length = i < 20 ? random.below(30) : random.below(good.size());
            CAPTURE(length);
            CHECK_FALSE(load(good.substr(0, length)).has_value());
        }
    }

    TEST_CASE("no flipped byte makes the reader crash, or hand on an avatar that breaks its promises") {
        const std::string good = goodFile();
        Random random(2);
        int rejected = 0;
        for (int i = 0; i < 150; ++i) {
            std::string bytes = good;
            const std::size_t range = i % 5 == 0 ? bytes.size() : binaryStart(bytes);
            for (int flips = 0; flips < 2; ++flips)
                bytes[random.below(range)] ^= static_cast<char>(1U << random.below(8));
            const auto result = load(bytes);
            if (!result) {
                ++rejected;
                continue;
            }
            REQUIRE(result->joint_from_bind.size() == result->skeleton.joints.size());
            for (const std::uint32_t index : result->indices) REQUIRE(index < result->vertices.size());
            for (const auto& v : result->vertices)
                for (std::size_t k = 0; k < 4; ++k) {
                    REQUIRE(v.joints[k] < result->skeleton.joints.size());
                    REQUIRE(std::isfinite(v.position[static_cast<int>(k % 3)]));
                }
        }
        CHECK(rejected > 20);
    }
}
