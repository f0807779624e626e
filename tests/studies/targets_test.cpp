#include "studies/design/targets.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "core/hash.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

TargetSpace paperLike() {
    TargetSpace space;
    space.count = 100;
    space.height_m = {0.1, 2.1};
    space.arc_deg = {-85.0, 85.0};
    space.radius_m = {1.9, 2.2};
    space.ball_diameter_m = 0.1;
    return space;
}

/// "2 distractors ... within 20-40 cm away" (2.4.2, 2.4.3).
const DistanceBand paper_band{"near", {0.2, 0.4}, 2};

std::vector<TargetItem> sampled(const TargetSpace& space, std::uint64_t seed,
                                const std::vector<DistanceBand>& bands = {paper_band}) {
    Result<std::vector<TargetItem>> targets = sampleTargets(space, bands, seed);
    if (!targets) FAIL(targets.error().text());
    return *targets;
}

double azimuthDeg(const Vec3& position) {
    return degreesFromRadians(std::atan2(position.x, position.z));
}

constexpr double rounding_m = 1e-4;  // a position moves by at most half of it on each axis

bool within(double value, const Range& range, double slack) {
    return value >= range.low - slack && value <= range.high + slack;
}

/// Kolmogorov-Smirnov's distance of a sample from the uniform distribution over a range.
double uniformDistance(std::vector<double> values, const Range& range) {
    std::sort(values.begin(), values.end());
    const double n = static_cast<double>(values.size());
    double max = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double expected = (values[i] - range.low) / (range.high - range.low);
        max = std::max({max, std::abs(expected - static_cast<double>(i) / n),
                        std::abs(expected - static_cast<double>(i + 1) / n)});
    }
    return max;
}

}  // namespace

