// deixis clips measure: when and how well clips point, and whether the body keeps to what bodies do.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>
#include <variant>

#include "app/clips/clip_files.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "assets/tables/ball_list.hpp"
#include "clips_commands.hpp"
#include "clips_motion.hpp"
#include "core/csv.hpp"
#include "motion/pointing/measures.hpp"
#include "motion/pointing/rays.hpp"

namespace deixis::app {

namespace {

struct ClipsMeasureArguments {
    std::vector<std::string> files;
    std::vector<double> target;
    std::string balls;
    bool detect = false;
    bool csv = false;
    bool json = false;
};

/// One measure: its name with the unit, and what was found; empty where the clip has none.
struct Entry {
    std::string name;
    std::variant<std::monostate, double, int, bool, std::string> value;
};
using Entries = std::vector<Entry>;

/// `from`: an optional or a pointer.
template <typename Maybe, typename F>
Entry optionalEntry(std::string name, const Maybe& from, const F& get) {
    if (!from) return {std::move(name), {}};
    return {std::move(name), get(*from)};
}

Entry optionalEntry(std::string name, const std::optional<double>& from) {
    return optionalEntry(std::move(name), from, [](double v) { return v; });
}

void addRay(Entries& out, motion::PointingRay kind, const std::optional<motion::RayMeasures>& ray) {
    const std::string name(motion::pointingRayName(kind));
    const auto degrees = [](double motion::RayMeasures::*field) {
        return [field](const motion::RayMeasures& r) { return degreesFromRadians(r.*field); };
    };
    out.push_back(optionalEntry(name + "_error_deg", ray, degrees(&motion::RayMeasures::error_rad)));
    out.push_back(optionalEntry(name + "_min_error_deg", ray, degrees(&motion::RayMeasures::min_error_rad)));
    out.push_back(optionalEntry(name + "_distance_m", ray, [](const auto& r) { return r.distance_m; }));
    out.push_back(optionalEntry(name + "_points_away", ray, [](const auto& r) { return r.points_away; }));
    const motion::Steadiness* steadiness = ray && ray->steadiness ? &*ray->steadiness : nullptr;
    out.push_back(optionalEntry(name + "_drift_degps", steadiness,
                                [](const auto& s) { return degreesFromRadians(s.drift_per_s); }));
    out.push_back(optionalEntry(name + "_jitter_deg", steadiness,
                                [](const auto& s) { return degreesFromRadians(s.jitter_rms); }));
}

/// Which ball a reader of each ray would take, and by which angle before the next one.
void addChoices(Entries& out, const motion::PointingMeasures& m, const std::vector<assets::BallSet>& sets) {
    for (const motion::PointingRay kind : motion::all_pointing_rays) {
        const auto& ray = m.rays[static_cast<std::size_t>(kind)];
        for (const assets::BallSet& set : sets) {
            std::string name(motion::pointingRayName(kind));
            if (!set.band.empty()) name += "_" + set.band;
            const auto choice = ray ? motion::chosenBall(ray->middle, set.balls) : std::nullopt;
            out.push_back(
                optionalEntry(name + "_ball", choice, [&](const auto& c) { return set.names[c.ball]; }));
            out.push_back(optionalEntry(name + "_margin_deg", choice ? choice->margin_rad : std::nullopt,
                                        [](double margin_rad) { return degreesFromRadians(margin_rad); }));
        }
    }
}

void addBody(Entries& out, const motion::PointingMeasures& m) {
    out.push_back(optionalEntry("foot_skate_cm_s", m.foot_skate,
                                [](const motion::FootSkate& s) { return 100.0 * s.speed_m_s; }));
    std::string names;
    double excess = 0.0;
    for (const auto& violation : m.limit_violations) {
        excess = std::max(excess, violation.max_deg);
        names += (names.empty() ? "" : "; ") +
                 (violation.side ? std::string(motion::sideName(*violation.side)) + " " : std::string()) +
                 std::string(motion::jointLimitName(violation.limit));
    }
    out.push_back({"limit_excess_deg", excess});
    out.push_back({"limits_exceeded", names});
    double depth = 0.0;
    std::string where;
    for (const auto& pair : m.intersections) {
        depth = std::max(depth, pair.depth_m);
        where += fmt::format("{}{} arm in {}", where.empty() ? "" : "; ", motion::sideName(pair.side),
                             pair.with_head ? "head" : "trunk");
    }
    out.push_back({"intersection_cm", 100.0 * depth});
    out.push_back({"intersections", where});
}

Entries entries(const NamedClip& clip, const motion::PointingMeasures& m) {
    const motion::GesturePhases& p = m.phases;
    Entries out{{"clip", clip.file.string()},
                {"system", clip.system},
                {"target_id", clip.target_id},
                {"hand", std::string(motion::sideName(p.hand))},
                {"onset_frame", p.onset_frame},
                {"peak_frame", p.peak_frame},
                {"hold_frame", p.hold_frame},
                {"end_frame", p.end_frame},
                {"hold_s", m.hold_s},
                {"time_to_peak_s", m.time_to_peak_s},
                {"time_to_peak_speed_s", m.time_to_peak_speed_s},
                {"peak_speed_m_s", m.peak_speed_m_s}};
    // What only the detection tells.
    const auto detected = [&](const char* name, auto motion::DetectedGesture::*field) {
        out.push_back(optionalEntry(name, m.detected, [&](const auto& d) { return d.*field; }));
    };
    detected("clear_hold", &motion::DetectedGesture::clear_hold);
    detected("returns", &motion::DetectedGesture::returns);
    detected("strokes", &motion::DetectedGesture::strokes);
    out.push_back(optionalEntry("fingertip_drift_cm_s", m.fingertip,
                                [](const auto& s) { return 100.0 * s.drift_per_s; }));
    out.push_back(optionalEntry("fingertip_jitter_cm", m.fingertip,
                                [](const auto& s) { return 100.0 * s.jitter_rms; }));
    out.push_back(optionalEntry("log_dimensionless_jerk", m.log_dimensionless_jerk));
    out.push_back(optionalEntry("sparc", m.spectral_arc_length));
    out.push_back(optionalEntry("reward", m.reward));
    out.push_back(optionalEntry("max_reward", m.max_reward));
    for (const motion::PointingRay kind : motion::all_pointing_rays)
        addRay(out, kind, m.rays[static_cast<std::size_t>(kind)]);
    addBody(out, m);
    return out;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20)
            out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            out += c;
    }
    return out + "\"";
}

