// deixis fit: the simulated participant's noise, lapses and weights, fitted to the choices of a database.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/analysis_commands/report.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "app/study/recorded_avatar.hpp"
#include "app/study/recorded_clips.hpp"
#include "assets/data/data_paths.hpp"
#include "core/files.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "results/participants/participants.hpp"
#include "studies/simulation/observer_fit.hpp"
#include "studies/simulation/simulated_participant.hpp"

namespace deixis::app {

namespace {

using FitJson = nlohmann::ordered_json;

struct FitArguments {
    std::string database;
    std::string output;
    std::string parameters;
    std::string ray;
    std::string stimuli;
    std::string avatar;
    std::string json;
    bool force = false;
    double level = 0.95;
};

/// What each participant chose, in the order of their ids.
struct ChoicesMade {
    std::vector<std::string> participants{};
    std::vector<std::vector<studies::SeenChoice>> choices{};
    int not_seen = 0;  ///< choices without an arm that was seen to point
    bool synthetic = false;
};

bool choiceCounts(const results::RecordedAnswer& answer) {
    const studies::Trial& trial = answer.trial.trial;
    return !answer.superseded && trial.scored() && answer.trial.chosenPlace() >= 0;
}

/// All scored choices of participants who count, one recording each.
Result<std::vector<results::Recording>> gamesOf(const std::string& database) {
    const auto list = results::listParticipants(database);
    if (!list) return tl::unexpected(list.error());
    std::vector<results::Recording> out;
    for (const results::ParticipantRow& row : list->rows) {
        if (row.status != results::ParticipantStatus::active) continue;
        auto recording = results::loadRecording(database, row.id);
        if (!recording) return tl::unexpected(recording.error());
        std::erase_if(recording->answers, [](const auto& answer) { return !choiceCounts(answer); });
        if (!recording->answers.empty()) out.push_back(std::move(*recording));
    }
    if (out.empty())
        return fail(database, "has no choices of a referential game that count",
                    "Only these show how rays are read");
    return out;
}

/// The clips of all, each once.
Result<results::ClipRecords> clipsShown(const std::vector<results::Recording>& games,
                                        const std::string& database) {
    results::ClipRecords out;
    for (const results::Recording& recording : games)
        for (const results::RecordedAnswer& answer : recording.answers)
            for (const auto& [stimulus, record] : answer.clips)
                if (auto added = addShownClip(out, stimulus, record, database); !added)
                    return tl::unexpected(added.error());
    return out;
}

Result<ChoicesMade> choicesMade(const FitArguments& options, const studies::SimulatedParameters& base) {
    const auto games = gamesOf(options.database);
    if (!games) return tl::unexpected(games.error());
    const auto records = clipsShown(*games, options.database);
    if (!records) return tl::unexpected(records.error());
    ShownAvatar shown{games->front().study_source, {}, "the participants"};
    for (const results::Recording& recording : *games) shown.hashes.merge(shownAvatar(recording).hashes);
    const auto avatar = recordedAvatar(shown, options.database, options.avatar);
    if (!avatar) return tl::unexpected(avatar.error());
    const auto clips = RecordedClips::load(*records, *avatar, options.stimuli, options.database);
    if (!clips) return tl::unexpected(clips.error());
    const motion::LocalPose idle = motion::relaxedPose(avatar->skeleton);
    ChoicesMade out;
    for (const results::Recording& recording : *games) {
        std::vector<studies::SeenChoice> choices;
        for (const results::RecordedAnswer& answer : recording.answers) {
            out.synthetic = out.synthetic || answer.trial.synthetic;
            auto seen =
                studies::seenChoice(answer.trial, *clips, avatar->skeleton, idle, base.observer.reading,
                                    base.elevation_bias_deg, base.frame_rate_hz);
            if (seen)
                choices.push_back(std::move(*seen));
            else
                ++out.not_seen;
        }
        if (choices.empty()) continue;
        out.participants.push_back(recording.participant);
        out.choices.push_back(std::move(choices));
    }
    if (out.choices.empty())
        return fail(options.database, "has no choice among several balls after a pointing movement");
    return out;
}

std::string endText(const std::optional<double>& end, const char* none) {
    return end ? fmt::format("{:.3f}", *end) : std::string(none);
}

std::string fitLine(const std::string& name, const studies::ObserverFit& fit) {
    const auto interval = [](const studies::FittedParameter& of, const char* low, const char* high) {
        return fmt::format("{:>8.3f} {:<17}", of.value,
                           fmt::format("[{}, {}]", endText(of.lower, low), endText(of.upper, high)));
    };
    return fmt::format("{:<14} {:>7}  {} {} {:>12.3f} {:>12.3f}\n", name, fit.choices,
                       interval(fit.noise_deg, "0", "-"), interval(fit.lapse_rate, "0", "1"),
                       fit.log_likelihood, fit.aic);
}

FitJson parameterJson(const studies::FittedParameter& of) {
    FitJson out{{"value", of.value}};
    out["lower"] = of.lower ? FitJson(*of.lower) : FitJson();
    out["upper"] = of.upper ? FitJson(*of.upper) : FitJson();
    return out;
}

FitJson fitJson(const studies::ObserverFit& fit) {
    FitJson out{{"choices", fit.choices},
                {"noise_deg", parameterJson(fit.noise_deg)},
                {"lapse_rate", parameterJson(fit.lapse_rate)}};
    if (fit.eye_line_share) out["eye_line_share"] = parameterJson(*fit.eye_line_share);
    if (fit.visual_weight) out["visual_weight"] = parameterJson(*fit.visual_weight);
    out["log_likelihood"] = fit.log_likelihood;
    out["aic"] = fit.aic;
    return out;
}

/// The text of a parameters file with the value of a key of [pointing] replaced; unchanged where the key does
/// not stand on a line of its own.
std::string withValue(const std::string& text, const std::string& key, const std::string& value) {
    std::string out;
    bool pointing = false;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string line = text.substr(at, end - at);
        if (line.starts_with('[')) pointing = line.starts_with("[pointing]");
        const std::size_t equals = line.find('=');
        if (pointing && equals != std::string::npos && line.starts_with(key) &&
            line.find_first_not_of(' ', key.size()) == equals) {
            const std::size_t comment = line.find('#');
            line = fmt::format("{} = {}{}", key, value,
                               comment == std::string::npos ? "" : "    " + line.substr(comment));
        }
        out += line + (end < text.size() ? "\n" : "");
        at = end + 1;
    }
    return out;
}

/// What a fit puts in the place of the parameters that it began with.
struct Fitted {
    double noise_deg = 0.0;
    double noise_between = 0.0;
    studies::ObserverModel observer{};  ///< its noise is noise_deg
};

/// The parameters file given, with what was fitted; checked by reading it again.
Result<void> writeParameters(const FitArguments& options, const Fitted& fitted) {
    auto text = readFile(options.parameters);
    if (!text) return tl::unexpected(text.error());
    const auto number = [](double value) { return fmt::format("{}", value); };
    std::vector<std::pair<std::string, std::string>> values{
        {"ray", fmt::format("\"{}\"", studies::readingName(fitted.observer.reading))},
        {"noise_deg", number(fitted.noise_deg)},
        {"noise_between", number(fitted.noise_between)},
        {"lapse_rate", number(fitted.observer.lapse_rate)}};
    if (fitted.observer.reading.twoCue()) {
        values.emplace_back("eye_line_share", number(fitted.observer.eye_line_share));
        values.emplace_back("visual_weight", number(fitted.observer.visual_weight));
    }
    std::string out = *text;
    for (const auto& [key, value] : values) out = withValue(out, key, value);
    out = fmt::format("# [pointing] was fitted by deixis fit to {}; everything else is from\n# {}.\n\n",
                      options.database, options.parameters) +
          out;
    if (auto written = writeUnlessEdited(options.output, out, options.force); !written) return written;
    const auto read = studies::loadSimulatedParameters(options.output);
    if (!read) return tl::unexpected(read.error());
    const studies::ObserverModel& kept = read->observer;
    if (kept.reading != fitted.observer.reading || kept.noise_rad != radiansFromDegrees(fitted.noise_deg) ||
        read->pointing_noise_between != fitted.noise_between ||
        kept.lapse_rate != fitted.observer.lapse_rate ||
        kept.eye_line_share != fitted.observer.eye_line_share ||
        kept.visual_weight != fitted.observer.visual_weight)
        return fail(options.parameters,
                    "its [pointing] could not be changed: its keys are not on separate lines",
                    "Write them as in the default file");
    fmt::print(remarksBeside(options.json), "parameters: {}\n", options.output);
    return {};
}

/// All choices as those of one observer: with the weights of two cues, which `model` then has.
studies::ObserverFit fitTogether(const std::vector<std::vector<studies::SeenChoice>>& by_participant,
                                 studies::ObserverModel& model, double level) {
    std::vector<studies::SeenChoice> all;
    for (const auto& choices : by_participant) all.insert(all.end(), choices.begin(), choices.end());
    if (!model.reading.twoCue()) return studies::fitObserver(all, model, level);
    studies::ObserverFit fit = studies::fitWeights(all, model, level);
    model.eye_line_share = fit.eye_line_share->value;
    model.visual_weight = fit.visual_weight->value;
    return fit;
}

void printWeights(std::FILE* to, const studies::ObserverFit& fit) {
    const auto line = [to](const char* name, const studies::FittedParameter& of) {
        fmt::print(to, "{:<24} {:>8.3f} [{}, {}]\n", name, of.value, endText(of.lower, "0"),
                   endText(of.upper, "1"));
    };
    if (fit.eye_line_share) line("eye_line_share, pooled", *fit.eye_line_share);
    if (fit.visual_weight) line("visual_weight, pooled", *fit.visual_weight);
}

/// Everybody by themselves with the weights of all, all as one, and all as differing in their noise.
Fitted fitAll(const ChoicesMade& made, studies::ObserverModel model, double level, FitJson& json,
              std::FILE* to) {
    const studies::ObserverFit pooled = fitTogether(made.choices, model, level);
    fmt::print(to, "{:<14} {:>7}  {:<26} {:<26} {:>12} {:>12}\n", "participant", "choices", "noise, degrees",
               "lapse rate", "log-lik.", "AIC");
    json["participants"] = FitJson::array();
    for (std::size_t i = 0; i < made.choices.size(); ++i) {
        const studies::ObserverFit one = studies::fitObserver(made.choices[i], model, level);
        fmt::print(to, "{}", fitLine(made.participants[i], one));
        FitJson row{{"participant", made.participants[i]}};
        row.update(fitJson(one));
        json["participants"].push_back(std::move(row));
    }
    fmt::print(to, "{}", fitLine("all, pooled", pooled));
    printWeights(to, pooled);
    json["pooled"] = fitJson(pooled);
    json["population"] = FitJson();
    model.lapse_rate = pooled.lapse_rate.value;
    if (made.choices.size() == 1) return {pooled.noise_deg.value, 0.0, model};
    const studies::PopulationFit population = studies::fitPopulation(made.choices, model);
    model.lapse_rate = population.lapse_rate;
    json["population"] = {{"noise_deg", population.noise_deg},
                          {"noise_between", population.noise_between},
                          {"lapse_rate", population.lapse_rate},
                          {"log_likelihood", population.log_likelihood},
                          {"aic", population.aic}};
    fmt::print(
        "participants' noise differing: noise {:.3f} degrees, noise_between {:.3f}, lapse rate "
        "{:.3f}; log-likelihood {:.3f}, AIC {:.3f}\n",
        population.noise_deg, population.noise_between, population.lapse_rate, population.log_likelihood,
        population.aic);
    return {population.noise_deg, population.noise_between, model};
}

Result<void> fitDatabase(const FitArguments& options) {
    auto base = studies::loadSimulatedParameters(options.parameters);
    if (!base) return tl::unexpected(base.error());
    if (!options.ray.empty()) {
        const auto reading = studies::readingFromName(options.ray);
        if (!reading) return fail("--ray", reading.error().message, reading.error().hint);
        base->observer.reading = *reading;
    }
    for (const std::string& file : {options.output, options.json})
        if (auto checked = checkOutput(file); !checked) return checked;
    if (auto free = checkReplaceable(options.json, options.force); !free) return free;
    auto working = std::make_optional<ElapsedOnTerminal>("reading the choices");
    const auto made = choicesMade(options, *base);
    working.reset();
    if (!made) return tl::unexpected(made.error());

    std::FILE* const to = remarksBeside(options.json);
    const std::string_view ray = studies::readingName(base->observer.reading);
    FitJson json{{"schema", {{"name", "deixis-fit"}, {"version", 1}}},
                 {"ray", ray},
                 {"level", options.level},
                 {"synthetic", made->synthetic},
                 {"choices_not_seen", made->not_seen}};
    fmt::print(to, "{}; choice ~ (1 - lapse) P(ball | noise) + lapse / balls; {:.4g} % profile intervals\n",
               ray, 100.0 * options.level);
    if (made->synthetic) fmt::print(to, "Simulated participants are among them: no evidence about people.\n");
    if (made->not_seen > 0) fmt::print(to, "{} choices left out: no pointing was seen\n", made->not_seen);
    const Fitted fitted = fitAll(*made, base->observer, options.level, json, to);
    if (!options.json.empty()) {
        if (auto written = writeOutput(options.json, json.dump(2) + "\n"); !written) return written;
        if (options.json != standard_output) fmt::print("numbers: {}\n", options.json);
    }
    if (options.output.empty()) return {};
    return writeParameters(options, fitted);
}

}  // namespace

void addFitCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<FitArguments>();
    Parser command = cli.addCommand(
        "fit", "Fit the simulated participant's noise, lapses and weights to the choices of a database");
    describe(command,
             {.writes = "only what it prints, unless -o or --json FILE is given.",
              .example =
                  "deixis fit study.sqlite -o observer.toml\ndeixis fit study.sqlite --ray arm-finger --json",
              .page = "docs/simulated-participant.md"});
    command.addOption("DB", options->database, "Database of a study with a referential game").required();
    addOutput(command, options->output, "Parameters file to write, for deixis simulate --parameters");
    addForce(command, options->force);
    command
        .addOption("--parameters", options->parameters,
                   "Parameters that are not fitted (TOML) [the default ones]")
        .defaultValue(assets::dataFile("simulated_participant.toml").string())
        .showDefault("");
    command.addOption("--ray", options->ray,
                      "How the arm is read: two-cue, arm-finger, eye-fingertip, ... [as in the parameters]");
    command.addOption("--level", options->level, "Level of the intervals")
        .check(Range(0.5, 0.9999))
        .showDefault();
    addJsonOrFile(command, options->json);
    command.addOption("--stimuli", options->stimuli, "Folder of the clips that were shown [where they were]");
    command.addOption("--avatar", options->avatar,
                      "The avatar that was shown, glTF or VRM [the study's; else Deixis's own]");
    command.callback([options, &chosen] { chosen = [options] { return fitDatabase(*options); }; });
}

}  // namespace deixis::app
