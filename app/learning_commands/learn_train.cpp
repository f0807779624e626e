// deixis learn gt-nn, moglow, amp-no-runtime, amp-base, amp-pfnn: makes a system of demonstrations; deixis
// learn join: puts together what was trained in parts.
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "core/number.hpp"
#include "demonstrations.hpp"
#include "learn_commands.hpp"
#include "motion/learned/gt_nn.hpp"
#include "start_trainers.hpp"
#include "training_curves.hpp"
#include "training_watch.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;
using learning::TrainingProgress;

struct LearnTrainArguments {
    TrainingRequest request;
    std::string out;
    std::string demonstrations;
    bool no_mirror = false;
    bool force = false;
};

/// RANK, WORLD_SIZE, MASTER_ADDR and MASTER_PORT, as launchers of several processes set them; none without
/// WORLD_SIZE, or where it is 1.
Result<std::optional<learning::RankPlace>> rankFromEnvironment() {
    const auto text = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value == nullptr ? "" : value);
    };
    if (text("WORLD_SIZE").empty() || text("WORLD_SIZE") == "1") return std::optional<learning::RankPlace>();
    const auto number = [&text](const char* name, std::uint64_t low, std::uint64_t high) -> Result<int> {
        const auto value = naturalNumber(text(name));
        if (!value || *value < low || *value > high)
            return fail(
                name, fmt::format("found '{}', expected a whole number from {} to {}", text(name), low, high),
                "A launcher of several processes sets RANK, WORLD_SIZE, MASTER_ADDR and MASTER_PORT");
        return static_cast<int>(*value);
    };
    const auto count = number("WORLD_SIZE", 1, 4096);
    if (!count) return tl::unexpected(count.error());
    const auto rank = number("RANK", 0, static_cast<std::uint64_t>(*count) - 1);
    if (!rank) return tl::unexpected(rank.error());
    const auto port = number("MASTER_PORT", 1, 65535);
    if (!port) return tl::unexpected(port.error());
    if (text("MASTER_ADDR").empty()) return fail("MASTER_ADDR", "is not set, expected the address of rank 0");
    return std::optional(
        learning::RankPlace{*rank, *count, text("MASTER_ADDR"), static_cast<std::uint16_t>(*port)});
}

std::string measuresText(const learning::ClipMeasures& measures) {
    std::string out = fmt::format("{} {:.3f}, at rest {:.0f} %, jerk x {:.2f}", measures.reward_name,
                                  measures.reward, 100.0 * measures.at_rest, measures.jerk_ratio);
    if (measures.arm_error_m > 0.0) out += fmt::format(", arm {:.1f} cm", 100.0 * measures.arm_error_m);
    return out;
}

/// Prints a line for each try-out with the time left, and keeps the curves.
class Teller {
  public:
    explicit Teller(TrainingCurves& curves) : curves_(curves) {}

    bool operator()(const TrainingProgress& progress) {
        curves_.add(progress);
        std::string text = progress.part.empty() ? "" : progress.part + ": ";
        text += fmt::format("{:5} of {}", progress.update, progress.updates);
        const std::string left_text = left_.text(progress.done);
        if (progress.validation) {
            if (const auto written = curves_.write(); !written) problem_ = written.error();
            status_.clear();
            fmt::print("{}: {}{}{}\n", text, measuresText(*progress.validation),
                       progress.best ? "; the best yet" : "", left_text);
            std::fflush(stdout);
        } else {
            status_.show(text + left_text);
        }
        return !InterruptWatch::interrupted() && !problem_;
    }
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  private:
    TrainingCurves& curves_;
    StatusLine status_;
    TimeLeft left_;
    std::optional<Error> problem_;
};

std::string outcomeText(const learning::TrainingOutcome& outcome, const LearnTrainArguments& options) {
    const std::string file = options.out;
    if (outcome.stopped)
        return fmt::format("Stopped. {} holds the best so far ({}); the same command goes on", file,
                           measuresText(outcome.best));
    return fmt::format("{}: {}; curves in {}.curves.html", file, measuresText(outcome.best), file);
}

