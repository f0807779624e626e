// deixis evaluate gestures: a model of speech gestures in numbers, as table 1 of Yoon et al. (2021), and in
// strips of poses, as figure 3.
#include "evaluate_gestures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "app/speech_corpus/corpus_source.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/data/unit_gestures.hpp"
#include "core/files.hpp"
#include "learning/gesture_scores/evaluation.hpp"
#include "results/gestures/gesture_evaluation.hpp"
#include "speech/sound/sound.hpp"

namespace deixis::app {

namespace {

using learning::GestureEvaluation, learning::GestureTake;
using motion::SpeechGestureModel, motion::SpeechGestureRequest;
using results::GestureModelScores, results::GestureTestSet, results::MarkedFrames;

struct EvaluateGesturesArguments {
    std::string weights;
    std::string baseline;
    CorpusSource source;
    std::string page;
    std::string json;
    std::string tables;
    bool force = false;
};

/// With what looks at its motions, and what its file says of it.
struct LoadedModel {
    motion::NetworkWeights weights;
    SpeechGestureModel model;
};

Result<LoadedModel> loadModel(const std::string& file) {
    auto weights = motion::readWeights(file, motion::speech_gestures_architecture);
    if (!weights) return tl::unexpected(weights.error());
    auto model = SpeechGestureModel::read(*weights);
    if (!model) return tl::unexpected(model.error());
    return LoadedModel{std::move(*weights), std::move(*model)};
}

GestureModelScores scoresOf(const std::string& name, const GestureEvaluation& found, bool poses) {
    GestureModelScores out{name, found.scores.fgd_no_controls};
    if (!found.scores.controls) return out;
    if (poses) {
        out.fgd_pose_controls = found.scores.fgd_pose_controls;
        out.fgd_style_controls = found.scores.fgd_style_controls;
        out.posed_off_deg = found.posed_off_deg;
        out.exact_off_deg = found.exact_off_deg;
    }
    out.pcs = found.scores.pcs;
    out.scs = found.scores.scs;
    return out;
}

/// Takes under a name.
struct NamedTakes {
    std::string name;
    bool synthetic = true;
    std::vector<GestureTake> takes;
};

Result<NamedTakes> takesFrom(CorpusSource source, const std::string& name) {
    source.parts = {speech::CorpusPart::test};
    auto corpus = makeOrReadCorpus(source);
    if (!corpus) return tl::unexpected(corpus.error());
    NamedTakes out{name, corpus->synthetic, takenFrom(*corpus, speech::CorpusPart::test)};
    if (out.takes.empty())
        return fail(source.folder,
                    "found no takes for the test, expected some in its folder test, or ten takes "
                    "or more, of which the tenth is for the test");
    return out;
}

Result<std::vector<NamedTakes>> testSets(const CorpusSource& source) {
    std::vector<NamedTakes> out;
    const auto add = [&out](Result<NamedTakes> takes) -> Result<void> {
        if (!takes) return tl::unexpected(takes.error());
        out.push_back(std::move(*takes));
        return {};
    };
    if (!source.folder.empty()) {
        if (const auto added = add(takesFrom(source, source.folder)); !added)
            return tl::unexpected(added.error());
        return out;
    }
    for (const std::string rules : {"a", "b"}) {
        CorpusSource one = source;
        one.rules = rules;
        const std::string name = rules == "a" ? "rules A, unseen sentences" : "rules B, unseen sentences";
        if (const auto added = add(takesFrom(one, name)); !added) return tl::unexpected(added.error());
    }
    return out;
}

Result<GestureTestSet> scoreSet(const NamedTakes& set, const LoadedModel& proposed,
                                const std::optional<LoadedModel>& baseline,
                                const learning::MotionEncoder& encoder) {
    GestureTestSet out;
    out.name = set.name;
    out.synthetic = set.synthetic;
    out.speeches = static_cast<int>(set.takes.size());
    out.minutes = minutesOf(set.takes);
    const auto found =
        learning::evaluateGestures(proposed.model, encoder, set.takes, progressOnTerminal(set.name));
    if (!found) return tl::unexpected(found.error());
    out.parts = found->parts;
    out.models.push_back(scoresOf("proposed", *found, true));
    if (baseline) {
        const auto of_baseline = learning::evaluateGestures(baseline->model, encoder, set.takes,
                                                            progressOnTerminal(set.name + ", baseline"));
        if (!of_baseline) return tl::unexpected(of_baseline.error());
        out.models.push_back(scoresOf("baseline", *of_baseline, true));
    }
    const auto still = learning::evaluateMeanPose(proposed.model, encoder, set.takes);
    if (!still) return tl::unexpected(still.error());
    out.models.push_back(scoresOf("mean pose", *still, false));
    return out;
}

/// Arms stretched out to both sides.
motion::UpperBodyPose stretchedArms(motion::UpperBodyPose pose) {
    using motion::UpperBone;
    pose[UpperBone::left_upper_arm] = pose[UpperBone::left_forearm] = {1.0, 0.0, 0.0};
    pose[UpperBone::right_upper_arm] = pose[UpperBone::right_forearm] = {-1.0, 0.0, 0.0};
    return pose;
}

/// The same speech with different wishes, as in the paper's figure 3.
class Strips {
  public:
    Strips(const SpeechGestureModel& model, const GestureTake& take) : model_(model) {
        request_.samples = take.samples;
        request_.utterance = take.utterance;
        request_.duration_s = take.utterance.duration_s;
        count_ = take.motion.frames.size();
    }

