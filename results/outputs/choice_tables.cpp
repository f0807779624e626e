// Tables of the game's choices, and of what was measured over the target space.
#include "results/analysis/measured_space.hpp"
#include "results/answers/accuracy_by_angle.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "test_fields.hpp"

namespace deixis::results::tables {

Table chance(const AnalysisResult& result) {
    Fields<ChanceResult> fields{
        {"system", &ChanceResult::system},
        {"successes", &ChanceResult::successes, {"correct", "correct"}},
        {"choices", &ChanceResult::n, {"of", "of"}},
        {"choices_with_balls", &ChanceResult::n_known, {.in = in_data}},
        {"estimate",
         [](auto& one) { return known(one.n > 0, static_cast<double>(one.successes) / one.n); },
         {"Share", "share", Format::percent}},
        {"chance",
         [](auto& one) { return known(one.n_known > 0, one.chance); },
         {"Chance", nullptr, Format::percent}},
        {"mean_above",
         [](auto& one) { return known(one.n_known > 0, one.mean_above); },
         {"Mean above", "above", Format::percent}}};
    return tableOf(
        "chance", units::means_and_choices,
        "Correct choices and chance: signed-rank tests of participants' means of correct - 1 / balls",
        joined(std::move(fields), testFields(result)), result.chance);
}

Table unanswered(const AnalysisResult& result) {
    return tableOf<UnansweredResult>(
        "unanswered", units::means_and_choices, "Choices that were not made",
        {{"system", &UnansweredResult::system},
         {"answered", &UnansweredResult::answered, {"made"}},
         {"timed_out", &UnansweredResult::timed_out},
         {"skipped", &UnansweredResult::skipped},
         {"headline", &UnansweredResult::headline, {"Accuracy", nullptr, Format::percent}},
         {"answered_only", &UnansweredResult::answered_only, {"made alone", nullptr, Format::percent}},
         {"unanswered_wrong",
          &UnansweredResult::unanswered_wrong,
          {"all others wrong", "all others wrong", Format::percent}}},
        result.unanswered);
}

Table confusion(const AnalysisResult& result) {
    return tableOf<ConfusionResult>("confusion", units::choices, "Which balls were chosen",
                                    {{"system", &ConfusionResult::system},
                                     {"role", &ConfusionResult::role, {.latex = "ball"}},
                                     {"chosen", &ConfusionResult::chosen},
                                     {"shown", &ConfusionResult::shown},
                                     {"share",
                                      [](auto& one) { return static_cast<double>(one.chosen) / one.shown; },
                                      {.in = in_csv | in_print}}},
                                    result.confusion);
}

Table angles(const AnalysisResult& result) {
    return tableOf<AngleResult>(
        "angles", units::choices,
        "Correct choices by the angle from the target to the distractor that looks nearest",
        {{"eyes", &AngleResult::eyes},
         {"system", &AngleResult::system},
         {"from_deg", &AngleResult::from_deg, {.latex = "from (deg)"}},
         {"below_deg", &AngleResult::below_deg, {.latex = "below (deg)"}},
         {"right", &AngleResult::right},
         {"choices", &AngleResult::choices}},
        accuracyByAngle(result.table));
}

namespace {

struct Reading {
    const ObserverReading* of = nullptr;
    std::size_t observer = 0;
};

}  // namespace

Table observers(const std::vector<ObserverReading>& readings, const char* trials) {
    std::vector<Reading> rows;
    for (const ObserverReading& one : readings)
        for (std::size_t i = 0; i < observer_names.size(); ++i) rows.push_back({&one, i});
    return tableOf<Reading>(
        "observers", units::trials,
        "Expected correct choices of simulated observers; no evidence about people",
        {{"system", [](auto& one) { return one.of->system; }},
         {"layout", [](auto& one) { return one.of->layout; }},
         {"observer", [](auto& one) { return observer_names[one.observer]; }},
         {trials, [](auto& one) { return one.of->trials; }, {.in = in_csv}},
         {"accuracy", [](auto& one) { return one.of->accuracy[one.observer]; }},
         {"without_error", [](auto& one) { return one.of->without_error[one.observer]; }}},
        rows);
}

Table drift(const AnalysisResult& result) {
    return tableOf<DriftResult>(
        "drift", units::choices,
        "Choices of the ball nearest to the arm when the hold began and when it ended",
        {{"system", &DriftResult::system},
         {"line", &DriftResult::line},
         {"choices", &DriftResult::choices},
         {"of_first", &DriftResult::of_first, {"nearest at first", "at first"}},
         {"of_last", &DriftResult::of_last, {"at last", "at last"}},
         {"moved", &DriftResult::moved, {"two balls", "two balls"}},
         {"moved_first", &DriftResult::moved_first, {"the first chosen", "the first"}},
         {"moved_last", &DriftResult::moved_last, {"the last", "the last"}},
         {"another",
          [](auto& one) { return one.moved - one.moved_first - one.moved_last; },
          {.in = page_only}}},
        result.drift);
}

Table measuredSpace(const AnalysisResult& result) {
    return tableOf<MeasuredPlace>("measured_space", units::answers,
                                  "What was measured, by the target's place",
                                  {{"measure", &MeasuredPlace::measure},
                                   {"measured_in", &MeasuredPlace::unit},
                                   {"system", &MeasuredPlace::system},
                                   {"item", &MeasuredPlace::target_id},
                                   {"x_m", [](auto& one) { return one.position_m.x; }},
                                   {"y_m", [](auto& one) { return one.position_m.y; }},
                                   {"z_m", [](auto& one) { return one.position_m.z; }},
                                   {"n", &MeasuredPlace::n},
                                   {"mean", &MeasuredPlace::mean}},
                                  measuredSpace(result.table));
}

Table targetSpace(const AnalysisResult& result) {
    return tableOf<TargetPlace>("target_space", units::choices, "Correct choices by the target's place",
                                {{"system", &TargetPlace::system, {.heading = true}},
                                 {"item", &TargetPlace::target_id},
                                 {"x_m", [](auto& one) { return one.position_m.x; }, {"x", "$x$ (m)"}},
                                 {"y_m", [](auto& one) { return one.position_m.y; }, {"y", "$y$ (m)"}},
                                 {"z_m", [](auto& one) { return one.position_m.z; }, {"z", "$z$ (m)"}},
                                 {"mean", &TargetPlace::mean, {.latex = "correct"}},
                                 {"n", &TargetPlace::n}},
                                result.target_space);
}

}  // namespace deixis::results::tables