Result<void> runTraining(const LearnTrainArguments& options) {
    TrainingRequest request = options.request;
    request.file = options.out;
    const auto rank = rankFromEnvironment();
    if (!rank) return tl::unexpected(rank.error());
    request.rank = *rank;
    if (request.system == "amp-pfnn" && !request.clusters && request.bandwidth.empty())
        requireUsage("--clusters or --bandwidth");
    const bool tells = !request.rank || request.rank->rank == 0;
    const Trainers* const trainers = trainersHere();
    if (trainers == nullptr) return startTrainers();
    request.provenance = programProvenance();

    std::error_code code;
    const fs::path state(options.out + ".training");
    const bool goes_on = fs::exists(state, code);
    if (tells)
        if (const auto free = checkFree(options.out, options.force || goes_on); !free) return free;
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());
    const auto data = demonstrationSets(options.demonstrations, *avatar, !options.no_mirror);
    if (!data) return tl::unexpected(data.error());

    TrainingCurves curves(request.file, request.system);
    if (tells && goes_on)
        if (const auto read = curves.read(); !read) return read;
    Teller tell(curves);
    const auto remark = [&](const std::string& text) {
        if (tells) fmt::print("{}\n", text);
    };
    remark(fmt::format("{} {}demonstrations to train on, {} held out{}", data->training.size(),
                       data->synthetic ? "synthetic " : "", data->validation.size(),
                       goes_on ? "; the training goes on" : ""));
    const InterruptWatch watch;
    const auto outcome = trainers->train(request, *data, remark, [&](const TrainingProgress& progress) {
        return tells ? tell(progress) : !InterruptWatch::interrupted();
    });
    if (!outcome) return tl::unexpected(outcome.error());
    if (tell.problem()) return tl::unexpected(*tell.problem());
    if (!tells) return {};
    if (const auto written = curves.write(); !written) return written;
    fmt::print("{}\n", outcomeText(*outcome, options));
    return {};
}

/// Nothing is trained: the demonstrations are the system.
Result<void> keepDemonstrations(const LearnTrainArguments& options) {
    if (const auto free = checkFree(options.out, options.force); !free) return free;
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());
    auto data = demonstrationSets(options.demonstrations, *avatar, !options.no_mirror);
    if (!data) return tl::unexpected(data.error());
    std::vector<motion::Demonstration> all = std::move(data->training);
    all.insert(all.end(), data->validation.begin(), data->validation.end());
    motion::NetworkWeights weights = motion::gtNnWeights(all);
    learning::setProvenance(weights, *data, options.request.seed, programProvenance());
    const auto written = motion::writeWeights(options.out, weights, motion::WeightsPrecision::float32);
    if (written)
        fmt::print("{} {}demonstrations: {}\n", all.size(), data->synthetic ? "synthetic " : "", options.out);
    return written;
}

void addDemonstrations(Parser command, LearnTrainArguments& options) {
    command
        .addOption("--demonstrations", options.demonstrations,
                   "Manifest of the demonstrations, each with a target [synthetic ones]")
        .valueName("MANIFEST");
    addOutput(command, options.out, "File for the weights").required();
}

void addNoMirror(Parser command, LearnTrainArguments& options) {
    command.addFlag("--no-mirror", options.no_mirror, "Without the demonstrations' mirror images");
}

void addGtNn(Parser learn, Command& chosen) {
    const auto options = std::make_shared<LearnTrainArguments>();
    Parser command = learn.addCommand("gt-nn", "Keep demonstrations as a system that plays the nearest");
    describe(command, {.writes = "the demonstrations to FILE.",
                       .example = "deixis learn gt-nn --demonstrations clips/manifest.csv -o gt-nn.weights",
                       .page = "docs/learning.md"});
    addDemonstrations(command, *options);
    addNoMirror(command, *options);
    addForce(command, options->force);
    command.callback([options, &chosen] { chosen = [options] { return keepDemonstrations(*options); }; });
}

