#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "studies/study.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

const fs::path fixtures = fs::path(DEIXIS_SOURCE_DIR) / "tests/studies/fixtures";
const fs::path shipped = fs::path(DEIXIS_SOURCE_DIR) / "assets/data/studies/pointing2023.toml";

std::string readText(const fs::path& path) {
    const Result<std::string> text = readFile(path);
    REQUIRE(text.has_value());
    return *text;
}

/// A folder of its own beside the clips' manifest that the fixture names; gone with the test.
class Folder {
  public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "deixis_study_XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
        fs::copy(fixtures, path_, fs::copy_options::recursive);
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] fs::path write(const std::string& bytes) const {
        const fs::path file = path_ / "study.toml";
        REQUIRE(writeFile(file, bytes).has_value());
        return file;
    }

  private:
    fs::path path_;
};

/// The small fixture with its only occurrence of `from` replaced.
std::string edited(const std::string& from, const std::string& to) {
    std::string text = readText(fixtures / "small.toml");
    const auto at = text.find(from);
    REQUIRE_MESSAGE(at != std::string::npos, from);
    REQUIRE_MESSAGE(text.find(from, at + 1) == std::string::npos, from);
    return text.replace(at, from.size(), to);
}

int lineOf(const std::string& text, const std::string& part) {
    const auto at = text.find(part);
    REQUIRE_MESSAGE(at != std::string::npos, part);
    return 1 +
           static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

struct BadEdit {
    std::string from, to;
    std::string line_of;  ///< text on the line that the error names, in the edited file
    std::string key;
    std::vector<std::string> words;  ///< what the error must tell
};

}  // namespace