enum class Form : unsigned char { list, csv, json };

std::string shown(const Entry& entry, Form form) {
    if (const auto* number = std::get_if<double>(&entry.value)) return fmt::format("{:.6g}", *number);
    if (const auto* count = std::get_if<int>(&entry.value)) return fmt::format("{}", *count);
    if (const auto* truth = std::get_if<bool>(&entry.value)) return *truth ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&entry.value))
        return form == Form::json ? quoted(*text) : form == Form::csv ? csvField(safeText(*text)) : *text;
    return form == Form::json ? "null" : "";
}

void print(const std::vector<Entries>& clips, const ClipsMeasureArguments& options) {
    if (options.json) fmt::print("[");
    for (std::size_t i = 0; i < clips.size(); ++i) {
        const Entries& clip = clips[i];
        std::string line;
        if (options.csv) {
            for (std::size_t k = 0; i == 0 && k < clip.size(); ++k)
                fmt::print("{}{}", clip[k].name, k + 1 < clip.size() ? "," : "\n");
            for (const Entry& entry : clip) line += (line.empty() ? "" : ",") + shown(entry, Form::csv);
            fmt::print("{}\n", line);
        } else if (options.json) {
            for (const Entry& entry : clip)
                line += (line.empty() ? "" : ", ") + quoted(entry.name) + ": " + shown(entry, Form::json);
            fmt::print("{}\n{{{}}}", i == 0 ? "" : ",", line);
        } else {
            for (const Entry& entry : clip)
                if (const std::string value = shown(entry, Form::list); !value.empty())
                    fmt::print("{:<35} {}\n", entry.name, value);
            fmt::print("\n");
        }
    }
    if (options.json) fmt::print("\n]\n");
}

