// The evaluation's numbers: JSON, and CSV tables.
#include <nlohmann/json.hpp>

#include "evaluation_rays.hpp"
#include "results/evaluation/evaluation.hpp"
#include "results/outputs/observers_tables.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/tables/csv_table.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::ordered_json;

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
            {"least", orNull(any, quantile(values, 0.0))},
            {"greatest", orNull(any, quantile(values, 1.0))}};
}

Json profileJson(const HandProfile& profile) {
    Json points = Json::array();
    for (const ProfilePoint& p : profile.points)
        points.push_back({{"time_s", p.time_s},
                          {"n", p.n},
                          {"accuracy_mean", p.reward_mean},
                          {"accuracy_sd", orNull(p.n > 1, p.reward_sd)},
                          {"speed_mean_m_s", p.speed_mean},
                          {"speed_sd_m_s", orNull(p.n > 1, p.speed_sd)}});
    return {{"clips", profile.clips}, {"points", std::move(points)}};
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

Json optionalJson(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json comparisonJson(const Evaluation& evaluation, const SystemComparison& pair) {
    const SignedRankTest& test = pair.test;
    const bool any = test.n_pairs > 0;
    return {{"a", evaluation.systems[pair.a].system},
            {"b", evaluation.systems[pair.b].system},
            {"targets", test.n_pairs},
            {"mean_difference", orNull(any, pair.mean_difference)},
            {"sd", orNull(test.n_pairs > 1, pair.sd)},
            {"mean_difference_deg", orNull(any, pair.mean_difference_deg)},
            {"typical_difference", optionalJson(test.hodges_lehmann.estimate)},
            {"interval", {optionalJson(test.hodges_lehmann.lower), optionalJson(test.hodges_lehmann.upper)}},
            {"interval_level", optionalJson(test.hodges_lehmann.level)},
            {"n_zero", test.n_zero},
            {"w_plus", orNull(any, test.w_plus)},
            {"rank_biserial", optionalJson(test.rank_biserial)},
            {"p", orNull(any, test.p_two_sided)},
            {"p_holm", optionalJson(pair.p_holm)},
            {"method", any ? test.method : "no targets"}};
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

std::string evaluationJson(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    Json out;
    out["format"] = "deixis-evaluation";
    out["version"] = 1;
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
    Json clusters = Json::array();
    for (const TargetCluster& cluster : evaluation.clusters)
        clusters.push_back({{"centre", vectorJson(cluster.centre)},
                            {"training_targets", cluster.training_targets},
                            {"test_points", cluster.test_points}});
    out["clusters"] = std::move(clusters);
    out["clips_without_target"] = input.without_target;
    Json systems = Json::array();
    for (const SystemEvaluation& system : evaluation.systems) systems.push_back(systemJson(system));
    out["systems"] = std::move(systems);
    Json comparisons = Json::array();
    for (const SystemComparison& pair : evaluation.comparisons)
        comparisons.push_back(comparisonJson(evaluation, pair));
    out["comparisons"] = std::move(comparisons);
    Json points = Json::array();
    for (const TestPoint& point : evaluation.points)
        points.push_back({{"target_id", point.target_id},
                          {"target", vectorJson(point.target)},
                          {"density", point.density},
                          {"cluster", point.cluster + 1}});
    out["targets"] = std::move(points);
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

namespace {

ColumnSpec column(const char* name, ColumnType type = ColumnType::number) {
    return {name, type, ""};
}

void position(CsvTable& table, const Vec3& at) {
    table.number(at.x);
    table.number(at.y);
    table.number(at.z);
}

void orEmpty(CsvTable& table, bool known, double value) {
    if (known)
        table.number(value);
    else
        table.empty();
}

std::string clipsTable(const Evaluation& evaluation) {
    using enum ColumnType;
    CsvTable table({column("system", text), column("clip", text), column("target_id", text),
                    column("target_x"), column("target_y"), column("target_z"), column("hand", text),
                    column("pointing_frame", whole), column("phases", text), column("placed", truth),
                    column("accuracy"), column("error_deg"), column("accuracy_frame", whole)});
    for (const MeasuredClip& clip : evaluation.input.clips) {
        table.text(clip.system);
        table.text(clip.clip);
        table.text(clip.target_id);
        position(table, clip.target);
        table.text(motion::sideName(clip.hand));
        table.whole(clip.pointing_frame);
        table.text(clip.phases_given ? "given" : "found");
        table.whole(clip.placed ? 1 : 0);
        if (clip.accuracy) {
            table.number(clip.accuracy->reward);
            table.number(degreesFromRadians(clip.accuracy->error_rad));
            table.whole(clip.accuracy->frame);
        } else {
            for (int i = 0; i < 3; ++i) table.empty();
        }
        table.endRow();
    }
    return table.take();
}

std::string systemsCsv(const Evaluation& evaluation) {
    using enum ColumnType;
    CsvTable table({column("system", text), column("synthetic", truth), column("clips", whole),
                    column("n", whole), column("missing", whole), column("left_hand", whole),
                    column("accuracy_mean"), column("accuracy_sd"), column("accuracy_median"),
                    column("error_deg_mean"), column("error_deg_sd"), column("error_deg_median"),
                    column("density_rho"), column("density_p"), column("density_test", text)});
    for (const SystemEvaluation& system : evaluation.systems) {
        table.text(system.system);
        table.whole(system.synthetic ? 1 : 0);
        table.whole(static_cast<long long>(system.clips.size()));
        table.whole(static_cast<long long>(system.rewards.size()));
        table.whole(system.missing);
        table.whole(system.left_hand);
        for (const auto* values : {&system.rewards, &system.errors_deg}) {
            orEmpty(table, !values->empty(), mean(*values));
            orEmpty(table, values->size() > 1, sampleSd(*values));
            orEmpty(table, !values->empty(), quantile(*values, 0.5));
        }
        const bool known = system.correlation.method != "undefined";
        orEmpty(table, known, system.correlation.rho);
        orEmpty(table, known, system.correlation.p);
        table.text(system.correlation.method);
        table.endRow();
    }
    return table.take();
}

std::string comparisonsTable(const Evaluation& evaluation) {
    using enum ColumnType;
    CsvTable table({column("a", text), column("b", text), column("targets", whole), column("mean_difference"),
                    column("sd"), column("mean_difference_deg"), column("typical_difference"),
                    column("interval_low"), column("interval_high"), column("n_zero", whole),
                    column("w_plus"), column("rank_biserial"), column("p"), column("p_holm"),
                    column("test", text)});
    const auto optional = [&](const std::optional<double>& value) {
        orEmpty(table, value.has_value(), value.value_or(0.0));
    };
    for (const SystemComparison& pair : evaluation.comparisons) {
        const SignedRankTest& test = pair.test;
        const bool any = test.n_pairs > 0;
        table.text(evaluation.systems[pair.a].system);
        table.text(evaluation.systems[pair.b].system);
        table.whole(test.n_pairs);
        orEmpty(table, any, pair.mean_difference);
        orEmpty(table, test.n_pairs > 1, pair.sd);
        orEmpty(table, any, pair.mean_difference_deg);
        optional(test.hodges_lehmann.estimate);
        optional(test.hodges_lehmann.lower);
        optional(test.hodges_lehmann.upper);
        table.whole(test.n_zero);
        orEmpty(table, any, test.w_plus);
        optional(test.rank_biserial);
        orEmpty(table, any, test.p_two_sided);
        optional(pair.p_holm);
        table.text(any ? test.method : "no targets");
        table.endRow();
    }
    return table.take();
}

std::string profilesTable(const Evaluation& evaluation) {
    using enum ColumnType;
    CsvTable table({column("system", text), column("hand", text), column("time_s"), column("n", whole),
                    column("accuracy_mean"), column("accuracy_sd"), column("speed_mean_m_s"),
                    column("speed_sd_m_s")});
    for (const SystemEvaluation& system : evaluation.systems)
        for (const auto& [hand, profile] :
             {std::pair{"left", &system.left}, std::pair{"right", &system.right}})
            for (const ProfilePoint& point : profile->points) {
                table.text(system.system);
                table.text(hand);
                table.number(point.time_s);
                table.whole(point.n);
                table.number(point.reward_mean);
                orEmpty(table, point.n > 1, point.reward_sd);
                table.number(point.speed_mean);
                orEmpty(table, point.n > 1, point.speed_sd);
                table.endRow();
            }
    return table.take();
}

std::string targetsTable(const Evaluation& evaluation) {
    using enum ColumnType;
    CsvTable table({column("target_id", text), column("x"), column("y"), column("z"),
                    column("density_per_m3"), column("cluster", whole)});
    for (const TestPoint& point : evaluation.points) {
        table.text(point.target_id);
        position(table, point.target);
        table.number(point.density);
        table.whole(point.cluster + 1);
        table.endRow();
    }
    return table.take();
}

std::string clustersCsv(const Evaluation& evaluation) {
    using enum ColumnType;
    std::vector<ColumnSpec> columns{
        column("cluster", whole),    column("x"), column("y"), column("z"), column("training_targets", whole),
        column("test_points", whole)};
    for (const SystemEvaluation& system : evaluation.systems)
        columns.push_back(column(("accuracy_" + system.system).c_str()));
    CsvTable table(std::move(columns));
    for (std::size_t c = 0; c < evaluation.clusters.size(); ++c) {
        const TargetCluster& cluster = evaluation.clusters[c];
        table.whole(static_cast<long long>(c) + 1);
        position(table, cluster.centre);
        table.whole(cluster.training_targets);
        table.whole(cluster.test_points);
        for (const SystemEvaluation& system : evaluation.systems)
            orEmpty(table, system.cluster_means[c].has_value(), system.cluster_means[c].value_or(0.0));
        table.endRow();
    }
    return table.take();
}

}  // namespace

std::vector<std::pair<std::string, std::string>> evaluationTables(const Evaluation& evaluation) {
    std::vector<std::pair<std::string, std::string>> out{{"clips.csv", clipsTable(evaluation)},
                                                         {"systems.csv", systemsCsv(evaluation)},
                                                         {"comparisons.csv", comparisonsTable(evaluation)},
                                                         {"profiles.csv", profilesTable(evaluation)},
                                                         {"targets.csv", targetsTable(evaluation)},
                                                         {"clusters.csv", clustersCsv(evaluation)},
                                                         {"rays.csv", raysTable(evaluation)}};
    if (!evaluation.observers.empty()) out.emplace_back("observers.csv", readingsCsv(evaluation.observers));
    return out;
}

}  // namespace deixis::results
