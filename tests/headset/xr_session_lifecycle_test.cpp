// Expected duties: OpenXR 1.0, 9.3 "Session Lifecycle".
#include "xr_session_lifecycle.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace deixis::app;

TEST_SUITE("headset/session_lifecycle") {
    TEST_CASE("A session that comes into focus and is stopped begins once, ends once and is left") {
        struct Step {
            XrSessionState state;
            XrDuty duty;
            bool running, visible, focused;
        };
        const Step steps[] = {
            {XR_SESSION_STATE_IDLE, XrDuty::none, false, false, false},
            {XR_SESSION_STATE_READY, XrDuty::begin_session, true, false, false},
            {XR_SESSION_STATE_SYNCHRONIZED, XrDuty::none, true, false, false},
            {XR_SESSION_STATE_VISIBLE, XrDuty::none, true, true, false},
            {XR_SESSION_STATE_FOCUSED, XrDuty::none, true, true, true},
            {XR_SESSION_STATE_VISIBLE, XrDuty::none, true, true, false},
            {XR_SESSION_STATE_SYNCHRONIZED, XrDuty::none, true, false, false},
            {XR_SESSION_STATE_STOPPING, XrDuty::end_session, false, false, false},
            {XR_SESSION_STATE_IDLE, XrDuty::none, false, false, false},
            {XR_SESSION_STATE_EXITING, XrDuty::leave, false, false, false},
        };
        XrSessionLifecycle session;
        CHECK_FALSE(session.running());
        for (const Step& step : steps) {
            CAPTURE(nameOf(step.state));
            CHECK(session.enter(step.state) == step.duty);
            CHECK(session.state() == step.state);
            CHECK(session.running() == step.running);
            CHECK(session.visible() == step.visible);
            CHECK(session.focused() == step.focused);
        }
    }

    TEST_CASE("A session that was stopped can begin again") {
        XrSessionLifecycle session;
        for (int life = 0; life < 2; ++life) {
            CHECK(session.enter(XR_SESSION_STATE_IDLE) == XrDuty::none);
            CHECK(session.enter(XR_SESSION_STATE_READY) == XrDuty::begin_session);
            CHECK(session.enter(XR_SESSION_STATE_SYNCHRONIZED) == XrDuty::none);
            CHECK(session.enter(XR_SESSION_STATE_STOPPING) == XrDuty::end_session);
        }
    }

    TEST_CASE("A runtime that repeats itself makes nothing begin or end twice") {
        XrSessionLifecycle session;
        CHECK(session.enter(XR_SESSION_STATE_STOPPING) == XrDuty::none);
        CHECK(session.enter(XR_SESSION_STATE_READY) == XrDuty::begin_session);
        CHECK(session.enter(XR_SESSION_STATE_READY) == XrDuty::none);
        CHECK(session.running());
        CHECK(session.enter(XR_SESSION_STATE_STOPPING) == XrDuty::end_session);
        CHECK(session.enter(XR_SESSION_STATE_STOPPING) == XrDuty::none);
        CHECK_FALSE(session.running());
    }

    TEST_CASE("A session that the runtime calls idle runs on until it was ended") {
        XrSessionLifecycle session;
        CHECK(session.enter(XR_SESSION_STATE_READY) == XrDuty::begin_session);
        CHECK(session.enter(XR_SESSION_STATE_IDLE) == XrDuty::none);
        CHECK(session.running());
        CHECK_FALSE(session.visible());
    }

    TEST_CASE("After a loss nothing is done to the session, whatever state it was in") {
        for (int before = XR_SESSION_STATE_UNKNOWN; before <= XR_SESSION_STATE_STOPPING; ++before) {
            CAPTURE(before);
            XrSessionLifecycle session;
            (void)session.enter(XR_SESSION_STATE_READY);
            (void)session.enter(static_cast<XrSessionState>(before));
            CHECK(session.enter(XR_SESSION_STATE_LOSS_PENDING) == XrDuty::lost);
            CHECK_FALSE(session.running());
            for (const auto after :
                 {XR_SESSION_STATE_READY, XR_SESSION_STATE_FOCUSED, XR_SESSION_STATE_STOPPING,
                  XR_SESSION_STATE_EXITING, XR_SESSION_STATE_LOSS_PENDING}) {
                CHECK(session.enter(after) == XrDuty::none);
                CHECK(session.state() == XR_SESSION_STATE_LOSS_PENDING);
                CHECK_FALSE(session.running());
            }
        }
    }

    TEST_CASE("A session that was left does not come back, and is not lost either") {
        XrSessionLifecycle session;
        CHECK(session.enter(XR_SESSION_STATE_EXITING) == XrDuty::leave);
        CHECK(session.enter(XR_SESSION_STATE_READY) == XrDuty::none);
        CHECK(session.enter(XR_SESSION_STATE_LOSS_PENDING) == XrDuty::none);
        CHECK_FALSE(session.running());
    }

    TEST_CASE("Only with focus the operator is told that the headset is in use") {
        for (int state = XR_SESSION_STATE_UNKNOWN; state <= XR_SESSION_STATE_EXITING; ++state) {
            CAPTURE(state);
            CHECK(wordsOf(static_cast<XrSessionState>(state)).in_use == (state == XR_SESSION_STATE_FOCUSED));
        }
        const auto of_later_version = static_cast<XrSessionState>(1000);
        CHECK(nameOf(of_later_version) == "unknown");
        CHECK_FALSE(wordsOf(of_later_version).in_use);
    }

    TEST_CASE("Every state has a name of its own") {
        std::set<std::string> names;
        for (int state = XR_SESSION_STATE_UNKNOWN; state <= XR_SESSION_STATE_EXITING; ++state)
            names.emplace(nameOf(static_cast<XrSessionState>(state)));
        CHECK(names.size() == 9);
        CHECK(nameOf(XR_SESSION_STATE_LOSS_PENDING) == "loss pending");
        CHECK(nameOf(XR_SESSION_STATE_FOCUSED) == "focused");
    }
}