    Result<std::vector<results::GestureStrip>> make(const motion::UpperBodyMotion& gesture) {
        add("no controls", {}, {});
        if (!model_.takesControls()) return finished();
        const std::size_t third = count_ / 3, half = count_ / 2;
        std::vector<motion::PoseControl> raised;
        for (std::size_t f = 0; f < gesture.frames.size() && third + f < count_; ++f)
            raised.push_back({static_cast<int>(third + f), gesture.frames[f]});
        const motion::UpperBodyPose arms = stretchedArms(model_.meanPose());
        add("a gesture as poses", raised, {});
        add("one pose", {{static_cast<int>(half), arms}}, {});
        add("style: speed 2", {}, styles({.speed = 2.0}, third, 2 * third));
        add("style: left hand, wide", {}, styles({.space = 2.0, .handedness = 2.0}, third, 2 * third));
        add("one pose, speed -1", {{static_cast<int>(half), arms}},
            styles({.speed = -1.0}, half - std::min<std::size_t>(half, 15), half + 15));
        return finished();
    }

  private:
    [[nodiscard]] std::vector<motion::StyleControl> styles(const motion::StyleControl& wanted,
                                                           std::size_t first, std::size_t last) const {
        std::vector<motion::StyleControl> out(count_);
        for (std::size_t f = first; f < std::min(last, count_); ++f) out[f] = wanted;
        return out;
    }

    void add(const std::string& title, const std::vector<motion::PoseControl>& poses,
             const std::vector<motion::StyleControl>& wanted) {
        if (problem_) return;
        request_.poses = poses;
        request_.styles = wanted;
        auto made = model_.generate(request_);
        if (!made) {
            problem_ = made.error();
            return;
        }
        results::GestureStrip strip{title, std::move(*made)};
        if (!poses.empty())
            strip.posed = {{static_cast<std::size_t>(poses.front().frame),
                            static_cast<std::size_t>(poses.back().frame) + 1}};
        MarkedFrames styled;
        for (std::size_t f = 0; f < wanted.size(); ++f) {
            if (!wanted[f].speed && !wanted[f].space && !wanted[f].handedness) continue;
            if (styled.last == 0) styled.first = f;
            styled.last = f + 1;
        }
        if (styled.last > 0) strip.styled = {styled};
        strips_.push_back(std::move(strip));
    }

    [[nodiscard]] Result<std::vector<results::GestureStrip>> finished() const {
        if (problem_) return tl::unexpected(*problem_);
        return strips_;
    }

