// Avatars whose accessors are sparse (glTF 2.0, section 3.6.2.3) are the figures that the replaced values
// make.
#include <doctest/doctest.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "assets/avatar/avatar.hpp"
#include "core/files.hpp"
#include "gltf_rig.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Result<assets::Avatar> loadSparse(const std::string& bytes) {
    const auto path = deixis::tests::buildDir() / "avatar_sparse.glb";
    REQUIRE(writeFile(path, bytes).has_value());
    return assets::loadAvatar(path);
}

/// The plain figure with normals and with indices that turn every triangle over.
std::string withNormals(bool sparse) {
    const RigOptions options{.rest_rotations = true, .sparse = sparse};
    const Rig rig = makeRig(options);
    GlbText file = rigFile(rig, options);
    const std::size_t count = rig.vertices.size();
    std::vector<float> normals;
    std::vector<std::uint16_t> indices;
    for (std::size_t v = 0; v < count; ++v) {
        const Vec3 normal = glm::normalize(Vec3(1.0, 0.01 * static_cast<double>(v), -0.5));
        for (int axis = 0; axis < 3; ++axis) normals.push_back(static_cast<float>(normal[axis]));
        indices.push_back(static_cast<std::uint16_t>(count - 1 - v));
    }
    const int normal = file.accessor(normals, 5126, "VEC3", count);
    const int index = file.accessor(indices, 5123, "SCALAR", count);
    file.meshes[0] = fmt::format(
        R"({{"primitives":[{{"indices":{},"attributes":{{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2,"NORMAL":{}}}}}]}})",
        index, normal);
    return file.glb();
}

}  // namespace

TEST_SUITE("assets/avatar_sparse") {
    TEST_CASE("A figure of sparse accessors is skinned as the specification has it") {
        for (const bool shorts : {false, true}) {
            const RigOptions options{.rest_rotations = true, .short_joints = shorts, .sparse = true};
            const Rig rig = makeRig(options);
            const auto avatar = loadSparse(rigFile(rig, options).glb());
            REQUIRE_MESSAGE(avatar.has_value(), (avatar ? std::string() : avatar.error().text()));
            const std::vector<Quat> still(motion::bone_count, no_rotation);
            const auto expected = skinnedBySpecification(rig, posed(rig, still));
            REQUIRE(avatar->vertices.size() == expected.size());
            const auto world = motion::worldPose(avatar->skeleton, motion::restPose(avatar->skeleton));
            for (std::size_t v = 0; v < expected.size(); ++v) {
                const auto& vertex = avatar->vertices[v];
                Vec3 place(0.0);
                for (std::size_t k = 0; k < 4; ++k)
                    place +=
                        static_cast<double>(vertex.weights[k]) *
                        transformPoint(world[vertex.joints[k]] * avatar->joint_from_bind[vertex.joints[k]],
                                       Vec3(vertex.position));
                REQUIRE(glm::length(place - expected[v]) < 1e-5);
            }
        }
    }

    TEST_CASE("Sparse normals and indices make the same avatar as plain ones") {
        const auto plain = loadSparse(withNormals(false));
        const auto sparse = loadSparse(withNormals(true));
        REQUIRE(plain.has_value());
        REQUIRE_MESSAGE(sparse.has_value(), (sparse ? std::string() : sparse.error().text()));
        CHECK(sparse->indices == plain->indices);
        CHECK(sparse->indices.front() == plain->vertices.size() - 1);
        REQUIRE(sparse->vertices.size() == plain->vertices.size());
        for (std::size_t v = 0; v < plain->vertices.size(); ++v) {
            REQUIRE(sparse->vertices[v].position == plain->vertices[v].position);
            REQUIRE(sparse->vertices[v].normal == plain->vertices[v].normal);
            REQUIRE(sparse->vertices[v].joints == plain->vertices[v].joints);
            REQUIRE(sparse->vertices[v].weights == plain->vertices[v].weights);
        }
    }

    TEST_CASE("Sparse parts that leave the file or the accessor are rejected by name") {
        const RigOptions options;
        const Rig rig = makeRig(options);
        const std::size_t count = rig.vertices.size();
        std::vector<float> values;
        for (const Vec3& vertex : rig.vertices)
            for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(vertex[axis]));
        struct Broken {
            std::vector<std::uint16_t> indices;
            std::string view_members, index_members, value_members;
            int replaced;
            int index_view = -1;
        };
        const auto rejection = [&](const Broken& broken) {
            GlbText file = rigFile(rig, options);
            const int base = file.view(values);
            const int index_view = file.view(broken.indices, broken.view_members);
            const int value_view = file.view(std::vector<float>(values.begin(), values.begin() + 6));
            const std::string index_members =
                fmt::format(R"("bufferView":{},{})", broken.index_view < 0 ? index_view : broken.index_view,
                            broken.index_members.empty() ? R"("componentType":5123)" : broken.index_members);
            const int position = file.accessor(fmt::format(
                R"("bufferView":{},"componentType":5126,"count":{},"type":"VEC3","sparse":{{"count":{},"indices":{{{}}},"values":{{"bufferView":{}{}}}}})",
                base, count, broken.replaced, index_members, value_view, broken.value_members));
            file.meshes[0] = fmt::format(
                R"({{"primitives":[{{"attributes":{{"POSITION":{},"JOINTS_0":1,"WEIGHTS_0":2}}}}]}})",
                position);
            const auto avatar = loadSparse(file.glb());
            return avatar ? std::string() : avatar.error().text();
        };
        const auto past = static_cast<std::uint16_t>(count);
        const std::vector<std::pair<Broken, std::string>> cases{
            {{{0, past}, "", "", "", 2},
             fmt::format("sparse index 1 is {0}, expected 1 to {1}", count, count - 1)},
            {{{1, 1}, "", "", "", 2}, "sparse index 1 is 1, expected 2 to"},
            {{{0, 1}, "", R"("componentType":5126)", "", 2}, "sparse indices of component type 5126"},
            {{{0, 1}, "", R"("componentType":5125)", "", 2},
             "2 elements from byte 0 exceed buffer view 5 of 4 bytes"},
            {{{0, 1}, "", R"("componentType":5123,"byteOffset":-2)", "", 2},
             "/indices/byteOffset: found -2, expected a whole number"},
            {{{0, 1}, "", R"("componentType":5123,"byteOffset":2)", "", 2},
             "2 elements from byte 2 exceed buffer view 5 of 4 bytes"},
            {{{0, 0, 1, 0}, R"(,"byteStride":4)", "", "", 2}, "sparse index 1 is 0, expected 1 to"},
            {{{0, 1, 2}, "", "", "", 3}, "3 elements from byte 0 exceed buffer view 6 of 24 bytes"},
            {{{0, 1}, "", "", R"(,"byteOffset":4)", 2},
             "2 elements from byte 4 exceed buffer view 6 of 24 bytes"},
            {{{0, 1}, "", "", "", 0}, "replaces 0 of"},
            {{{0, 1}, "", "", "", -1}, "sparse/count: found -1, expected a whole number"},
            {{{0, 1}, "", "", "", 4000}, "replaces 4000 of"},
            {{{0, 1}, "", "", "", 2, 99}, "buffer view 99 does not exist"}};
        for (const auto& broken : cases) {
            const std::string text = rejection(broken.first);
            const std::string& words = broken.second;
            CHECK_MESSAGE(text.find(words) != std::string::npos, (text + " | " + words));
            CHECK(text.find(": /accessors/4") != std::string::npos);
        }
        CHECK(rejection({{0, 1}, "", "", "", 2}).empty());
    }
}
