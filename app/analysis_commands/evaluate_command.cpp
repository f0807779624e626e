// deixis evaluate: the objective evaluation of systems' clips as a page, as JSON and as CSV tables.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <thread>
#include <variant>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/analysis_commands/report.hpp"
#include "app/clips/measured_clips.hpp"
#include "app/clips/study_setup.hpp"
#include "app/clips/systems.hpp"
#include "app/clips/training_targets.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/version.hpp"
#include "app/program/written_output.hpp"
#include "assets/tables/manifest.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/number.hpp"
#include "evaluate_gestures.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/synthesis/generator.hpp"
#include "results/evaluation/evaluation.hpp"
#include "studies/study_file/stage_kind.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct EvaluateArguments {
    std::vector<std::string> manifests;
    std::string training;
    std::string bandwidth = "normal-reference";
    std::string mean_shift_bandwidth = "auto";
    std::string study;
    std::string page;
    std::string json;
    std::string tables;
    bool force = false;
    unsigned threads = 0;
};

/// A positive, finite number, the whole of the text.
std::optional<double> lengthFrom(std::string_view text) {
    const auto value = finiteNumber(text);
    if (!value || *value <= 0.0 || *value > 1e6) return std::nullopt;
    return value;
}

/// "normal-reference", "scott", "scott-covariance", or three lengths.
Result<std::variant<results::BandwidthRule, std::vector<double>>> bandwidthFrom(const std::string& text) {
    if (text.find_first_of("0123456789") == std::string::npos) {
        const auto rule = results::bandwidthRuleFromName(text);
        if (!rule)
            return fail("--bandwidth", rule.error().message,
                        rule.error().hint + ", or three lengths hx,hy,hz");
        return *rule;
    }
    std::vector<double> lengths;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const auto length = lengthFrom(std::string_view(text).substr(at, comma - at));
        if (!length)
            return fail("--bandwidth",
                        fmt::format("found '{}', expected three lengths above 0 in metres", text),
                        "Such as 0.80,0.36,0.35");
        lengths.push_back(*length);
        at = comma + 1;
    }
    if (lengths.size() != 3)
        return fail("--bandwidth",
                    fmt::format("found {} lengths, expected three, for x, y and z", lengths.size()),
                    "Such as 0.80,0.36,0.35");
    return lengths;
}

Result<std::optional<double>> meanShiftBandwidthFrom(const std::string& text) {
    if (text == "auto") return std::optional<double>();
    const auto length = lengthFrom(text);
    if (!length)
        return fail("--meanshift-bandwidth",
                    fmt::format("found '{}', expected auto or a length above 0 in metres", text));
    return length;
}

struct Listed {
    std::vector<ClipToMeasure> clips;
    std::vector<results::InputFile> files;
    int without_target = 0;
};

Result<void> addManifest(const std::string& given, Listed& listed) {
    std::error_code code;
    const fs::path path = fs::is_directory(given, code) ? fs::path(given) / "manifest.csv" : fs::path(given);
    const std::string name = path.string();
    for (const auto& file : listed.files)
        if (file.path == name || fs::equivalent(file.path, path, code))
            return fail(name, "is given twice", "Each clip counts once");
    const auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto manifest = assets::parseManifest(*bytes, path);
    if (!manifest) return tl::unexpected(manifest.error());
    bool any = false;
    for (const auto& row : manifest->rows) {
        if (row.target) {
            listed.clips.push_back({path.parent_path() / row.clip, row});
            any = true;
        } else {
            ++listed.without_target;
        }
    }
    if (!any)
        return fail(name, "lists no clip with a target; accuracy is measured against targets",
                    "Fill in target_x, target_y and target_z");
    listed.files.push_back({name, sha256Hex(*bytes)});
    return {};
}

Result<void> failWith(const std::vector<Error>& problems, const char* what) {
    for (const Error& problem : problems) fmt::print(stderr, "{}\n", problem.text());
    return fail("", fmt::format("{} clip{} {}; nothing was written", problems.size(),
                                problems.size() == 1 ? "" : "s", what));
}