Parser addTraining(Parser learn, const char* system, const char* what, Command& chosen,
                   const std::shared_ptr<LearnTrainArguments>& options) {
    options->request.system = system;
    Parser command = learn.addCommand(system, what);
    const std::string pfnn = options->request.system == "amp-pfnn" ? " --clusters 8" : "";
    const std::string example = fmt::format("deixis learn {}{} -o {}.weights", system, pfnn, system);
    // A training of seconds, on the demonstrations of one hand, goes on from nothing and needs no threads.
    const bool quick = options->request.system == "flow";
    const std::string state =
        quick ? "" : "; while it trains also FILE.training, from which the same command goes on";
    const std::string writes = "the weights to FILE, FILE.curves.csv and FILE.curves.html" + state +
                               ". Prints how well targets are pointed at that were not trained on.";
    describe(command, {.writes = writes.c_str(), .example = example.c_str(), .page = "docs/learning.md"});
    addDemonstrations(command, *options);
    addForce(command, options->force, "what of an ended training is");
    addSeed(command, options->request.seed, "the training");
    if (quick) {
        options->no_mirror = true;
    } else {
        addNoMirror(command, *options);
        command.addOption("--threads", options->request.threads, "Threads at the same time")
            .showDefault()
            .check(Range(1, 256));
    }
    command.addOption("--updates", options->request.updates, "How long to train [as docs/learning.md says]")
        .check(Range(1, 10'000'000));
    command
        .addOption("--validate-every", options->request.validate_every,
                   "Updates between two try-outs [as docs/learning.md says]")
        .check(Range(1, 10'000'000));
    command.callback([options, &chosen] { chosen = [options] { return runTraining(*options); }; });
    return command;
}

std::string notABandwidth(const std::string& text) {
    const auto number = finiteNumber(text);
    if (text == "scott" || (number && *number > 0.0)) return "";
    return "found '" + text + "', expected metres above 0, or scott";
}

void addAmp(Parser learn, const char* system, const char* what, Command& chosen) {
    const auto options = std::make_shared<LearnTrainArguments>();
    Parser command = addTraining(learn, system, what, chosen, options);
    if (options->request.system == "amp-pfnn") {
        command
            .addOption("--clusters", options->request.clusters,
                       "Clusters of targets, each with a policy [as many as --bandwidth makes]")
            .check(Range(1, 1000));
        command
            .addOption("--bandwidth", options->request.bandwidth,
                       "Of the clusters, in metres, or scott [0.78 where it gives so many, else the widest "
                       "that does]")
            .check(notABandwidth);
        command
            .addOption("--cluster", options->request.only_cluster,
                       "Train this one alone, from 0; 'deixis learn join' puts them together")
            .check(Range(0, 999));
    }
    command
        .addOption("--reward", options->request.reward,
                   "The task: the line of the forearm, that from the eyes through the fingertip, or an "
                   "observer's choice")
        .showDefault()
        .check(OneOf{{"forearm", "eye-fingertip", "observer"}});
    command.addFlag("--full-body", options->request.full_body,
                    "The body stands on its feet; else its pelvis is held");
    command.addOption("--set", options->request.settings, "A setting of the training (docs/learning.md)")
        .valueName("NAME=VALUE");
}

struct LearnJoinArguments {
    std::vector<std::string> parts;
    std::string out;
    bool force = false;
};

Result<void> join(const LearnJoinArguments& options) {
    if (const auto free = checkFree(options.out, options.force); !free) return free;
    const Trainers* const trainers = trainersHere();
    if (trainers == nullptr) return startTrainers();
    const auto joined = trainers->join({options.parts.begin(), options.parts.end()}, options.out);
    if (joined) fmt::print("{} clusters: {}\n", options.parts.size(), options.out);
    return joined;
}

void addJoin(Parser learn, Command& chosen) {
    const auto options = std::make_shared<LearnJoinArguments>();
    Parser command = learn.addCommand("join", "Put together clusters that were trained one by one");
    describe(command, {.writes = "the weights to FILE.",
                       .example = "deixis learn join cluster-*.weights -o amp-pfnn-8.weights",
                       .page = "docs/learning.md"});
    command.addOption("PARTS", options->parts, "Weights of one cluster each").required().expected(1, 1000);
    addOutput(command, options->out, "File for the weights").required();
    addForce(command, options->force);
    command.callback([options, &chosen] { chosen = [options] { return join(*options); }; });
}

}  // namespace

void addLearnTrainCommands(Parser learn, Command& chosen) {
    addGtNn(learn, chosen);
    addTraining(learn, "moglow", "Train MoGlow, a conditional normalising flow", chosen,
                std::make_shared<LearnTrainArguments>());
    addTraining(learn, "flow", "Train flow, conditional flow matching on whole gestures", chosen,
                std::make_shared<LearnTrainArguments>());
    addAmp(learn, "amp-no-runtime", "Train a policy that does not know the time", chosen);
    addAmp(learn, "amp-base", "Train a policy that knows the time", chosen);
    addAmp(learn, "amp-pfnn", "Train policies against phase-functioned discriminators", chosen);
    addJoin(learn, chosen);
}

}  // namespace deixis::app
