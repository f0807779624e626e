// The evaluation's numbers: JSON, and CSV tables.
#include "tables.hpp"
#include "comparisons.hpp"
#include "results/evaluation/evaluation.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/outputs/observers_json.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

Json orNull(bool known, double value) {
    return known ? Json(value) : Json();
}

Json vectorJson(const Vec3& v) {
    return {v.x, v.y, v.z};
}

Json summaryJson(const std::vector<double>& values) {
    const bool any = !values.empty();
    return {{"mean", orNull(any, mean(values))},
            {"sd", orNull(values.size() > 1, sampleSd(values))},
            {"median", orNull(any, quantile(values, 0.5))},
            {"q1", orNull(any, quantile(values, 0.25))},
            {"q3", orNull(any, quantile(values, 0.75))},
            {"min", orNull(any, quantile(values, 0.0))},
            {"max", orNull(any, quantile(values, 1.0))}};
}

/// A system's hand at one step of time.
struct ProfileStep {
    std::string system;
    const char* hand = "";
    const ProfilePoint* of = nullptr;
};

const Fields<ProfileStep>& profileFields() {
    static const Fields<ProfileStep> fields{
        {"system", &ProfileStep::system, {.in = in_csv}},
        {"hand", &ProfileStep::hand, {.in = in_csv}},
        {"time_s", [](auto& one) { return one.of->time_s; }},
        {"n", [](auto& one) { return one.of->n; }},
        {"accuracy_mean", [](auto& one) { return one.of->reward_mean; }},
        {"accuracy_sd", [](auto& one) { return known(one.of->n > 1, one.of->reward_sd); }},
        {"speed_mean_m_s", [](auto& one) { return one.of->speed_mean; }},
        {"speed_sd_m_s", [](auto& one) { return known(one.of->n > 1, one.of->speed_sd); }}};
    return fields;
}

Table profilesTable(const std::string& system, const char* hand, const HandProfile& profile) {
    std::vector<ProfileStep> steps;
    for (const ProfilePoint& point : profile.points) steps.push_back({system, hand, &point});
    return tableOf("profiles", units::clips, "", profileFields(), steps);
}

Json profileJson(const HandProfile& profile) {
    return {{"clips", profile.clips}, {"points", tableJson(profilesTable("", "", profile))}};
}

Json correlationJson(const SpearmanTest& test) {
    const bool known = test.method != "undefined";
    return {{"n", test.n},
            {"rho", orNull(known, test.rho)},
            {"p", orNull(known, test.p)},
            {"method", test.method}};
}

Json raysJson(const SystemEvaluation& system) {
    Json out = Json::object();
    for (const motion::PointingRay ray : compared_rays)
        if (const auto errors = rayErrors_deg(system, ray); !errors.empty())
            out[std::string(motion::pointingRayName(ray))] = summaryJson(errors);
    return out;
}

Json systemJson(const SystemEvaluation& system) {
    Json clusters = Json::array();
    for (const auto& value : system.cluster_means) clusters.push_back(value ? Json(*value) : Json());
    return {{"system", system.system},
            {"synthetic", system.synthetic},
            {"clips", system.clips.size()},
            {"n", system.rewards.size()},
            {"missing", system.missing},
            {"left_hand", system.left_hand},
            {"phases_found", system.phases_found},
            {"placed", system.placed},
            {"accuracy", summaryJson(system.rewards)},
            {"error_deg", summaryJson(system.errors_deg)},
            {"ray_errors_deg", raysJson(system)},
            {"density_correlation", correlationJson(system.correlation)},
            {"accuracy_by_cluster", std::move(clusters)},
            {"profiles", {{"left", profileJson(system.left)}, {"right", profileJson(system.right)}}}};
}

Json settingsJson(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    return {{"window_s", input.rule.window_s},
            {"slower_than_m_s", input.rule.slower_than_m_s},
            {"bandwidth_rule", evaluation.bandwidth_rule},
            {"bandwidths_m", evaluation.bandwidths},
            {"mean_shift_bandwidth_m", evaluation.mean_shift_bandwidth},
            {"mean_shift_bandwidth_estimated", evaluation.mean_shift_estimated}};
}

}  // namespace

