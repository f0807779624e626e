#include "studies/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "toml_table.hpp"

namespace deixis::studies {

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string_view>;

struct Section {
    std::string_view name;
    Names keys;
};

/// The whole vocabulary: what is not here is an unknown key, and the loader cannot read what is not here.
const std::vector<Section>& vocabulary() {
    static const std::vector<Section> sections{
        {"study",
         {"name", "title", "description", "reference", "seed", "eye_height_m", "inter_trial_s",
          "after_interruption"}},
        {"texts", {"welcome", "break", "goodbye"}},
        {"targets",
         {"count", "height_m", "arc_deg", "radius_m", "fit_manifest", "ball_diameter_m", "distractors",
          "distractor_distance_m"}},
        {"layouts", {"name", "viewer_m", "heading_deg"}},
        {"systems", {"name", "generator", "manifest"}},
        {"naturalness",
         {"items", "practice", "break_every", "max_replays", "layout", "question", "labels", "instructions",
          "practice_instructions"}},
        {"game",
         {"items", "practice", "break_every", "max_replays", "layouts", "question", "instructions",
          "practice_instructions"}},
        {"headset",
         {"eye_level", "assumed_eye_height_m", "place_tolerance_m", "record_gaze", "record_hands"}},
        {"analysis", {"alpha"}},
    };
    return sections;
}

const Names& keysOf(std::string_view section) {
    const auto found = std::find_if(vocabulary().begin(), vocabulary().end(),
                                    [&](const Section& entry) { return entry.name == section; });
    return found->keys;
}

/// Names stand in file names, tables and command lines.
std::string readName(TomlTable& table, std::string_view key) {
    constexpr std::size_t longest = 48;
    std::string name = table.text(key);
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_';
    });
    if (!plain || name.size() > longest)
        table.problem(key,
                      fmt::format("found \"{}\", expected a name of 1 to {} letters A-Z a-z, digits, '-' "
                                  "and '_'",
                                  name, longest));
    return name;
}

/// A path written relative to the study file, as one that can be opened from anywhere. Whether the file is
/// there is for whoever opens it: the targets of a study are printed before the clips for them can be made.
std::string readPath(TomlTable& table, std::string_view key, const fs::path& folder) {
    return (folder / table.text(key)).lexically_normal().string();
}

Range readRange(TomlTable& table, std::string_view key, double low, double high) {
    const auto [a, b] = table.pair(key, low, high);
    if (a > b) table.problem(key, fmt::format("found [{}, {}], expected the smaller number first", a, b));
    return {a, b};
}

int readCount(TomlTable& table, std::string_view key, int low, int high,
              std::optional<std::int64_t> fallback = {}) {
    return static_cast<int>(table.whole(key, low, high, fallback));
}

/// One of the names of an enumeration's values, which stand in its order.
template <typename Value, std::size_t count>
Value readChoice(TomlTable& table, std::string_view key, const std::string_view (&names)[count],
                 Value fallback) {
    return static_cast<Value>(table.choice(key, names, static_cast<std::size_t>(fallback)));
}

void readStudySection(TomlTable& table, Study& study) {
    study.name = readName(table, "name");
    study.title = table.text("title");
    study.description = table.text("description", "");
    study.reference = table.text("reference", "");
    study.seed = static_cast<std::uint64_t>(table.whole("seed", 0, std::numeric_limits<std::int64_t>::max()));
    study.eye_height_m = table.number("eye_height_m", 0.5, 2.5, study.eye_height_m);
    study.inter_trial_s = table.number("inter_trial_s", 0.0, 60.0, study.inter_trial_s);
    constexpr std::string_view after_interruption[] = {"resume", "repeat"};
    study.after_interruption =
        readChoice(table, "after_interruption", after_interruption, study.after_interruption);
}

