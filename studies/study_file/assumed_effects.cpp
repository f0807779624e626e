#include "studies/study_file/assumed_effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "studies/study_file/answer_curve.hpp"
#include "studies/texts/study_texts.hpp"
#include "studies/texts/toml_table.hpp"

namespace deixis::studies {

namespace {

constexpr double largest_sd = 100.0;
constexpr double largest_shift = 20.0;
constexpr std::array<std::string_view, 3> effect_sections{"accuracy", "rating", "preference"};
constexpr std::array<std::string_view, 8> accuracy_keys{
    "systems",   "participant_sd", "participant_system_sd", "item_sd", "lapse_rate", "layouts",
    "distances", "groups"};
constexpr std::array<std::string_view, 6> assumed_rating_keys{
    "systems", "participant_sd", "participant_system_sd", "item_sd", "noise_sd", "groups"};
constexpr std::array<std::string_view, 5> assumed_preference_keys{"systems", "participant_system_sd",
                                                                  "noise_sd", "tie_zone", "clear_zone"};

/// The systems, layouts or distances that scored stages of a kind use.
enum class NamedFactor : unsigned char { system, layout, distance };

std::vector<std::string_view> namesUsed(const Study& study, AnswerKind kind, const std::string& measure,
                                        NamedFactor factor) {
    std::set<std::string_view> used;
    for (const Stage& stage : study.stages) {
        if (!stage.scored()) continue;
        const std::vector<StudyMeasure> asked = measuresOf(study, stage);
        if (std::none_of(asked.begin(), asked.end(), [&](const StudyMeasure& one) {
                return one.kind == kind && (kind != AnswerKind::rating || one.name == measure);
            }))
            continue;
        const auto& names = factor == NamedFactor::system   ? stage.design.systems
                            : factor == NamedFactor::layout ? stage.design.layouts
                                                            : stage.design.distances;
        used.insert(names.begin(), names.end());
    }
    return {used.begin(), used.end()};
}

/// [key] with a number for each of `names`; without `required` none of them has to be there.
ByName readByName(TomlTable& table, std::string_view key, const std::vector<std::string_view>& names,
                  double low, double high, bool required) {
    TomlTable numbers = table.below(key, table.section(key, required), names);
    ByName out;
    for (const std::string_view name : names) {
        if (!required && !numbers.has(name)) continue;
        const double number = numbers.number(name, low, high);
        if (numbers.sound(name)) out.emplace(name, number);
    }
    return out;
}

AssumedSpread readSpread(TomlTable& table) {
    return {table.number("participant_sd", 0.0, largest_sd),
            table.number("participant_system_sd", 0.0, largest_sd), table.number("item_sd", 0.0, largest_sd)};
}

GroupShifts readGroups(TomlTable& table, const Study& study) {
    std::vector<std::string_view> factors;
    for (const BetweenFactor& factor : study.between) factors.push_back(factor.name);
    GroupShifts out;
    if (!table.has("groups")) return out;
    TomlTable groups = table.below("groups", table.section("groups", true), factors);
    for (const BetweenFactor& factor : study.between)
        if (groups.has(factor.name))
            out[factor.name] = readByName(groups, factor.name, {factor.levels.begin(), factor.levels.end()},
                                          -largest_shift, largest_shift, false);
    return out;
}

AssumedAccuracy readAccuracy(TomlTable table, const Study& study, const StudyMeasure& measure) {
    AssumedAccuracy read;
    read.spread = readSpread(table);
    read.lapse_rate = table.number("lapse_rate", 0.0, 1.0, 0.0);
    const auto names = [&](NamedFactor factor) { return namesUsed(study, AnswerKind::accuracy, "", factor); };
    read.systems = readByName(table, "systems", names(NamedFactor::system), 0.0, 1.0, true);
    read.layouts =
        readByName(table, "layouts", names(NamedFactor::layout), -largest_shift, largest_shift, false);
    read.distances =
        readByName(table, "distances", names(NamedFactor::distance), -largest_shift, largest_shift, false);
    read.groups = readGroups(table, study);
    const AnswerCurve curve = AnswerCurve::choice(read.lapse_rate, measure.balls);
    for (const auto& [name, share] : read.systems)
        if (!table.faulty("systems") && !table.faulty("lapse_rate") &&
            !(share > curve.low() && share < curve.high()))
            table.problemAt("systems", name,
                            fmt::format("found {}, expected a share of correct choices above {} and below "
                                        "{}: lapses are spread evenly over {} balls",
                                        share, curve.low(), curve.high(), measure.balls));
    return read;
}

AssumedRating readAssumedRating(TomlTable table, const Study& study, const StudyMeasure& measure) {
    AssumedRating read;
    read.spread = readSpread(table);
    read.noise_sd = table.number("noise_sd", 0.01, largest_sd);
    read.groups = readGroups(table, study);
    read.systems =
        readByName(table, "systems", namesUsed(study, AnswerKind::rating, measure.name, NamedFactor::system),
                   measure.low, measure.high, true);
    for (const auto& [name, value] : read.systems)
        if (!table.faulty("systems") && !(value > measure.low && value < measure.high))
            table.problemAt("systems", name,
                            fmt::format("found {}, expected a mean above {} and below {}: at an end of the "
                                        "scale no answer could differ",
                                        value, measure.low, measure.high));
    return read;
}

AssumedPreference readAssumedPreference(TomlTable table, const Study& study) {
    AssumedPreference read;
    read.participant_system_sd = table.number("participant_system_sd", 0.0, largest_sd);
    read.noise_sd = table.number("noise_sd", 0.01, largest_sd);
    read.tie_zone = table.number("tie_zone", 0.0, largest_sd);
    read.clear_zone = table.number("clear_zone", 0.0, largest_sd);
    if (table.sound("clear_zone") && table.sound("tie_zone") && read.clear_zone < read.tie_zone)
        table.problem("clear_zone", fmt::format("found {}, less than tie_zone; expected at least {}",
                                                read.clear_zone, read.tie_zone));
    read.systems =
        readByName(table, "systems", namesUsed(study, AnswerKind::preference, "", NamedFactor::system),
                   -largest_sd, largest_sd, true);
    return read;
}

std::string tableToml(const std::string& name, const ByName& numbers) {
    if (numbers.empty()) return "";
    std::string out = fmt::format("\n[{}]\n", name);
    for (const auto& [key, value] : numbers) out += fmt::format("{} = {}\n", key, value);
    return out;
}

std::string groupsToml(const std::string& name, const GroupShifts& groups) {
    std::string out;
    for (const auto& [factor, shifts] : groups)
        out += tableToml(fmt::format("{}.groups.{}", name, factor), shifts);
    return out;
}

std::string spreadToml(const AssumedSpread& spread) {
    return fmt::format("participant_sd = {}\nparticipant_system_sd = {}\nitem_sd = {}\n",
                       spread.participant_sd, spread.participant_system_sd, spread.item_sd);
}

}  // namespace

std::vector<StudyMeasure> measuresOf(const Study& study, const Stage& stage) {
    const StageDeclaration& kind = declarationOf(stage.kind);
    std::vector<StudyMeasure> out;
    const auto questions =
        kind.questions != nullptr ? kind.questions(stage, LanguageTable::english()) : std::vector<Question>{};
    for (const DeclaredMeasure& measure : kind.measures) {
        StudyMeasure asked{std::string(measure.name.empty() ? stage.measure : measure.name), measure.kind};
        if (measure.question.empty()) {
            asked.balls = 1;
            for (const std::string& name : stage.design.distances)
                if (const DistanceBand* band = study.findDistance(name))
                    asked.balls = std::max(asked.balls, band->distractors + 1);
            out.push_back(std::move(asked));
            continue;
        }
        const auto question = std::find_if(questions.begin(), questions.end(),
                                           [&](const Question& one) { return one.id == measure.question; });
        if (question == questions.end()) continue;
        const bool scale = question->kind == QuestionKind::scale;
        asked.low = scale ? question->scale.low : static_cast<int>(question->low);
        asked.high = scale ? question->scale.high : static_cast<int>(question->high);
        out.push_back(std::move(asked));
    }
    return out;
}

std::vector<StudyMeasure> studyMeasures(const Study& study) {
    std::vector<StudyMeasure> out;
    const auto add = [&](const StudyMeasure& measure) {
        const auto same = std::find_if(out.begin(), out.end(),
                                       [&](const StudyMeasure& known) { return known.name == measure.name; });
        if (same == out.end()) {
            out.push_back(measure);
            return;
        }
        same->low = std::min(same->low, measure.low);
        same->high = std::max(same->high, measure.high);
        same->balls = std::max(same->balls, measure.balls);
    };
    for (const bool choices : {true, false})
        for (const Stage& stage : study.stages)
            if (stage.scored())
                for (const StudyMeasure& measure : measuresOf(study, stage))
                    if ((measure.kind == AnswerKind::accuracy) == choices) add(measure);
    return out;
}

Result<AssumedEffects> loadAssumedEffects(const std::filesystem::path& path, const Study& study) {
    const auto file = readToml(path);
    if (!file) return tl::unexpected(file.error());
    Problems problems(path.string());
    TextBook no_texts(problems);
    TomlTable root(&*file, "", effect_sections, problems, no_texts);
    const std::vector<StudyMeasure> measures = studyMeasures(study);
    std::vector<std::string_view> rated;
    AssumedEffects read;
    for (const StudyMeasure& measure : measures)
        if (measure.kind == AnswerKind::rating) rated.push_back(measure.name);
    TomlTable ratings = root.below("rating", root.section("rating", false), rated);
    const auto asked = [&](AnswerKind kind) {
        return std::find_if(measures.begin(), measures.end(),
                            [&](const StudyMeasure& measure) { return measure.kind == kind; });
    };
    for (const StudyMeasure& measure : measures)
        if (measure.kind == AnswerKind::rating && ratings.has(measure.name))
            read.ratings[measure.name] = readAssumedRating(
                ratings.below(measure.name, ratings.section(measure.name, true), assumed_rating_keys), study,
                measure);
    if (asked(AnswerKind::accuracy) == measures.end())
        root.reject("accuracy", "where the study has no referential game");
    else if (root.has("accuracy"))
        read.accuracy = readAccuracy(root.below("accuracy", root.section("accuracy", true), accuracy_keys),
                                     study, *asked(AnswerKind::accuracy));
    if (asked(AnswerKind::preference) == measures.end())
        root.reject("preference", "where the study compares no pairs");
    else if (root.has("preference"))
        read.preference = readAssumedPreference(
            root.below("preference", root.section("preference", true), assumed_preference_keys), study);
    if (problems.none() && !read.accuracy && read.ratings.empty() && !read.preference)
        return fail(path.string(), "assumes nothing about any measure of the study",
                    "Give [accuracy], [rating.MEASURE] or [preference]; docs/power.md describes them");
    if (!problems.none()) return tl::unexpected(problems.sorted().front());
    return read;
}

std::string assumedEffectsToml(const AssumedEffects& effects) {
    std::string out = "# Assumed answers for deixis power (docs/power.md).\n";
    if (effects.accuracy) {
        const AssumedAccuracy& accuracy = *effects.accuracy;
        out += fmt::format("\n[accuracy]\nlapse_rate = {}\n{}", accuracy.lapse_rate,
                           spreadToml(accuracy.spread));
        out += tableToml("accuracy.systems", accuracy.systems);
        out += tableToml("accuracy.layouts", accuracy.layouts);
        out += tableToml("accuracy.distances", accuracy.distances);
        out += groupsToml("accuracy", accuracy.groups);
    }
    for (const auto& [measure, rating] : effects.ratings) {
        out += fmt::format("\n[rating.{}]\n{}noise_sd = {}\n", measure, spreadToml(rating.spread),
                           rating.noise_sd);
        out += tableToml(fmt::format("rating.{}.systems", measure), rating.systems);
        out += groupsToml(fmt::format("rating.{}", measure), rating.groups);
    }
    if (effects.preference) {
        const AssumedPreference& preference = *effects.preference;
        out += fmt::format(
            "\n[preference]\nparticipant_system_sd = {}\nnoise_sd = {}\ntie_zone = {}\nclear_zone = {}\n",
            preference.participant_system_sd, preference.noise_sd, preference.tie_zone,
            preference.clear_zone);
        out += tableToml("preference.systems", preference.systems);
    }
    return out;
}

std::vector<double> groupShifts(const Study& study, const GroupShifts& groups) {
    std::vector<double> out{0.0};
    for (const BetweenFactor& factor : study.between) {
        const auto shifts = groups.find(factor.name);
        if (shifts == groups.end()) continue;
        std::vector<double> sums;
        for (const double sum : out)
            for (const std::string& level : factor.levels) {
                const auto found = shifts->second.find(level);
                sums.push_back(sum + (found == shifts->second.end() ? 0.0 : found->second));
            }
        out = std::move(sums);
    }
    return out;
}

std::vector<double> gameShifts(const Study& study, const AssumedAccuracy& accuracy) {
    const auto shiftsOf = [](const std::vector<std::string_view>& names, const ByName& shifts) {
        std::vector<double> out;
        for (const std::string_view name : names) {
            const auto found = shifts.find(std::string(name));
            out.push_back(found == shifts.end() ? 0.0 : found->second);
        }
        if (out.empty()) out.push_back(0.0);
        return out;
    };
    const auto layouts =
        shiftsOf(namesUsed(study, AnswerKind::accuracy, "", NamedFactor::layout), accuracy.layouts);
    const auto distances =
        shiftsOf(namesUsed(study, AnswerKind::accuracy, "", NamedFactor::distance), accuracy.distances);
    std::vector<double> out;
    for (const double group : groupShifts(study, accuracy.groups))
        for (const double layout : layouts)
            for (const double distance : distances) out.push_back(group + layout + distance);
    return out;
}

}  // namespace deixis::studies
