#include <fmt/format.h>

#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "results/reproduction/reproduction.hpp"
#include "results/tables/written_json.hpp"

namespace deixis::results {

namespace {

std::optional<double> numberOf(const Json& value) {
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

template <typename Figures>
Result<Figures> readBy(const std::filesystem::path& file, const WrittenJson& expected,
                       Figures (*read)(const Json&)) {
    Figures out;
    const auto done = readWritten(file, expected, [&](const Json& json) -> Result<void> {
        out = read(json);
        return {};
    });
    if (!done) return tl::unexpected(done.error());
    out.file = file.string();
    return out;
}

GridFigures gridFrom(const Json& json) {
    GridFigures out;
    out.points = static_cast<int>(json.at("targets").size());
    out.training_targets = static_cast<int>(json.at("training").at("targets").size());
    for (const Json& one : json.at("systems")) {
        GridFigures::System& system = out.systems.emplace_back();
        system.system = one.at("system");
        system.missing = one.at("missing");
        system.mean = numberOf(one.at("accuracy").at("mean"));
        system.sd = numberOf(one.at("accuracy").at("sd"));
        system.median = numberOf(one.at("accuracy").at("median"));
        system.error_deg = numberOf(one.at("error_deg").at("mean"));
        system.eye_error_deg = numberOf(one.at("ray_errors_deg").at("eye-fingertip").at("mean"));
        system.density_rho = numberOf(one.at("density_correlation").at("rho"));
        system.density_p = numberOf(one.at("density_correlation").at("p"));
        for (const Json& target : json.at("targets"))
            if (const Json& by_system = target.at("accuracy"); by_system.contains(system.system))
                system.accuracies.push_back(by_system.at(system.system));
    }
    return out;
}

StudyFigures studyFrom(const Json& json) {
    StudyFigures out;
    out.participants = json.at("participants");
    out.synthetic = json.at("synthetic");
    out.alpha = json.at("alpha");
    for (const Json& system : json.at("systems"))
        for (const Json& measure : json.at("measures")) {
            const std::string name = measure.at("measure");
            const Json& summary = system.at(name);
            const auto mean = numberOf(summary.at("mean"));
            if (!mean) continue;
            StudyFigures::Score& score = out.scores.emplace_back();
            score.system = system.at("system");
            score.measure = name;
            score.mean = *mean;
            if (const Json& interval = summary.at("interval"); interval.is_object()) {
                score.lower = numberOf(interval.at("lower"));
                score.upper = numberOf(interval.at("upper"));
            }
        }
    for (const Json& one : json.at("layouts"))
        if (one.at("measure") == "accuracy")
            if (const auto mean = numberOf(one.at("mean")))
                out.layouts.push_back(
                    {one.at("system"), one.at("layout"), *mean, numberOf(one.at("sd_trials")).value_or(0.0)});
    for (const Json& one : json.at("pairwise"))
        out.pairs.push_back({one.at("measure"), one.at("a"), one.at("b"), one.at("significant")});
    for (const Json& one : json.at("layout_tests")) {
        if (one.at("measure") != "accuracy") continue;
        ++out.layout_tests;
        if (one.at("significant").get<bool>()) ++out.layouts_that_differ;
    }
    return out;
}

CeilingFigures ceilingFrom(const Json& json) {
    CeilingFigures out;
    const Json& observers = json.at("observers");
    for (const Json& reading : observers.at("readings")) {
        if (reading.at("layout") != "all") continue;
        for (const auto& [observer, read] : reading.at("observers").items())
            out.readings.push_back({reading.at("system"), observer, read.at("without_error")});
    }
    out.nearest_target_share = numberOf(observers.at("nearest_training_target").at("share_right"));
    return out;
}

}  // namespace

Result<GridFigures> readGridFigures(const std::string& grid, const std::filesystem::path& file) {
    auto out = readBy(file, writtenEvaluation(), gridFrom);
    if (out) out->grid = grid;
    return out;
}

Result<StudyFigures> readStudyFigures(const std::string& kind, const std::filesystem::path& file) {
    auto out = readBy(file, writtenAnalysis(), studyFrom);
    if (out) out->participants_kind = kind;
    return out;
}

Result<CeilingFigures> readCeilingFigures(const std::filesystem::path& file) {
    return readBy(file, writtenEvaluation(), ceilingFrom);
}

Result<std::vector<DemonstrationFigures>> readDemonstrationFigures(const std::filesystem::path& file) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const auto sheet = parseCsvSheet(*text, file.string());
    if (!sheet) return tl::unexpected(sheet.error());
    const std::string hint = "Expected the table that 'deixis clips measure ... --csv' prints";
    const auto hand = sheet->column("hand", hint), reward = sheet->column("max_reward", hint),
               speed = sheet->column("peak_speed_m_s", hint);
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