Table clipsTable(const Evaluation& evaluation) {
    using Row = MeasuredClip;
    const auto measured = [](auto read) {
        return [=](const Row& one) { return one.accuracy ? Cell(read(*one.accuracy)) : Cell(); };
    };
    return tableOf<Row>("clips", units::clips, "",
                        {{"system", &Row::system},
                         {"clip", &Row::clip},
                         {"target_id", &Row::target_id},
                         {"target_x", [](auto& one) { return one.target.x; }},
                         {"target_y", [](auto& one) { return one.target.y; }},
                         {"target_z", [](auto& one) { return one.target.z; }},
                         {"hand", [](auto& one) { return motion::sideName(one.hand); }},
                         {"pointing_frame", &Row::pointing_frame},
                         {"phases", [](auto& one) { return one.phases_given ? "given" : "found"; }},
                         {"placed", &Row::placed},
                         {"accuracy", measured([](auto& of) { return of.reward; })},
                         {"error_deg", measured([](auto& of) { return degreesFromRadians(of.error_rad); })},
                         {"accuracy_frame", measured([](auto& of) { return of.frame; })}},
                        evaluation.input.clips);
}

Table systemsTable(const Evaluation& evaluation) {
    using Row = SystemEvaluation;
    const auto correlated = [](auto member) {
        return [=](const Row& one) {
            return known(one.correlation.method != "undefined", one.correlation.*member);
        };
    };
    Fields<Row> fields{{"system", &Row::system},
                       {"synthetic", &Row::synthetic},
                       {"clips", [](auto& one) { return one.clips.size(); }},
                       {"n", [](auto& one) { return one.rewards.size(); }},
                       {"missing", &Row::missing},
                       {"left_hand", &Row::left_hand, {.label = "left hand"}}};
    const auto add = [&](const char* mean_of, const char* sd_of, const char* median_of,
                         std::vector<double> Row::*of, const char* unit, Format format) {
        const std::string names[]{std::string("Mean") + unit, std::string("SD") + unit,
                                  std::string("Median") + unit};
        fields.push_back({mean_of,
                          [=](const Row& one) { return known(!(one.*of).empty(), mean(one.*of)); },
                          {.label = names[0].c_str(), .format = format}});
        fields.push_back({sd_of,
                          [=](const Row& one) { return known((one.*of).size() > 1, sampleSd(one.*of)); },
                          {.label = names[1].c_str(), .format = format}});
        fields.push_back({median_of,
                          [=](const Row& one) { return known(!(one.*of).empty(), quantile(one.*of, 0.5)); },
                          {.label = names[2].c_str(), .format = format}});
    };
    add("accuracy_mean", "accuracy_sd", "accuracy_median", &Row::rewards, "", Format::three_decimals);
    add("error_deg_mean", "error_deg_sd", "error_deg_median", &Row::errors_deg, " (\u00b0)",
        Format::one_decimal);
    const Fields<Row> correlation{
        {"density_rho",
         correlated(&SpearmanTest::rho),
         {.label = "\u03c1", .format = Format::three_decimals}},
        {"density_p", correlated(&SpearmanTest::p), {.label = "p", .format = Format::p_value}},
        {"density_test", [](auto& one) { return one.correlation.method; }}};
    return tableOf("systems", units::clips, "", joined(std::move(fields), correlation), evaluation.systems);
}