void readTargets(TomlTable& table, const fs::path& folder, TargetSpace& space) {
    space.count = readCount(table, "count", 1, 10000);
    space.ball_diameter_m = table.number("ball_diameter_m", 0.01, 1.0);
    space.distractors = readCount(table, "distractors", 1, 8);
    space.distractor_distance_m = readRange(table, "distractor_distance_m", 0.01, 10.0);
    if (space.distractor_distance_m.low < space.ball_diameter_m)
        table.problem("distractor_distance_m",
                      fmt::format("found {} m as the least distance, expected no less than "
                                  "targets.ball_diameter_m ({} m): balls would overlap",
                                  space.distractor_distance_m.low, space.ball_diameter_m));
    if (table.has("fit_manifest")) {
        for (const std::string_view key : {"height_m", "arc_deg", "radius_m"})
            if (table.has(key))
                table.problem(key, "found together with targets.fit_manifest, which gives this range",
                              "Remove one of the two");
        space.fit_manifest = readPath(table, "fit_manifest", folder);
        return;
    }
    space.height_m = readRange(table, "height_m", 0.0, 4.0);
    space.arc_deg = readRange(table, "arc_deg", -180.0, 180.0);
    space.radius_m = readRange(table, "radius_m", 0.3, 20.0);
    if (space.height_m.low < space.ball_diameter_m / 2)
        table.problem("height_m",
                      fmt::format("found {} m as the least height, expected at least {} m, half of "
                                  "targets.ball_diameter_m: balls would stick in the floor",
                                  space.height_m.low, space.ball_diameter_m / 2));
}

/// Reads a [[list]] of named entries and sees to it that no name comes twice.
template <typename Entry, typename Read>
std::vector<Entry> readNamed(TomlTable& root, std::string_view section, TomlProblems& problems,
                             const Read& read) {
    std::vector<Entry> out;
    for (const toml::table* table : root.sections(section)) {
        TomlTable entry(table, std::string(section), keysOf(section), problems);
        const std::string name = readName(entry, "name");
        for (const Entry& other : out)
            if (other.name == name) entry.problem("name", fmt::format("\"{}\" comes twice", name));
        out.push_back(read(entry, name));
    }
    return out;
}

Layout readLayout(TomlTable& table, const std::string& name) {
    constexpr double body_m = 0.3;
    const auto [x, z] = table.pair("viewer_m", -20.0, 20.0);
    if (std::hypot(x, z) < body_m)
        table.problem("viewer_m", fmt::format("found [{}, {}], expected at least {} m from [0, 0], where the "
                                              "avatar stands",
                                              x, z, body_m));
    return {name, x, z, table.number("heading_deg", -360.0, 360.0)};
}

SystemSource readSystem(TomlTable& table, const std::string& name, const fs::path& folder) {
    SystemSource system{name};
    if (table.has("generator") == table.has("manifest")) {
        table.problem("generator",
                      table.has("generator") ? "found both generator and manifest, expected one of them"
                                             : "found neither generator nor manifest, expected one of them",
                      "A built-in system has a generator, a folder of clips a manifest");
        return system;
    }
    if (table.has("generator"))
        system.generator = readName(table, "generator");
    else
        system.manifest = readPath(table, "manifest", folder);
    return system;
}

void checkLayoutName(TomlTable& table, std::string_view key, std::string_view name, const Study& study) {
    if (study.findLayout(name) != nullptr) return;
    Names names;
    for (const Layout& layout : study.layouts) names.push_back(layout.name);
    table.problem(key, fmt::format("there is no layout \"{}\" in [[layouts]]", name),
                  proposeName(name, names));
}

/// What both stages have in common.
template <typename Stage>
void readStage(TomlTable& table, Stage& stage) {
    stage.items = readCount(table, "items", 1, 10000);
    stage.practice = readCount(table, "practice", 0, 100, 0);
    stage.break_every = readCount(table, "break_every", 0, 10000, 0);
    stage.max_replays = readCount(table, "max_replays", 0, 100, 0);
    stage.question = table.text("question");
    stage.instructions = table.text("instructions");
    stage.practice_instructions = table.text("practice_instructions", "");
    if (stage.practice > 0 && stage.practice_instructions.empty())
        table.problem("practice_instructions", "missing; expected a text, since there are practice trials");
}

void readNaturalness(TomlTable& table, Study& study) {
    readStage(table, study.rating);
    study.rating.layout = table.text("layout");
    checkLayoutName(table, "layout", study.rating.layout, study);
    study.rating.labels = table.texts("labels", 2, 10);
}