    const SpeechGestureModel& model_;
    SpeechGestureRequest request_;
    std::size_t count_ = 0;
    std::vector<results::GestureStrip> strips_;
    std::optional<Error> problem_;
};

/// From 0 to 1, over the loudest of all.
std::vector<double> loudnessOver(const std::vector<float>& samples, std::size_t stretches) {
    std::vector<double> out;
    double most = 1e-6;
    for (const speech::Peaks& one : speech::envelopeOf({learning::corpus_rate_hz, samples}, stretches)) {
        out.push_back(0.5 * static_cast<double>(one.high - one.low));
        most = std::max(most, out.back());
    }
    for (double& one : out) one /= most;
    return out;
}

/// About ten seconds long.
const GestureTake& shownTake(const std::vector<GestureTake>& takes) {
    constexpr double wanted_s = 10.0;
    return *std::ranges::min_element(
        takes, {}, [](const GestureTake& take) { return std::abs(take.utterance.duration_s - wanted_s); });
}

Result<void> addStrips(const LoadedModel& loaded, const GestureTake& take,
                       results::GestureEvaluationPage& page) {
    const auto library = assets::loadUnitGestures(assets::dataFile("unit_gestures.toml"));
    if (!library) return tl::unexpected(library.error());
    const motion::UnitGesture* const gesture = motion::findGesture(*library, "rising");
    if (gesture == nullptr) return fail("unit_gestures.toml", "found no gesture 'rising'");
    auto strips = Strips(loaded.model, take).make(motion::motionOf(*gesture));
    if (!strips) return tl::unexpected(strips.error());
    page.strips = std::move(*strips);
    page.utterance = take.utterance;
    page.loudness = loudnessOver(take.samples, 430);
    return {};
}

std::vector<std::pair<std::string, std::string>> factsOf(const EvaluateGesturesArguments& options,
                                                         const motion::NetworkWeights& weights) {
    std::vector<std::pair<std::string, std::string>> out{
        {"Weights", std::filesystem::path(options.weights).filename().string()},
        {"Trained on", std::string(weights.synthetic ? "synthetic" : "recorded") + " motions, SHA-256 " +
                           weights.training_data_sha256},
        {"Program", weights.program_version},
        {"Seed of the training", fmt::format("{}", weights.seed)}};
    if (!options.baseline.empty())
        out.emplace_back("Baseline", std::filesystem::path(options.baseline).filename().string());
    return out;
}

Result<void> evaluateWeights(const EvaluateGesturesArguments& options) {
    for (const std::string& file : {options.page, options.json})
        if (const auto free = checkReplaceable(file, options.force); !free) return free;
    const auto proposed = loadModel(options.weights);
    if (!proposed) return tl::unexpected(proposed.error());
    const auto encoder = learning::MotionEncoder::read(proposed->weights);
    if (!encoder) return tl::unexpected(encoder.error());
    std::optional<LoadedModel> baseline;
    if (!options.baseline.empty()) {
        auto loaded = loadModel(options.baseline);
        if (!loaded) return tl::unexpected(loaded.error());
        baseline = std::move(*loaded);
        if (baseline->weights.training_data_sha256 != proposed->weights.training_data_sha256)
            return fail(options.baseline, "was trained on other motions than " + options.weights +
                                              ", expected the same ones: FGD would not be comparable");
    }
    const auto sets = testSets(options.source);
    if (!sets) return tl::unexpected(sets.error());
    results::GestureEvaluationPage page;
    page.trained_on_synthetic = proposed->weights.synthetic;
    page.facts = factsOf(options, proposed->weights);
    for (const NamedTakes& set : *sets) {
        auto scored = scoreSet(set, *proposed, baseline, *encoder);
        if (!scored) return tl::unexpected(scored.error());
        page.sets.push_back(std::move(*scored));
    }
    if (const auto added = addStrips(*proposed, shownTake(sets->front().takes), page); !added) return added;

    if (!options.tables.empty())
        if (const auto written = writeFolders(
                {{options.tables, {{"gesture_scores.csv", results::gestureScoresCsv(page.sets)}}}},
                options.force);
            !written)
            return written;
    if (!options.json.empty())
        if (const auto written = writeOutput(options.json, results::gestureScoresJson(page)); !written)
            return written;
    if (!options.page.empty())
        if (const auto written = writeFile(options.page, results::gestureEvaluationHtml(page)); !written)
            return written;
    std::FILE* const to = remarksBeside(options.json);
    fmt::print(to, "{}", results::gestureScoresText(page.sets));
    if (!options.page.empty()) fmt::print(to, "evaluation: {}\n", options.page);
    return {};
}

}  // namespace

void addEvaluateGesturesCommand(Parser evaluate, Command& chosen) {
    const auto options = std::make_shared<EvaluateGesturesArguments>();
    Parser command = evaluate.addCommand(
        "gestures", "Measure how well a model of speech gestures does what it is asked for");
    describe(
        command,
        {.writes =
             "the page (-o), and the files of --json and --csv. Prints FGD, PCS and SCS on speeches that "
             "were not trained on, with those of Yoon et al. (2021) beside them.",
         .example = "deixis evaluate gestures -o gestures.html",
         .page = "docs/speech-gestures.md"});
    options->weights = assets::dataFile("weights/speech-gestures.weights").string();
    command.addOption("WEIGHTS", options->weights, "Weights of the model [those that ship]");
    command
        .addOption("--baseline", options->baseline,
                   "Weights of a model without controls, trained on the same motions")
        .valueName("FILE");
    addCorpusOptions(command, options->source);
    addOutput(command, options->page, "HTML page to write");
    addForce(command, options->force);
    addJsonOrFile(command, options->json);
    addCsv(command, options->tables, "Folder to write the table to, as CSV");
    command.callback([options, &chosen] { chosen = [options] { return evaluateWeights(*options); }; });
}

}  // namespace deixis::app
