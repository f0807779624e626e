#include "assets/gltf/gltf_clip.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>

#include "tiny_gltf_file.hpp"

using namespace deixis;
using assets::GltfClipFile;
using assets::GltfClipOptions;
using doctest::Approx;
using tests::TinyGltf;

namespace {

const std::string one_node = R"("nodes":[{"name":"a"}])";

GltfClipFile parse(const std::string& bytes, const GltfClipOptions& options = {}) {
    auto file = assets::parseGltfClip(bytes, "f.glb", options);
    if (!file) FAIL(file.error().text());
    return std::move(*file);
}

GltfClipFile parseAt(const std::string& bytes, double fps) {
    GltfClipOptions options;
    options.fps = fps;
    return parse(bytes, options);
}

Vec3 positionOf(const GltfClipFile& file, std::size_t frame, std::size_t joint = 0) {
    return file.clip.frames.at(frame).joints.at(joint).position;
}

Quat rotationOf(const GltfClipFile& file, std::size_t frame, std::size_t joint = 0) {
    return file.clip.frames.at(frame).joints.at(joint).orientation;
}

Vec3 worldOf(const GltfClipFile& file, std::size_t frame, const char* joint) {
    const auto index = file.clip.skeleton.find(joint);
    REQUIRE(index >= 0);
    return motion::worldPose(file.clip.skeleton, file.clip.frames.at(frame))
        .at(static_cast<std::size_t>(index))
        .position;
}

void checkNear(const Vec3& found, const Vec3& expected, double tolerance = 1e-6) {
    INFO("found " << found.x << " " << found.y << " " << found.z);
    CHECK(glm::length(found - expected) < tolerance);
}

/// Degrees of the turn from `expected` to `found`.
double degreesOff(const Quat& found, const Quat& expected) {
    const Quat off = glm::conjugate(expected) * found;
    return degreesFromRadians(2.0 * std::atan2(glm::length(Vec3(off.x, off.y, off.z)), std::abs(off.w)));
}

Quat turn(double degrees, const Vec3& axis) {
    return glm::angleAxis(radiansFromDegrees(degrees), axis);
}

bool has(const GltfClipFile& file, const std::string& words) {
    for (const std::string& remark : file.remarks)
        if (remark.find(words) != std::string::npos) return true;
    for (const std::string& remark : file.remarks) MESSAGE(remark);
    return false;
}

const auto half = static_cast<float>(std::sqrt(0.5));

}  // namespace

