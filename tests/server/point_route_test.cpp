// POST /v1/point: the arm of the avatar that is drawn, followed by forward kinematics of the tracks.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/skeleton.hpp"
#include "studio_server.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

constexpr double degrees = 57.29577951308232;

/// Where the joints of the avatar are, in the pose that the page would draw.
struct Drawn {
    std::vector<Pose> world;

    Drawn(const StudioServer& server, const json& frame) {
        const json tracks = server.post("/v1/tracks", {{"frames", json::array({frame})}}).body["tracks"];
        const auto& skeleton = motion::referenceHumanoid();
        auto local = motion::restPose(skeleton);
        for (std::size_t i = 0; i < tracks["bones"].size(); ++i) {
            const auto joint = static_cast<std::size_t>(skeleton.find(tracks["bones"][i].get<std::string>()));
            const json& row = tracks["rotations"][0];
            local.joints[joint].orientation =
                Quat(row[4 * i + 3].get<double>(), row[4 * i].get<double>(), row[4 * i + 1].get<double>(),
                     row[4 * i + 2].get<double>());
        }
        world = motion::worldPose(skeleton, local);
    }
    [[nodiscard]] Vec3 at(const std::string& name) const {
        return world[static_cast<std::size_t>(motion::referenceHumanoid().find(name))].position;
    }
    [[nodiscard]] Vec3 fingertip(const std::string& side) const {
        const auto& skeleton = motion::referenceHumanoid();
        return motion::tipPosition(skeleton, world, skeleton.find(side + "IndexDistal"));
    }
    [[nodiscard]] Vec3 eyes() const { return 0.5 * (at("leftEye") + at("rightEye")); }
};

double angleDeg(const Vec3& a, const Vec3& b) {
    return std::acos(std::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0)) * degrees;
}

json asJson(const Vec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

TEST_SUITE("server/point_route") {
    TEST_CASE("The line from the eyes over the fingertip meets what an arm can point at") {
        const StudioServer server;
        Random random(1, "targets");
        for (int i = 0; i < 60; ++i) {
            const std::string side = i % 2 == 0 ? "left" : "right";
            const double out = (side == "left" ? 1.0 : -1.0);
            const double azimuth = (-20.0 + 110.0 * random.uniform()) / degrees;
            const double distance_m = 1.0 + 3.0 * random.uniform();
            const Vec3 target(out * distance_m * std::sin(azimuth), 0.2 + 2.0 * random.uniform(),
                              distance_m * std::cos(azimuth));
            CAPTURE(asJson(target).dump());
            const auto answer = server.post("/v1/point", {{"target_m", asJson(target)}, {"side", side}});
            REQUIRE_MESSAGE(answer.status == 200, answer.body.dump());
            CHECK(answer.body["side"] == side);
            const Drawn drawn(server, answer.body["frame"]);
            const double off_deg = angleDeg(drawn.fingertip(side) - drawn.eyes(), target - drawn.eyes());
            CHECK(off_deg < 0.5);
            CHECK(std::abs(off_deg - answer.body["off_deg"].get<double>()) < 0.1);
            // An almost straight arm, and bones of their own length.
            const Vec3 shoulder = drawn.at(side + "UpperArm"), elbow = drawn.at(side + "LowerArm");
            CHECK(angleDeg(elbow - shoulder, drawn.at(side + "Hand") - elbow) < 60.0);
        }
    }

    TEST_CASE("Only that arm changes; auto takes the arm on the target's side") {
        const StudioServer server;
        json pose = server.get("/v1/motions")["motions"][3]["frames"][10];
        const auto left = server.post("/v1/point", {{"target_m", {1.5, 1.2, 2.0}}, {"pose", pose}});
        REQUIRE(left.status == 200);
        CHECK(left.body["side"] == "left");
        for (std::size_t i = 0; i < 27; ++i) {
            const bool of_arm = i >= 12 && i < 18;
            if (!of_arm) CHECK(std::abs(left.body["frame"][i].get<double>() - pose[i].get<double>()) < 2e-6);
        }
        CHECK(left.body["frame"][12] != pose[12]);
        CHECK(server.post("/v1/point", {{"target_m", {-1.5, 1.2, 2.0}}}).body["side"] == "right");
        // The mirror image by the other arm.
        const auto right = server.post("/v1/point", {{"target_m", {-1.0, 1.0, 2.0}}, {"side", "right"}});
        const auto other = server.post("/v1/point", {{"target_m", {1.0, 1.0, 2.0}}, {"side", "left"}});
        for (std::size_t i = 0; i < 6; ++i)
            CHECK(std::abs(std::abs(right.body["frame"][21 + i].get<double>()) -
                           std::abs(other.body["frame"][12 + i].get<double>())) < 1e-3);
    }

    TEST_CASE("What lies behind is missed by a body's limits, and that is told") {
        const StudioServer server;
        for (const json& target : {json{-0.5, 1.3, -2.0}, json{2.0, 1.3, -0.5}, json{0.0, 0.1, -1.0},
                                   json{0.0, 3.0, 0.0}, json{0.0, 0.0, 0.3}, json{-0.2, 1.0, -0.1}}) {
            CAPTURE(target.dump());
            const auto answer = server.post("/v1/point", {{"target_m", target}, {"side", "right"}});
            REQUIRE(answer.status == 200);
            const Drawn drawn(server, answer.body["frame"]);
            const Vec3 to(target[0].get<double>(), target[1].get<double>(), target[2].get<double>());
            const double off_deg = angleDeg(drawn.fingertip("right") - drawn.eyes(), to - drawn.eyes());
            CHECK(std::abs(off_deg - answer.body["off_deg"].get<double>()) < 0.2);
            // Not behind the back: the hand is at most 30 degrees behind the shoulders' line.
            const Vec3 arm = drawn.at("rightHand") - drawn.at("rightUpperArm");
            if (std::hypot(arm.x, arm.z) > 0.2) CHECK(std::atan2(arm.z, -arm.x) * degrees > -45.0);
        }
        CHECK(server.post("/v1/point", {{"target_m", {0.0, 1.3, -2.0}}}).body["off_deg"] > 20.0);
    }

    TEST_CASE("What cannot be pointed at is refused") {
        const StudioServer server;
        const auto refused = [&](const json& request, const std::string& field) {
            const auto answer = server.post("/v1/point", request);
            CHECK(answer.status == 400);
            CHECK(answer.field() == field);
        };
        const Drawn standing(server, server.get("/v1/health")["mean_pose"]);
        const Vec3 shoulder = standing.at("rightUpperArm");
        refused({{"target_m", asJson(shoulder + Vec3(0.0, 0.0, 0.29))}, {"side", "right"}}, "target_m");
        refused({{"target_m", asJson(shoulder)}, {"side", "right"}}, "target_m");
        CHECK(
            server
                .post("/v1/point", {{"target_m", asJson(shoulder + Vec3(0.0, 0.0, 0.31))}, {"side", "right"}})
                .status == 200);
        refused({{"target_m", {1, 2}}}, "target_m");
        refused({{"target_m", {1, 2, 1000}}}, "target_m[2]");
        refused({{"target_m", {1, 2, 3}}, {"side", "middle"}}, "side");
        json crooked = server.get("/v1/health")["mean_pose"];
        for (std::size_t i = 0; i < 3; ++i) crooked[i] = 0.0;
        refused({{"target_m", {1, 2, 3}}, {"pose", crooked}}, "pose");
    }
}
