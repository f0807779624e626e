// What is wrong with the texts of a study or questionnaire and their languages, and how that is told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

TEST_SUITE("studies/study_texts") {
    TEST_CASE("Texts: what lacks a language, is used nowhere, is nowhere or stands as written is told.") {
        checkEdits(
            "full.toml",
            {{"mid = \"mittel\"\n", "", "[texts.de]", "texts.de.mid", {"missing", "[texts.en]"}},
             {"mid = \"middle\"\n", "", "[texts.en]", "texts.en.mid", {"missing", "[texts.de]"}},
             {"mid = \"mittel\"",
              "mit = \"mittel\"",
              "mit = ",
              "texts.de.mit",
              {"used nowhere", "Did you mean mid?"}},
             {"mid = \"mittel\"", "mid = \" \"", "mid = \" \"", "texts.de.mid", {"empty text"}},
             {"mid = \"mittel\"", "mid = 3", "mid = 3", "texts.de.mid", {"the whole number 3", "a text"}},
             {"mid = \"mittel\"",
              "mid = \"mittel\"\nfoe = \"x\"",
              "foe",
              "texts.de.foe",
              {"used nowhere", "Remove it"}},
             {"emphasis = \"@line\"",
              "emphasis = \"@lime\"",
              "@lime",
              "stages.emphasis",
              {"no text \"lime\"", "Did you mean line?"}},
             {"languages = [\"en\", \"de\"]",
              "languages = [\"en\", \"de\", \"de\"]",
              "languages = [",
              "study.languages",
              {"\"de\" comes twice"}},
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
        const std::vector<Error> errors = problemsOf(folder.write(text));
        REQUIRE_MESSAGE(errors.size() == 2, allText(errors));
        CHECK(errors[0].where.find("study.languages") != std::string::npos);
        CHECK(errors[0].message.find("fr.toml") != std::string::npos);
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
}
