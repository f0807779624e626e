// A program that was built without MuJoCo.
#include "bodies.hpp"
#include "physics/body/body.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

TEST_SUITE("physics/absent") {
    TEST_CASE("without MuJoCo no body is made, and the message says what to do") {
        const auto made = physics::Body::make(figureOf(physics::Stance::pinned));
        REQUIRE_FALSE(made.has_value());
        CHECK(contains(made.error().text(), "built without MuJoCo"));
        CHECK(contains(made.error().text(), "libmujoco-dev"));
        CHECK(physics::mujocoLibraryName().empty());
    }
}
