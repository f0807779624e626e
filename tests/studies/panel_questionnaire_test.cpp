// Pages of questionnaires.
#include "panel_fixture.hpp"
#include "studies/session/session.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Question someQuestion(RandomTexts& texts, int id) {
    Question question;
    question.id = "q" + std::to_string(id);
    question.kind = static_cast<QuestionKind>(texts.between(0, 4));
    question.text = texts(1, 20);
    question.scale.kind = texts.flip() ? ScaleKind::steps : ScaleKind::slider;
    question.scale.low = texts.between(-2, 1);
    question.scale.high = question.scale.low + texts.between(1, 10);
    const int labels = texts.flip() ? question.scale.steps() : 2;
    if (texts.flip())
        for (int i = 0; i < labels; ++i) question.scale.labels.push_back(texts(1, 3));
    const int options = texts.between(2, 8);
    for (int i = 0; i < options; ++i)
        question.options.push_back({"o" + std::to_string(i), texts(1, texts.flip() ? 3 : 25)});
    question.low = texts.flip() ? -5.0 : 0.0;
    question.whole = texts.flip();
    return question;
}

Questionnaire someQuestionnaire(RandomTexts& texts, int count) {
    Questionnaire questionnaire;
    questionnaire.title = texts(1, 4);
    questionnaire.text = texts(1, 30);
    for (int i = 0; i < count; ++i) questionnaire.questions.push_back(someQuestion(texts, i));
    return questionnaire;
}

QuestionnaireBoard boardOf(const std::vector<const Question*>& page, bool keyboard,
                           const LanguageTable& words) {
    QuestionnaireBoard board;
    board.questions = page;
    board.answers.resize(page.size());
    board.keyboard = keyboard;
    board.buttons = {{words("continue"), button_id::go_on, ButtonRole::go_on, false}};
    return board;
}

Question choice(QuestionKind kind, const std::vector<std::string>& options) {
    Question question;
    question.kind = kind;
    question.text = "Which?";
    for (const std::string& option : options) question.options.push_back({option, option});
    return question;
}

}  // namespace

