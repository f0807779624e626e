// Distances, layouts, systems, between-participants factors, targets, headset, analysis.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/synthesis/generator.hpp"
#include "studies/study_file/assumed_effects.hpp"
#include "study_reading.hpp"

namespace deixis::studies {

namespace {

namespace fs = std::filesystem;

/// A path written relative to the study file, as one that can be opened from anywhere. Whether the file is
/// there is for whoever opens it: the targets of a study are printed before the clips for them can be made.
std::string readPath(TomlTable& table, std::string_view key, const fs::path& folder) {
    return (folder / table.note(key)).lexically_normal().string();
}

/// Likewise of a folder of projects: beside the study file, else one of those that ship, by its name.
std::string readProjects(TomlTable& table, std::string_view key, const StudyReader& reader) {
    const std::string path = readPath(table, key, reader.folder);
    const std::string name = table.note(key);
    std::error_code code;
    if (reader.folders.speeches.empty() || !isName(name) || fs::exists(path, code)) return path;
    return (reader.folders.speeches / name).string();
}

Range asRange(std::pair<double, double> pair) {
    return {pair.first, pair.second};
}

/// Reads [[section]] and sees to it that no name comes twice.
template <typename Entry, typename Read>
void readNamed(StudyReader& reader, std::string_view section, bool required, Keys known,
               std::vector<Entry>& out, const Read& read) {
    for (const toml::table* table : reader.root.sections(section, required)) {
        TomlTable entry = reader.root.below(section, table, known);
        const std::string name = entry.name("name");
        if (!name.empty() &&
            std::any_of(out.begin(), out.end(), [&](const Entry& other) { return other.name == name; }))
            entry.problem("name", fmt::format("\"{}\" occurs twice, expected a unique name", name));
        out.push_back(read(entry, name));
    }
}

Layout readLayout(TomlTable& table, const std::string& name) {
    constexpr double body_m = 0.3;
    const auto place = [&](std::string_view key) {
        const auto [x, z] = table.pair(key, -20.0, 20.0);
        if (table.sound(key) && std::hypot(x, z) < body_m)
            table.problem(key, fmt::format("found [{}, {}], expected at least {} m from [0, 0], where the "
                                           "avatar stands",
                                           x, z, body_m));
        return ViewerPlace{x, z, 0.0};
    };
    const ViewerPlace viewer = place("viewer_m");
    Layout layout{name, viewer.x_m, viewer.z_m, table.number("heading_deg", -360.0, 360.0)};
    if (!table.has("desktop_viewer_m")) {
        table.reject("desktop_heading_deg", "without desktop_viewer_m, to which the heading belongs");
        return layout;
    }
    layout.desktop = place("desktop_viewer_m");
    layout.desktop->heading_deg = table.number("desktop_heading_deg", -360.0, 360.0, layout.heading_deg);
    return layout;
}

/// Of a system's clips: which of three there is. Several, or none, are a problem.
void readSource(TomlTable& table, SystemSource& system, const StudyReader& reader) {
    std::vector<std::string_view> found;
    for (const std::string_view key : {"generator", "manifest", "projects"})
        if (table.has(key)) found.push_back(key);
    if (found.size() > 1)
        table.problem(found.back(),
                      fmt::format("found both {}, expected one of them", fmt::join(found, " and ")),
                      found.size() == 2 ? "Remove one of the two" : "Keep one of the three");
    else if (found.empty() || found.front() == "generator")
        system.generator = table.name("generator");
    else if (found.front() == "manifest")
        system.manifest = readPath(table, "manifest", reader.folder);
    else
        system.projects = readProjects(table, "projects", reader);
}

SystemSource readSystem(TomlTable& table, const std::string& name, const StudyReader& reader) {
    SystemSource system{name};
    readSource(table, system, reader);
    if (!system.generator.empty()) {
        const std::vector<std::string>& names = motion::systemNames();
        table.checkKnown("generator", system.generator,
                         std::vector<std::string_view>(names.begin(), names.end()),
                         "the systems that come with the program");
    }
    if (!system.manifest.empty() || !system.projects.empty())
        for (const std::string_view key : {"hold_s", "unsteadiness_m"})
            table.reject(key, system.projects.empty() ? "with a manifest, whose clips are used as they are"
                                                      : "with projects, which point at nothing");
    if (system.manifest.empty() && !(system.generator.empty() && system.projects.empty()))
        for (const std::string_view key : {"keep", "fingers"})
            table.reject(key, system.projects.empty()
                                  ? "with a generator, whose clips are made for the avatar"
                                  : "with projects, whose clips are made for the avatar");
    if (!system.generator.empty() || !system.manifest.empty())
        table.reject("controls", "without projects, which have them");
    system.controls = table.flag("controls", true);
    constexpr std::string_view keeps[] = {"joint-angles", "pointing-ray"};
    system.keep = static_cast<motion::Keep>(table.choice("keep", keeps, false).value_or(0));
    constexpr std::string_view fingers[] = {"relaxed", "pointing"};
    system.pointing_fingers = table.choice("fingers", fingers, false).value_or(0) == 1;
    if (table.has("hold_s")) system.hold_s = table.number("hold_s", 0.1, 10.0);
    if (table.has("unsteadiness_m")) system.unsteadiness_m = table.number("unsteadiness_m", 0.0, 0.5);
    system.levels = table.levels("levels");
    system.compared = table.flag("compared", true);
    if (system.compared)
        table.reject("remark", "with a system that is compared; it says why one is not");
    else
        system.remark = table.note("remark");
    return system;
}

/// The within-participants factors that every study has.
bool isBuiltInFactor(std::string_view name) {
    return name == "system" || name == "layout" || name == "distance";
}

/// All systems must name the same factors, and a factor must have something to compare.
void checkLevels(std::vector<TomlTable>& tables, const std::vector<SystemSource>& systems) {
    std::map<std::string, std::set<std::string>> factors;
    std::map<std::string, std::size_t> first;
    bool sound = true;
    for (std::size_t i = 0; i < systems.size(); ++i) {
        sound = sound && !tables[i].faulty("levels");
        for (const auto& [factor, level] : systems[i].levels) {
            factors[factor].insert(level);
            first.emplace(factor, i);
        }
    }
    if (!sound) return;
    for (const auto& [factor, levels] : factors) {
        TomlTable& table = tables[first[factor]];
        if (isBuiltInFactor(factor))
            table.problemAt("levels", factor, "found a factor that every study has, expected another name");
        bool complete = true;
        for (std::size_t i = 0; i < systems.size(); ++i) {
            if (systems[i].levels.count(factor) > 0) continue;
            complete = false;
            tables[i].problem(
                "levels", fmt::format("the factor \"{}\" is missing, but the system \"{}\" has it", factor,
                                      systems[first[factor]].name));
        }
        if (complete && levels.size() < 2)
            table.problemAt(
                "levels", factor,
                fmt::format("found \"{}\" for all systems, expected two levels or more", *levels.begin()));
    }
}

}  // namespace

void readDistances(StudyReader& reader) {
    const double ball_m = reader.study.targets.ball_diameter_m;
    readNamed(reader, "distances", reader.shows_balls, keys::distances, reader.study.distances,
              [&](TomlTable& table, const std::string& name) {
                  const Range range = asRange(table.range("distance_m", 0.01, 10.0));
                  if (table.sound("distance_m") && range.low < ball_m)
                      table.problem("distance_m",
                                    fmt::format("found {} m as the minimum distance, expected no less than "
                                                "targets.ball_diameter_m ({} m): balls would overlap",
                                                range.low, ball_m));
                  DistanceBand band{name, range, table.count("distractors", 1, 8), {}, {}};
                  if (table.has("avatar_angle_deg"))
                      band.avatar_angle_deg = asRange(table.range("avatar_angle_deg", 0.0, 180.0));
                  if (table.has("participant_angle_deg"))
                      band.participant_angle_deg = asRange(table.range("participant_angle_deg", 0.0, 180.0));
                  return band;
              });
}

void readLayouts(StudyReader& reader) {
    readNamed(reader, "layouts", reader.shows_clips, keys::layouts, reader.study.layouts,
              [&](TomlTable& table, const std::string& name) {
                  reader.keepPlace("layouts." + name, table, "heading_deg");
                  return readLayout(table, name);
              });
}

void readSystems(StudyReader& reader) {
    std::vector<TomlTable> tables;
    readNamed(reader, "systems", reader.shows_clips, keys::systems, reader.study.systems,
              [&](TomlTable& table, const std::string& name) {
                  SystemSource system = readSystem(table, name, reader);
                  tables.push_back(table);
                  reader.keepPlace("systems." + name, table,
                                   !system.projects.empty()  ? "projects"
                                   : system.manifest.empty() ? "generator"
                                                             : "manifest");
                  return system;
              });
    const auto& systems = reader.study.systems;
    if (!systems.empty() && std::ranges::none_of(systems, &SystemSource::compared))
        tables.front().problem("compared", "found no system that is compared, expected one at least");
    checkLevels(tables, reader.study.systems);
}

void readBetween(StudyReader& reader) {
    std::set<std::string> nested;
    for (const SystemSource& system : reader.study.systems)
        for (const auto& [factor, level] : system.levels) nested.insert(factor);
    std::size_t cells = 1;
    readNamed(
        reader, "between", false, keys::between, reader.study.between,
        [&](TomlTable& table, const std::string& name) {
            constexpr std::size_t max = 20;
            BetweenFactor factor{name, table.names("levels", 2, true)};
            if (factor.levels.size() > max)
                table.problem("levels",
                              fmt::format("found {} levels, expected at most {}", factor.levels.size(), max));
            if (isBuiltInFactor(name))
                table.problem(
                    "name",
                    fmt::format("found \"{}\", which is a factor of every study; expected another name",
                                name));
            if (nested.count(name) > 0)
                table.problem(
                    "name",
                    fmt::format(
                        "found \"{}\", which is a factor of the systems' levels; expected another name",
                        name));
            constexpr std::size_t max_cells = 1000;
            cells *= std::max<std::size_t>(factor.levels.size(), 1);
            if (cells > max_cells) {
                table.problem("levels", fmt::format("found {} combinations of all factors' levels so far, "
                                                    "expected at most {}",
                                                    cells, max_cells));
                cells = 1;
                factor.levels.clear();
            }
            return factor;
        });
}

namespace {

void readRanges(TomlTable& table, StudyReader& reader) {
    TargetSpace& space = reader.study.targets;
    constexpr std::string_view ranges[] = {"height_m", "arc_deg", "radius_m"};
    if (table.has("fit_manifest")) {
        for (const std::string_view key : ranges)
            table.reject(key, "together with fit_manifest, which gives this range");
        space.fit_manifest = readPath(table, "fit_manifest", reader.folder);
        reader.keepPlace("targets.fit_manifest", table, "fit_manifest");
        return;
    }
    space.height_m = asRange(table.range("height_m", 0.0, 4.0));
    space.arc_deg = asRange(table.range("arc_deg", -180.0, 180.0));
    space.radius_m = asRange(table.range("radius_m", 0.3, 20.0));
    if (table.sound("height_m") && !table.faulty("ball_diameter_m") &&
        space.height_m.low < space.ball_diameter_m / 2)
        table.problem("height_m",
                      fmt::format("found {} m as the minimum height, expected at least {} m, half of "
                                  "targets.ball_diameter_m: balls would stick in the floor",
                                  space.height_m.low, space.ball_diameter_m / 2));
}

void readLeaveOut(TomlTable& analysis, LeaveOutRule& rule) {
    const toml::table* section = analysis.section("leave_out", false);
    TomlTable table = analysis.below("leave_out", section, keys::leave_out);
    const auto read = [&table](std::string_view key, double low, double high, std::optional<double>& value) {
        if (table.has(key)) value = table.number(key, low, high);
    };
    read("same_rating_share", 0.51, 1.0, rule.same_rating_share);
    read("one_side_share", 0.51, 1.0, rule.one_side_share);
    read("median_time_below_s", 0.001, 60.0, rule.median_time_below_s);
}

}  // namespace

void readTargets(StudyReader& reader) {
    TargetSpace& space = reader.study.targets;
    const toml::table* section = reader.root.section("targets", reader.shows_clips);
    TomlTable table = reader.root.below("targets", section, keys::targets);
    if (section == nullptr) {
        space.count = 0;
        return;
    }
    const double ball_m = table.number("ball_diameter_m", 0.01, 1.0, space.ball_diameter_m);
    if (!table.faulty("ball_diameter_m")) space.ball_diameter_m = ball_m;
    constexpr std::string_view visibilities[] = {"clear", "any"};
    space.clear_view = table.choice("visibility", visibilities, false).value_or(0) == 0;
    if (!reader.shows_balls) table.reject("visibility", "since no game shows balls");
    const std::string_view from = table.has("from_projects") ? "from_projects" : "from_manifest";
    if (!table.has(from)) {
        space.count = table.count("count", 1, 10000);
        if (table.faulty("count")) space.count = 0;  // asks no more of it
        readRanges(table, reader);
        return;
    }
    space.count = 0;
    if (table.has("from_projects") && table.has("from_manifest"))
        table.problem("from_projects", "found both from_manifest and from_projects, expected one of them",
                      "Remove one of the two");
    if (from == "from_projects")
        space.from_projects = readProjects(table, from, reader);
    else
        space.from_manifest = readPath(table, from, reader.folder);
    reader.keepPlace(fmt::format("targets.{}", from), table, from);
    const std::string together = fmt::format("together with {}, ", from);
    table.reject("count", together + "which gives the items");
    if (reader.shows_balls && from == "from_projects")
        table.problem(from, "found items without places, but a stage of this study shows balls",
                      "Projects point at nothing; see [targets] count and from_manifest");
    if (reader.shows_balls) return readRanges(table, reader);
    for (const std::string_view key : {"height_m", "arc_deg", "radius_m", "fit_manifest"})
        table.reject(key, together + "since no game draws distractors");
}

void readHeadset(StudyReader& reader) {
    TomlTable table = reader.root.below("headset", reader.root.section("headset", false), keys::headset);
    HeadsetOptions& headset = reader.study.headset;
    constexpr std::string_view eye_levels[] = {"measured", "raise", "scale"};
    headset.eye_level = static_cast<EyeLevel>(table.choice("eye_level", eye_levels, false).value_or(0));
    headset.assumed_eye_height_m =
        table.number("assumed_eye_height_m", 0.5, 2.5, headset.assumed_eye_height_m);
    headset.place_tolerance_m = table.number("place_tolerance_m", 0.1, 5.0, headset.place_tolerance_m);
    headset.record_gaze = table.flag("record_gaze", headset.record_gaze);
    headset.record_hands = table.flag("record_hands", headset.record_hands);
}

void readAnalysis(StudyReader& reader) {
    TomlTable table = reader.root.below("analysis", reader.root.section("analysis", false), keys::analysis);
    reader.study.alpha = table.number("alpha", 1e-6, 0.5, reader.study.alpha);
    constexpr std::string_view stations[] = {"apart", "together"};
    reader.study.stations_together = table.choice("stations", stations, false).value_or(0) == 1;
    const std::vector<StudyMeasure> measures = studyMeasures(reader.study);
    std::vector<std::string_view> names;
    for (const StudyMeasure& measure : measures)
        if (measure.kind != AnswerKind::preference) names.push_back(measure.name);
    constexpr std::string_view units[] = {"participants", "ratings"};
    reader.study.by_ratings = table.choice("unit", units, false).value_or(0) == 1;
    const auto isRating = [](const StudyMeasure& measure) { return measure.kind == AnswerKind::rating; };
    if (reader.study.by_ratings && std::none_of(measures.begin(), measures.end(), isRating))
        table.problem("unit", "found \"ratings\", but no stage asks for ratings", "Remove it");
    const toml::table* section = table.section("equivalence", false);
    TomlTable bounds = table.below("equivalence", section, names);
    for (const StudyMeasure& measure : measures)
        if (bounds.has(measure.name) && measure.kind != AnswerKind::preference)
            reader.study.equivalence[measure.name] =
                bounds.number(measure.name, 1e-6, static_cast<double>(measure.high - measure.low));
    readLeaveOut(table, reader.study.leave_out);
}

}  // namespace deixis::studies