TEST_SUITE("assets/gltf_clip") {
    TEST_CASE("Linear translations lie on the straight line between their keys") {
        TinyGltf gltf;
        gltf.animate(0, "translation", gltf.times({0, 1, 2}), gltf.vectors({0, 0, 0, 2, 0, 0, 2, 4, 0}));
        const auto file = parseAt(gltf.glb(one_node), 4);
        CHECK(file.clip.frameCount() == 9);
        checkNear(positionOf(file, 0), {0, 0, 0});
        checkNear(positionOf(file, 1), {0.5, 0, 0});
        checkNear(positionOf(file, 4), {2, 0, 0});
        checkNear(positionOf(file, 6), {2, 2, 0});
        checkNear(positionOf(file, 8), {2, 4, 0});
        CHECK(file.frame_rate == "4 fps (given)");
        CHECK(file.animation == "move");
        CHECK(file.unit == "metre (as in glTF)");
    }

    TEST_CASE("Linear rotations take the shorter arc, whatever the sign of the quaternions") {
        TinyGltf gltf;
        gltf.animate(0, "rotation", gltf.times({0, 1}), gltf.quaternions({0, 0, 0, 1, 0, 0, -half, -half}));
        const auto file = parseAt(gltf.glb(one_node), 3);
        for (std::size_t k = 0; k < 4; ++k)
            CHECK(degreesOff(rotationOf(file, k), turn(30.0 * static_cast<double>(k), {0, 0, 1})) < 1e-5);
    }

    TEST_CASE("A step holds its key until the next one") {
        TinyGltf gltf;
        gltf.animate(0, "translation", gltf.times({0, 1, 2}), gltf.vectors({1, 0, 0, 2, 0, 0, 3, 0, 0}),
                     "STEP");
        gltf.animate(0, "rotation", gltf.times({0, 1}), gltf.quaternions({0, 0, 0, 1, 0, 1, 0, 0}), "STEP");
        const auto file = parseAt(gltf.glb(one_node), 4);
        checkNear(positionOf(file, 3), {1, 0, 0});
        checkNear(positionOf(file, 4), {2, 0, 0});
        checkNear(positionOf(file, 7), {2, 0, 0});
        checkNear(positionOf(file, 8), {3, 0, 0});
        CHECK(degreesOff(rotationOf(file, 3), no_rotation) < 1e-6);
        CHECK(degreesOff(rotationOf(file, 4), turn(180, {0, 1, 0})) < 1e-6);
    }

    TEST_CASE("Tangents of a cubic spline are multiplied by the interval") {
        // Keys at 0 and 2 s: value 0 leaving with 1 a second, value 4 arriving with 3 a second. By hand, with
        // the Hermite basis of appendix C: x(0.5 s) = 0.28125 + 0.625 - 0.28125, x(1 s) = 0.25 + 2 - 0.75.
        TinyGltf gltf;
        gltf.animate(0, "translation", gltf.times({0, 2}),
                     gltf.vectors({9, 9, 9, 0, 0, 0, 1, 0, 0, 3, 0, 0, 4, 0, 0, 9, 9, 9}), "CUBICSPLINE");
        const auto file = parseAt(gltf.glb(one_node), 2);
        REQUIRE(file.clip.frameCount() == 5);
        checkNear(positionOf(file, 0), {0, 0, 0});
        checkNear(positionOf(file, 1), {0.625, 0, 0});
        checkNear(positionOf(file, 2), {1.5, 0, 0});
        checkNear(positionOf(file, 4), {4, 0, 0});
    }

    TEST_CASE("A cubic spline of rotations is brought back to unit length") {
        // With tangents 0 the weights at a quarter of the way are 0.84375 and 0.15625.
        TinyGltf gltf;
        gltf.animate(
            0, "rotation", gltf.times({0, 1}),
            gltf.quaternions({0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0}),
            "CUBICSPLINE");
        const auto file = parseAt(gltf.glb(one_node), 4);
        const double quarter = degreesFromRadians(2.0 * std::atan2(0.15625, 0.84375));
        CHECK(degreesOff(rotationOf(file, 1), turn(quarter, {0, 1, 0})) < 1e-6);
        CHECK(degreesOff(rotationOf(file, 2), turn(90, {0, 1, 0})) < 1e-6);
    }

    TEST_CASE("Rotations as normalised integers of each size are fractions") {
        const auto check = [](TinyGltf& gltf, int output, double tolerance) {
            gltf.animate(0, "rotation", gltf.times({0, 1}), output);
            const auto file = parseAt(gltf.glb(one_node), 1);
            CHECK(degreesOff(rotationOf(file, 0), no_rotation) < tolerance);
            CHECK(degreesOff(rotationOf(file, 1), turn(90, {1, 0, 0})) < tolerance);
        };
        const std::string normalised = R"(,"normalized":true)";
        TinyGltf words;
        check(words,
              words.add<std::int16_t>({0, 0, 0, 32767, 23170, 0, 0, 23170}, "VEC4", 5122, 4, normalised),
              0.01);
        TinyGltf bytes;
        check(bytes, bytes.add<std::int8_t>({0, 0, 0, 127, 90, 0, 0, 90}, "VEC4", 5120, 4, normalised), 0.01);
        TinyGltf unsigned_words;
        check(unsigned_words,
              unsigned_words.add<std::uint16_t>({0, 0, 0, 65535, 46341, 0, 0, 46341}, "VEC4", 5123, 4,
                                                normalised),
              0.01);
        TinyGltf unsigned_bytes;
        check(unsigned_bytes,
              unsigned_bytes.add<std::uint8_t>({0, 0, 0, 255, 180, 0, 0, 180}, "VEC4", 5121, 4, normalised),
              0.01);
    }

    TEST_CASE("The least signed integer is the fraction -1, not below it") {
        TinyGltf gltf;
        const int output =
            gltf.add<std::int8_t>({-128, 0, 0, 0, -127, 0, 0, 0}, "VEC4", 5120, 4, R"(,"normalized":true)");
        gltf.animate(0, "rotation", gltf.times({0, 1}), output);
        const auto file = parseAt(gltf.glb(one_node), 1);
        CHECK(degreesOff(rotationOf(file, 0), rotationOf(file, 1)) == 0.0);
        CHECK(file.remarks.empty());
    }

    TEST_CASE("Sparse elements replace zeros, or what the buffer view holds") {
        const auto accessor = [](TinyGltf& gltf, const std::string& view) {
            const int indices = gltf.addView<std::uint16_t>({1, 2});
            const int values = gltf.addView<float>({5, 6, 7, 8, 9, 10});
            return gltf.addAccessor(fmt::format(
                R"({}"componentType":5126,"count":3,"type":"VEC3","sparse":{{"count":2,"indices":{{"bufferView":{},)"
                R"("componentType":5123}},"values":{{"bufferView":{}}}}})",
                view, indices, values));
        };
        TinyGltf zeros;
        zeros.animate(0, "translation", zeros.times({0, 1, 2}), accessor(zeros, ""));
        const auto first = parseAt(zeros.glb(one_node), 1);
        checkNear(positionOf(first, 0), {0, 0, 0});
        checkNear(positionOf(first, 1), {5, 6, 7});
        checkNear(positionOf(first, 2), {8, 9, 10});
        TinyGltf over;
        const int base = over.addView<float>({1, 2, 3, 0, 0, 0, 0, 0, 0});
        over.animate(0, "translation", over.times({0, 1, 2}),
                     accessor(over, fmt::format(R"("bufferView":{},)", base)));
        const auto second = parseAt(over.glb(one_node), 1);
        checkNear(positionOf(second, 0), {1, 2, 3});
        checkNear(positionOf(second, 2), {8, 9, 10});
    }

    TEST_CASE("Times and values may stand interleaved in one buffer view") {
        TinyGltf gltf;
        const int view = gltf.addView<float>({0, 1, 2, 3, 1, 4, 5, 6}, R"(,"byteStride":16)");
        const int input = gltf.addAccessor(fmt::format(
            R"("bufferView":{},"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1])", view));
        const int output = gltf.addAccessor(fmt::format(
            R"("bufferView":{},"byteOffset":4,"componentType":5126,"count":2,"type":"VEC3")", view));
        gltf.animate(0, "translation", input, output);
        const auto file = parseAt(gltf.glb(one_node), 1);
        checkNear(positionOf(file, 0), {1, 2, 3});
        checkNear(positionOf(file, 1), {4, 5, 6});
        CHECK(has(file, "stride"));
    }

    TEST_CASE(
        "The clip begins at the first key of all; a channel is held before its first key and after its "
        "last") {
        TinyGltf gltf;
        gltf.animate(0, "translation", gltf.times({2, 3}), gltf.vectors({0, 0, 0, 1, 0, 0}));
        gltf.animate(1, "translation", gltf.times({1, 4}), gltf.vectors({0, 0, 0, 0, 3, 0}));
        const auto file = parseAt(gltf.glb(R"("nodes":[{"name":"a","children":[1]},{"name":"b"}])"), 2);
        REQUIRE(file.clip.frameCount() == 7);
        checkNear(positionOf(file, 1), {0, 0, 0});
        checkNear(positionOf(file, 3), {0.5, 0, 0});
        checkNear(positionOf(file, 6), {1, 0, 0});
        checkNear(positionOf(file, 6, 1), {0, 3, 0});
        CHECK(has(file, "first key is at 1 s"));
    }

    TEST_CASE("The frame rate is that of the keys") {
        const auto rateOf = [](const std::vector<float>& times) {
            TinyGltf gltf;
            std::vector<float> values;
            for (const float t : times) values.insert(values.end(), {t, 0, 0});
            gltf.animate(0, "translation", gltf.times(times), gltf.vectors(values));
            return parse(gltf.glb(one_node));
        };
        const auto every = [](double step, int count) {
            std::vector<float> times;
            for (int i = 0; i < count; ++i) times.push_back(static_cast<float>(i * step));
            return times;
        };
        for (const double fps : {15.0, 24.0, 25.0, 30.0, 60.0, 120.0}) {
            const auto file = rateOf(every(1.0 / fps, 200));
            CHECK(file.clip.frame_time_s == 1.0 / fps);
            CHECK(file.clip.frameCount() == 200);
            CHECK(file.remarks.empty());
        }
        CHECK(rateOf(every(1001.0 / 30000.0, 300)).clip.framesPerSecond() == Approx(29.97003).epsilon(1e-6));
        // Times rounded to milliseconds.
        const auto rounded = rateOf({0.0F, 0.033F, 0.067F, 0.1F, 0.133F, 0.167F, 0.2F});
        CHECK(rounded.clip.frame_time_s == 1.0 / 30.0);
        CHECK(rounded.clip.frameCount() == 7);
        checkNear(positionOf(rounded, 2), {0.067, 0, 0});
        // A key left out here and there.
        const auto thinned = rateOf({0.0F, 0.04F, 0.08F, 0.2F, 0.24F, 0.4F});
        CHECK(thinned.clip.frame_time_s == 1.0 / 25.0);
        CHECK(thinned.clip.frameCount() == 11);
        // Keys by hand, half a second apart.
        const auto posed = rateOf(every(0.5, 7));
        CHECK(posed.clip.framesPerSecond() == Approx(30.0));
        CHECK(posed.clip.frameCount() == 91);
        CHECK(posed.frame_rate == "30 fps (keys are 0.5 s apart)");
        const auto uneven = rateOf({0.0F, 0.1F, 0.137F, 0.5F, 0.77F});
        CHECK(uneven.clip.framesPerSecond() == Approx(30.0));
        CHECK(has(uneven, "uneven"));
        const auto single = rateOf({0.0F});
        CHECK(single.clip.frameCount() == 1);
        CHECK(single.frame_rate.find("assumed") != std::string::npos);
    }

    TEST_CASE("Even scale is folded into the positions below it") {
        const auto file = parse(TinyGltf().json(
            R"("nodes":[{"name":"armature","scale":[100,100,100],"rotation":[-0.70710678,0,0,0.70710678],"children":[1]},)"
            R"({"name":"hips","translation":[0,0,0.01],"scale":[0.5,0.5,0.5],"children":[2]},)"
            R"({"name":"head","translation":[0,0,0.02],"children":[3]},{"name":"head_end","translation":[0,0,0.004]}])"));
        checkNear(worldOf(file, 0, "hips"), {0, 1, 0});
        checkNear(worldOf(file, 0, "head"), {0, 2, 0});
        checkNear(file.clip.skeleton.joints[2].end_site.value(), {0, 0, 0.2});
        CHECK(file.clip.skeleton.size() == 3);
        CHECK(file.clip.frameCount() == 1);
        CHECK(has(file, "no animation"));
        CHECK(file.remarks.size() == 1);
    }

    TEST_CASE("Under uneven and moving scale positions are exact") {
        // The parent stretches y by 2; its child is turned by 90 degrees about z, so the grandchild's x is
        // its y.
        const std::string nodes =
            R"("nodes":[{"name":"a","scale":[1,2,1],"children":[1]},{"name":"b","translation":[1,1,0],"rotation":[0,0,0.70710678,0.70710678],"children":[2]},{"name":"c","translation":[1,0,0]}])";
        const auto still = parse(TinyGltf().json(nodes));
        checkNear(worldOf(still, 0, "b"), {1, 2, 0});
        checkNear(worldOf(still, 0, "c"), {1, 4, 0});
        CHECK(has(still, "scales by different amounts"));
        CHECK(degreesOff(rotationOf(still, 0, 1), turn(90, {0, 0, 1})) < 1e-5);
        TinyGltf gltf;
        gltf.animate(0, "scale", gltf.times({0, 1}), gltf.vectors({1, 2, 1, 3, 3, 3}));
        const auto moving = parseAt(gltf.glb(nodes), 1);
        checkNear(worldOf(moving, 0, "c"), {1, 4, 0});
        checkNear(worldOf(moving, 1, "c"), {3, 6, 0});
    }

    TEST_CASE("A mirrored node keeps the positions below it") {
        const auto even = parse(TinyGltf().json(
            R"("nodes":[{"name":"a","scale":[-1,-1,-1],"children":[1]},{"name":"b","translation":[1,2,3],"children":[2]},{"name":"c","translation":[0,0,1]}])"));
        checkNear(worldOf(even, 0, "c"), {-1, -2, -4});
        CHECK(has(even, "mirrors"));
        const auto one_axis = parse(TinyGltf().json(
            R"("nodes":[{"name":"a","scale":[-1,1,1],"children":[1]},{"name":"b","translation":[1,2,3],"children":[2]},{"name":"c","translation":[4,0,1]}])"));
        checkNear(worldOf(one_axis, 0, "c"), {-5, 2, 4});
    }

    TEST_CASE("A matrix is taken apart") {
        // Turned by 90 degrees about y (x to -z), scaled by 2, moved to 1 2 3.
        const auto file = parse(TinyGltf().json(
            R"("nodes":[{"name":"a","matrix":[0,0,-2,0,0,2,0,0,2,0,0,0,1,2,3,1],"children":[1]},{"name":"b","translation":[1,0,0]}])"));
        checkNear(positionOf(file, 0), {1, 2, 3});
        CHECK(degreesOff(rotationOf(file, 0), turn(90, {0, 1, 0})) < 1e-6);
        checkNear(worldOf(file, 0, "b"), {1, 2, 1});
    }

    TEST_CASE("With a skin its joints, all above them and what moves become joints") {
        TinyGltf gltf;
        gltf.animate(4, "translation", gltf.times({0, 1}), gltf.vectors({0, 0, 0, 1, 0, 0}));
        const auto file = parse(gltf.glb(
            R"("nodes":[{"name":"top","children":[1,3,4]},{"name":"hips","children":[2]},{"name":"spine"},)"
            R"({"name":"lamp"},{"name":"prop"},{"name":"body","mesh":0,"skin":0}],)"
            R"("skins":[{"joints":[2,1]}],"meshes":[{}])"));
        REQUIRE(file.clip.skeleton.size() == 4);
        CHECK(file.clip.skeleton.joints[0].name == "top");
        CHECK(file.clip.skeleton.joints[1].name == "hips");
        CHECK(file.clip.skeleton.joints[2].name == "spine");
        CHECK(file.clip.skeleton.joints[2].parent == 1);
        CHECK(file.clip.skeleton.joints[3].name == "prop");
    }

    TEST_CASE("Several roots are joined, and names made unique") {
        const auto file = parse(TinyGltf().json(
            R"("nodes":[{"name":"a","translation":[1,0,0]},{"name":"a","children":[2]},{},{"name":"root"}])"));
        const auto& joints = file.clip.skeleton.joints;
        REQUIRE(joints.size() == 5);
        CHECK(joints[0].name == "root");
        CHECK(joints[0].parent == -1);
        CHECK(joints[1].name == "a");
        CHECK(joints[2].name == "a#2");
        CHECK(joints[2].parent == 0);
        CHECK(joints[3].name == "node_2");
        CHECK(joints[3].parent == 2);
        CHECK(joints[4].name == "root#2");
        CHECK(has(file, "3 roots are joined"));
        CHECK(has(file, "3 nodes have no name or a repeated one"));
    }

    TEST_CASE("An animation is chosen by name or number, and the others are told") {
        TinyGltf gltf;
        const int times = gltf.times({0, 1});
        const int values = gltf.vectors({0, 0, 0, 1, 0, 0});
        const auto animation = [&](const char* members, int node) {
            return fmt::format(
                R"({{{}"samplers":[{{"input":{},"output":{}}}],"channels":[{{"sampler":0,"target":{{"node":{},"path":"translation"}}}}]}})",
                members, times, values, node);
        };
        const std::string bytes = gltf.glb(
            fmt::format(R"("nodes":[{{"name":"a","children":[1]}},{{"name":"b"}}],"animations":[{},{}])",
                        animation(R"("name":"walk",)", 0), animation("", 1)));
        const auto first = parse(bytes);
        CHECK(first.animation == "walk");
        CHECK(first.animations == std::vector<std::string>{"walk", "animation 1"});
        CHECK(has(first, "2 animations; the first is used: walk, animation 1"));
        GltfClipOptions second;
        second.animation_index = 1;
        checkNear(positionOf(parse(bytes, second), 30, 1), {1, 0, 0});  // a key each second: 30 fps
        GltfClipOptions named;
        named.animation = "walk";
        CHECK(parse(bytes, named).remarks.empty());
        named.animation = "run";
        const auto missing = assets::parseGltfClip(bytes, "f.glb", named);
        REQUIRE_FALSE(missing.has_value());
        CHECK(missing.error().text() == "f.glb: has no animation \"run\". It has: walk, animation 1");
        second.animation_index = 2;
        CHECK_FALSE(assets::parseGltfClip(bytes, "f.glb", second).has_value());
    }

    TEST_CASE("Metres per unit multiply positions; without them an odd size is told") {
        GltfClipOptions centimetres;
        centimetres.metres_per_unit = 0.01;
        const std::string text = TinyGltf().json(
            R"("nodes":[{"name":"a","children":[1]},{"name":"b","translation":[0,170,0],"children":[2]},{"name":"b_End","translation":[0,20,0]}])");
        const auto file = parse(text, centimetres);
        checkNear(positionOf(file, 0, 1), {0, 1.7, 0});
        checkNear(file.clip.skeleton.joints[1].end_site.value(), {0, 0.2, 0});
        CHECK(file.unit == "as given");
        CHECK(has(parse(text), "measures 170 m"));
    }

    TEST_CASE("Morph weights are left out, and the file says so") {
        TinyGltf gltf;
        gltf.animate(0, "weights", gltf.times({0, 1}), gltf.add<float>({0, 1}, "SCALAR", 5126, 1));
        const auto file = parse(gltf.glb(one_node));
        CHECK(file.clip.frameCount() == 1);
        CHECK(has(file, "morph weights"));
    }

    TEST_CASE("VRM 0.x: its thumbs are renamed and the model is turned to face +z") {
        const auto file = parse(TinyGltf().json(
            R"("nodes":[{"name":"Root","translation":[0,0,1],"children":[1]},{"name":"Hips","translation":[0.5,1,0],"children":[2]},{"name":"T1","children":[3]},{"name":"T2","children":[4]},{"name":"T3"}],)"
            R"("extensionsUsed":["VRM"],"extensions":{"VRM":{"humanoid":{"humanBones":[{"bone":"hips","node":1},)"
            R"({"bone":"leftThumbProximal","node":2},{"bone":"leftThumbIntermediate","node":3},{"bone":"leftThumbDistal","node":4},{"bone":"jaw","node":-1}]}}})"));
        REQUIRE(file.humanoid.has_value());
        using motion::Bone;
        CHECK((*file.humanoid)[Bone::hips] == 1);
        CHECK((*file.humanoid)[Bone::leftThumbMetacarpal] == 2);
        CHECK((*file.humanoid)[Bone::leftThumbProximal] == 3);
        CHECK((*file.humanoid)[Bone::leftThumbDistal] == 4);
        CHECK_FALSE(file.humanoid->has(Bone::jaw));
        checkNear(worldOf(file, 0, "Hips"), {-0.5, 1, -1});
        CHECK(file.humanoid_source == "VRM 0.x");
        CHECK(has(file, "faces -z"));
    }

    TEST_CASE("VRM 1.0 and VRM animations: bones by name, unknown ones told, expressions left out") {
        const auto vrm = parse(TinyGltf().json(
            R"("nodes":[{"name":"Hips"}],"extensions":{"VRMC_vrm":{"specVersion":"1.0","humanoid":{"humanBones":{"hips":{"node":0},"tail":{"node":0},"jaw":{"node":-1}}}}})"));
        CHECK((*vrm.humanoid)[motion::Bone::hips] == 0);
        CHECK_FALSE(vrm.humanoid->has(motion::Bone::jaw));
        CHECK(has(vrm, "tail"));
        TinyGltf gltf;
        gltf.animate(0, "translation", gltf.times({0, 0.5F}), gltf.vectors({0, 1, 0, 0, 2, 0}));
        gltf.animate(1, "translation", gltf.times({0, 9}), gltf.vectors({0, 0, 0, 1, 0, 0}));
        const auto vrma = parse(gltf.glb(
            R"("nodes":[{"name":"Hips"},{"name":"happy"},{"name":"gaze"}],"extensions":{"VRMC_vrm_animation":{"specVersion":"1.0",)"
            R"("humanoid":{"humanBones":{"hips":{"node":0}}},"expressions":{"preset":{"happy":{"node":1}}},"lookAt":{"node":2}}})"));
        CHECK(vrma.clip.skeleton.size() == 1);
        CHECK(vrma.clip.duration_s() == Approx(0.5));
        CHECK(has(vrma, "expressions"));
        CHECK(vrma.humanoid_source == "VRMC_vrm_animation");
    }
}
