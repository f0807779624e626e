// Numbers of scikit-learn 1.2.1's MeanShift (Debian 12) on the same points; its labels are numbered by
// falling size, too. Scott's rule by NumPy.
#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <utility>

#include "learning/amp/clusters.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "results/statistics/mean_shift.hpp"

using namespace deixis;
using namespace deixis::learning;

namespace {

const std::vector<Vec3>& points() {
    static const std::vector<Vec3> all{
        {0.089, 0.999, 1.867},  {-0.569, 1.005, 2.232}, {0.261, 0.866, 2.557},  {0.486, 0.943, 1.961},
        {0.24, 0.936, 2.056},   {0.305, 1.297, 1.868},  {-0.114, 0.863, 1.996}, {0.019, 0.903, 2.194},
        {0.012, 1.003, 1.508},  {-0.346, 0.826, 2.09},  {-0.217, 1.39, 2.037},  {0.064, 1.03, 2.123},
        {0.231, 0.862, 2.392},  {-0.195, 1.129, 1.948}, {1.158, 1.468, 1.55},   {1.602, 1.173, 1.629},
        {1.346, 1.828, 1.902},  {1.376, 1.718, 1.712},  {1.005, 1.383, 1.807},  {1.069, 1.682, 1.589},
        {1.043, 1.416, 1.108},  {1.028, 1.039, 1.625},  {0.944, 0.909, 1.576},  {1.08, 1.119, 1.351},
        {-0.738, 0.843, 1.612}, {-0.299, 0.922, 2.279}, {-0.737, 1.142, 1.581}, {-1.143, 0.961, 1.779},
        {-0.98, 1.072, 1.224},  {-1.083, 1.184, 1.683}, {-0.99, 0.896, 1.88},   {-0.921, 0.567, 1.883},
        {-1.151, 1.195, 1.643}, {0.364, 1.85, 1.483},   {0.33, 2.077, 1.059},   {0.205, 1.664, 1.157},
        {0.229, 1.617, 0.886},  {0.34, 1.857, 1.023},   {0.07, 1.623, 1.224},   {0.166, 1.741, 1.059}};
    return all;
}

int countOf(double bandwidth_m, const std::vector<Vec3>& targets_m) {
    std::vector<std::vector<double>> rows;
    for (const Vec3& one : targets_m) rows.push_back({one.x, one.y, one.z});
    return std::ranges::max(results::meanShift(rows, bandwidth_m).value().labels) + 1;
}

/// The 52 synthetic demonstrations, split as a training splits them.
const DemonstrationSets& library() {
    static const DemonstrationSets data =
        splitDemonstrations(motion::makeDemonstrations(motion::referenceHumanoid(), {}).value(), true);
    return data;
}

}  // namespace

TEST_SUITE("learning/amp_clusters") {
    TEST_CASE("Scott's rule") {
        CHECK(scottBandwidth_m(points()).value() == doctest::Approx(0.3016157236541873));
    }

    TEST_CASE("the paper's bandwidth makes its eight clusters of the 52 targets") {
        const auto eight = clustersOf(library(), 8, {});
        REQUIRE(eight.has_value());
        CHECK(eight->bandwidth_m == paper_bandwidth_m);
        CHECK(std::set<int>(eight->training.begin(), eight->training.end()).size() == 8);
        REQUIRE(eight->training.size() == library().training.size());
        REQUIRE(eight->validation.size() == library().validation.size());
    }

    TEST_CASE("one cluster needs no bandwidth; another number takes the widest that makes it") {
        const auto one = clustersOf(library(), 1, {});
        REQUIRE(one.has_value());
        CHECK(one->bandwidth_m == 0.0);
        CHECK(std::ranges::all_of(one->training, [](int cluster) { return cluster == 0; }));
        const auto three = clustersOf(library(), 3, {});
        REQUIRE(three.has_value());
        CHECK(countOf(three->bandwidth_m, library().targets_m) == 3);
        CHECK(countOf(three->bandwidth_m + 0.01, library().targets_m) < 3);
    }

    TEST_CASE("a mirrored demonstration joins the cluster of the nearest target that was given") {
        const auto eight = clustersOf(library(), 8, {});
        REQUIRE(eight.has_value());
        const auto clusterOf = [&](const Vec3& target_m) {
            // Each demonstration is followed by its mirror image.
            std::size_t nearest = 0;
            for (std::size_t i = 0; i < library().training.size(); i += 2)
                if (glm::distance(library().training[i].target, target_m) <
                    glm::distance(library().training[nearest].target, target_m))
                    nearest = i;
            return std::pair(glm::distance(library().training[nearest].target, target_m),
                             eight->training[nearest]);
        };
        int joined = 0;
        for (std::size_t i = 1; i < library().training.size(); i += 2) {
            const auto [away_m, cluster] = clusterOf(library().training[i].target);
            // A held-out target may be nearer.
            if (std::ranges::all_of(library().validation, [&, away = away_m](const auto& one) {
                    return glm::distance(one.target, library().training[i].target) > away;
                })) {
                CHECK(eight->training[i] == cluster);
                ++joined;
            }
        }
        CHECK(joined > 30);
    }

    TEST_CASE("a bandwidth alone makes as many as it makes") {
        CHECK(clustersOf(library(), {}, 0.78).value().count == 8);
        CHECK(clustersOf(library(), {}, 30.0).value().count == 1);
    }

    TEST_CASE("numbers of clusters that cannot be made are rejected") {
        const auto many = clustersOf(library(), 60, {});
        REQUIRE_FALSE(many.has_value());
        CHECK(many.error().text().find("60 clusters of 52 targets") != std::string::npos);
        const auto other = clustersOf(library(), 5, 0.78);
        REQUIRE_FALSE(other.has_value());
        CHECK(other.error().text().find("makes 8 clusters of 52 targets, expected 5") != std::string::npos);
    }
}
