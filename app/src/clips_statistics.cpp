// deixis clips statistics: how fast and jerkily sets of clips move, their style, and how far two sets lie
// apart.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "clip_files.hpp"
#include "clips_commands.hpp"
#include "clips_motion.hpp"
#include "motion/gesture_style.hpp"
#include "motion/motion_statistics.hpp"

namespace deixis::app {

namespace {

using motion::JointCourses;

struct ClipsStatisticsArguments {
    std::vector<std::string> files;
    std::vector<std::string> against;
    double fps = 30.0;
};

/// What is asked of each clip, at the rate that each measure is defined for.
struct Corpus {
    std::vector<JointCourses> compared;
    std::vector<std::vector<motion::Style>> styles;
};

motion::Clip atRate(const motion::Clip& clip, double frame_time_s) {
    return std::abs(clip.frame_time_s - frame_time_s) < 1e-6 ? clip : motion::resample(clip, frame_time_s);
}

Result<Corpus> readCorpus(const std::vector<std::string>& files, double fps) {
    const auto clips = namedClips(files);
    if (!clips) return tl::unexpected(clips.error());
    Corpus out;
    for (const NamedClip& named : *clips) {
        const auto read = readMappedClip(named.file);
        if (!read) return tl::unexpected(read.error());
        out.compared.push_back(
            motion::jointCourses(atRate(read->clip, 1.0 / fps), read->map, motion::comparedBones()));
        auto style = motion::gestureStyle(motion::jointCourses(atRate(read->clip, motion::style_frame_time_s),
                                                               read->map, motion::styleBones()));
        if (!style) {
            Error error = style.error();
            error.where = named.file.string();
            return tl::unexpected(error);
        }
        out.styles.push_back(std::move(*style));
    }
    return out;
}

void printStyle(const Corpus& corpus, const Corpus& norm_corpus) {
    const motion::StyleNorm norm = motion::styleNorm(norm_corpus.styles);
    std::vector<std::vector<motion::Style>> normalised;
    for (const auto& clip : corpus.styles) {
        normalised.emplace_back();
        for (const motion::Style& style : clip)
            normalised.back().push_back(motion::normalisedStyle(style, norm));
    }
    const motion::StyleNorm raw = motion::styleNorm(corpus.styles);
    const motion::StyleNorm z = motion::styleNorm(normalised);
    fmt::print("\nstyle (window {} frames at 15 a second)  mean       sd      mean z\n",
               motion::style_window);
    const auto line = [&](const char* name, double motion::Style::*element) {
        fmt::print("{:<36} {:>8.4f} {:>8.4f}    {:>8.3f}\n", name, raw.mean.*element, raw.sd.*element,
                   z.mean.*element);
    };
    line("speed, m a frame over ten joints", &motion::Style::speed);
    line("space, m", &motion::Style::space);
    line("handedness, -1 right to 1 left", &motion::Style::handedness);
}

Result<void> statistics(const ClipsStatisticsArguments& options) {
    const auto corpus = readCorpus(options.files, options.fps);
    if (!corpus) return tl::unexpected(corpus.error());
    const auto found = motion::motionStatistics(corpus->compared);
    if (!found) return tl::unexpected(found.error());
    fmt::print("{} clips at {:g} frames a second, {} joints relative to the hips\n", corpus->compared.size(),
               options.fps, found->joints.size());
    fmt::print("{:<24} {:>10} {:>10}\n", "average", "mean", "sd");
    const char* const units[] = {"m/s", "m/s^2", "m/s^3"};
    for (std::size_t d = 0; d < motion::derivative_count; ++d)
        fmt::print(
            "{:<24} {:>10.4g} {:>10.4g}\n",
            fmt::format("{}, {}", motion::derivativeName(static_cast<motion::Derivative>(d)), units[d]),
            found->average[d].mean, found->average[d].sd);
    if (options.against.empty()) {
        printStyle(*corpus, *corpus);
        return {};
    }
    const auto other = readCorpus(options.against, options.fps);
    if (!other) return tl::unexpected(other.error());
    const auto compared = motion::motionStatistics(other->compared);
    if (!compared) return tl::unexpected(compared.error());
    const auto distances = motion::motionDistances(*found, *compared);
    if (!distances) return tl::unexpected(distances.error());
    fmt::print("\nHellinger distance to {} clips    pooled   mean over joints\n", other->compared.size());
    for (std::size_t d = 0; d < motion::derivative_count; ++d)
        fmt::print("{:<30} {:>8.4f} {:>18.4f}\n", motion::derivativeName(static_cast<motion::Derivative>(d)),
                   (*distances)[d].pooled, (*distances)[d].mean);
    printStyle(*corpus, *other);
    return {};
}

}  // namespace

void addClipsStatisticsCommand(CLI::App& clips, Command& chosen) {
    auto options = std::make_shared<ClipsStatisticsArguments>();
    CLI::App* command = clips.add_subcommand(
        "statistics", "Speed, acceleration, jerk and style of clips, and distances of two sets of clips");
    command->add_option("FILES", options->files, "Clips, or manifests of clips")->required();
    command->add_option("--against", options->against,
                        "Clips or manifests to compare with; style is normalised by them");
    command->add_option("--fps", options->fps, "Rate at which all clips are compared")
        ->capture_default_str()
        ->check(CLI::Range(5.0, 240.0));
    command->callback([options, &chosen] { chosen = [options] { return statistics(*options); }; });
}

}  // namespace deixis::app