/// The balls about a clip's target: those of its target id, or the only ones that there are. None of them
/// where no list was given.
Result<std::vector<assets::BallSet>> ballsFor(const NamedClip& clip, const std::optional<Vec3>& target,
                                              const assets::BallList& list, const std::string& file) {
    if (list.empty()) return std::vector<assets::BallSet>();
    const bool only = clip.target_id.empty() && list.size() == 1;
    const auto found = only ? list.begin() : list.find(clip.target_id);
    if (found == list.end())
        return fail(clip.file.string(),
                    clip.target_id.empty()
                        ? fmt::format("names no target, and {} has {}", file, list.size())
                        : fmt::format("points at {}, which {} does not have", clip.target_id, file),
                    "Balls are matched to a clip by the target_id in its manifest");
    const Vec3& listed = found->second.front().balls.front();
    constexpr double same_place_m = 1e-3;
    if (target && glm::length(*target - listed) > same_place_m)
        return fail(clip.file.string(),
                    fmt::format("its target is at {:.4f}, {:.4f}, {:.4f}, in {} at {:.4f}, {:.4f}, {:.4f}",
                                target->x, target->y, target->z, file, listed.x, listed.y, listed.z),
                    "Give the list that the clips were made for");
    return found->second;
}

struct Measured {
    motion::PointingMeasures measures;
    std::vector<assets::BallSet> balls;
};

Result<Measured> measured(const NamedClip& clip, const ClipsMeasureArguments& options,
                          const assets::BallList& list) {
    auto read = readMappedClip(clip.file);
    if (!read) return tl::unexpected(read.error());
    std::optional<Vec3> target = clip.target;
    if (!options.target.empty())
        target = Vec3(options.target[0], options.target[1], options.target[2]);
    else
        standByTarget(read->clip, read->map, clip.target_frame);
    auto balls = ballsFor(clip, target, list, options.balls);
    if (!balls) return tl::unexpected(balls.error());
    if (!target && !balls->empty()) target = balls->front().balls.front();
    auto found =
        motion::measurePointing(read->clip, read->map, target, options.detect ? std::nullopt : clip.phases);
    if (!found && found.error().where.empty()) {
        Error error = found.error();
        error.where = clip.file.string();
        return tl::unexpected(error);
    }
    if (!found) return tl::unexpected(found.error());
    return Measured{std::move(*found), std::move(*balls)};
}

Result<void> measure(const ClipsMeasureArguments& options) {
    const auto clips = namedClips(options.files);
    if (!clips) return tl::unexpected(clips.error());
    assets::BallList balls;
    if (!options.balls.empty()) {
        auto read = assets::readBallList(options.balls);
        if (!read) return tl::unexpected(read.error());
        balls = std::move(*read);
    }
    std::vector<Entries> rows;
    std::vector<Error> problems;
    auto working = std::make_optional<ElapsedOnTerminal>("measuring");
    for (const NamedClip& clip : *clips) {
        const auto found = measured(clip, options, balls);
        if (found) {
            rows.push_back(entries(clip, found->measures));
            addChoices(rows.back(), found->measures, found->balls);
            continue;
        }
        if (clips->size() == 1) return tl::unexpected(found.error());
        problems.push_back(found.error());
    }
    working.reset();
    for (const Error& problem : problems) fmt::print(stderr, "{}\n", problem.text());
    print(rows, options);
    if (!problems.empty())
        return fail("", fmt::format("{} of {} clips could not be measured", problems.size(), clips->size()),
                    "Each is named above");
    return {};
}

}  // namespace

void addClipsMeasureCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsMeasureArguments>();
    Parser command = clips.addCommand(
        "measure", "Measure phases, rays, steadiness, smoothness and faults of pointing clips");
    describe(command, {.writes = "nothing; it prints the measures.",
                       .example = "deixis clips measure clips/manifest.csv --csv > measures.csv",
                       .page = "docs/measures.md"});
    command.addOption("FILES", options->files, "Clips, or manifests of clips").required();
    command
        .addOption("--target", options->target,
                   "x,y,z of the target in the clips' coordinates, metres [the manifest's]")
        .delimiter(',')
        .expected(3);
    command.addOption("--balls", options->balls,
                      "CSV of targets with distractors, as 'deixis targets STUDY' prints it: which ball each "
                      "ray chooses");
    command.addFlag("--detect", options->detect, "Detect the phases, even where the manifest gives them");
    Option csv = command.addFlag("--csv", options->csv, "Print CSV, a line for each clip");
    addJson(command, options->json, "Print JSON, an object for each clip").excludes(csv);
    command.callback([options, &chosen] { chosen = [options] { return measure(*options); }; });
}

}  // namespace deixis::app
