// deixis learn gestures: trains the model of speech gestures; deixis learn corpus: the speeches and gestures
// that we make for it, with their statistics.
#include <fmt/format.h>

#include <memory>

#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "app/speech_corpus/corpus_source.hpp"
#include "demonstrations.hpp"
#include "gesture_curves.hpp"
#include "learn_commands.hpp"
#include "learning/corpus/corpus_folder.hpp"
#include "learning/corpus/corpus_statistics.hpp"
#include "learning/word_vectors/wink_embeddings.hpp"
#include "start_trainers.hpp"
#include "training_watch.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;
using learning::GestureScores;
using speech::CorpusPart;

struct LearnGesturesArguments {
    CorpusSource source;
    GestureTrainingRequest request;
    std::string word_vectors;
    std::string out;
    bool no_controls = false;
    bool force = false;
};

std::string scoresText(const GestureScores& scores) {
    if (!scores.controls) return fmt::format("FGD {:.3g}", scores.fgd_no_controls);
    return fmt::format("PCS {:.4f}, SCS {:.3f}, FGD {:.3g} (poses {:.3g}, styles {:.3g})", scores.pcs,
                       scores.scs, scores.fgd_no_controls, scores.fgd_pose_controls,
                       scores.fgd_style_controls);
}

Result<learning::GestureTakes> readTakes(const LearnGesturesArguments& options) {
    CorpusSource source = options.source;
    source.parts = {CorpusPart::training, CorpusPart::validation};
    const auto words = learning::readWinkEmbeddings(options.word_vectors);
    if (!words) return tl::unexpected(words.error());
    auto corpus = makeOrReadCorpus(source);
    if (!corpus) return tl::unexpected(corpus.error());
    learning::GestureTakes out;
    out.words = *words;
    out.sha256 = learning::corpusHash(*corpus);
    out.synthetic = corpus->synthetic;
    out.training = takenFrom(*corpus, CorpusPart::training);
    out.validation = takenFrom(*corpus, CorpusPart::validation);
    return out;
}

Result<void> learnGestures(const LearnGesturesArguments& options) {
    const Trainers* const trainers = trainersHere();
    if (trainers == nullptr) return startTrainers();
    std::error_code code;
    const bool goes_on = fs::exists(options.out + ".training", code);
    if (const auto free = checkFree(options.out, options.force || goes_on); !free) return free;
    const auto takes = readTakes(options);
    if (!takes) return tl::unexpected(takes.error());
    fmt::print("{} {}speeches ({:.0f} min) to train on, {} ({:.0f} min) held out, vectors of {} words{}\n",
               takes->training.size(), takes->synthetic ? "synthetic " : "", minutesOf(takes->training),
               takes->validation.size(), minutesOf(takes->validation), takes->words.count(),
               goes_on ? "; the training goes on" : "");
    std::fflush(stdout);

    GestureTrainingRequest request = options.request;
    request.file = options.out;
    request.controls = !options.no_controls;
    request.provenance = programProvenance();
    GestureCurves curves(options.out);
    if (goes_on)
        if (const auto read = curves.read(); !read) return read;
    StatusLine status;
    TimeLeft left;
    std::string tried;  // is told with the next report, which knows the time left
    std::optional<Error> problem;
    const InterruptWatch watch;
    learning::GestureCallbacks callbacks;
    callbacks.report = [&](const learning::TrainingProgress& progress) {
        const std::string left_text = left.text(progress.done);
        if (tried.empty()) {
            status.show(fmt::format("{:5} of {}{}", progress.update, progress.updates, left_text));
        } else {
            status.clear();
            fmt::print("{}{}\n", tried, progress.done < 1.0 ? left_text : "");
            std::fflush(stdout);
            tried.clear();
        }
        return !InterruptWatch::interrupted() && !problem;
    };
    callbacks.epoch = [&](const learning::GestureEpoch& epoch) {
        curves.add(epoch);
        if (const auto written = curves.write(); !written) problem = written.error();
        tried = fmt::format("epoch {:3}: {}{}", epoch.epoch, scoresText(epoch.scores),
                            epoch.best ? "; the best yet" : "");
    };
    const auto outcome = trainers->train_gestures(request, *takes, callbacks);
    if (!outcome) return tl::unexpected(outcome.error());
    if (problem) return tl::unexpected(*problem);
    if (outcome->stopped)
        fmt::print("Stopped. {} holds the best so far ({}); the same command goes on\n", options.out,
                   scoresText(outcome->best));
    else
        fmt::print("{}: epoch {}, {}; the mean pose {}; curves in {}.curves.html\n", options.out,
                   outcome->best_epoch, scoresText(outcome->best), scoresText(outcome->mean_pose),
                   options.out);
    return {};
}