Table comparisonsTable(const Evaluation& evaluation) {
    using Row = SystemComparison;
    const auto name = [&](std::size_t Row::*of) {
        return [&evaluation, of](const Row& one) { return evaluation.systems[one.*of].system; };
    };
    const auto of = [](auto member) { return [=](const Row& one) { return one.test.*member; }; };
    const auto any = [](auto member) {
        return [=](const Row& one) { return known(one.test.n_pairs > 0, one.test.*member); };
    };
    const auto shift = [](auto member) {
        return [=](const Row& one) { return one.test.hodges_lehmann.*member; };
    };
    const Fields<Row> fields{
        {"a", name(&Row::a)},
        {"b", name(&Row::b)},
        {"pair",
         [&](auto& one) { return name(&Row::a)(one) + " \u2013 " + name(&Row::b)(one); },
         {.label = "Systems", .in = page_only}},
        {"targets", of(&SignedRankTest::n_pairs)},
        {"mean_difference",
         [](auto& one) { return known(one.test.n_pairs > 0, one.mean_difference); },
         {.label = "Mean", .format = Format::three_decimals}},
        {"sd",
         [](auto& one) { return known(one.test.n_pairs > 1, one.sd); },
         {.format = Format::three_decimals}},
        {"mean_difference_deg",
         [](auto& one) { return known(one.test.n_pairs > 0, one.mean_difference_deg); },
         {.label = "Mean (\u00b0)", .format = Format::one_decimal}},
        {"typical_difference", shift(&HodgesLehmann::estimate)},
        {"typical",
         [](auto& one) { return intervalOf(one.test.hodges_lehmann); },
         {.label = "Typical [interval]",
          .format = Format::three_decimals,
          .in = page_only,
          .estimate = true}},
        {"interval_low", shift(&HodgesLehmann::lower), {.in = in_csv}},
        {"interval_high", shift(&HodgesLehmann::upper), {.in = in_csv}},
        {"interval",
         [](auto& one) {
             return Json{jsonOf(one.test.hodges_lehmann.lower), jsonOf(one.test.hodges_lehmann.upper)};
         },
         {.in = in_json}},
        {"interval_level", shift(&HodgesLehmann::level), {.in = in_json}},
        {"n_zero", of(&SignedRankTest::n_zero)},
        {"w_plus", any(&SignedRankTest::w_plus)},
        {"rank_biserial", of(&SignedRankTest::rank_biserial)},
        {"p", any(&SignedRankTest::p_two_sided)},
        {"p_holm", &Row::p_holm},
        {"test",
         [](auto& one) { return one.test.n_pairs > 0 ? one.test.method : "no targets"; },
         {.json = "method"}}};
    return tableOf("comparisons", units::targets, "", fields, evaluation.comparisons);
}

Table profilesTable(const Evaluation& evaluation) {
    Table out{"profiles", units::clips, "", columnsOf(profileFields())};
    for (const SystemEvaluation& system : evaluation.systems)
        for (const auto& [hand, profile] :
             {std::pair{"left", &system.left}, std::pair{"right", &system.right}})
            for (Table::Row& row : profilesTable(system.system, hand, *profile).rows)
                out.rows.push_back(std::move(row));
    return out;
}

Table targetsTable(const Evaluation& evaluation) {
    return tableOf<TestPoint>("targets", units::targets, "",
                              {{"target_id", &TestPoint::target_id},
                               {"target", [](auto& one) { return vectorJson(one.target); }, {.in = in_json}},
                               {"x", [](auto& one) { return one.target.x; }, {.in = in_csv}},
                               {"y", [](auto& one) { return one.target.y; }, {.in = in_csv}},
                               {"z", [](auto& one) { return one.target.z; }, {.in = in_csv}},
                               {"density_per_m3", &TestPoint::density, {.json = "density"}},
                               {"cluster", [](auto& one) { return one.cluster + 1; }}},
                              evaluation.points);
}

Table clustersTable(const Evaluation& evaluation) {
    using Row = TargetCluster;
    const auto place = [&evaluation](const Row& one) {
        return static_cast<std::size_t>(&one - evaluation.clusters.data());
    };
    Fields<Row> fields{
        {"cluster", [=](auto& one) { return place(one) + 1; }, {.label = "Cluster", .in = in_csv}},
        {"centre", [](auto& one) { return vectorJson(one.centre); }, {.in = in_json}},
        {"x", [](auto& one) { return one.centre.x; }, {.label = "x (m)", .in = in_csv}},
        {"y", [](auto& one) { return one.centre.y; }, {.label = "y (m)", .in = in_csv}},
        {"z", [](auto& one) { return one.centre.z; }, {.label = "z (m)", .in = in_csv}},
        {"training_targets", &Row::training_targets},
        {"test_points", &Row::test_points}};
    for (const SystemEvaluation& system : evaluation.systems)
        fields.push_back({("accuracy_" + system.system).c_str(),
                          [=, &system](const Row& one) { return system.cluster_means[place(one)]; },
                          {.label = system.system.c_str(), .format = Format::three_decimals, .in = in_csv}});
    return tableOf("clusters", units::clips, "", fields, evaluation.clusters);
}