Result<void> checkThere(const std::vector<ClipToMeasure>& clips) {
    std::vector<Error> problems;
    std::error_code code;
    for (const auto& clip : clips)
        if (!fs::is_regular_file(clip.file, code))
            problems.push_back({clip.file.string(), "the clip's file is not there"});
    return problems.empty() ? Result<void>() : failWith(problems, "missing");
}

Result<void> checkOutputs(const EvaluateArguments& options, const Listed& listed) {
    if (!options.json.empty() && options.json == options.page)
        return fail(options.page, "is named for both the page and the JSON");
    std::error_code code;
    for (const std::string& out : {options.page, options.json}) {
        if (auto checked = checkOutput(out); !checked) return checked;
        if (out.empty()) continue;
        for (const auto& file : listed.files)
            if (fs::equivalent(out, file.path, code))
                return fail(out, "is one of the inputs and is not overwritten", "Name another file");
        if (auto free = checkReplaceable(out, options.force); !free) return free;
    }
    return {};
}

Result<void> write(const results::Evaluation& evaluation, const EvaluateArguments& options) {
    if (!options.tables.empty()) {
        auto written = writeFolders({{options.tables, results::evaluationTables(evaluation)}}, options.force);
        if (!written) return written;
    }
    if (!options.json.empty())
        if (auto written = writeOutput(options.json, results::evaluationJson(evaluation)); !written)
            return written;
    if (options.page.empty()) return {};
    return writeFile(options.page, results::renderEvaluation(evaluation));
}

/// The games that a study plays: those of each target that can be played, in each distance band that a stage
/// uses, as they are seen in a headset.
Result<results::StudyGames> gamesOfStudy(const std::string& name) {
    const auto setup = loadStudySetup(name);
    if (!setup) return tl::unexpected(setup.error());
    const studies::Study& study = setup->study;
    results::StudyGames out;
    out.name = study.name;
    std::set<std::string> layouts;
    std::set<std::string> distances;
    for (const studies::Stage& stage : study.stages) {
        if (!studies::declarationOf(stage.kind).balls) continue;
        layouts.insert(stage.design.layouts.begin(), stage.design.layouts.end());
        distances.insert(stage.design.distances.begin(), stage.design.distances.end());
    }
    for (const studies::Layout& layout : study.layouts)
        if (layouts.contains(layout.name))
            out.places.push_back(
                {layout.name, studies::viewerPose(layout).position + Vec3(0.0, study.eye_height_m, 0.0)});
    for (const studies::TargetItem& item : setup->targets)
        for (std::size_t band = 0; band < item.distractors.size(); ++band) {
            if (!item.placed || !distances.contains(study.distances[band].name)) continue;
            results::StudyGames::Game& game = out.games.emplace_back();
            game.target_id = item.id;
            game.balls = {item.target};
            game.balls.insert(game.balls.end(), item.distractors[band].begin(), item.distractors[band].end());
        }
    if (out.games.empty() || out.places.empty())
        return fail(name, "has no referential game", "Observers need a game: leave --study out");
    const auto avatar = loadStudyAvatar(study);
    if (!avatar) return tl::unexpected(avatar.error());
    out.pointer_eye =
        motion::eyePosition(motion::mapByVrmNames(avatar->skeleton),
                            motion::worldPose(avatar->skeleton, motion::relaxedPose(avatar->skeleton)));
    return out;
}

