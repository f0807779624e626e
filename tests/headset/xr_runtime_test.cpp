#include "xr_runtime.hpp"

#include <doctest/doctest.h>

using namespace deixis::app;

TEST_SUITE("headset/runtime") {
    TEST_CASE("A result is called what the specification calls it, and a strange one by its number") {
        CHECK(nameOf(XR_SUCCESS) == "XR_SUCCESS");
        CHECK(nameOf(static_cast<XrResult>(-17)) == "XR_ERROR_SESSION_LOST");
        CHECK(nameOf(static_cast<XrResult>(8)) == "XR_SESSION_NOT_FOCUSED");
        CHECK(nameOf(static_cast<XrResult>(-1003000000)) == "-1003000000");
    }

    TEST_CASE("A failed call throws with its name and result; a success is handed back") {
        CHECK(check(XR_SESSION_NOT_FOCUSED, "xrSyncActions") == XR_SESSION_NOT_FOCUSED);
        CHECK_THROWS_WITH_AS(check(XR_ERROR_TIME_INVALID, "xrLocateSpace"),
                             "xrLocateSpace failed: XR_ERROR_TIME_INVALID", XrFailure);
    }

    TEST_CASE("A runtime that went away is told from a call that was wrong") {
        CHECK(XrFailure("", XR_ERROR_INSTANCE_LOST).lost());
        CHECK(XrFailure("", XR_ERROR_SESSION_LOST).lost());
        CHECK_FALSE(XrFailure("", XR_ERROR_VALIDATION_FAILURE).lost());
    }
}
