// Pages that are read or answered: consent, breaks, questionnaires with keyboard and without.
#include <doctest/doctest.h>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

struct Questioned : Driver {
    Questioned(std::vector<Question> questions, bool with_keyboard, int per_page = 4)
        : Driver({questionnaireStage(std::move(questions), per_page)}) {
        keyboard = with_keyboard;
        for (int page = 0; page < study.stages[0].questionnaire.pages(); ++page)
            add("questions", 0, {}).page = page;
        start();
        wait(0.6);
    }
};

void decline(Driver& driver) {
    driver.press(button_id::decline);
    driver.wait(0.6);
    driver.press(button_id::end_for_good);
}

constexpr int option(int question, int place) {
    return button_id::first_option + 100 * question + place;
}

}  // namespace

TEST_SUITE("studies/session_pages") {
    TEST_CASE("who agrees goes on, and the agreement is kept") {
        Driver driver({pageStage("consent", "May we?", StageKind::consent), ratingStage()});
        driver.add("consent", 0, {});
        driver.add("rating", 0, {"one"});
        driver.start();
        driver.wait(0.6);
        CHECK(driver.state() == "consent");
        CHECK(driver.session->trialUnderWay() == 0);
        InputFrame keys;
        keys.confirm = true;
        driver.step(keys);
        CHECK_MESSAGE(driver.responses.empty(), "no key gives consent");
        driver.press(button_id::agree);
        REQUIRE(driver.responses.size() == 1);
        CHECK(answerTo(driver.responses[0], "consent") == 1.0);
        CHECK(driver.responses[0].input == "ray");
        CHECK(driver.responses[0].response_time_s == doctest::Approx(0.6).epsilon(0.1));
        REQUIRE(driver.finish());
        CHECK(driver.responses.size() == 2);
    }

    TEST_CASE("who declines is thanked, and the session is over without a trial") {
        Driver driver({pageStage("consent", "May we?", StageKind::consent), ratingStage()});
        driver.add("consent", 0, {});
        driver.add("rating", 0, {"one"});
        driver.start();
        driver.wait(0.6);
        driver.press(button_id::decline);
        driver.wait(0.6);
        CHECK(driver.responses.empty());  // one press must not end it
        driver.press(button_id::back);
        driver.wait(0.6);
        CHECK(textOf(*driver.frame.panel).find("May we?") != std::string::npos);
        decline(driver);
        REQUIRE(driver.responses.size() == 1);
        CHECK(answerTo(driver.responses[0], "consent") == 0.0);
        driver.wait(0.6);
        CHECK(driver.state() == "closing");

        CHECK(textOf(*driver.frame.panel).find("You chose not to take part") != std::string::npos);
        CHECK(driver.running());
        driver.press(button_id::go_on);
        CHECK(driver.session->outcome() == SessionOutcome::declined);
        CHECK(driver.state() == "over");
        CHECK(driver.count(NoteKind::stimulus_onset) == 0);
        CHECK(driver.count(NoteKind::finished) == 0);
    }

    TEST_CASE("closing the window instead of reading the closing page does not make a decline a quit") {
        Driver driver({pageStage("consent", "May we?", StageKind::consent)});
        driver.add("consent", 0, {});
        driver.start();
        driver.wait(0.6);
        decline(driver);
        driver.wait(0.2);
        InputFrame quit;
        quit.quit = true;
        driver.step(quit);
        CHECK(driver.session->outcome() == SessionOutcome::declined);
    }

    TEST_CASE("whoever declined is asked again first when coming back, and goes on only after agreeing") {
        Driver driver({pageStage("information", "What this is about"),
                       questionnaireStage({question("age", QuestionKind::choice)}),
                       pageStage("consent", "May we?", StageKind::consent), ratingStage()});
        driver.add("questions", 0, {});
        driver.add("consent", 0, {});
        driver.add("rating", 0, {"one"});
        driver.left.answered[0] = true;  // the questionnaire, in an earlier visit
        driver.start();
        const auto says = [&](const char* text) {
            return driver.frame.panel && textOf(*driver.frame.panel).find(text) != std::string::npos;
        };
        for (const bool agrees : {false, false, true}) {
            driver.restart();
            driver.wait(0.6);
            CHECK(says("May we?"));
            CHECK(driver.session->trialUnderWay() == 1);
            if (agrees)
                driver.press(button_id::agree);
            else
                decline(driver);
            driver.wait(0.6);
            CHECK(says(driver.study.words("declined_title").c_str()) == !agrees);
            CHECK(driver.count(NoteKind::stimulus_onset) == 0);
        }
        REQUIRE(driver.finish());
        CHECK(trialsOf(driver.responses) == std::vector<int>{1, 1, 1, 2});
    }

    TEST_CASE("a study's pages may be called as the program's own are") {
        Stage first = ratingStage("first");
        AttentionChecks checks;
        checks.rule = CheckRule::warn;
        first.checks = {checks};
        Driver driver({first, pageStage("attention", "Look at the hand"), ratingStage("second"),
                       pageStage("welcome-back", "Read this"), ratingStage("third"),
                       pageStage("closing", "That was all")});
        driver.add("first", 0, {"one"}).check = TrialCheck{CheckKind::number, 0, 5.0, -1};
        driver.add("second", 1, {"one"});
        driver.add("third", 2, {"one"});
        driver.start();
        std::vector<std::string> read;
        while (driver.running()) {
            if (!resting(driver.frame)) {
                carryOn(driver);
                continue;
            }
            const std::string text = textOf(*driver.frame.panel);
            for (const char* page : {"Look at the hand", "Read this", "That was all"})
                if (text.find(page) != std::string::npos) read.emplace_back(page);
            driver.leavePage();
        }
        CHECK(driver.count(NoteKind::warned) == 1);
        CHECK(read == std::vector<std::string>{"Look at the hand", "Read this", "That was all"});
    }

    TEST_CASE("a break lets go only after its time, counts down, and pauses do not stop its clock") {
        Stage rest = pageStage("rest", "Rest.", StageKind::rest);
        rest.minimum_s = 5.0;
        Driver driver({rest});
        driver.start();
        driver.wait(1.1);
        CHECK(driver.state() == "break");
        CHECK(sessionStatusText(driver.frame.status) == "rest, 4 s");
        CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
        InputFrame keys;
        keys.confirm = true;
        driver.step(keys);
        CHECK(driver.count(NoteKind::break_end) == 0);
        driver.step(pauseFor(PauseReason::escape));
        driver.wait(2.0);
        driver.press(button_id::resume);
        CHECK(sessionStatusText(driver.frame.status) == "rest, 2 s");
        driver.wait(1.5);
        CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
        CHECK(textOf(*driver.frame.panel).find("continue in 1 second.") != std::string::npos);
        driver.wait(0.5);
        CHECK(hasButton(driver.frame, button_id::go_on));
        CHECK(sessionStatusText(driver.frame.status) == "rest");
        driver.press(button_id::go_on);
        CHECK(driver.count(NoteKind::break_start) == 1);
        CHECK(driver.count(NoteKind::break_end) == 1);
    }

    TEST_CASE("a study without a last page of its own says thanks; one with a further visit says so") {
        for (const bool more : {false, true}) {
            CAPTURE(more);
            Driver driver({ratingStage(), ratingStage("later")});
            driver.add("rating", 0, {"one"});
            driver.stage("later").session = more ? 2 : 1;
            driver.add("later", 1, {"one"});
            driver.start();
            REQUIRE(carryOnUntil(driver, [&] { return driver.state() == "closing"; }));
            CHECK(trialsOf(driver.responses) == (more ? std::vector<int>{0} : std::vector<int>{0, 1}));
            const bool tells = textOf(*driver.frame.panel).find("another session") != std::string::npos;
            CHECK(tells == more);
            REQUIRE(carryOnUntil(driver, [&] { return !driver.running(); }));
            CHECK(driver.finished());
            if (!more) continue;
            driver.restart();
            driver.step();
            CHECK_MESSAGE(driver.state() == "waiting", "nobody is welcomed back into a new sitting");
            REQUIRE(driver.finish());
            CHECK(trialsOf(driver.responses) == std::vector<int>{0, 1});
        }
    }

    TEST_CASE("a page of a questionnaire takes an answer to each kind of question") {
        Questioned driver({question("s", QuestionKind::scale), question("c", QuestionKind::choice),
                           question("m", QuestionKind::choices), question("n", QuestionKind::number),
                           question("t", QuestionKind::text)},
                          true, 5);
        // The board may be shown in parts where it would grow too high: each is filled in turn.
        std::set<std::string> seen;
        for (int boards = 0; boards < 5 && driver.responses.empty(); ++boards) {
            driver.wait(0.5);
            CHECK(driver.state() == "questionnaire");
            CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
            const std::string text = textOf(*driver.frame.panel);
            int place = 0;
            for (const char* id : {"s", "c", "m", "n", "t"}) {
                if (text.find(std::string("About ") + id + "?") == std::string::npos) continue;
                seen.insert(id);
                if (*id == 's') driver.press(option(place, 3));
                if (*id == 'c') driver.press(option(place, 2));
                if (*id == 'c') driver.press(option(place, 1));
                if (*id == 'm')
                    for (const int k : {2, 1, 0, 1}) driver.press(option(place, k));
                if (*id == 'n' || *id == 't')
                    driver.step(
                        driver.pointing(fieldCentre(driver.frame, button_id::first_field + place), true));
                if (*id == 'n') type(driver, "4x2");
                if (*id == 't') type(driver, "so-so");
                ++place;
            }
            REQUIRE(hasButton(driver.frame, button_id::go_on));
            driver.press(button_id::go_on);
        }
        CHECK(seen.size() == 5);
        REQUIRE(driver.responses.size() == 1);
        const Response& response = driver.responses[0];
        CHECK(answerTo(response, "s") == 4.0);
        CHECK(answerTo(response, "c") == 1.0);
        CHECK(textOf(response, "c") == "b");
        CHECK(textOf(response, "m") == "a;c");
        CHECK(answerTo(response, "n") == 42.0);
        CHECK(textOf(response, "t") == "so-so");
        CHECK(response.answers.size() == 5);
    }

    TEST_CASE("a required question keeps the page, an optional one does not and leaves no answer") {
        Questioned driver(
            {question("must", QuestionKind::scale), question("may", QuestionKind::scale, false)}, false);
        CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
        InputFrame keys;
        keys.confirm = true;
        driver.step(keys);
        CHECK(driver.responses.empty());
        driver.press(option(0, 0));
        CHECK(hasButton(driver.frame, button_id::go_on));
        driver.step(keys);
        REQUIRE(driver.responses.size() == 1);
        CHECK(driver.responses[0].input == "key");
        REQUIRE(driver.responses[0].answers.size() == 1);
        CHECK(driver.responses[0].answers[0].question == "must");
    }

    TEST_CASE(
        "what is typed as soon as a field is there is kept; a key that leaves the page is not taken yet") {
        Driver driver({questionnaireStage({question("n", QuestionKind::number)})});
        driver.keyboard = true;
        driver.add("questions", 0, {}).page = 0;
        driver.start();
        driver.step();
        REQUIRE(driver.state() == "questionnaire");
        type(driver, "2");
        InputFrame more;
        more.typed = "6";
        more.confirm = true;
        driver.step(more);
        CHECK(driver.responses.empty());
        CHECK(driver.frame.panel->fields[0].text == "26");
        CHECK(hasButton(driver.frame, button_id::go_on));
    }

    TEST_CASE("a questionnaire's boards are counted through; its title stands on the first of each page") {
        std::vector<Question> questions;
        for (const char* id : {"a", "b", "c", "d", "e"}) {
            questions.push_back(question(id, QuestionKind::choice));
            for (int i = 0; i < 8; ++i)  // so many that two do not fit one board
                questions.back().options.push_back({id + std::to_string(i), "A long option in words"});
        }
        Questioned driver(questions, false, 3);
        std::vector<bool> titled;
        for (int board = 1; driver.running() && driver.state() == "questionnaire"; ++board) {
            const std::string text = textOf(*driver.frame.panel);
            CAPTURE(text);
            CHECK(text.find("Page " + std::to_string(board) + " of 5") != std::string::npos);
            CHECK(text.find("Please answer the question.") != std::string::npos);
            titled.push_back(text.find("Some questions") != std::string::npos);
            driver.press(option(0, 0));
            driver.press(button_id::go_on);
            driver.wait(1.5);
        }
        CHECK(titled == std::vector<bool>{true, false, false, true, false});
        CHECK(driver.responses.size() == 2);
    }

    TEST_CASE("text is typed and erased by characters, also those of several bytes") {
        Questioned driver({question("t", QuestionKind::text)}, true);
        REQUIRE(driver.frame.panel->fields.size() == 1);
        CHECK_MESSAGE(driver.frame.panel->fields[0].active, "the first field takes what is typed");
        type(driver, "schön 한국");
        CHECK(driver.frame.panel->fields[0].text == "schön 한국");
        type(driver, "", 4);
        CHECK(driver.frame.panel->fields[0].text == "schö");
        type(driver, "ner\n", 1);  // erased after what was typed; a line break is no character
        CHECK(driver.frame.panel->fields[0].text == "schöne");
        type(driver, "", 5);
        type(driver, "", 9);
        CHECK(driver.frame.panel->fields[0].text.empty());
        CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
        type(driver, "é");
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        CHECK(textOf(driver.responses[0], "t") == "é");
    }

    TEST_CASE("a number is kept only within its range, whole where it must be") {
        Question age = question("n", QuestionKind::number);
        age.low = 18.0;
        age.high = 99.0;
        Questioned driver({age}, true);
        for (const char* wrong : {"17", "100", "1"}) {
            CAPTURE(wrong);
            type(driver, wrong);
            CHECK_FALSE(hasButton(driver.frame, button_id::go_on));
            CHECK(textOf(*driver.frame.panel).find("from 18 to 99") != std::string::npos);
            type(driver, "", 5);
        }
        type(driver, "-2.5");  // neither a sign nor a point is taken
        CHECK(driver.frame.panel->fields[0].text == "25");
        CHECK(hasButton(driver.frame, button_id::go_on));
        type(driver, "", 2);

        Question height = age;
        height.whole = false;
        height.low = -1.0;
        Questioned fractions({height}, true);
        type(fractions, "1,5");
        CHECK(fractions.frame.panel->fields[0].text == "1.5");
        InputFrame keys;
        keys.confirm = true;
        fractions.step(keys);
        REQUIRE(fractions.responses.size() == 1);
        CHECK(answerTo(fractions.responses[0], "n") == 1.5);
    }

    TEST_CASE("without a keyboard a number is pressed on the pad, and texts are not asked") {
        Questioned driver({question("n", QuestionKind::number), question("t", QuestionKind::text)}, false);
        CHECK(textOf(*driver.frame.panel).find("About t?") == std::string::npos);
        for (const int key : {4, 7, 1}) driver.press(option(0, key));
        driver.press(option(0, 10));  // erases
        CHECK(hasButton(driver.frame, button_id::go_on));
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        CHECK(answerTo(driver.responses[0], "n") == 47.0);
        CHECK(driver.responses[0].answers.size() == 1);
    }

    TEST_CASE(
        "a page of nothing but texts is passed over where there is no keyboard, and counts as answered") {
        Questioned driver({question("t", QuestionKind::text), question("s", QuestionKind::scale)}, false, 1);
        CHECK(trialsOf(driver.responses) == std::vector<int>{0});
        CHECK(driver.responses[0].answers.empty());
        CHECK(driver.responses[0].status == ResponseStatus::answered);
        driver.press(option(0, 1));
        driver.press(button_id::go_on);
        CHECK(trialsOf(driver.responses) == std::vector<int>{0, 1});
    }

    TEST_CASE("a pause keeps what was entered, and is taken off the time") {
        Questioned driver({question("t", QuestionKind::text), question("s", QuestionKind::scale)}, true);
        driver.press(option(1, 2));
        type(driver, "half");
        driver.step(pauseFor(PauseReason::escape));
        driver.wait(3.0);
        type(driver, "not this");
        driver.press(button_id::resume);
        driver.wait(0.5);
        CHECK(driver.frame.panel->fields[0].text == "half");
        CHECK(buttonOf(driver.frame, option(1, 2))->chosen);
        driver.press(button_id::go_on);
        REQUIRE(driver.responses.size() == 1);
        const Response& response = driver.responses[0];
        CHECK(response.paused_s > 3.0);
        CHECK(response.pauses == 1);
        CHECK(response.response_time_s < 2.0);
        CHECK(textOf(response, "t") == "half");
    }
}
