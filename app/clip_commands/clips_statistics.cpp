// deixis clips statistics: how fast and jerkily sets of clips move, their style, how far two sets lie apart,
// and how closely clips keep to poses that were asked for.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/clips/clip_files.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "clips_commands.hpp"
#include "clips_motion.hpp"
#include "motion/gestures/gesture_style.hpp"
#include "motion/gestures/motion_statistics.hpp"

namespace deixis::app {

namespace {

using motion::JointTrajectories;
using Json = nlohmann::ordered_json;

struct ClipsStatisticsArguments {
    std::vector<std::string> files;
    std::vector<std::string> against;
    std::vector<std::string> asked;
    std::vector<int> asked_frames{10, 14};  // the paper's, first and last
    double fps = 30.0;
    bool json = false;
};

/// What is asked of each clip, at the rate that each measure is defined for.
struct Corpus {
    std::vector<std::string> files;
    std::vector<JointTrajectories> compared;
    std::vector<std::vector<motion::Style>> styles;
    std::vector<JointTrajectories> poses;  ///< at the files' own rates
};

/// Style of a set of clips, and its z-scores by a set's mean and deviation.
struct SetStyle {
    motion::StyleNorm raw;
    motion::StyleNorm z;
};

struct Compliance {
    std::vector<double> clips_m;
    double mean_m = 0.0;
    double sd_m = 0.0;  ///< over n, as that of the averages
};

struct Against {
    std::size_t clips = 0;
    std::array<motion::MotionDistance, motion::derivative_count> distances{};
};

struct Found {
    Corpus corpus;
    motion::MotionStatistics movement;
    SetStyle style;
    std::optional<Against> against{};
    std::optional<Compliance> compliance{};
};

Error placed(Error error, const std::string& file) {
    if (error.where.empty()) error.where = file;
    return error;
}

Result<motion::Clip> atRate(const motion::Clip& clip, double frame_time_s, const std::string& file) {
    if (std::abs(clip.frame_time_s - frame_time_s) < 1e-6) return clip;
    return motion::resample(clip, frame_time_s).map_error([&](const Error& e) { return placed(e, file); });
}

Result<Corpus> readCorpus(const std::vector<std::string>& files, double fps) {
    const auto clips = namedClips(files);
    if (!clips) return tl::unexpected(clips.error());
    Corpus out;
    for (const NamedClip& named : *clips) {
        const auto read = readMappedClip(named.file);
        if (!read) return tl::unexpected(read.error());
        out.files.push_back(named.file.string());
        const auto compared = atRate(read->clip, 1.0 / fps, out.files.back());
        if (!compared) return tl::unexpected(compared.error());
        out.compared.push_back(motion::jointTrajectories(*compared, read->map, motion::comparedBones()));
        out.poses.push_back(motion::jointTrajectories(read->clip, read->map, motion::poseBones()));
        const auto styled = atRate(read->clip, motion::style_frame_time_s, out.files.back());
        if (!styled) return tl::unexpected(styled.error());
        auto style =
            motion::gestureStyle(motion::jointTrajectories(*styled, read->map, motion::styleBones()));
        if (!style) return tl::unexpected(placed(style.error(), out.files.back()));
        out.styles.push_back(std::move(*style));
    }
    return out;
}

SetStyle styleOf(const Corpus& corpus, const Corpus& norm_corpus) {
    const motion::StyleNorm norm = motion::styleNorm(norm_corpus.styles);
    std::vector<std::vector<motion::Style>> normalised;
    for (const auto& clip : corpus.styles) {
        normalised.emplace_back();
        for (const motion::Style& style : clip)
            normalised.back().push_back(motion::normalisedStyle(style, norm));
    }
    return {motion::styleNorm(corpus.styles), motion::styleNorm(normalised)};
}

/// Of each clip with the poses of its own file, or of all with those of one.
Result<Compliance> complianceOf(const Corpus& corpus, const ClipsStatisticsArguments& options) {
    const auto asked = namedClips(options.asked);
    if (!asked) return tl::unexpected(asked.error());
    const std::size_t n = corpus.poses.size();
    if (asked->size() != n && asked->size() != 1)
        return fail("--asked",
                    fmt::format("found poses of {} clips, expected 1{}", asked->size(),
                                n == 1 ? "" : fmt::format(" or {}", n)),
                    "Give one for each clip, in their order, or one for all");
    std::vector<JointTrajectories> poses;
    for (const NamedClip& named : *asked) {
        const auto read = readMappedClip(named.file);
        if (!read) return tl::unexpected(read.error());
        poses.push_back(motion::jointTrajectories(read->clip, read->map, motion::poseBones()));
    }
    Compliance out;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto score = motion::poseCompliance(poses[poses.size() == 1 ? 0 : i], corpus.poses[i],
                                                  options.asked_frames[0], options.asked_frames[1] + 1);
        if (!score) return tl::unexpected(placed(score.error(), corpus.files[i]));
        out.clips_m.push_back(*score);
        sum += *score;
    }
    out.mean_m = sum / static_cast<double>(n);
    for (const double score : out.clips_m) squares += (score - out.mean_m) * (score - out.mean_m);
    out.sd_m = std::sqrt(squares / static_cast<double>(n));
    return out;
}

Result<Found> find(const ClipsStatisticsArguments& options) {
    auto corpus = readCorpus(options.files, options.fps);
    if (!corpus) return tl::unexpected(corpus.error());
    auto movement = motion::motionStatistics(corpus->compared);
    if (!movement) return tl::unexpected(movement.error());
    Found out;
    out.corpus = std::move(*corpus);
    out.movement = std::move(*movement);
    if (options.against.empty()) {
        out.style = styleOf(out.corpus, out.corpus);
    } else {
        const auto other = readCorpus(options.against, options.fps);
        if (!other) return tl::unexpected(other.error());
        const auto compared = motion::motionStatistics(other->compared);
        if (!compared) return tl::unexpected(compared.error());
        const auto distances = motion::motionDistances(out.movement, *compared);
        if (!distances) return tl::unexpected(distances.error());
        out.against = Against{other->compared.size(), *distances};
        out.style = styleOf(out.corpus, *other);
    }
    if (!options.asked.empty()) {
        auto compliance = complianceOf(out.corpus, options);
        if (!compliance) return tl::unexpected(compliance.error());
        out.compliance = std::move(*compliance);
    }
    return out;
}

constexpr std::array<std::pair<const char*, double motion::Style::*>, 3> style_elements{
    {{"speed", &motion::Style::speed},
     {"space", &motion::Style::space},
     {"handedness", &motion::Style::handedness}}};

void print(const Found& found, const ClipsStatisticsArguments& options) {
    fmt::print("{} clips at {:g} frames per second, {} joints relative to the hips\n",
               found.corpus.compared.size(), options.fps, found.movement.joints.size());
    fmt::print("{:<24} {:>10} {:>10}\n", "average", "mean", "sd");
    const char* const units[] = {"m/s", "m/s^2", "m/s^3"};
    for (std::size_t d = 0; d < motion::derivative_count; ++d)
        fmt::print(
            "{:<24} {:>10.4g} {:>10.4g}\n",
            fmt::format("{}, {}", motion::derivativeName(static_cast<motion::Derivative>(d)), units[d]),
            found.movement.average[d].mean, found.movement.average[d].sd);
    if (found.against) {
        fmt::print("\nHellinger distance to {} clips    pooled   mean over joints\n", found.against->clips);
        for (std::size_t d = 0; d < motion::derivative_count; ++d)
            fmt::print("{:<30} {:>8.4f} {:>18.4f}\n",
                       motion::derivativeName(static_cast<motion::Derivative>(d)),
                       found.against->distances[d].pooled, found.against->distances[d].mean);
    }
    fmt::print("\nstyle (window {} frames at 15 fps)       mean       sd      mean z\n",
               motion::style_window);
    const char* const names[] = {"speed, m per frame over ten joints", "space, m",
                                 "handedness, -1 right to 1 left"};
    for (std::size_t i = 0; i < style_elements.size(); ++i) {
        const auto element = style_elements[i].second;
        fmt::print("{:<36} {:>8.4f} {:>8.4f}    {:>8.3f}\n", names[i], found.style.raw.mean.*element,
                   found.style.raw.sd.*element, found.style.z.mean.*element);
    }
    if (!found.compliance) return;
    fmt::print("\npose compliance, frames {} to {}, {} joints     mean       sd\n", options.asked_frames[0],
               options.asked_frames[1], found.corpus.poses.front().joints.size());
    fmt::print("{:<44} {:>8.4f} {:>8.4f}\n", "off the reference, m per coordinate", found.compliance->mean_m,
               found.compliance->sd_m);
}

Json asJson(const Found& found, const ClipsStatisticsArguments& options) {
    Json out;
    out["clips"] = found.corpus.compared.size();
    out["fps"] = options.fps;
    out["joints"] = Json::array();
    for (const motion::Bone bone : found.movement.joints) out["joints"].push_back(motion::boneName(bone));
    const auto name = [](std::size_t d) {
        return std::string(motion::derivativeName(static_cast<motion::Derivative>(d)));
    };
    const char* const units[] = {"_m_s", "_m_s2", "_m_s3"};
    for (std::size_t d = 0; d < motion::derivative_count; ++d)
        out["average"][name(d) + units[d]] = {{"mean", found.movement.average[d].mean},
                                              {"sd", found.movement.average[d].sd}};
    if (found.against) {
        out["hellinger"]["clips"] = found.against->clips;
        for (std::size_t d = 0; d < motion::derivative_count; ++d)
            out["hellinger"][name(d)] = {{"pooled", found.against->distances[d].pooled},
                                         {"mean", found.against->distances[d].mean}};
    }
    for (const auto& [style, element] : style_elements)
        out["style"][style] = {{"mean", found.style.raw.mean.*element},
                               {"sd", found.style.raw.sd.*element},
                               {"mean_z", found.style.z.mean.*element}};
    if (!found.compliance) return out;
    Json& compliance = out["pose_compliance"];
    compliance["frames"] = options.asked_frames;
    compliance["joints"] = found.corpus.poses.front().joints.size();
    compliance["mean_m"] = found.compliance->mean_m;
    compliance["sd_m"] = found.compliance->sd_m;
    for (std::size_t i = 0; i < found.corpus.files.size(); ++i)
        compliance["clips"].push_back(
            {{"clip", found.corpus.files[i]}, {"compliance_m", found.compliance->clips_m[i]}});
    return out;
}

Result<void> statistics(const ClipsStatisticsArguments& options) {
    if (options.asked_frames[1] < options.asked_frames[0])
        return fail("--asked-frames",
                    fmt::format("found {} to {}, expected a first and a last frame", options.asked_frames[0],
                                options.asked_frames[1]),
                    "Such as 10,14");
    auto working = std::make_optional<ElapsedOnTerminal>("measuring");
    const auto found = find(options);
    working.reset();
    if (!found) return tl::unexpected(found.error());
    if (options.json)  // what is not UTF-8 in a file's name must not stop the output
        printAsJson(asJson(*found, options));
    else
        print(*found, options);
    return {};
}

}  // namespace

void addClipsStatisticsCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsStatisticsArguments>();
    Parser command = clips.addCommand("statistics",
                                      "Measure speed, acceleration, jerk and style of clips, distance "
                                      "of two sets, agreement with poses");
    describe(command, {.writes = "nothing; it prints the numbers.",
                       .example = "deixis clips statistics made/*.bvh --against recorded/*.bvh --json",
                       .page = "docs/measures.md"});
    command.addOption("FILES", options->files, "Clips, or manifests of clips").required();
    command.addOption("--against", options->against,
                      "Clips or manifests to compare with; style is normalised by them");
    Option asked = command.addOption(
        "--asked", options->asked,
        "Clips or manifests with the reference poses that were asked for: one for each clip, or one for all");
    command
        .addOption("--asked-frames", options->asked_frames,
                   "FIRST,LAST frames of the reference poses, counted from 0, at the clips' own rate [10,14]")
        .delimiter(',')
        .expected(2)
        .check(Range(0, 10'000'000))
        .needs(asked);
    command.addOption("--fps", options->fps, "Rate at which all clips are compared")
        .showDefault()
        .check(Range(5.0, 240.0));
    addJson(command, options->json, "Print JSON, one object");
    command.callback([options, &chosen] { chosen = [options] { return statistics(*options); }; });
}

}  // namespace deixis::app
