// Files that are broken or hostile: each ends in a clear message, none in a crash.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "assets/gltf/gltf_clip.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "paths.hpp"
#include "tiny_gltf_file.hpp"

using namespace deixis;
using tests::TinyGltf;

namespace {

const std::string single_node = R"("nodes":[{"name":"a"}])";

std::string errorOf(const std::string& bytes) {
    const auto file = assets::parseGltfClip(bytes, "f.glb");
    REQUIRE_FALSE(file.has_value());
    return file.error().text();
}

void checkError(const std::string& bytes, const std::string& words) {
    const std::string error = errorOf(bytes);
    INFO(error);
    CHECK(error.find(words) != std::string::npos);
    CHECK(error.rfind("f.glb", 0) == 0);
}

/// A file with one channel whose accessors the test gives. (Copied here: all arguments have been made by
/// then.)
std::string animated(const TinyGltf& file, int input, int output, const char* interpolation = "LINEAR",
                     const char* path = "translation") {
    TinyGltf gltf = file;
    gltf.animate(0, path, input, output, interpolation);
    return gltf.glb(single_node);
}

std::string goodFile() {
    TinyGltf gltf;
    gltf.animate(0, "translation", gltf.times({0, 1, 2}), gltf.vectors({0, 0, 0, 2, 0, 0, 2, 4, 0}));
    gltf.animate(1, "rotation", gltf.times({0, 2}),
                 gltf.add<std::int16_t>({0, 0, 0, 32767, 23170, 0, 0, 23170}, "VEC4", 5122, 4,
                                        R"(,"normalized":true)"),
                 "STEP");
    const int indices = gltf.addView<std::uint8_t>({1});
    const int values = gltf.addView<float>({1, 1, 2});
    const int sparse = gltf.addAccessor(fmt::format(
        R"("componentType":5126,"count":6,"type":"VEC3","sparse":{{"count":1,"indices":{{"bufferView":{},"componentType":5121}},"values":{{"bufferView":{}}}}})",
        indices, values));
    gltf.animate(1, "scale", gltf.times({0, 2}), sparse, "CUBICSPLINE");
    return gltf.glb(
        R"("nodes":[{"name":"hips","children":[1],"mesh":0,"skin":0},{"name":"head","translation":[0,1,0],"children":[2]},{"name":"head_end"}],)"
        R"("meshes":[{}],"skins":[{"joints":[0,1],"skeleton":0}],"extensions":{"VRMC_vrm":{"humanoid":{"humanBones":{"hips":{"node":0},"head":{"node":1}}}}})");
}

/// What a result must keep, whatever the file was.
void checkInvariants(const assets::GltfClipFile& file) {
    const auto& joints = file.clip.skeleton.joints;
    REQUIRE_FALSE(joints.empty());
    REQUIRE_FALSE(file.clip.frames.empty());
    REQUIRE(file.clip.frame_time_s > 0.0);
    for (std::size_t j = 0; j < joints.size(); ++j) REQUIRE(joints[j].parent < static_cast<int>(j));
    for (const auto& frame : file.clip.frames) {
        REQUIRE(frame.joints.size() == joints.size());
        for (const Pose& pose : frame.joints) {
            REQUIRE(std::isfinite(pose.position.x + pose.position.y + pose.position.z));
            REQUIRE(std::abs(glm::length(pose.orientation) - 1.0) < 1e-6);
        }
    }
}

}  // namespace