TEST_SUITE("studies/study_file") {
    TEST_CASE("The study that ships holds the numbers of the paper's sections 2.4.2, 2.4.3 and 3.1.") {
        const Result<Study> study = loadStudy(shipped);
        if (!study) FAIL(study.error().text());
        CHECK(study->name == "pointing2023");
        CHECK(study->rating.items == 5);
        CHECK(study->game.items == 10);
        CHECK(study->systems.size() == 4);
        CHECK(study->rating.question == "How natural do you find the animation?");
        CHECK(study->rating.labels.size() == 5);
        CHECK(study->targets.count == 100);
        CHECK(study->targets.distractors == 2);
        CHECK(study->targets.distractor_distance_m.low == 0.20);
        CHECK(study->targets.distractor_distance_m.high == 0.40);
        CHECK(study->alpha == 0.01);
        CHECK(study->game.layouts == std::vector<std::string>{"across", "side-by-side"});
        // 39 participants gave 780 ratings and 1,560 choices.
        const std::size_t ratings =
            39 * static_cast<std::size_t>(study->rating.items) * study->systems.size();
        const std::size_t choices = 39 * static_cast<std::size_t>(study->game.items) * study->systems.size();
        CHECK(ratings == 780);
        CHECK(choices == 1560);
        CHECK(study->hash == sha256Hex(readText(shipped)));
        CHECK(study->file == shipped);
    }

    TEST_CASE("Across looks back at the avatar from beyond the balls; side-by-side stands at its shoulder.") {
        const Result<Study> study = loadStudy(shipped);
        REQUIRE(study.has_value());
        const Layout* across = study->findLayout("across");
        const Layout* beside = study->findLayout("side-by-side");
        REQUIRE(across != nullptr);
        REQUIRE(beside != nullptr);
        CHECK(study->findLayout("behind") == nullptr);
        CHECK(across->viewer_z_m > study->targets.radius_m.high);
        CHECK(across->heading_deg == 180.0);
        CHECK(std::abs(beside->viewer_x_m) < 1.0);
        CHECK(std::abs(beside->viewer_x_m) > 0.5);
        CHECK(std::abs(beside->heading_deg) < 30.0);
    }

    TEST_CASE("A file with the required keys alone loads, and the rest has the documented defaults.") {
        const Result<Study> study = loadStudy(fixtures / "small.toml");
        if (!study) FAIL(study.error().text());
        CHECK(study->eye_height_m == 1.65);
        CHECK(study->inter_trial_s == 0.6);
        CHECK(study->alpha == 0.01);
        CHECK(study->description.empty());
        CHECK(study->rating.practice == 0);
        CHECK(study->game.break_every == 0);
        CHECK(study->game.max_replays == 0);
        CHECK(study->after_interruption == AfterInterruption::resume);
        CHECK(study->headset.eye_level == EyeLevel::measured);
        CHECK(study->headset.assumed_eye_height_m == 1.65);
        CHECK(study->headset.place_tolerance_m == 0.3);
        CHECK_FALSE(study->headset.record_gaze);
        CHECK_FALSE(study->headset.record_hands);
    }

    TEST_CASE("What a file says of headsets and interruptions is what the study holds.") {
        const Folder folder;
        std::string text = edited("[analysis]",
                                  "[headset]\neye_level = \"scale\"\nassumed_eye_height_m = 1.2\n"
                                  "place_tolerance_m = 0.45\nrecord_gaze = true\nrecord_hands = true\n"
                                  "[analysis]");
        text.replace(text.find("seed = 7"), 8, "seed = 7\nafter_interruption = \"repeat\"");
        const Result<Study> study = loadStudy(folder.write(text));
        if (!study) FAIL(study.error().text());
        CHECK(study->after_interruption == AfterInterruption::repeat);
        CHECK(study->headset.eye_level == EyeLevel::scale);
        CHECK(study->headset.assumed_eye_height_m == 1.2);
        CHECK(study->headset.place_tolerance_m == 0.45);
        CHECK(study->headset.record_gaze);
        CHECK(study->headset.record_hands);
        const Result<Study> raised =
            loadStudy(folder.write(edited("[analysis]", "[headset]\neye_level = \"raise\"\n[analysis]")));
        REQUIRE(raised.has_value());
        CHECK(raised->headset.eye_level == EyeLevel::raise);
        CHECK(raised->headset.place_tolerance_m == 0.3);
    }

    TEST_CASE("Line ends inside a paragraph are spaces and a blank line starts a new one.") {
        const Result<Study> study = loadStudy(fixtures / "small.toml");
        REQUIRE(study.has_value());
        CHECK(study->welcome == "Hello, first line and second line.\n\nA new paragraph.");
    }

    TEST_CASE("Paths are resolved against the folder of the study file.") {
        const Result<Study> study = loadStudy(fixtures / "small.toml");
        REQUIRE(study.has_value());
        CHECK(study->systems[1].manifest == (fixtures / "clips.csv").string());
        const Folder folder;
        const fs::path file =
            folder.write(edited("height_m = [0.5, 1.5]\narc_deg = [-60, 60]\nradius_m = [1.5, 2.0]",
                                "fit_manifest = \"./clips.csv\""));
        const Result<Study> fitted = loadStudy(file);
        if (!fitted) FAIL(fitted.error().text());
        CHECK(fitted->targets.fit_manifest == (file.parent_path() / "clips.csv").string());
    }

    TEST_CASE("Every kind of mistake is told with file, line, key, what was found and what was expected.") {
        const std::vector<BadEdit> edits{
            // Unknown keys and sections, with a proposal where one is near.
            {"seed = 7", "sead = 7", "sead = 7", "study.sead", {"unknown key", "Did you mean seed?"}},
            {"items = 4", "itmes = 4", "itmes = 4", "game.itmes", {"unknown key", "Did you mean items?"}},
            {"seed = 7",
             "seed = 7\ncolour = 3",
             "colour = 3",
             "study.colour",
             {"unknown key", "Known here: name, "}},
            {"[texts]", "[text]", "[text]", "text", {"unknown section", "Did you mean texts?"}},
            {"heading_deg = 10",
             "heading_deg = 10\nhight_m = 1",
             "hight_m",
             "layouts.hight_m",
             {"unknown key"}},
            {"[study]", "lose = 1\n[study]", "lose = 1", "lose", {"unknown section or key"}},
            // Missing keys and sections.
            {"seed = 7\n", "", "[study]", "study.seed", {"missing", "a whole number from 0 up"}},
            {"question = \"How natural?\"\n",
             "",
             "[naturalness]",
             "naturalness.question",
             {"missing", "a text"}},
            {"viewer_m = [0, 3]\n", "", "[[layouts]]", "layouts.viewer_m", {"missing", "two numbers"}},
            {"radius_m = [1.5, 2.0]\n", "", "[targets]", "targets.radius_m", {"missing", "0.3 to 20"}},
            {"items = 4", "items = 4\npractice = 1", "[game]", "game.practice_instructions", {"missing"}},
            // Wrong types.
            {"seed = 7", "seed = \"7\"", "seed = ", "study.seed", {"the text \"7\"", "a whole number"}},
            {"items = 4",
             "items = 4.0",
             "items = 4.0",
             "game.items",
             {"the number 4", "a whole number from 1"}},
            {"title = \"Small\"", "title = 5", "title = 5", "study.title", {"the whole number 5", "a text"}},
            {"title = \"Small\"", "title = true", "title = ", "study.title", {"found true", "a text"}},
            {"title = \"Small\"", "title = 2023-01-01", "title = ", "study.title", {"a date", "a text"}},
            {"height_m = [0.5, 1.5]",
             "height_m = 0.5",
             "height_m = 0.5",
             "targets.height_m",
             {"0.5", "[a, b]"}},
            {"height_m = [0.5, 1.5]", "height_m = [0.5]", "height_m", "targets.height_m", {"a list of 1"}},
            {"height_m = [0.5, 1.5]", "height_m = [0.5, \"a\"]", "height_m", "targets.height_m", {"entry 2"}},
            {"labels = [\"bad\", \"good\"]",
             "labels = [\"bad\", 2]",
             "labels",
             "naturalness.labels",
             {"entry 2 is the whole number 2"}},
            {"[analysis]",
             "[[analysis]]",
             "[[analysis]]",
             "analysis",
             {"a list of 1", "a section [analysis]"}},
            // Out of range.
            {"items = 4",
             "items = 0",
             "items = 0",
             "game.items",
             {"found the whole number 0", "from 1 to 10000"}},
            {"seed = 7", "seed = -1", "seed = -1", "study.seed", {"-1", "from 0 up"}},
            {"ball_diameter_m = 0.1",
             "ball_diameter_m = nan",
             "ball_diameter_m",
             "targets.ball_diameter_m",
             {"nan", "0.01 to 1"}},
            {"arc_deg = [-60, 60]",
             "arc_deg = [-60, 200]",
             "arc_deg",
             "targets.arc_deg",
             {"entry 2", "-180 to 180"}},
            {"height_m = [0.5, 1.5]",
             "height_m = [1.5, 0.5]",
             "height_m",
             "targets.height_m",
             {"smaller number first"}},
            {"labels = [\"bad\", \"good\"]",
             "labels = [\"bad\"]",
             "labels",
             "naturalness.labels",
             {"a list of 1", "2 to 10 texts"}},
            {"labels = [\"bad\", \"good\"]",
             "labels = [\"a\",\"b\",\"c\",\"d\",\"e\",\"f\",\"g\",\"h\",\"i\",\"j\",\"k\"]",
             "labels",
             "naturalness.labels",
             {"a list of 11", "2 to 10 texts"}},
            {"labels = [\"bad\", \"good\"]",
             "labels = [\"bad\", \" \"]",
             "labels",
             "naturalness.labels",
             {"entry 2 is an empty text"}},
            {"alpha = 0.01", "alpha = 1.0", "alpha", "analysis.alpha", {"the number 1", "0.5"}},
            {"title = \"Small\"", "title = \"  \"", "title", "study.title", {"empty text"}},
            {"name = \"small\"",
             "name = \"a study\"",
             "name = \"a study\"",
             "study.name",
             {"a study", "letters"}},
            // Things that do not go together.
            {"height_m = [0.5, 1.5]",
             "height_m = [0.01, 1.5]",
             "height_m",
             "targets.height_m",
             {"0.05 m", "floor"}},
            {"distractor_distance_m = [0.2, 0.4]",
             "distractor_distance_m = [0.05, 0.4]",
             "distractor_distance_m",
             "targets.distractor_distance_m",
             {"0.05 m", "overlap"}},
            {"count = 20",
             "count = 5",
             "count = 5",
             "targets.count",
             {"found 5", "at least 6", "game.items (4)"}},
            {"radius_m = [1.5, 2.0]",
             "radius_m = [1.5, 2.0]\nfit_manifest = \"clips.csv\"",
             "height_m",
             "targets.height_m",
             {"fit_manifest", "Remove one"}},
            {"name = \"side-by-side\"",
             "name = \"across\"",
             "name = \"across\"\nviewer_m = [-0.7",
             "layouts.name",
             {"\"across\" comes twice"}},
            {"name = \"theirs\"",
             "name = \"ours\"",
             "name = \"ours\"\nmanifest",
             "systems.name",
             {"\"ours\" comes twice"}},
            {"generator = \"direct\"",
             "generator = \"direct\"\nmanifest = \"clips.csv\"",
             "generator",
             "systems.generator",
             {"both"}},
            {"generator = \"direct\"\n", "", "[[systems]]", "systems.generator", {"neither"}},
            {"layout = \"across\"",
             "layout = \"acros\"",
             "acros\"",
             "naturalness.layout",
             {"no layout \"acros\"", "Did you mean across?"}},
            {"layouts = [\"across\", \"side-by-side\"]",
             "layouts = [\"across\", \"behind\"]",
             "behind",
             "game.layouts",
             {"no layout \"behind\"", "across, side-by-side"}},
            {"layouts = [\"across\", \"side-by-side\"]",
             "layouts = [\"across\", \"across\"]",
             "layouts = [\"across\", \"across\"]",
             "game.layouts",
             {"comes twice"}},
            {"layouts = [\"across\", \"side-by-side\"]",
             "layouts = []",
             "layouts = []",
             "game.layouts",
             {"a list of 0", "1 to 2 texts"}},
            // What concerns a headset, and interruptions.
            {"seed = 7",
             "seed = 7\nafter_interruption = \"restart\"",
             "after_interruption",
             "study.after_interruption",
             {"the text \"restart\"", "one of \"resume\", \"repeat\""}},
            {"seed = 7",
             "seed = 7\nafter_interruption = true",
             "after_interruption",
             "study.after_interruption",
             {"found true", "one of"}},
            {"[analysis]",
             "[headset]\neye_level = \"lift\"\n[analysis]",
             "eye_level",
             "headset.eye_level",
             {"the text \"lift\"", "\"measured\", \"raise\", \"scale\""}},
            {"[analysis]",
             "[headset]\nassumed_eye_height_m = 3\n[analysis]",
             "assumed_eye_height_m",
             "headset.assumed_eye_height_m",
             {"3", "0.5 to 2.5"}},
            {"[analysis]",
             "[headset]\nplace_tolerance_m = 0\n[analysis]",
             "place_tolerance_m",
             "headset.place_tolerance_m",
             {"0", "0.1 to 5"}},
            {"[analysis]",
             "[headset]\nrecord_gaze = 1\n[analysis]",
             "record_gaze",
             "headset.record_gaze",
             {"the whole number 1", "true or false"}},
            {"[analysis]",
             "[headset]\nrecord_hands = \"yes\"\n[analysis]",
             "record_hands",
             "headset.record_hands",
             {"the text \"yes\"", "true or false"}},
            {"[analysis]",
             "[headset]\nrecord_eyes = true\n[analysis]",
             "record_eyes",
             "headset.record_eyes",
             {"unknown key", "Known here: eye_level, "}},
            {"viewer_m = [0, 3]",
             "viewer_m = [0, 0.1]",
             "viewer_m = [0, 0.1]",
             "layouts.viewer_m",
             {"at least 0.3 m", "avatar"}},
        };
        CHECK(edits.size() >= 20);
        const Folder folder;
        for (const BadEdit& edit : edits) {
            CAPTURE(edit.from);
            CAPTURE(edit.to);
            const std::string text = edited(edit.from, edit.to);
            const fs::path file = folder.write(text);
            const Result<Study> study = loadStudy(file);
            REQUIRE_FALSE(study.has_value());
            CHECK(study.error().where ==
                  fmt::format("{}:{}: {}", file.string(), lineOf(text, edit.line_of), edit.key));
            for (const std::string& word : edit.words)
                CHECK_MESSAGE(study.error().text().find(word) != std::string::npos,
                              "'" << word << "' should stand in: " << study.error().text());
        }
    }

    TEST_CASE("A section that is missing altogether is named, for want of a line.") {
        const Folder folder;
        const std::string text = readText(fixtures / "small.toml");
        const fs::path file = folder.write(text.substr(0, text.find("[game]")));
        const Result<Study> study = loadStudy(file);
        REQUIRE_FALSE(study.has_value());
        CHECK(study.error().where == file.string() + ": game");
        CHECK(study.error().message == "missing; expected a section [game]");
    }

    TEST_CASE("A file that is no TOML is told with its line, and a file that is not there by its name.") {
        const Folder folder;
        const std::string text = edited("seed = 7", "seed == 7");
        const fs::path file = folder.write(text);
        const Result<Study> study = loadStudy(file);
        REQUIRE_FALSE(study.has_value());
        CHECK(study.error().where == fmt::format("{}:{}", file.string(), lineOf(text, "seed == 7")));
        CHECK(study.error().message.find("not valid TOML") != std::string::npos);

        for (const std::string& bytes : {std::string("title = \"\xff\xfe\"\n"), std::string("[study\n"),
                                         std::string("\0\0\0", 3), std::string("a = 1\na = 2\n")})
            CHECK_FALSE(loadStudy(folder.write(bytes)).has_value());
        CHECK(loadStudy(folder.write("")).error().message == "missing; expected a section [study]");

        const Result<Study> nowhere = loadStudy(fixtures / "nowhere.toml");
        REQUIRE_FALSE(nowhere.has_value());
        CHECK(nowhere.error().text().find("nowhere.toml") != std::string::npos);
    }

    TEST_CASE("The documentation has a row for every key that the loader accepts, and for no other.") {
        std::istringstream lines(readText(fs::path(DEIXIS_SOURCE_DIR) / "docs/study-file.md"));
        std::vector<std::string> documented;
        std::string section;
        for (std::string line; std::getline(lines, line);) {
            if (line.rfind("## ", 0) == 0) {
                section.clear();
                if (line.rfind("## `[", 0) == 0)
                    for (const char c : line.substr(4))
                        if (c != '[' && c != ']' && c != '`') section += c;
            }
            if (section.empty() || line.rfind("| `", 0) != 0) continue;
            documented.push_back(section + "." + line.substr(3, line.find('`', 3) - 3));
        }
        CHECK(documented == studyKeys());
    }

    TEST_CASE("The loader takes every documented key: a file with all of them loads.") {
        const Result<Study> full = loadStudy(shipped);
        REQUIRE(full.has_value());
        const std::string text = readText(shipped) + readText(fixtures / "small.toml");
        std::set<std::string> unused;
        for (const std::string& key : studyKeys()) {
            const std::string name = key.substr(key.find('.') + 1);
            if (text.find("\n" + name + " = ") == std::string::npos) unused.insert(key);
        }
        CHECK(unused == std::set<std::string>{"targets.fit_manifest"});  // taken in the case on paths
    }
}
