// What the experimenter asks for, and what is asked back first.
#include "app/operator/operator_request.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <string>

namespace studies = deixis::studies;
using namespace deixis::app;
using deixis::studies::InputFrame;
using deixis::studies::OperatorAction;
using Question = OperatorControls::Question;

namespace {

void type(OperatorControls::Text& field, const std::string& text) {
    field = {};
    std::memcpy(field.data(), text.data(), text.size());
}

}  // namespace

TEST_SUITE("operator/operator_request") {
    TEST_CASE("what is asked twice takes two askings within four seconds") {
        AskTwice end;
        CHECK_FALSE(end.left(99.0));
        CHECK_FALSE(end.ask(100.0));
        REQUIRE(end.left(101.0));
        CHECK(*end.left(101.0) == doctest::Approx(0.75));
        CHECK(end.ask(103.9));
        CHECK_FALSE(end.left(103.9));
        CHECK_FALSE(end.ask(104.9));
    }

    TEST_CASE("an asking after four seconds is a first one again") {
        AskTwice end;
        CHECK_FALSE(end.ask(10.0));
        CHECK_FALSE(end.left(14.1));
        CHECK_FALSE(end.ask(14.1));
        CHECK(end.ask(16.0));
    }

    TEST_CASE("a double click asks once, and does not lengthen the time for the second asking") {
        AskTwice end;
        CHECK_FALSE(end.ask(10.0));
        CHECK_FALSE(end.ask(10.1));
        CHECK_FALSE(end.ask(10.39));
        CHECK_FALSE(end.left(14.05));
        CHECK_FALSE(end.ask(20.0));
        CHECK_FALSE(end.ask(20.2));
        CHECK(end.ask(20.5));
    }

    TEST_CASE("ending and repeating the last trial are asked twice, each by itself") {
        OperatorControls controls;
        controls.repeatLast(10.0);
        controls.end(11.0);
        OperatorRequest asked = controls.take();
        CHECK(asked.commands.empty());
        CHECK_FALSE(asked.end);
        controls.repeatLast(12.0);
        asked = controls.take();
        REQUIRE(asked.commands.size() == 1);
        CHECK(asked.commands[0].action == OperatorAction::repeat_last);
        CHECK_FALSE(asked.end);
        controls.end(13.0);
        CHECK(controls.take().end);
        CHECK_FALSE(controls.take().end);
    }

    TEST_CASE("a trial is skipped only with a reason, which goes with it without the blanks around it") {
        OperatorControls controls;
        controls.ask(Question::skip);
        CHECK_FALSE(controls.answered());
        controls.answer(1.0);
        type(controls.reason(), " \t ");
        CHECK_FALSE(controls.answered());
        controls.answer(2.0);
        CHECK(controls.take().commands.empty());
        CHECK(controls.question() == Question::skip);
        type(controls.reason(), "  the clip did not move ");
        CHECK(controls.answered());
        controls.answer(3.0);
        const OperatorRequest asked = controls.take();
        REQUIRE(asked.commands.size() == 1);
        CHECK(asked.commands[0].action == OperatorAction::skip);
        CHECK(asked.commands[0].text == "the clip did not move");
        CHECK(controls.question() == Question::none);
    }

    TEST_CASE("a session is aborted only with a reason, and when asked for twice") {
        OperatorControls controls;
        controls.ask(Question::abort);
        controls.answer(1.0);
        controls.answer(2.0);
        CHECK(controls.take().commands.empty());
        type(controls.reason(), "felt unwell");
        controls.answer(3.0);
        CHECK(controls.take().commands.empty());
        CHECK(controls.abortLeft(4.0));
        SUBCASE("the second time within four seconds does it") {
            controls.answer(5.0);
            const OperatorRequest asked = controls.take();
            REQUIRE(asked.commands.size() == 1);
            CHECK(asked.commands[0].action == OperatorAction::abort);
            CHECK(asked.commands[0].text == "felt unwell");
        }
        SUBCASE("later it is the first time again") {
            controls.answer(7.5);
            CHECK(controls.take().commands.empty());
            CHECK(controls.question() == Question::abort);
        }
        SUBCASE("a double click is one time") {
            controls.answer(3.2);
            CHECK(controls.take().commands.empty());
        }
        SUBCASE("leaving the question forgets the first time and the reason") {
            controls.leaveQuestion();
            controls.ask(Question::abort);
            CHECK_FALSE(controls.answered());
            type(controls.reason(), "felt unwell");
            controls.answer(5.0);
            CHECK(controls.take().commands.empty());
        }
    }

    TEST_CASE("the reason for skipping is not taken for aborting") {
        OperatorControls controls;
        controls.ask(Question::skip);
        type(controls.reason(), "wrong clip");
        controls.ask(Question::abort);
        CHECK_FALSE(controls.answered());
    }

    TEST_CASE("a note is kept with its words and leaves an empty field; an empty one is none") {
        OperatorControls controls;
        controls.addNote();
        type(controls.note(), "   ");
        controls.addNote();
        CHECK(controls.take().commands.empty());
        type(controls.note(), "phone rang \xEC\xA0\x84\xED\x99\x94");
        controls.addNote();
        const OperatorRequest asked = controls.take();
        REQUIRE(asked.commands.size() == 1);
        CHECK(asked.commands[0].action == OperatorAction::note);
        CHECK(asked.commands[0].text == "phone rang \xEC\xA0\x84\xED\x99\x94");
        CHECK(controls.note()[0] == '\0');
    }

    TEST_CASE("the trial is hidden at first, and each looking at it is told once") {
        OperatorControls controls;
        CHECK_FALSE(controls.trialShown());
        controls.showTrial(true);
        CHECK(controls.trialShown());
        CHECK(controls.take().saw_trial);
        controls.showTrial(true);
        CHECK_FALSE(controls.take().saw_trial);
        controls.showTrial(false);
        CHECK_FALSE(controls.take().saw_trial);
        controls.showTrial(true);
        CHECK(controls.take().saw_trial);
    }

    TEST_CASE(
        "requests of several polls are joined in their order; of pausing and going on the last counts") {
        OperatorRequest asked;
        asked.pause = true;
        asked.commands.push_back({OperatorAction::note, "one"});
        OperatorRequest later;
        later.resume = true;
        later.commands.push_back({OperatorAction::note, "two"});
        asked.add(later);
        CHECK(asked.resume);
        CHECK_FALSE(asked.pause);
        REQUIRE(asked.commands.size() == 2);
        CHECK(asked.commands[0].text == "one");
        CHECK(asked.commands[1].text == "two");
        OperatorRequest last;
        last.pause = true;
        last.end = true;
        asked.add(last);
        CHECK(asked.pause);
        CHECK_FALSE(asked.resume);
        CHECK(asked.end);
    }

    TEST_CASE("a session is told all that was asked, at the time of the input") {
        OperatorRequest asked;
        asked.pause = asked.resume = asked.end = asked.saw_trial = true;
        asked.commands.push_back({OperatorAction::skip, "why"});
        InputFrame input;
        input.time_s = 12.0;
        input.input_time_s = 11.9;
        input.pause = true;
        input.pause_reason = studies::PauseReason::focus_lost;
        asked.putInto(input);
        CHECK(input.pause);
        CHECK(input.pause_reason == studies::PauseReason::experimenter);
        CHECK(input.resume);
        CHECK(input.quit);
        CHECK(input.quit_reason == "ended by the experimenter");
        REQUIRE(input.commands.size() == 1);
        CHECK(input.commands[0].text == "why");
        REQUIRE(input.notes.size() == 1);
        CHECK(input.notes[0].kind == studies::NoteKind::operator_saw_trial);
        CHECK(input.notes[0].time_s == 11.9);
    }

    TEST_CASE("nothing asked changes nothing, and an end for another reason keeps that reason") {
        InputFrame input;
        input.pause = true;
        input.pause_reason = studies::PauseReason::menu;
        input.quit = true;
        input.quit_reason = "the connection was lost";
        OperatorRequest{}.putInto(input);
        CHECK(input.pause_reason == studies::PauseReason::menu);
        CHECK_FALSE(input.resume);
        CHECK(input.commands.empty());
        CHECK(input.notes.empty());
        OperatorRequest asked;
        asked.end = true;
        asked.putInto(input);
        CHECK(input.quit_reason == "the connection was lost");
    }
}