Result<void> evaluateClips(const EvaluateArguments& options) {
    results::EvaluationInput input;
    auto bandwidth = bandwidthFrom(options.bandwidth);
    if (!bandwidth) return tl::unexpected(bandwidth.error());
    input.bandwidth = *bandwidth;
    const auto mean_shift = meanShiftBandwidthFrom(options.mean_shift_bandwidth);
    if (!mean_shift) return tl::unexpected(mean_shift.error());
    input.mean_shift_bandwidth = *mean_shift;

    if (!options.study.empty()) {
        auto games = gamesOfStudy(options.study);
        if (!games) return tl::unexpected(games.error());
        input.study = std::move(*games);
    }

    Listed listed;
    for (const std::string& manifest : options.manifests)
        if (auto added = addManifest(manifest, listed); !added) return added;
    auto training = loadTrainingTargets(options.training);
    if (!training) return tl::unexpected(training.error());
    listed.files.push_back(training->file);
    if (auto checked = checkOutputs(options, listed); !checked) return checked;
    if (auto checked = checkThere(listed.clips); !checked) return checked;

    for (const ClipToMeasure& clip : listed.clips)
        if (isSynthetic(clip.row)) input.synthetic_systems.insert(clip.row.system);
    const unsigned threads = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
    auto measured = measureClips(listed.clips, input.rule, threads, progressOnTerminal("clips"));
    if (!measured) return failWith(measured.error(), "cannot be measured");
    input.clips = std::move(measured->clips);
    input.motion_digest = std::move(measured->motion_digest);
    input.without_target = listed.without_target;
    input.training = std::move(training->targets);
    input.training_source = std::move(training->source);
    input.training_synthetic = training->synthetic;
    input.program = programVersion();
    input.build = buildProperties();
    input.files = std::move(listed.files);

    const auto evaluation = results::evaluate(std::move(input));
    if (!evaluation) return tl::unexpected(evaluation.error());
    if (auto written = write(*evaluation, options); !written) return written;
    std::FILE* const to = remarksBeside(options.json);
    if (!options.page.empty()) fmt::print(to, "evaluation: {}\n", options.page);
    if (!options.json.empty() && to == stdout) fmt::print("numbers: {}\n", options.json);
    if (!options.tables.empty()) fmt::print(to, "tables: {}\n", options.tables);
    return {};
}

}  // namespace

void addEvaluateCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<EvaluateArguments>();
    Parser command = cli.addCommand(
        "evaluate", "Measure how accurately systems' clips point: an HTML page, JSON and CSV tables");
    describe(
        command,
        {.writes = "the page (-o; default: evaluation.html in this folder), and the files of --json and "
                   "--csv. --json without FILE prints the numbers, and a page is then written only with -o.",
         .example = "deixis evaluate clips/mine clips/direct -o evaluation.html --csv tables\ndeixis "
                    "evaluate clips/mine --json",
         .page = "docs/evaluation.md"});
    command.addOption("MANIFEST", options->manifests, "Manifests of clips, or folders with a manifest.csv");
    command.addOption(
        "--training", options->training,
        "Manifest or CSV of the targets that the systems were trained on [those of the synthetic "
        "demonstrations]");
    command
        .addOption("--bandwidth", options->bandwidth,
                   "Bandwidth of the kernel density: normal-reference, scott, scott-covariance, or hx,hy,hz "
                   "in metres")
        .showDefault();
    command
        .addOption("--meanshift-bandwidth", options->mean_shift_bandwidth,
                   "Bandwidth of the MeanShift clusters of training targets: metres, or auto")
        .showDefault();
    command.addOption("--study", options->study,
                      "Study for whose games the clips were made: adds what simulated observers choose, and "
                      "the ceiling of any observer");
    addOutput(command, options->page, "HTML page to write [evaluation.html]");
    addForce(command, options->force);
    addJsonOrFile(command, options->json);
    addCsv(command, options->tables, "Folder to write every table to, as CSV");
    command.addOption("--threads", options->threads, "Threads that read clips [one per core]")
        .check(Range(1, 1024));
#ifdef DEIXIS_STUDIO
    addEvaluateGesturesCommand(command, chosen);
#endif
    command.callback([options, command, &chosen] {
        if (command.hasChosen()) return;
        if (options->manifests.empty()) requireUsage("MANIFEST");
        chosen = [options] {
            if (options->page.empty() && options->json != standard_output) options->page = "evaluation.html";
            return evaluateClips(*options);
        };
    });
}

}  // namespace deixis::app
