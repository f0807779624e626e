#include <doctest/doctest.h>

#include "learning/corpus/transcript.hpp"

using namespace deixis;

namespace {

const std::string long_grid = R"(File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0
xmax = 2.5
tiers? <exists>
size = 2
item []:
    item [1]:
        class = "IntervalTier"
        name = "phones"
        xmin = 0
        xmax = 2.5
        intervals: size = 1
        intervals [1]:
            xmin = 0
            xmax = 2.5
            text = "HH"
    item [2]:
        class = "IntervalTier"
        name = "Anna - words"
        xmin = 0
        xmax = 2.5
        intervals: size = 4
        intervals [1]:
            xmin = 0
            xmax = 0.5
            text = ""
        intervals [2]:
            xmin = 0.5
            xmax = 1.25
            text = "say"
        intervals [3]:
            xmin = 1.25
            xmax = 1.5
            text = "sp"
        intervals [4]:
            xmin = 1.5
            xmax = 2.25
            text = "a ""word"""
)";
const std::string short_grid =
    "File type = \"ooTextFile\"\nObject class = "
    "\"TextGrid\"\n\n0\n2.5\n<exists>\n2\n\"TextTier\"\n\"taps\"\n0\n2.5\n1\n"
    "1.0\n\"tap\"\n\"IntervalTier\"\n\"words\"\n0\n2.5\n2\n0\n0.5\n\"\"\n0.5\n1.25\n\"say\"\n";

std::string gridProblem(const std::string& text) {
    const auto words = learning::parseTextGrid(text, "a.TextGrid");
    return words ? "none" : words.error().text();
}
std::string tableProblem(const std::string& text) {
    const auto words = learning::parseWordTable(text, "a.csv");
    return words ? "none" : words.error().text();
}

}  // namespace

TEST_SUITE("corpus/transcript") {
    TEST_CASE("TextGrids, long and short: the tier of words, without silence") {
        const auto words = learning::parseTextGrid(long_grid, "a.TextGrid");
        REQUIRE_MESSAGE(words.has_value(), (words ? "" : words.error().text()));
        REQUIRE(words->size() == 2);
        CHECK((*words)[0].text == "say");
        CHECK((*words)[0].start_s == 0.5);
        CHECK((*words)[0].end_s == 1.25);
        CHECK((*words)[1].text == "a \"word\"");
        CHECK((*words)[1].end_s == 2.25);
        const auto same = learning::parseTextGrid(short_grid, "a.TextGrid");
        REQUIRE_MESSAGE(same.has_value(), (same ? "" : same.error().text()));
        REQUIRE(same->size() == 1);
        CHECK((*same)[0].text == "say");
        // UTF-16, as Praat writes names beyond ASCII.
        std::string wide = "\xFF\xFE";
        for (const char c : long_grid) wide += std::string{c, '\0'};
        CHECK(learning::parseTextGrid(wide, "a.TextGrid")->size() == 2);
    }

    TEST_CASE("A TextGrid of other tiers, of several, cut off, or none at all is told") {
        std::string other = long_grid;
        other.replace(other.find("Anna - words"), 12, "Anna - notes");
        CHECK(gridProblem(other) ==
              "a.TextGrid: found tiers phones (IntervalTier), Anna - notes (IntervalTier), expected an "
              "interval "
              "tier named \"words\"");
        std::string two = long_grid;
        two.replace(two.find("phones"), 6, "words");
        CHECK(gridProblem(two).find("found several tiers of words") != std::string::npos);
        for (const std::size_t length : {long_grid.size() / 2, long_grid.size() - 12, std::size_t{120}})
            CHECK_MESSAGE(gridProblem(long_grid.substr(0, length)).find("cut off") != std::string::npos,
                          length);
        for (const char* count : {"1e121", "-1", "1e9"}) {  // of tiers
            std::string many = short_grid;
            many.replace(many.find("\n2\n\"TextTier\"") + 1, 1, count);
            CHECK_MESSAGE(gridProblem(many).find("cut off") != std::string::npos, count);
        }
        CHECK(gridProblem("word,start\n").find("found no TextGrid of Praat") != std::string::npos);
        CHECK(gridProblem("").find("found no TextGrid of Praat") != std::string::npos);
        std::string back = long_grid;
        back.replace(back.find("xmin = 1.5\n"), 10, "xmin = 0.9");
        CHECK(gridProblem(back).find("before \"say\" is over at 1.25 s") != std::string::npos);
    }

    TEST_CASE("Tables of words by several names of columns; what is written is read again") {
        const auto words = learning::parseWordTable(
            "id;Label;begin;end\n1;say;0.5;1.25\n2;;1.25;1.5\n3;\"it, so\";1.5;2\n", "a.csv");
        REQUIRE_MESSAGE(words.has_value(), (words ? "" : words.error().text()));
        REQUIRE(words->size() == 2);
        CHECK((*words)[1].text == "it, so");
        const auto again = learning::parseWordTable(learning::wordTable(*words), "b.csv");
        REQUIRE(again.has_value());
        REQUIRE(again->size() == 2);
        CHECK((*again)[1].text == "it, so");
        CHECK((*again)[0].start_s == 0.5);
        CHECK((*again)[1].end_s == 2.0);
        // Rounded times may touch.
        CHECK(tableProblem("word,start_s,end_s\na,0,0.501\nb,0.5,1\n") == "none");
    }

    TEST_CASE("Tables without columns, with times that are none or out of order are told by line") {
        CHECK(tableProblem("word,start_s\na,1\n") ==
              "a.csv:1: found columns word, start_s, expected one named end_s or end or xmax");
        CHECK(tableProblem("word,start_s,end_s\na,one,2\n").find("a.csv:2: start_s: found 'one'") == 0);
        CHECK(tableProblem("word,start_s,end_s\na,-1,2\n").find("a.csv:2: found \"a\" from -1 to 2 s") == 0);
        CHECK(tableProblem("word,start_s,end_s\na,2,2\n").find("a.csv:2: found \"a\" from 2 to 2 s") == 0);
        CHECK(tableProblem("word,start_s,end_s\na,0,2\nb,1,3\n").find("a.csv:3: found \"b\" at 1 s") == 0);
    }
}