void readGame(TomlTable& table, Study& study) {
    readStage(table, study.game);
    study.game.layouts = table.texts("layouts", 1, study.layouts.size());
    for (std::size_t i = 0; i < study.game.layouts.size(); ++i) {
        const std::string& name = study.game.layouts[i];
        checkLayoutName(table, "layouts", name, study);
        if (std::count(study.game.layouts.begin(), study.game.layouts.end(), name) > 1)
            table.problem("layouts", fmt::format("\"{}\" comes twice", name));
    }
}

void readHeadset(TomlTable& table, HeadsetOptions& headset) {
    constexpr std::string_view eye_levels[] = {"measured", "raise", "scale"};
    headset.eye_level = readChoice(table, "eye_level", eye_levels, headset.eye_level);
    headset.assumed_eye_height_m =
        table.number("assumed_eye_height_m", 0.5, 2.5, headset.assumed_eye_height_m);
    headset.place_tolerance_m = table.number("place_tolerance_m", 0.1, 5.0, headset.place_tolerance_m);
    headset.record_gaze = table.flag("record_gaze", headset.record_gaze);
    headset.record_hands = table.flag("record_hands", headset.record_hands);
}

/// Items of the two stages and practice trials all have targets of their own.
void checkEnoughTargets(TomlTable& targets, const Study& study) {
    const int practice = study.rating.practice + study.game.practice;
    const int needed = study.rating.items + study.game.items + practice;
    if (needed > study.targets.count)
        targets.problem(
            "count",
            fmt::format("found {}, expected at least {}: naturalness.items ({}), game.items ({}) and "
                        "practice ({}) each take targets of their own",
                        study.targets.count, needed, study.rating.items, study.game.items, practice));
}

void readAll(const toml::table& file, const fs::path& folder, TomlProblems& problems, Study& study) {
    Names section_names;
    for (const Section& section : vocabulary()) section_names.push_back(section.name);
    TomlTable root(&file, "", section_names, problems);
    const auto section = [&](std::string_view name, bool required = true) {
        return TomlTable(root.section(name, required), std::string(name), keysOf(name), problems);
    };

    TomlTable head = section("study");
    readStudySection(head, study);
    TomlTable texts = section("texts");
    study.welcome = texts.text("welcome");
    study.break_text = texts.text("break");
    study.goodbye = texts.text("goodbye");
    TomlTable targets = section("targets");
    readTargets(targets, folder, study.targets);
    study.layouts = readNamed<Layout>(root, "layouts", problems, readLayout);
    study.systems = readNamed<SystemSource>(
        root, "systems", problems,
        [&](TomlTable& table, const std::string& name) { return readSystem(table, name, folder); });
    TomlTable naturalness = section("naturalness");
    readNaturalness(naturalness, study);
    TomlTable game = section("game");
    readGame(game, study);
    TomlTable headset = section("headset", false);
    readHeadset(headset, study.headset);
    TomlTable analysis = section("analysis", false);
    study.alpha = analysis.number("alpha", 1e-6, 0.5, study.alpha);
    checkEnoughTargets(targets, study);
}

}  // namespace

const Layout* Study::findLayout(std::string_view wanted) const {
    const auto found = std::find_if(layouts.begin(), layouts.end(),
                                    [&](const Layout& layout) { return layout.name == wanted; });
    return found == layouts.end() ? nullptr : &*found;
}

Result<Study> loadStudy(const std::filesystem::path& path) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const Result<toml::table> table = parseToml(path.string(), *bytes);
    if (!table) return tl::unexpected(table.error());

    Study study;
    study.file = path;
    study.hash = sha256Hex(*bytes);
    TomlProblems problems{path.string()};
    readAll(*table, path.parent_path(), problems, study);
    if (problems.first) return tl::unexpected(*problems.first);
    return study;
}

std::vector<std::string> studyKeys() {
    std::vector<std::string> out;
    for (const Section& section : vocabulary())
        for (const std::string_view key : section.keys)
            out.push_back(fmt::format("{}.{}", section.name, key));
    return out;
}

}  // namespace deixis::studies
