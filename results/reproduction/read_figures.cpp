#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "results/reproduction/reproduction.hpp"

namespace deixis::results {

namespace {

using Parsed = nlohmann::json;

std::optional<double> numberOf(const Parsed& value) {
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// Parses a file and reads it by `read`, to which what has not the expected form is an exception.
template <typename Figures>
Result<Figures> readJson(const std::filesystem::path& file, bool (*expected)(const Parsed&),
                         const char* command, Figures (*read)(const Parsed&)) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const Parsed json = Parsed::parse(*text, nullptr, false);
    const std::string hint = fmt::format("Expected the JSON that '{}' writes", command);
    if (!json.is_object() || !expected(json)) return fail(file.string(), "is no such JSON", hint);
    try {
        Figures out = read(json);
        out.file = file.string();
        return out;
    } catch (const Parsed::exception& problem) {
        return fail(file.string(), fmt::format("is damaged: {}", problem.what()), hint);
    }
}

bool isEvaluation(const Parsed& json) {
    return json.value("format", Parsed()) == "deixis-evaluation";
}

bool isAnalysis(const Parsed& json) {
    return json.contains("schema") && json["schema"].is_object() &&
           json["schema"].value("name", Parsed()) == "deixis-analysis";
}

GridFigures gridFrom(const Parsed& json) {
    GridFigures out;
    out.points = static_cast<int>(json.at("targets").size());
    out.training_targets = static_cast<int>(json.at("training").at("targets").size());
    for (const Parsed& one : json.at("systems")) {
        GridFigures::System& system = out.systems.emplace_back();
        system.system = one.at("system");
        system.synthetic = one.at("synthetic");
        system.missing = one.at("missing");
        system.mean = numberOf(one.at("accuracy").at("mean"));
        system.sd = numberOf(one.at("accuracy").at("sd"));
        system.median = numberOf(one.at("accuracy").at("median"));
        system.error_deg = numberOf(one.at("error_deg").at("mean"));
        system.eye_error_deg = numberOf(one.at("ray_errors_deg").at("eye-fingertip").at("mean"));
        system.density_rho = numberOf(one.at("density_correlation").at("rho"));
        system.density_p = numberOf(one.at("density_correlation").at("p"));
        for (const Parsed& target : json.at("targets"))
            if (const Parsed& by_system = target.at("accuracy"); by_system.contains(system.system))
                system.accuracies.push_back(by_system.at(system.system));
    }
    return out;
}

StudyFigures studyFrom(const Parsed& json) {
    StudyFigures out;
    out.participants = json.at("participants");
    out.synthetic = json.at("synthetic");
    out.alpha = json.at("alpha");
    for (const Parsed& system : json.at("systems"))
        for (const Parsed& measure : json.at("measures")) {
            const std::string name = measure.at("measure");
            const Parsed& summary = system.at(name);
            const auto mean = numberOf(summary.at("mean"));
            if (!mean) continue;
            StudyFigures::Score& score = out.scores.emplace_back();
            score.system = system.at("system");
            score.measure = name;
            score.mean = *mean;
            if (const Parsed& interval = summary.at("interval"); interval.is_object()) {
                score.lower = numberOf(interval.at("lower"));
                score.upper = numberOf(interval.at("upper"));
            }
        }
    for (const Parsed& one : json.at("layouts"))
        if (one.at("measure") == "accuracy")
            if (const auto mean = numberOf(one.at("mean")))
                out.layouts.push_back(
                    {one.at("system"), one.at("layout"), *mean, numberOf(one.at("sd_trials")).value_or(0.0)});
    for (const Parsed& one : json.at("pairwise"))
        out.pairs.push_back({one.at("measure"), one.at("a"), one.at("b"), one.at("mean_difference"),
                             numberOf(one.at("p_holm")), one.at("significant")});
    for (const Parsed& one : json.at("layout_tests")) {
        if (one.at("measure") != "accuracy") continue;
        ++out.layout_tests;
        if (one.at("significant").get<bool>()) ++out.layouts_that_differ;
    }
    return out;
}

CeilingFigures ceilingFrom(const Parsed& json) {
    CeilingFigures out;
    const Parsed& observers = json.at("observers");
    for (const Parsed& reading : observers.at("readings")) {
        if (reading.at("layout") != "all") continue;
        for (const auto& [observer, read] : reading.at("observers").items())
            out.readings.push_back({reading.at("system"), observer, read.at("without_error")});
    }
    out.nearest_target_share = numberOf(observers.at("nearest_training_target").at("share_right"));
    return out;
}

}  // namespace

Result<GridFigures> readGridFigures(const std::string& grid, const std::filesystem::path& file) {
    auto out = readJson<GridFigures>(file, isEvaluation, "deixis evaluate ... --json FILE", gridFrom);
    if (out) out->grid = grid;
    return out;
}

Result<StudyFigures> readStudyFigures(const std::string& kind, const std::filesystem::path& file) {
    auto out = readJson<StudyFigures>(file, isAnalysis, "deixis report ... --json FILE", studyFrom);
    if (out) out->participants_kind = kind;
    return out;
}

Result<CeilingFigures> readCeilingFigures(const std::filesystem::path& file) {
    return readJson<CeilingFigures>(file, isEvaluation, "deixis evaluate ... --study STUDY --json FILE",
                                    ceilingFrom);
}

Result<std::vector<DemonstrationFigures>> readDemonstrationFigures(const std::filesystem::path& file) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const auto sheet = parseCsvSheet(*text, file.string());
    if (!sheet) return tl::unexpected(sheet.error());
    const std::string hint = "Expected the table that 'deixis clips measure ... --csv' prints";
    const auto hand = sheet->column("hand", hint), reward = sheet->column("greatest_reward", hint),
               speed = sheet->column("peak_speed_mps", hint);
    for (const auto* column : {&hand, &reward, &speed})
        if (!*column) return tl::unexpected(column->error());
    std::vector<DemonstrationFigures> out;
    for (const CsvRecord& row : sheet->rows) {
        const auto equation_2 = sheet->number(row, *reward), peak_speed = sheet->number(row, *speed);
        if (!equation_2) return tl::unexpected(equation_2.error());
        if (!peak_speed) return tl::unexpected(peak_speed.error());
        out.push_back({row.fields[*hand] == "left", *equation_2, *peak_speed});
    }
    if (out.empty()) return fail(file.string(), "found no clips", hint);
    return out;
}

}  // namespace deixis::results
