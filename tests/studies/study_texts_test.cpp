// What is wrong with the texts of a study or questionnaire and their languages, and how that is told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

// small.toml in French, with the program's words from the English table; each key says itself.
std::string frenchStudy() {
    std::string words = "\n[words.fr]\nstatus = \"written\"\n";
    for (const auto& [key, english] : languageKeys()) {
        std::string text(english);
        text += " (fr)";
        words += fmt::format("{} = \"{}\"\n", key, text);
    }
    return replaced(readText(fixtures / "small.toml"), "[study]\n", "[study]\nlanguages = [\"fr\"]\n") +
           words;
}

}  // namespace

TEST_SUITE("studies/study_texts") {
    TEST_CASE(
        "Texts: what lacks a language, is not used anywhere, is nowhere or stands as written is told.") {
        checkEdits(
            "full.toml",
            {{"mid = \"mittel\"\n", "", "[texts.de]", "texts.de.mid", {"missing", "[texts.en]"}},
             {"mid = \"middle\"\n", "", "[texts.en]", "texts.en.mid", {"missing", "[texts.de]"}},
             {"mid = \"mittel\"",
              "mit = \"mittel\"",
              "mit = ",
              "texts.de.mit",
              {"not used anywhere", "Did you mean mid?"}},
             {"mid = \"mittel\"", "mid = \" \"", "mid = \" \"", "texts.de.mid", {"empty text"}},
             {"mid = \"mittel\"", "mid = 3", "mid = 3", "texts.de.mid", {"the whole number 3", "a text"}},
             {"mid = \"mittel\"",
              "mid = \"mittel\"\nfoe = \"x\"",
              "foe",
              "texts.de.foe",
              {"not used anywhere", "Remove it"}},
             {"emphasis = \"@line\"",
              "emphasis = \"@lime\"",
              "@lime",
              "stages.emphasis",
              {"no text \"lime\"", "Did you mean line?"}},
             {"languages = [\"en\", \"de\"]",
              "languages = [\"en\", \"de\", \"de\"]",
              "languages = [",
              "study.languages",
              {"\"de\" occurs twice"}},
             {"[texts.de]",
              "[texts.dee]",
              "[texts.dee]",
              "texts.dee",
              {"not among languages", "Did you mean de?"}},
             {"[targets]",
              "[texts.sv]\npage = \"Sida\"\n[targets]",
              "[texts.sv]",
              "texts.sv",
              {"not among languages"}},
             {"[targets]",
              "[texts]\nsv = 2\n[targets]",
              "sv = 2",
              "texts.sv",
              {"the whole number 2", "[texts.en]"}},
             {"title = \"@title\"\ndescription",
              "title = \"Plain\"\ndescription",
              "title = \"Plain\"",
              "study.title",
              {"in one language", "2 languages"}}});
    }

    TEST_CASE(
        "The study is told where the program or a questionnaire has no words in one of its languages.") {
        const Folder folder;
        std::string text = replaced(readText(fixtures / "full.toml"), "[\"en\", \"de\"]", "[\"en\", \"fr\"]");
        text = replaced(text, "[texts.de]", "[texts.fr]");
        text = replaced(text, "de = \"reviewed\"", "fr = \"reviewed\"");
        const std::vector<Error> errors = problemsOf(folder.write(text));
        REQUIRE_MESSAGE(errors.size() == 2, allText(errors));
        CHECK(errors[0].where.find("study.languages") != std::string::npos);
        CHECK(errors[0].hint.find("[words.fr]") != std::string::npos);
        CHECK(errors[1].where.find("stages.file") != std::string::npos);
        CHECK(errors[1].message.find("has no texts in \"fr\", only in de, en, sv") != std::string::npos);

        const std::vector<Error> wanted = problemsOf(fixtures / "full.toml", "sv");
        REQUIRE(wanted.size() == 1);
        CHECK(wanted[0].message.find("no language \"sv\"") != std::string::npos);
        CHECK(wanted[0].message.find("en, de") != std::string::npos);
    }

    TEST_CASE("The problems of a questionnaire file come in its own lines, at the place where it is named.") {
        const Folder folder;
        std::string comfort = readText(fixtures / "comfort.toml");
        comfort = replaced(comfort, "reversed = [\"tense\"]", "reversed = [\"tens\"]");
        comfort = replaced(comfort, "per_page = 2", "per_page = 0");
        const fs::path questionnaire = folder.write(comfort, "comfort.toml");
        std::string text = replaced(readText(fixtures / "full.toml"), "seed = 11", "sead = 11");
        text = replaced(text, "minimum_s = 30", "minimum_s = -30");
        const fs::path file = folder.write(text);
        const std::vector<Error> errors = problemsOf(file);
        std::vector<std::string> places;
        for (const Error& error : errors) places.push_back(error.where);
        CHECK(places ==
              std::vector<std::string>{
                  fmt::format("{}:{}: study.sead", file.string(), lineOf(text, "sead")),
                  fmt::format("{}:{}: per_page", questionnaire.string(), lineOf(comfort, "per_page")),
                  fmt::format("{}:{}: scores.reversed", questionnaire.string(), lineOf(comfort, "tens\"]")),
                  fmt::format("{}:{}: stages.minimum_s", file.string(), lineOf(text, "-30"))});
    }

    TEST_CASE("A study brings the words of a language that the program lacks.") {
        const Folder folder;
        const auto study = loadStudy(folder.write(frenchStudy()), shipped_folders);
        REQUIRE_MESSAGE(study.has_value(), (study ? "" : study.error().front().text()));
        CHECK(study->words.code() == "fr");
        CHECK(study->words("continue") == "Continue (fr)");
        REQUIRE(study->language_status.size() == 1);
        CHECK(study->language_status.front().words == TextStatus::written);
        CHECK(study->language_status.front().texts == TextStatus::unstated);

        const auto lacking =
            loadStudy(folder.write(replaced(frenchStudy(), "end_yes = ", "end_yse = ")), shipped_folders);
        REQUIRE_FALSE(lacking.has_value());
        REQUIRE(lacking.error().size() == 1);
        CHECK(lacking.error().front().where.find("words.fr.end_yse") != std::string::npos);
        CHECK(lacking.error().front().message.find("end_yes: this key is missing") != std::string::npos);

        const auto none = loadStudy(folder.write(replaced(readText(fixtures / "small.toml"), "[study]\n",
                                                          "[study]\nlanguages = [\"fr\"]\n")),
                                    shipped_folders);
        REQUIRE_FALSE(none.has_value());
        CHECK(none.error().front().hint.find("[words.fr]") != std::string::npos);
    }

    TEST_CASE(
        "A study replaces single words of a language that the program has, and says how far its own can be "
        "trusted.") {
        const Folder folder;
        const std::string text = replaced(readText(fixtures / "small.toml"), "[study]\n",
                                          "[study]\ntext_status = {en = \"reviewed\"}\n") +
                                 "\n[words.en]\nfinish = \"Hand in\"\n";
        const auto study = loadStudy(folder.write(text), shipped_folders);
        REQUIRE_MESSAGE(study.has_value(), (study ? "" : study.error().front().text()));
        CHECK(study->words("finish") == "Hand in");
        CHECK(study->words("continue") == "Continue");
        CHECK(study->language_status.front().words == TextStatus::written);
        CHECK(study->language_status.front().texts == TextStatus::reviewed);

        for (const auto& [from, to, where] : std::vector<std::array<std::string, 3>>{
                 {"[words.en]", "[words.de]", "words.de"},
                 {"{en = \"reviewed\"}", "{en = \"fine\"}", "study.text_status.en"},
                 {"{en = \"reviewed\"}", "{de = \"reviewed\"}", "study.text_status.de"},
                 {"finish = \"Hand in\"", "finish = \"مر\"", "words.en.finish"}}) {
            const auto faulty = loadStudy(folder.write(replaced(text, from, to)), shipped_folders);
            REQUIRE_FALSE(faulty.has_value());
            CAPTURE(faulty.error().front().text());
            CHECK(faulty.error().front().where.find(where) != std::string::npos);
        }
    }

    TEST_CASE("Texts in scripts that boards cannot draw are rejected.") {
        checkEdits("full.toml", {{"mid = \"mittel\"",
                                  "mid = \"وسط\"",
                                  "mid = \"وسط\"",
                                  "texts.de.mid",
                                  {"Arabic script", "left to right"}}});
    }
}