Table raysTable(const Evaluation& evaluation) {
    struct Row {
        std::string system;
        motion::PointingRay ray;
        std::vector<double> errors;
    };
    std::vector<Row> rows;
    for (const SystemEvaluation& system : evaluation.systems)
        for (const motion::PointingRay ray : compared_rays)
            if (auto errors = rayErrors_deg(system, ray); !errors.empty())
                rows.push_back({system.system, ray, std::move(errors)});
    const auto at = [](double q) { return [=](const Row& one) { return quantile(one.errors, q); }; };
    return tableOf<Row>(
        "rays", units::clips, "",
        {{"system", &Row::system},
         {"ray", [](auto& one) { return motion::pointingRayName(one.ray); }},
         {"clips", [](auto& one) { return one.errors.size(); }},
         {"error_mean", [](auto& one) { return mean(one.errors); }},
         {"error_sd", [](auto& one) { return known(one.errors.size() > 1, sampleSd(one.errors)); }},
         {"error_q25", at(0.25)},
         {"error_median", at(0.5)},
         {"error_q75", at(0.75)}},
        rows);
}

namespace {

/// With each system's accuracy there, the mean where it has several clips.
Json targetsJson(const Evaluation& evaluation) {
    Json out = tableJson(targetsTable(evaluation));
    for (Json& target : out) target["accuracy"] = Json::object();
    for (const SystemEvaluation& system : evaluation.systems) {
        const ByTarget targets = byTarget(system);
        for (std::size_t i = 0; i < evaluation.points.size(); ++i) {
            const Vec3& at = evaluation.points[i].target;
            if (const auto found = targets.find({at.x, at.y, at.z}); found != targets.end())
                out[i]["accuracy"][system.system] = mean(found->second.accuracy);
        }
    }
    return out;
}

}  // namespace

std::string evaluationJson(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    Json out;
    out["format"] = "deixis-evaluation";
    out["version"] = 2;
    out["program"] = input.program;
    out["build"] = Json::object();
    for (const auto& [name, value] : input.build) out["build"][name] = value;
    out["settings"] = settingsJson(evaluation);
    Json files = Json::array();
    for (const InputFile& file : input.files) files.push_back({{"path", file.path}, {"sha256", file.sha256}});
    out["files"] = std::move(files);
    out["motion_digest"] = input.motion_digest;
    Json training = Json::array();
    for (const Vec3& target : input.training) training.push_back(vectorJson(target));
    out["training"] = {{"source", input.training_source},
                       {"synthetic", input.training_synthetic},
                       {"targets", std::move(training)}};
    out["clusters"] = tableJson(clustersTable(evaluation));
    out["clips_without_target"] = input.without_target;
    Json systems = Json::array();
    for (const SystemEvaluation& system : evaluation.systems) systems.push_back(systemJson(system));
    out["systems"] = std::move(systems);
    out["comparisons"] = tableJson(comparisonsTable(evaluation));
    out["targets"] = targetsJson(evaluation);
    if (evaluation.nearest)
        out["observers"] = {{"study", input.study->name},
                            {"readings", readingsJson(evaluation.observers)},
                            {"nearest_training_target",
                             {{"targets", evaluation.nearest->targets},
                              {"median_distance_m", evaluation.nearest->median_distance_m},
                              {"share_right", evaluation.nearest->share_right}}}};
    out["remarks"] = evaluation.remarks;
    // What is not UTF-8 in a file's name must not stop the output.
    return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::pair<std::string, std::string>> evaluationTables(const Evaluation& evaluation) {
    std::vector<std::pair<std::string, std::string>> out;
    const auto add = [&](const Table& table) { out.emplace_back(table.name + ".csv", csvText(table)); };
    add(clipsTable(evaluation));
    add(systemsTable(evaluation));
    add(comparisonsTable(evaluation));
    add(profilesTable(evaluation));
    add(targetsTable(evaluation));
    add(clustersTable(evaluation));
    add(raysTable(evaluation));
    if (!evaluation.observers.empty()) add(tables::observers(evaluation.observers, "trials"));
    return out;
}

}  // namespace deixis::results
