// What the experimenter asks for, and what is asked back first.
#include "app/operator/operator_request.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <string>

namespace studies = deixis::studies;
using namespace deixis::app;
using deixis::studies::InputFrame;
using deixis::studies::OperatorAction;
using Question = OperatorDesk::Question;

namespace {

void type(OperatorDesk::Text& field, const std::string& text) {
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
        OperatorDesk desk;
        desk.repeatLast(10.0);
        desk.end(11.0);
        OperatorRequest asked = desk.take();
        CHECK(asked.commands.empty());
        CHECK_FALSE(asked.end);
        desk.repeatLast(12.0);
        asked = desk.take();
        REQUIRE(asked.commands.size() == 1);
        CHECK(asked.commands[0].action == OperatorAction::repeat_last);
        CHECK_FALSE(asked.end);
        desk.end(13.0);
        CHECK(desk.take().end);
        CHECK_FALSE(desk.take().end);
    }

    TEST_CASE("a trial is skipped only with a reason, which goes with it without the blanks around it") {
        OperatorDesk desk;
        desk.ask(Question::skip);
        CHECK_FALSE(desk.answered());
        desk.answer(1.0);
        type(desk.reason(), " \t ");
        CHECK_FALSE(desk.answered());
        desk.answer(2.0);
        CHECK(desk.take().commands.empty());
        CHECK(desk.question() == Question::skip);
        type(desk.reason(), "  the clip did not move ");
        CHECK(desk.answered());
        desk.answer(3.0);
        const OperatorRequest asked = desk.take();
        REQUIRE(asked.commands.size() == 1);
        CHECK(asked.commands[0].action == OperatorAction::skip);
        CHECK(asked.commands[0].text == "the clip did not move");
        CHECK(desk.question() == Question::none);
    }

    TEST_CASE("a session is aborted only with a reason, and when asked for twice") {
        OperatorDesk desk;
        desk.ask(Question::abort);
        desk.answer(1.0);
        desk.answer(2.0);
        CHECK(desk.take().commands.empty());
        type(desk.reason(), "felt unwell");
        desk.answer(3.0);
        CHECK(desk.take().commands.empty());
        CHECK(desk.abortLeft(4.0));
        SUBCASE("the second time within four seconds does it") {
            desk.answer(5.0);
            const OperatorRequest asked = desk.take();
            REQUIRE(asked.commands.size() == 1);
            CHECK(asked.commands[0].action == OperatorAction::abort);
            CHECK(asked.commands[0].text == "felt unwell");
        }
        SUBCASE("later it is the first time again") {
            desk.answer(7.5);
            CHECK(desk.take().commands.empty());
            CHECK(desk.question() == Question::abort);
        }
        SUBCASE("a double click is one time") {
            desk.answer(3.2);
            CHECK(desk.take().commands.empty());
        }
        SUBCASE("leaving the question forgets the first time and the reason") {
            desk.leaveQuestion();
            desk.ask(Question::abort);
            CHECK_FALSE(desk.answered());
            type(desk.reason(), "felt unwell");
            desk.answer(5.0);
            CHECK(desk.take().commands.empty());
        }
    }

    TEST_CASE("the reason for skipping is not taken for aborting") {
        OperatorDesk desk;
        desk.ask(Question::skip);
        type(desk.reason(), "wrong clip");
        desk.ask(Question::abort);
        CHECK_FALSE(desk.answered());
    }

    TEST_CASE("a note is kept with its words and leaves an empty field; an empty one is none") {
        OperatorDesk desk;
        desk.addNote();
        type(desk.note(), "   ");
        desk.addNote();
        CHECK(desk.take().commands.empty());
        type(desk.note(), "phone rang \xEC\xA0\x84\xED\x99\x94");
        desk.addNote();
        const OperatorRequest asked = desk.take();
        REQUIRE(asked.commands.size() == 1);
        CHECK(asked.commands[0].action == OperatorAction::note);
        CHECK(asked.commands[0].text == "phone rang \xEC\xA0\x84\xED\x99\x94");
        CHECK(desk.note()[0] == '\0');
    }

    TEST_CASE("the trial is hidden at first, and each looking at it is told once") {
        OperatorDesk desk;
        CHECK_FALSE(desk.trialShown());
        desk.showTrial(true);
        CHECK(desk.trialShown());
        CHECK(desk.take().saw_trial);
        desk.showTrial(true);
        CHECK_FALSE(desk.take().saw_trial);
        desk.showTrial(false);
        CHECK_FALSE(desk.take().saw_trial);
        desk.showTrial(true);
        CHECK(desk.take().saw_trial);
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