TEST_SUITE("studies/targets") {
    TEST_CASE(
        "Over 1,000 seeds every ball lies in the ranges, the band holds and no two balls of a trial "
        "overlap.") {
        TargetSpace space = paperLike();
        space.count = 10;
        const std::vector<DistanceBand> bands{{"near", {0.2, 0.4}, 3}, {"far", {0.9, 1.5}, 2}};
        int outside = 0;
        int off_band = 0;
        int overlapping = 0;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            for (const TargetItem& item : sampled(space, seed, bands)) {
                REQUIRE(item.distractors.size() == 2);
                for (std::size_t band = 0; band < bands.size(); ++band) {
                    std::vector<Vec3> balls = item.distractors[band];
                    REQUIRE(static_cast<int>(balls.size()) == bands[band].distractors);
                    for (const Vec3& distractor : balls)
                        off_band +=
                            !within(glm::distance(item.target, distractor), bands[band].distance_m, 1e-12);
                    balls.push_back(item.target);
                    for (std::size_t i = 0; i < balls.size(); ++i) {
                        const Vec3& ball = balls[i];
                        const double slack_deg = degreesFromRadians(rounding_m / space.radius_m.low);
                        outside += !within(ball.y, space.height_m, 0.0);
                        outside += !within(std::hypot(ball.x, ball.z), space.radius_m, rounding_m);
                        outside += !within(azimuthDeg(ball), space.arc_deg, slack_deg);
                        for (std::size_t j = 0; j < i; ++j)
                            overlapping += glm::distance(ball, balls[j]) < space.ball_diameter_m - 1e-12;
                    }
                }
            }
        }
        CHECK(outside == 0);
        CHECK(off_band == 0);
        CHECK(overlapping == 0);
    }

    TEST_CASE("Targets are uniform in height, arc and radius, and the three do not hang together.") {
        TargetSpace space = paperLike();
        space.count = 5000;
        const std::vector<TargetItem> targets = sampled(space, 42);
        std::vector<double> heights, azimuths, radii;
        for (const TargetItem& item : targets) {
            heights.push_back(item.target.y);
            azimuths.push_back(azimuthDeg(item.target));
            radii.push_back(std::hypot(item.target.x, item.target.z));
        }
        // Critical value at p = 0.001 for a large sample: 1.949 / sqrt(n).
        const double critical = 1.949 / std::sqrt(5000.0);
        CHECK(uniformDistance(heights, space.height_m) < critical);
        CHECK(uniformDistance(azimuths, space.arc_deg) < critical);
        CHECK(uniformDistance(radii, space.radius_m) < critical);
        // The measure itself sees a sample that is uniform over the area and not over the radius.
        std::vector<double> by_area;
        for (int i = 0; i < 5000; ++i) by_area.push_back(std::sqrt(0.01 + (4.0 - 0.01) * (i + 0.5) / 5000));
        CHECK(uniformDistance(by_area, {0.1, 2.0}) > critical);

        const auto correlation = [](const std::vector<double>& a, const std::vector<double>& b) {
            double mean_a = 0.0, mean_b = 0.0, ab = 0.0, aa = 0.0, bb = 0.0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                mean_a += a[i] / static_cast<double>(a.size());
                mean_b += b[i] / static_cast<double>(b.size());
            }
            for (std::size_t i = 0; i < a.size(); ++i) {
                ab += (a[i] - mean_a) * (b[i] - mean_b);
                aa += (a[i] - mean_a) * (a[i] - mean_a);
                bb += (b[i] - mean_b) * (b[i] - mean_b);
            }
            return ab / std::sqrt(aa * bb);
        };
        const double four_sd = 4.0 / std::sqrt(5000.0);
        CHECK(std::abs(correlation(heights, azimuths)) < four_sd);
        CHECK(std::abs(correlation(heights, radii)) < four_sd);
        CHECK(std::abs(correlation(azimuths, radii)) < four_sd);
    }

    TEST_CASE("Positions are whole tenths of a millimetre, so that printing keeps them.") {
        for (const TargetItem& item : sampled(paperLike(), 3))
            for (const double value : {item.target.x, item.target.y, item.target.z, item.distractors[0][0].x})
                CHECK(value == std::round(value * 1e4) / 1e4);
    }

    TEST_CASE("The same seed gives the same targets, another seed others.") {
        const std::vector<DistanceBand> bands{paper_band};
        const std::string csv = targetsCsv(sampled(paperLike(), 2023), bands);
        CHECK(csv == targetsCsv(sampled(paperLike(), 2023), bands));
        CHECK(csv != targetsCsv(sampled(paperLike(), 2024), bands));
        // Pinned, from before there were bands: what a study showed must not change with the program.
        const std::string rows = csv.substr(csv.find('\n'));
        CHECK(sha256Hex("target_id,x,y,z,d1_x,d1_y,d1_z,d2_x,d2_y,d2_z" + rows) ==
              "b5eafe3da2b1303c8a89634a919ba3cc4874653cedd0a6990c0efc33741a4300");
    }

    TEST_CASE("Targets depend neither on their number nor on the distractors' settings.") {
        TargetSpace space = paperLike();
        const std::vector<TargetItem> all = sampled(space, 5);
        space.count = 30;
        const std::vector<TargetItem> some = sampled(space, 5, {{"wide", {0.3, 0.9}, 4}});
        REQUIRE(some.size() == 30);
        for (std::size_t i = 0; i < some.size(); ++i) {
            CHECK(some[i].target == all[i].target);
            CHECK(some[i].id == all[i].id);
        }
        CHECK(all.front().id == "T001");
        CHECK(all.back().id == "T100");
        CHECK(sampled(space, 5, {}).front().distractors.empty());
    }

    TEST_CASE("A band's distractors are the same whatever other bands there are.") {
        const DistanceBand far{"far", {0.8, 1.2}, 2};
        const std::vector<TargetItem> alone = sampled(paperLike(), 5);
        const std::vector<TargetItem> both = sampled(paperLike(), 5, {far, paper_band});
        const std::vector<TargetItem> far_alone = sampled(paperLike(), 5, {far});
        for (std::size_t i = 0; i < both.size(); ++i) {
            CHECK(both[i].distractors[1] == alone[i].distractors[0]);
            CHECK(both[i].distractors[0] == far_alone[i].distractors[0]);
        }
    }

    TEST_CASE("The distractors of two bands do not hang together.") {
        TargetSpace space = paperLike();
        space.count = 5000;
        const std::vector<TargetItem> targets =
            sampled(space, 42, {{"near", {0.2, 0.4}, 1}, {"far", {0.5, 0.8}, 1}});
        // The side of the target on which a band's distractor lies, left or right of it, above or below.
        int same_side = 0;
        int same_height = 0;
        int used = 0;
        for (const TargetItem& item : targets) {
            // Far from the ranges' ends: near them both must lie towards the middle.
            if (std::abs(azimuthDeg(item.target)) > 60.0 || std::abs(item.target.y - 1.1) > 0.2) continue;
            ++used;
            const Vec3 near = item.distractors[0][0];
            const Vec3 far = item.distractors[1][0];
            same_side +=
                (azimuthDeg(near) > azimuthDeg(item.target)) == (azimuthDeg(far) > azimuthDeg(item.target));
            same_height += (near.y > item.target.y) == (far.y > item.target.y);
        }
        REQUIRE(used > 500);
        const double four_sd = 4.0 * std::sqrt(used) / 2.0;
        CHECK(std::abs(same_side - used / 2.0) < four_sd);
        CHECK(std::abs(same_height - used / 2.0) < four_sd);
    }

    TEST_CASE("Given items get distractors around their own targets, and those without a place none.") {
        const TargetSpace space = paperLike();
        std::vector<TargetItem> items(3);
        items[0] = {"pointing-left", {1.2, 1.3, 1.6}};
        items[1] = {"no-place", {0.0, 0.0, 0.0}, false};
        items[2] = {"pointing-ahead", {0.00004, 1.0, 2.0}, true, {{{9.0, 9.0, 9.0}}}};
        const Result<std::vector<TargetItem>> drawn = drawDistractors(items, space, {paper_band}, 3);
        REQUIRE(drawn.has_value());
        CHECK((*drawn)[1].distractors.empty());
        for (const int i : {0, 2}) {
            const TargetItem& item = (*drawn)[static_cast<std::size_t>(i)];
            CHECK(item.target == items[static_cast<std::size_t>(i)].target);
            REQUIRE(item.distractors.size() == 1);
            REQUIRE(item.distractors[0].size() == 2);
            for (const Vec3& distractor : item.distractors[0])
                CHECK(within(glm::distance(item.target, distractor), paper_band.distance_m, rounding_m));
        }
        // By the item's id, whatever else there is.
        const Result<std::vector<TargetItem>> alone = drawDistractors({items[2]}, space, {paper_band}, 3);
        CHECK((*alone)[0].distractors == (*drawn)[2].distractors);
        // Without bands no ranges are needed.
        const Result<std::vector<TargetItem>> without = drawDistractors(items, TargetSpace{}, {}, 3);
        REQUIRE(without.has_value());
        CHECK((*without)[2].distractors.empty());
        CHECK_FALSE(drawDistractors(items, TargetSpace{}, {paper_band}, 3).has_value());
    }

    TEST_CASE("Ranges in which no distractor can lie give an error that says what to widen.") {
        TargetSpace space = paperLike();
        space.height_m = {1.0, 1.1};
        space.arc_deg = {-2.0, 2.0};
        space.radius_m = {2.0, 2.05};  // no two points are 0.2 m apart: 0.14 by 0.1 by 0.05 m
        Result<std::vector<TargetItem>> targets = sampleTargets(space, {paper_band}, 1);
        REQUIRE_FALSE(targets.has_value());
        const std::string text = targets.error().text();
        for (const char* part : {"distances.near.distance_m", "T001", "height 1 to 1.1 m", "0.2 to 0.4 m",
                                 "radius 2 to 2.05 m", "arc -2 to 2 degrees", "Widen"})
            CHECK_MESSAGE(text.find(part) != std::string::npos, part << " should stand in: " << text);

        // Room for one distractor at the target's side but not for eight.
        space = paperLike();
        space.count = 1;
        space.height_m = {1.0, 1.0};
        space.arc_deg = {-4.0, 4.0};
        space.radius_m = {2.0, 2.0};
        CHECK_FALSE(sampleTargets(space, {{"close", {0.1, 0.4}, 8}}, 1).has_value());
    }

    TEST_CASE("Ranges that are upside down or empty of sense are rejected.") {
        const auto rejected = [](const TargetSpace& space, const DistanceBand& band = paper_band) {
            return !sampleTargets(space, {band}, 1).has_value();
        };
        TargetSpace space = paperLike();
        CHECK_FALSE(rejected(space));
        CHECK(rejected(space, {"upside-down", {0.4, 0.2}, 2}));
        CHECK(rejected(space, {"none", {0.2, std::nan("")}, 2}));
        CHECK(rejected(space, {"negative", {0.2, 0.4}, -1}));
        space.height_m = {2.0, 1.0};
        CHECK(rejected(space));
        space = paperLike();
        space.radius_m = {0.0, std::nan("")};
        CHECK(rejected(space));
        space = paperLike();
        space.count = 0;
        CHECK(rejected(space));
        space = paperLike();
        space.radius_m = {};
        space.fit_manifest = "clips.csv";
        REQUIRE(rejected(space));
        CHECK(sampleTargets(space, {}, 1).error().message.find("fitted") != std::string::npos);
    }

    TEST_CASE("Fitted ranges are the minimum and maximum height, azimuth and radius of the positions.") {
        TargetSpace space = paperLike();
        space.fit_manifest = "clips.csv";
        const Result<TargetSpace> fitted =
            fitTargetSpace(space, {{2.0, 1.0, 0.0}, {0.0, 0.5, 1.5}, {-1.0, 1.75, 1.0}});
        REQUIRE(fitted.has_value());
        CHECK(fitted->height_m.low == 0.5);
        CHECK(fitted->height_m.high == 1.75);
        CHECK(fitted->arc_deg.low == doctest::Approx(-45.0));
        CHECK(fitted->arc_deg.high == doctest::Approx(90.0));
        CHECK(fitted->radius_m.low == doctest::Approx(std::sqrt(2.0)));
        CHECK(fitted->radius_m.high == 2.0);
        CHECK(fitted->count == 100);
        CHECK(sampleTargets(*fitted, {}, 1).has_value());

        CHECK_FALSE(fitTargetSpace(space, {}).has_value());
        CHECK_FALSE(fitTargetSpace(space, {{0.0, 1.0, 0.0}}).has_value());
        CHECK_FALSE(fitTargetSpace(space, {{1.0, 0.04, 1.0}}).has_value());
        CHECK_FALSE(fitTargetSpace(space, {{1.0, std::nan(""), 1.0}}).has_value());
        const Result<TargetSpace> centimetres = fitTargetSpace(space, {{50.0, 120.0, 180.0}});
        REQUIRE_FALSE(centimetres.has_value());
        CHECK(centimetres.error().text().find("metres") != std::string::npos);
    }

    TEST_CASE("The CSV has the promised header and one row of ten fields a target, that read back exactly.") {
        const std::vector<TargetItem> targets = sampled(paperLike(), 9);
        std::istringstream lines(targetsCsv(targets, {paper_band}));
        std::string line;
        std::getline(lines, line);
        CHECK(line == "target_id,x,y,z,d1_x,d1_y,d1_z,d2_x,d2_y,d2_z");
        std::size_t row = 0;
        while (std::getline(lines, line)) {
            REQUIRE(row < targets.size());
            std::istringstream fields(line);
            std::string field;
            std::getline(fields, field, ',');
            CHECK(field == targets[row].id);
            std::vector<double> numbers;
            while (std::getline(fields, field, ',')) numbers.push_back(std::stod(field));
            REQUIRE(numbers.size() == 9);
            CHECK(numbers[0] == targets[row].target.x);
            CHECK(numbers[2] == targets[row].target.z);
            CHECK(numbers[4] == targets[row].distractors[0][0].y);
            CHECK(numbers[8] == targets[row].distractors[0][1].z);
            ++row;
        }
        CHECK(row == 100);
    }

    TEST_CASE("The CSV of several bands names them, and leaves empty what has no place.") {
        const std::vector<DistanceBand> bands{{"near", {0.2, 0.4}, 1}, {"far", {0.8, 1.2}, 1}};
        const std::vector<TargetItem> items{
            {"a", {0.0, 1.0, 2.0}, true, {{{1.0, 2.0, 3.0}}, {{4.0, 5.0, 6.0}}}}, {"b", {}, false}};
        CHECK(targetsCsv(items, bands) ==
              "target_id,x,y,z,near_d1_x,near_d1_y,near_d1_z,far_d1_x,far_d1_y,far_d1_z\n"
              "a,0.0000,1.0000,2.0000,1.0000,2.0000,3.0000,4.0000,5.0000,6.0000\n"
              "b,,,,,,,,,\n");
    }

    TEST_CASE("Items of a manifest are drawn without ranges, and without those that have no place.") {
        TargetSpace space;
        space.from_manifest = "clips.csv";
        std::vector<TargetItem> items{{"a", {0.5, 1.0, 2.0}}, {"b", {-0.5, 1.2, 1.0}}, {"c", {}, false}};
        const std::string svg = targetsSvg(space, items, {});
        const deixis::tests::XmlDocument picture(svg);
        CHECK(picture.text().find("2 targets") != std::string::npos);
        CHECK(picture.text().find("limits of the ranges") == std::string::npos);
        CHECK(picture.count("//@stroke-dasharray") == 0);
        CHECK(svg.find("nan") == std::string::npos);
        CHECK(deixis::tests::XmlDocument(targetsSvg(paperLike(), items, {})).count("//@stroke-dasharray") >
              0);
    }

    TEST_CASE("The picture shows every target in all three views, and demonstrations in their own colour.") {
        const std::vector<TargetItem> targets = sampled(paperLike(), 9);
        // One view is shaded; each of the two others has a plain disc of the shade's own colour.
        const auto drawn = [](const deixis::tests::XmlDocument& picture, const std::string& what) {
            const auto colours = picture.texts("//s:radialGradient[@id='" + what + "']/s:stop/@stop-color");
            int flat = 0;
            for (const std::string& colour : colours)
                flat += picture.count("//s:circle[@fill='" + colour + "']");
            return std::pair(picture.count("//s:circle[@fill='url(#" + what + ")']"), flat);
        };
        const deixis::tests::XmlDocument alone(targetsSvg(paperLike(), targets, {}));
        CHECK(alone.count("/s:svg") == 1);
        CHECK(drawn(alone, "target") == std::pair(101, 200));  // and one in the legend
        CHECK(alone.text().find("demonstrations") == std::string::npos);
        const std::string svg = targetsSvg(paperLike(), targets, {{0.5, 1.0, 2.0}, {-0.5, 1.0, 2.0}});
        const deixis::tests::XmlDocument both(svg);
        CHECK(drawn(both, "target") == std::pair(101, 200));
        CHECK(drawn(both, "demonstration") == std::pair(3, 4));
        CHECK(both.text().find("2 demonstrations") != std::string::npos);
        CHECK(svg.find("nan") == std::string::npos);
        CHECK(svg.find("inf") == std::string::npos);
    }

    TEST_CASE("Kept targets come back bit by bit, with those that have no place") {
        std::vector<TargetItem> targets = sampled(paperLike(), 7, {paper_band, {"far", {0.8, 1.2}, 3}});
        targets[3].target = Vec3(0.1 + 0.2, 1.0 / 3.0, -1e-17);
        targets.push_back({"wave", Vec3(0.0), false, {}});
        const auto back = targetsFromJson(targetsJson(targets));
        REQUIRE(back);
        REQUIRE(back->size() == targets.size());
        for (std::size_t i = 0; i < targets.size(); ++i) {
            CHECK((*back)[i].id == targets[i].id);
            CHECK((*back)[i].placed == targets[i].placed);
            CHECK((*back)[i].target == targets[i].target);
            CHECK((*back)[i].distractors == targets[i].distractors);
        }
        for (const char* broken : {"", "[", "{\"id\": 1}", "[{\"id\": \"T\"}]",
                                   "[{\"id\": \"T\", \"target\": [1, 2], \"distractors\": []}]"})
            CHECK_FALSE(targetsFromJson(broken));
    }
}