TEST_SUITE("studies/panel_questionnaire") {
    TEST_CASE("pages stay tidy with any questions in all four languages, with and without a keyboard") {
        for (const std::string& code : languageCodes()) {
            const LanguageTable words = languageTable(code);
            RandomTexts texts(words, 7);
            for (int round = 0; round < 100; ++round) {
                CAPTURE(code);
                CAPTURE(round);
                const bool keyboard = texts.flip();
                const Questionnaire questionnaire = someQuestionnaire(texts, texts.between(1, 9));
                const auto pages = questionnairePages(questionnaire, keyboard, words);
                for (std::size_t i = 0; i < pages.size(); ++i) {
                    QuestionnaireBoard board = boardOf(pages[i], keyboard, words);
                    board.title = i == 0 ? questionnaire.title : "";
                    board.text = i == 0 ? questionnaire.text : "";
                    board.page = static_cast<int>(i);
                    board.pages = static_cast<int>(pages.size());
                    if (texts.flip()) board.missing = words("answer_all");
                    if (texts.flip()) board.progress = 0.5;
                    const Panel panel = questionnairePanel(board, words);
                    checkTidy(panel, 0.05);
                    if (pages[i].size() > 1) CHECK(panel.height_m <= 1.1 + 0.03 + 1e-9);  // the bar's room
                }
            }
        }
    }

    TEST_CASE("every question comes once, in its order, at most per_page at a time") {
        const LanguageTable& words = LanguageTable::english();
        RandomTexts texts(words, 3);
        for (int round = 0; round < 100; ++round) {
            Questionnaire questionnaire = someQuestionnaire(texts, texts.between(1, 12));
            questionnaire.per_page = texts.between(1, 6);
            for (const bool keyboard : {true, false}) {
                std::vector<std::string> expected;
                for (const Question& question : questionnaire.questions)
                    if (keyboard || question.kind != QuestionKind::text) expected.push_back(question.id);
                std::vector<std::string> got;
                for (const auto& page : questionnairePages(questionnaire, keyboard, words)) {
                    CHECK_FALSE(page.empty());
                    CHECK(static_cast<int>(page.size()) <= questionnaire.per_page);
                    for (const Question* question : page) got.push_back(question->id);
                }
                CHECK(got == expected);
            }
        }
    }

    TEST_CASE("four items with four labelled steps, as of the sickness questionnaire, go on one page") {
        const LanguageTable& words = LanguageTable::english();
        Questionnaire questionnaire;
        questionnaire.title = "How do you feel now?";
        questionnaire.text = "Choose for each symptom how much it affects you right now.";
        for (const char* symptom : {"General discomfort", "Fatigue", "Headache", "Eyestrain"}) {
            Question question;
            question.text = symptom;
            question.scale = {ScaleKind::steps, 0, 3, {"none", "slight", "moderate", "severe"}};
            questionnaire.questions.push_back(question);
        }
        const auto pages = questionnairePages(questionnaire, false, words);
        REQUIRE(pages.size() == 1);
        QuestionnaireBoard board = boardOf(pages[0], false, words);
        board.answers[2].value = 2;
        const Panel panel = questionnairePanel(board, words);
        for (int question = 0; question < 4; ++question)
            for (int step = 0; step < 4; ++step) {
                const PanelButton* button =
                    findButton(panel, button_id::first_option + 100 * question + step);
                REQUIRE(button != nullptr);
                CHECK(button->label ==
                      questionnaire.questions[0].scale.labels[static_cast<std::size_t>(step)]);
                CHECK(button->role == ButtonRole::option);
                CHECK(button->chosen == (question == 2 && step == 2));
            }
        REQUIRE(findButton(panel, button_id::go_on) != nullptr);
        CHECK_FALSE(findButton(panel, button_id::go_on)->enabled);
    }

    TEST_CASE("options are buttons in rows, the chosen ones marked, and long ones stand beside a letter") {
        const LanguageTable& words = LanguageTable::english();
        const Question some = choice(QuestionKind::choices, {"one", "two", "three", "four", "five", "six"});
        const Question other =
            choice(QuestionKind::choice, {"short", std::string(150, 'x') + " end", "last"});
        QuestionnaireBoard board = boardOf({&some, &other}, true, words);
        board.answers[0].chosen = {0, 4};
        board.answers[1].chosen = {1};
        const Panel panel = questionnairePanel(board, words);
        checkTidy(panel, 0.1);
        for (int i = 0; i < 6; ++i) {
            const PanelButton* button = findButton(panel, button_id::first_option + i);
            REQUIRE(button != nullptr);
            CHECK(button->label == some.options[static_cast<std::size_t>(i)].text);
            CHECK(button->chosen == (i == 0 || i == 4));
        }
        const PanelButton* lettered = findButton(panel, button_id::first_option + 101);
        REQUIRE(lettered != nullptr);
        CHECK(lettered->label == "B");
        CHECK(lettered->chosen);
        CHECK(findButton(panel, button_id::first_option + 102)->label == "last");
        const auto beside = std::find_if(panel.texts.begin(), panel.texts.end(), [&](const PanelText& text) {
            return text.text.starts_with("xxxx") && text.text.ends_with("end");
        });
        REQUIRE(beside != panel.texts.end());
        CHECK(beside->box.x > lettered->box.x + lettered->box.width);
        CHECK(std::any_of(panel.texts.begin(), panel.texts.end(),
                          [&](const PanelText& text) { return text.text == words("choices_hint"); }));
    }

    TEST_CASE("a number has a field, and a pad of keys where there is no keyboard") {
        const LanguageTable& words = LanguageTable::english();
        Question question;
        question.kind = QuestionKind::number;
        question.text = "How old are you?";
        question.low = 18;
        question.high = 99;
        QuestionnaireBoard board = boardOf({&question}, true, words);
        board.answers[0].typed = "3";
        board.active_field = 0;
        const Panel typed = questionnairePanel(board, words);
        REQUIRE(typed.fields.size() == 1);
        CHECK(typed.fields[0].id == button_id::first_field);
        CHECK(typed.fields[0].text == "3");
        CHECK(typed.fields[0].hint == "18 to 99");
        CHECK(typed.fields[0].active);
        CHECK(typed.fields[0].enabled);
        CHECK(typed.buttons.size() == 1);

        board.keyboard = false;
        const auto keysOf = [&] {
            std::vector<int> keys;
            for (const PanelButton& button : questionnairePanel(board, words).buttons)
                if (button.id >= button_id::first_option) keys.push_back(button.id - button_id::first_option);
            std::sort(keys.begin(), keys.end());
            return keys;
        };
        CHECK(keysOf() == std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, pad_key::erase});
        const Panel pad = questionnairePanel(board, words);
        checkTidy(pad, 0.1);
        for (int digit = 0; digit < 10; ++digit)
            CHECK(findButton(pad, button_id::first_option + digit)->label == std::to_string(digit));
        question.whole = false;
        question.low = -1.5;
        CHECK(keysOf() ==
              std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, pad_key::erase, pad_key::point, pad_key::minus});
        CHECK(questionnairePanel(board, words).fields[0].hint == "-1.5 to 99");
    }

    TEST_CASE("a board does not change its size when the line about what is missing goes") {
        const LanguageTable& words = LanguageTable::english();
        const Question question = choice(QuestionKind::choice, {"one", "two"});
        QuestionnaireBoard board = boardOf({&question}, true, words);
        board.pages = 3;
        board.page = 1;
        const Panel without = questionnairePanel(board, words);
        board.missing = words("answer_all");
        const Panel with = questionnairePanel(board, words);
        CHECK(with.height_m == without.height_m);
        CHECK(with.texts.size() == without.texts.size() + 1);
        CHECK(std::any_of(with.texts.begin(), with.texts.end(),
                          [](const PanelText& text) { return text.text == "Page 2 of 3"; }));
    }
}