TEST_SUITE("assets/gltf_safety") {
    TEST_CASE("Files of another kind, of another version, and cut ones are told apart") {
        checkError("", "neither a glTF binary nor glTF text");
        checkError("HIERARCHY\nROOT hips", "neither a glTF binary nor glTF text");
        checkError("{\"nodes\":", "no readable JSON");
        checkError("{}", "has no \"asset\"");
        checkError(R"({"asset":{"version":"1.0"}})", "version 1.0, expected 2.0");
        checkError(R"({"asset":{"version":"2.0"}})", "no nodes");
        const std::string good = goodFile();
        REQUIRE(assets::parseGltfClip(good, "f.glb").has_value());
        for (std::size_t length = 4; length < good.size(); length += 7)
            checkError(good.substr(0, length), "f.glb");
        std::string long_chunk = good;
        long_chunk[15] = '\x7F';
        checkError(long_chunk, "claims");
        std::string version = good;
        version[4] = 1;
        checkError(version, "version 1, expected 2");
        const auto missing = assets::readGltfClip("/nowhere/f.glb");
        REQUIRE_FALSE(missing.has_value());
        CHECK(missing.error().text().find("/nowhere/f.glb") != std::string::npos);
    }

    TEST_CASE("Every wrong type and reference is named with its place") {
        const auto with = [](const std::string& members) { return TinyGltf().json(members); };
        checkError(with(R"("nodes":{})"), "f.glb: /nodes: found object, expected an array");
        checkError(with(R"("nodes":[{"translation":[0,1]}])"),
                   "/nodes/0/translation: found array, expected an array of 3");
        checkError(with(R"("nodes":[{"translation":[0,"x",1]}])"),
                   "/nodes/0/translation/1: found string, expected a number");
        checkError(with(R"("nodes":[{"rotation":[0,0,0,0]}])"), "quaternion of length 0");
        checkError(with(R"("nodes":[{"children":[3]}])"),
                   "/nodes/0/children/0: node 3 does not exist; the file has 1");
        checkError(with(R"("nodes":[{"children":[-1]}])"), "found -1, expected a whole number");
        checkError(with(R"("nodes":[{"children":[0.5]}])"), "found 0.5, expected a whole number");
        checkError(with(R"("nodes":[{"translation":[1e999,0,0]}])"), "no readable JSON");
        checkError(with(R"("nodes":[{"matrix":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]}])"), "flattens space");
        checkError(with(R"("nodes":[{"matrix":[1,0,0,0,1,1,0,0,0,0,1,0,0,0,0,1]}])"), "shears");
        checkError(with(R"("nodes":[{"translation":[1e300,0,0]}])"), "expected a figure");
        checkError(with(R"("nodes":[{}],"skins":[{}])"), "/skins/0: has no \"joints\"");
        checkError(
            with(R"("nodes":[{}],"extensions":{"VRMC_vrm":{"humanoid":{"humanBones":{"hips":{"node":4}}}}})"),
            "node 4 does not exist");
        checkError(with(R"("nodes":[{}],"extensionsRequired":["KHR_materials_unlit","ACME_secret_nodes"])"),
                   "requires the extension ACME_secret_nodes");
    }

    TEST_CASE("A skin without joints and an animation without channels leave the nodes as they are") {
        const auto file = assets::parseGltfClip(
            TinyGltf().json(
                R"("nodes":[{"name":"a"}],"skins":[{"joints":[]}],"animations":[{"samplers":[],"channels":[]}])"),
            "f.glb");
        REQUIRE(file.has_value());
        CHECK(file->clip.skeleton.size() == 1);
        checkInvariants(*file);
    }

    TEST_CASE("Nodes that form a ring, or have two parents, are rejected") {
        checkError(TinyGltf().json(R"("nodes":[{"children":[1]},{"children":[2]},{"children":[1]}])"),
                   "already");
        checkError(TinyGltf().json(R"("nodes":[{"children":[1]},{"children":[0]}])"), "its own ancestor");
        checkError(TinyGltf().json(R"("nodes":[{},{"children":[1]}])"), "its own ancestor");
    }

    TEST_CASE("Deep JSON, deep hierarchies and a million nodes end in a message or a clip") {
        checkError(std::string(100'000, '{'), "nests deeper");
        checkError(R"({"asset":{"version":"2.0","extras":)" + std::string(1'000'000, '['), "nests deeper");
        std::string many = R"({"asset":{"version":"2.0"},"nodes":[{})";
        for (int i = 1; i < 1'000'000; ++i) many += ",{}";
        checkError(many + "]}", "1000000 nodes, expected at most 65536");
        checkError(R"({"asset":{"version":"2.0"},"x":[0)" +
                       [] {
                           std::string zeros;
                           for (int i = 0; i < 3'000'000; ++i) zeros += ",0";
                           return zeros;
                       }() +
                       "]}",
                   "more than 3000000 values");
        std::string chain = R"({"asset":{"version":"2.0"},"nodes":[)";
        constexpr int length = 60'000;
        for (int i = 0; i + 1 < length; ++i) chain += fmt::format(R"({{"children":[{}]}},)", i + 1);
        const auto file = assets::parseGltfClip(chain + "{}]}", "f.gltf");
        REQUIRE(file.has_value());
        CHECK(file->clip.skeleton.size() == length);
    }

    TEST_CASE("Buffers, views and accessors out of range are named") {
        TinyGltf gltf;
        const int times = gltf.times({0, 1});
        const int values = gltf.vectors({0, 0, 0, 1, 1, 1});
        const auto accessor = [&](const std::string& members) {
            TinyGltf copy = gltf;
            const int bad = copy.addAccessor(members);
            return animated(copy, times, bad);
        };
        checkError(accessor(R"("bufferView":1,"componentType":5126,"count":3,"type":"VEC3")"),
                   "3 values for 2 times");
        checkError(accessor(R"("bufferView":1,"byteOffset":4,"componentType":5126,"count":2,"type":"VEC3")"),
                   "exceed buffer view 1 of 24 bytes");
        checkError(accessor(R"("bufferView":7,"componentType":5126,"count":2,"type":"VEC3")"),
                   "buffer view 7 does not exist");
        checkError(accessor(R"("bufferView":1,"componentType":5124,"count":2,"type":"VEC3")"),
                   "component type 5124");
        checkError(accessor(R"("bufferView":1,"componentType":5126,"count":2,"type":"VEC9")"), "type VEC9");
        checkError(
            accessor(
                R"("bufferView":1,"byteOffset":9007199254740991,"componentType":5126,"count":2,"type":"VEC3")"),
            "exceed buffer view");
        checkError(accessor(R"("bufferView":1,"componentType":5123,"count":2,"type":"VEC3")"),
                   "expected VEC3 of 5126");
        const std::string huge =
            R"("bufferView":1,"componentType":5126,"count":9007199254740991,"type":"SCALAR","min":[0],"max":[1])";
        TinyGltf overflow = gltf;
        checkError(animated(overflow, overflow.addAccessor(huge), values), "expected 1 to 10000000");
        TinyGltf view = gltf;
        checkError(view.glb(R"("nodes":[{}],"bufferViews":[{"buffer":3,"byteLength":4}])"),
                   "buffer 3 does not exist");
        checkError(
            TinyGltf().json(
                R"("nodes":[{}],"buffers":[{"byteLength":8}],"bufferViews":[{"buffer":0,"byteLength":8}],)"
                R"("accessors":[{"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR"},{"count":2,"type":"VEC3","componentType":5126}],"animations":[{"samplers":[{"input":0,"output":1}],"channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}]}])"),
            "has no data");
    }

    TEST_CASE("Sparse indices must rise and stay in range") {
        const auto file = [](const std::vector<std::uint8_t>& indices, int count, int index_type) {
            TinyGltf gltf;
            const int times = gltf.times({0, 1});
            const int index_view = gltf.addView<std::uint8_t>(indices);
            const int value_view = gltf.addView<float>({1, 2, 3, 4, 5, 6});
            const int values = gltf.addAccessor(fmt::format(
                R"("componentType":5126,"count":2,"type":"VEC3","sparse":{{"count":{},"indices":{{"bufferView":{},"componentType":{}}},"values":{{"bufferView":{}}}}})",
                count, index_view, index_type, value_view));
            return animated(gltf, times, values);
        };
        CHECK(assets::parseGltfClip(file({0, 1}, 2, 5121), "f.glb").has_value());
        checkError(file({0, 2}, 2, 5121), "sparse index 1 is 2, expected 1 to 1");
        checkError(file({1, 1}, 2, 5121), "sparse index 1 is 1, expected 2 to 1");
        checkError(file({0, 1, 2}, 3, 5121), "replaces 3 of 2 elements");
        checkError(file({0, 1}, 2, 5126), "sparse indices of component type 5126");
        checkError(file({0, 1}, 2, 5125), "exceed buffer view");
    }

    TEST_CASE("Times must be finite, rise, and begin at 0 or later") {
        const auto file = [](const std::vector<float>& times, const char* interpolation = "LINEAR") {
            TinyGltf gltf;
            const int input = gltf.add(times, "SCALAR", 5126, 1, R"(,"min":[0],"max":[1])");
            std::vector<float> values(times.size() * 3 * (interpolation[0] == 'C' ? 3 : 1), 0.0F);
            return animated(gltf, input, gltf.vectors(values), interpolation);
        };
        checkError(file({0, 1, 1}), "time 1 is 1 s and time 2 is 1 s, expected a later one");
        checkError(file({0, 2, 1}), "expected a later one");
        checkError(file({-1, 2}), "begins at -1 s");
        checkError(file({0, std::numeric_limits<float>::quiet_NaN()}), "element 1 is nan");
        checkError(file({0, std::numeric_limits<float>::infinity()}), "element 1 is inf");
        checkError(file({0, 1e30F}), "expected 1000000 s or earlier");
        checkError(file({0}, "CUBICSPLINE"), "cubic spline of one key");
        checkError(file({0, 900'000}), "stretch over");
    }

    TEST_CASE("Values that are no numbers or no rotations are rejected") {
        TinyGltf gltf;
        const int times = gltf.times({0, 1});
        const float no_number = std::numeric_limits<float>::quiet_NaN();
        checkError(animated(gltf, times, 1), "does not exist");
        TinyGltf odd = gltf;
        const int values = odd.vectors({0, 0, 0, 0, no_number, 0});
        checkError(animated(odd, times, values), "element 1 is nan");
        TinyGltf zero = gltf;
        const int rotations = zero.quaternions({0, 0, 0, 1, 0, 0, 0, 0});
        checkError(animated(zero, times, rotations, "LINEAR", "rotation"), "the rotation of key 1");
        checkError(animated(zero, times, rotations, "BEZIER", "rotation"), "found \"BEZIER\", expected STEP");
        checkError(animated(zero, rotations, rotations, "LINEAR", "rotation"), "times of type VEC4");
    }

    TEST_CASE("Buffers are read from the file's own folder and from data URIs alone") {
        const std::filesystem::path folder = deixis::tests::buildDir() / "gltf_uri_test";
        std::filesystem::remove_all(folder);
        const std::string two_floats("\0\0\0\0\0\0\x80\x3F", 8);  // 0 and 1 s
        REQUIRE(writeFile(folder / "inside" / "my data.bin", two_floats + std::string(24, '\0')).has_value());
        REQUIRE(writeFile(folder / "secret.bin", std::string(64, '\0')).has_value());
        std::filesystem::create_symlink(folder / "secret.bin", folder / "inside" / "link.bin");
        const auto with = [&](const std::string& uri, int length = 32) {
            return fmt::format(
                R"({{"asset":{{"version":"2.0"}},"nodes":[{{"name":"a"}}],"buffers":[{{"uri":"{}","byteLength":{}}}],)"
                R"("bufferViews":[{{"buffer":0,"byteLength":8}},{{"buffer":0,"byteOffset":8,"byteLength":24}}],)"
                R"("accessors":[{{"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]}},)"
                R"({{"bufferView":1,"componentType":5126,"count":2,"type":"VEC3"}}],)"
                R"("animations":[{{"samplers":[{{"input":0,"output":1}}],"channels":[{{"sampler":0,"target":{{"node":0,"path":"translation"}}}}]}}]}})",
                uri, length);
        };
        const auto read = [&](const std::string& text) {
            REQUIRE(writeFile(folder / "inside" / "f.gltf", text).has_value());
            return assets::readGltfClip(folder / "inside" / "f.gltf");
        };
        CHECK(read(with("my data.bin")).has_value());
        CHECK(read(with("my%20data.bin")).has_value());
        CHECK(read(with("./my%20data.bin")).has_value());
        CHECK(read(with("data:application/octet-stream;base64,AAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA="))
                  .has_value());
        const auto rejected = [&](const std::string& uri, const std::string& words, int length = 32) {
            const auto file = read(with(uri, length));
            CAPTURE(uri);
            REQUIRE_FALSE(file.has_value());
            INFO(file.error().text());
            CHECK(file.error().text().find(words) != std::string::npos);
            CHECK(file.error().text().find("f.gltf: /buffers/0/uri") != std::string::npos);
        };
        rejected("../secret.bin", "leaves the folder");
        rejected("%2e%2e/secret.bin", "leaves the folder");
        rejected("a/%2e./../secret.bin", "leaves the folder");
        rejected("..%5csecret.bin", "backslash");
        rejected((folder / "secret.bin").string(), "absolute path");
        rejected("%2Fetc%2Fpasswd", "absolute path");
        rejected("file:///etc/passwd", "scheme");
        rejected("http://example.org/a.bin", "scheme");
        rejected("C:secret.bin", "scheme or a drive");
        rejected("a%00.bin", "control character");
        rejected("a%2", "two hexadecimal digits");
        rejected("", "is empty");
        rejected("link.bin", "link that leaves");
        rejected("nothing.bin", "does not exist");
        rejected(".", "does not exist");
        rejected("my data.bin", "has 32 bytes, expected 33 or more", 33);
        const auto unused = read(
            R"({"asset":{"version":"2.0"},"nodes":[{"name":"a"}],"buffers":[{"uri":"../x.bin","byteLength":1}]})");
        REQUIRE_FALSE(unused.has_value());
        CHECK(unused.error().text().find("leaves the folder") != std::string::npos);
        rejected("data:text/plain,hello", "base64");
        rejected("data:;base64,AA!A", "not a base64 digit");
        CHECK_FALSE(assets::parseGltfClip(with("my data.bin"), "f.gltf").has_value());
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("No flipped byte makes the reader crash, or hand on a clip that breaks its promises") {
        const std::string good = goodFile();
        Random random(7);
        int rejected = 0;
        for (int i = 0; i < 600; ++i) {
            std::string bytes = good;
            const std::size_t flips = 1 + random.below(3);
            for (std::size_t f = 0; f < flips; ++f) {
                const std::size_t at = random.below(bytes.size());
                switch (random.below(4)) {
                    case 0:
                        bytes[at] ^= static_cast<char>(1U << random.below(8));
                        break;
                    case 1:
                        bytes[at] = static_cast<char>('0' + random.below(10));
                        break;
                    case 2:
                        bytes.erase(at, 1 + random.below(4));
                        break;
                    default:
                        bytes[at] = bytes[random.below(bytes.size())];
                }
            }
            const auto file = assets::parseGltfClip(bytes, "f.glb");
            if (file)
                checkInvariants(*file);
            else
                ++rejected;
        }
        CHECK(rejected > 100);
        CHECK(rejected < 600);
    }
}