struct LearnCorpusArguments {
    CorpusSource source;
    std::string out;
    std::string tables;
    bool force = false;
};

Result<void> learnCorpus(const LearnCorpusArguments& options) {
    std::error_code code;
    if (!options.out.empty() && !options.force && fs::exists(options.out, code) &&
        !fs::is_empty(options.out, code))
        return fail(options.out, "found a folder with files, expected none or an empty one",
                    "--force replaces files of the same names");
    const auto corpus = makeOrReadCorpus(options.source);
    if (!corpus) return tl::unexpected(corpus.error());
    if (!options.out.empty())
        if (const auto written = learning::writeCorpusFolder(*corpus, options.out); !written) return written;
    const std::string rules = options.source.rules == "b" ? "rules B, synthetic" : "rules A, synthetic";
    const std::vector<learning::StatisticsColumn> columns{
        {corpus->synthetic ? rules : options.source.folder, learning::corpusStatistics(*corpus)}};
    if (!options.tables.empty())
        if (const auto written = writeFolders(
                {{options.tables, {{"corpus.csv", learning::statisticsCsv(columns)}}}}, options.force);
            !written)
            return written;
    fmt::print("{}", learning::statisticsText(columns));
    if (!options.out.empty()) fmt::print("{} takes: {}\n", corpus->takes.size(), options.out);
    return {};
}

}  // namespace

void addLearnGesturesCommands(Parser learn, Command& chosen) {
    const auto options = std::make_shared<LearnGesturesArguments>();
    Parser command =
        learn.addCommand("gestures", "Train the model of speech gestures with pose and style controls");
    describe(
        command,
        {.writes =
             "the weights to FILE, FILE.curves.csv and FILE.curves.html; while it trains also "
             "FILE.training, from which the same command goes on. Prints PCS, SCS and FGD of speeches that "
             "were not trained on.",
         .example = "deixis learn gestures -o gestures.weights",
         .page = "docs/speech-gestures.md"});
    addCorpusOptions(command, options->source);
    addCorpusRules(command, options->source);
    options->word_vectors = "build/word_vectors";
    command
        .addOption("--word-vectors", options->word_vectors,
                   "Where scripts/fetch_word_vectors.sh put the vectors of words")
        .valueName("DIR")
        .showDefault();
    command.addFlag("--no-controls", options->no_controls, "The baseline without pose and style controls");
    command
        .addOption("--epochs", options->request.epochs, "How long to train [as docs/speech-gestures.md says]")
        .check(Range(1, 100'000));
    command
        .addOption("--hidden", options->request.hidden, "Size of each GRU [as docs/speech-gestures.md says]")
        .check(Range(8, 2048));
    addOutput(command, options->out, "File for the weights").required();
    addForce(command, options->force, "what of an ended training is");
    addSeed(command, options->request.seed, "the training");
    command.addOption("--threads", options->request.threads, "Threads at the same time")
        .showDefault()
        .check(Range(1, 256));
    command.callback([options, &chosen] { chosen = [options] { return learnGestures(*options); }; });

    const auto corpus = std::make_shared<LearnCorpusArguments>();
    command =
        learn.addCommand("corpus", "Make speeches with gestures by rules, or read a lab's, and count them");
    describe(command, {.writes = "WAV, BVH and words of each speech to the folder of -o, and the table to "
                                 "that of --csv. Prints its "
                                 "statistics beside those that were published.",
                       .example = "deixis learn corpus --minutes 10 -o corpus",
                       .page = "docs/speech-gestures.md"});
    addCorpusOptions(command, corpus->source);
    addCorpusRules(command, corpus->source);
    addOutput(command, corpus->out, "Folder for the speeches", "DIR");
    addForce(command, corpus->force);
    addCsv(command, corpus->tables, "Folder for the statistics as a table");
    command.callback([corpus, &chosen] { chosen = [corpus] { return learnCorpus(*corpus); }; });
}

}  // namespace deixis::app
