#include "studies/design/targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "core/random.hpp"
#include "studies/design/angles.hpp"
#include "target_text.hpp"

namespace deixis::studies {

namespace {

constexpr double units_per_metre = 1e4;  // positions and distances count in tenths of a millimetre

/// A position in whole tenths of a millimetre: distances between such are exact.
struct GridPoint {
    std::int64_t x = 0, y = 0, z = 0;
};

std::int64_t gridUnits(double metres) {
    return std::llround(metres * units_per_metre);
}

Vec3 metres(const GridPoint& point) {
    return {static_cast<double>(point.x) / units_per_metre, static_cast<double>(point.y) / units_per_metre,
            static_cast<double>(point.z) / units_per_metre};
}

std::int64_t squaredDistance(const GridPoint& a, const GridPoint& b) {
    const std::int64_t x = a.x - b.x;
    const std::int64_t y = a.y - b.y;
    const std::int64_t z = a.z - b.z;
    return x * x + y * y + z * z;
}

/// Uniform in height, arc and radius, each on its own (2.4.3), so denser in space towards the axis.
GridPoint drawPosition(const TargetSpace& space, Random& random) {
    const double height_m = random.uniform(space.height_m.low, space.height_m.high);
    const double azimuth_rad = radiansFromDegrees(random.uniform(space.arc_deg.low, space.arc_deg.high));
    const double radius_m = random.uniform(space.radius_m.low, space.radius_m.high);
    return {gridUnits(radius_m * std::sin(azimuth_rad)), gridUnits(height_m),
            gridUnits(radius_m * std::cos(azimuth_rad))};
}

std::string describeRanges(const TargetSpace& space) {
    return fmt::format("height {} to {} m, arc {} to {} degrees, radius {} to {} m", space.height_m.low,
                       space.height_m.high, space.arc_deg.low, space.arc_deg.high, space.radius_m.low,
                       space.radius_m.high);
}

bool ordered(const Range& range) {
    return range.low <= range.high;  // not-a-number is not
}

/// What keeps positions from being drawn.
std::optional<Error> problemWith(const TargetSpace& space) {
    if (space.radius_m.high <= 0.0 && !space.fit_manifest.empty())
        return Error{"targets.fit_manifest", "the ranges have not been fitted to the manifest's targets", ""};
    if (!ordered(space.height_m) || !ordered(space.arc_deg) || !ordered(space.radius_m) ||
        space.radius_m.low <= 0.0)
        return Error{"targets",
                     fmt::format("found {}; expected ranges with the smaller number first and radii above 0",
                                 describeRanges(space)),
                     ""};
    return std::nullopt;
}

std::optional<Error> problemWith(const DistanceBand& band) {
    if (ordered(band.distance_m) && band.distractors >= 0) return std::nullopt;
    return Error{"distances." + band.name,
                 fmt::format("found {} distractors {} to {} m away; expected a range with the smaller number "
                             "first and no negative count",
                             band.distractors, band.distance_m.low, band.distance_m.high),
                 ""};
}

/// What a band asks of the angles between a target and its distractors.
class AngleLimits {
  public:
    AngleLimits(const DistanceBand& band, const std::vector<Viewpoint>& places, const Vec3& target)
        : target_(target) {
        if (band.avatar_angle_deg)
            limits_.emplace_back(StandingAvatar::reference().eyes(), *band.avatar_angle_deg);
        if (band.participant_angle_deg)
            for (const Viewpoint& place : places)
                limits_.emplace_back(place.eyes.at(place.eyes.size() / 2), *band.participant_angle_deg);
    }
    [[nodiscard]] bool admit(const Vec3& distractor) const {
        return std::all_of(limits_.begin(), limits_.end(), [&](const auto& limit) {
            const double seen_deg = angleSeen_deg(limit.first, target_, distractor);
            return seen_deg >= limit.second.low && seen_deg <= limit.second.high;
        });
    }

  private:
    Vec3 target_;
    std::vector<std::pair<Vec3, Range>> limits_;  ///< by eye
};

std::string describeAngles(const DistanceBand& band) {
    std::string out;
    const auto add = [&](const std::optional<Range>& range, std::string_view whose) {
        if (range) out += fmt::format(", {} to {} degrees as seen by {}", range->low, range->high, whose);
    };
    add(band.avatar_angle_deg, "the avatar");
    add(band.participant_angle_deg, "the participant");
    return out;
}

/// Draws until a position fits; empty after a bounded search (about a tenth of a second). With the ranges of
/// the paper's size about one draw in 30 is near enough, and most of these are seen.
std::optional<GridPoint> drawDistractor(const TargetSpace& space, const DistanceBand& band,
                                        const GridPoint& target, const std::vector<GridPoint>& others,
                                        const AngleLimits& angles, const ClearView* view, Random& random) {
    constexpr int max_draws = 1'000'000;
    constexpr int max_hidden = 3000;
    const std::int64_t diameter = gridUnits(space.ball_diameter_m);
    const std::int64_t nearest = std::max(gridUnits(band.distance_m.low), diameter);
    const std::int64_t farthest = gridUnits(band.distance_m.high);
    std::vector<Vec3> seen_beside;
    std::transform(others.begin(), others.end(), std::back_inserter(seen_beside), metres);
    int hidden = 0;
    for (int draw = 0; draw < max_draws && hidden < max_hidden; ++draw) {
        const GridPoint point = drawPosition(space, random);
        const std::int64_t from_target = squaredDistance(point, target);
        if (from_target < nearest * nearest || from_target > farthest * farthest) continue;
        const bool free = std::none_of(others.begin(), others.end(), [&](const GridPoint& other) {
            return squaredDistance(point, other) < diameter * diameter;
        });
        if (!free || !angles.admit(metres(point))) continue;
        if (view == nullptr || view->admits(seen_beside, metres(point))) return point;
        ++hidden;
    }
    return std::nullopt;
}

/// All bands take from the same row of draws. Bands that share no distance thus get distractors that are
/// independent of each other; one that differs from another only in their number has the same ones and more.
Result<std::vector<Vec3>> bandDistractors(const TargetItem& item, const TargetSpace& space,
                                          const DistanceBand& band, std::uint64_t seed,
                                          const std::vector<Viewpoint>& places, const ClearView* view) {
    Random random(seed, "distractors of " + item.id);
    const GridPoint target{gridUnits(item.target.x), gridUnits(item.target.y), gridUnits(item.target.z)};
    const AngleLimits angles(band, places, metres(target));
    std::vector<GridPoint> points;
    while (static_cast<int>(points.size()) < band.distractors) {
        const std::optional<GridPoint> point =
            drawDistractor(space, band, target, points, angles, view, random);
        if (!point)
            return fail(
                fmt::format("distances.{}.distance_m", band.name),
                fmt::format("found no place for distractor {} of target {} ({} m): it must be within {}, {} "
                            "to {} m from the target{} and {} m (a ball's diameter) from the others{}",
                            points.size() + 1, item.id, positionText(item.target), describeRanges(space),
                            band.distance_m.low, band.distance_m.high, describeAngles(band),
                            space.ball_diameter_m,
                            view != nullptr ? ", be visible, and hide none of them" : ""),
                fmt::format("Widen its distance_m{} or the ranges of height, arc and radius, or use fewer "
                            "distractors or smaller balls{}",
                            describeAngles(band).empty() ? "" : ", its angles",
                            view != nullptr ? ", or set targets.visibility = \"any\"" : ""));
        points.push_back(*point);
    }
    std::vector<Vec3> out;
    std::transform(points.begin(), points.end(), std::back_inserter(out), metres);
    return out;
}

/// The position drawn first where it is seen, else one of the target's own numbers that is; empty after a
/// bounded search.
std::optional<Vec3> seenTarget(const TargetSpace& space, const std::string& id, const Vec3& first,
                               std::uint64_t seed, const std::vector<Viewpoint>& from) {
    constexpr int max_draws = 1000;
    Random random(seed, "another place for " + id);
    Vec3 position = first;
    for (int draw = 0; draw < max_draws; ++draw) {
        if (ClearView(from, position, space.ball_diameter_m / 2).seesTarget()) return position;
        position = metres(drawPosition(space, random));
    }
    return std::nullopt;
}

std::string listedPlaces(const std::vector<Viewpoint>& from) {
    std::string out;
    for (const Viewpoint& viewpoint : from)
        out += fmt::format("{}{} ({})", out.empty() ? "" : ", ", viewpoint.layout,
                           standingName(viewpoint.standing));
    return out;
}

}  // namespace

Result<std::vector<TargetItem>> sampleTargets(const TargetSpace& space,
                                              const std::vector<DistanceBand>& bands, std::uint64_t seed,
                                              const std::vector<Viewpoint>& from,
                                              const std::vector<Viewpoint>& places) {
    if (const std::optional<Error> problem = problemWith(space)) return tl::unexpected(*problem);
    if (space.count < 1)
        return fail("targets.count", fmt::format("found {}, expected at least 1", space.count));
    std::vector<TargetItem> items;
    Random random(seed, "targets");
    for (int i = 0; i < space.count; ++i) {
        TargetItem& item = items.emplace_back();
        item.id = fmt::format("T{:03}", i + 1);
        item.target = metres(drawPosition(space, random));
        if (from.empty()) continue;
        const std::optional<Vec3> seen = seenTarget(space, item.id, item.target, seed, from);
        if (!seen)
            return fail("targets.visibility",
                        fmt::format("found no place for target {} within {} that is visible past the avatar "
                                    "from all places of the participant: {}",
                                    item.id, describeRanges(space), listedPlaces(from)),
                        "Move the places in [[layouts]], or set targets.visibility = \"any\"");
        item.target = *seen;
    }
    return drawDistractors(std::move(items), space, bands, seed, from, places);
}

Result<std::vector<TargetItem>> drawDistractors(std::vector<TargetItem> items, const TargetSpace& space,
                                                const std::vector<DistanceBand>& bands, std::uint64_t seed,
                                                const std::vector<Viewpoint>& from,
                                                const std::vector<Viewpoint>& places) {
    for (TargetItem& item : items) item.distractors.clear();
    if (bands.empty()) return items;
    if (const std::optional<Error> problem = problemWith(space)) return tl::unexpected(*problem);
    for (const DistanceBand& band : bands)
        if (const std::optional<Error> problem = problemWith(band)) return tl::unexpected(*problem);
    for (TargetItem& item : items) {
        if (!item.placed) continue;
        const ClearView view(from, item.target, space.ball_diameter_m / 2);
        const bool asked = !from.empty() && view.seesTarget();
        for (const DistanceBand& band : bands) {
            Result<std::vector<Vec3>> drawn =
                bandDistractors(item, space, band, seed, places, asked ? &view : nullptr);
            if (!drawn) return tl::unexpected(drawn.error());
            item.distractors.push_back(std::move(*drawn));
        }
    }
    return items;
}

std::vector<Viewpoint> askedViewpoints(const Study& study) {
    return study.targets.clear_view ? viewpoints(study) : std::vector<Viewpoint>{};
}

Result<std::vector<TargetItem>> sampleTargets(const Study& study) {
    return sampleTargets(study.targets, study.distances, study.seed, askedViewpoints(study),
                         viewpoints(study));
}

Result<std::vector<TargetItem>> drawDistractors(std::vector<TargetItem> items, const Study& study) {
    return drawDistractors(std::move(items), study.targets, study.distances, study.seed,
                           askedViewpoints(study), viewpoints(study));
}

Result<std::vector<Redrawn>> redrawn(const Study& study, const std::vector<TargetItem>& targets) {
    std::vector<Redrawn> out(targets.size(), Redrawn::nothing);
    const std::vector<Viewpoint> places = viewpoints(study);
    if (!study.targets.clear_view || places.empty()) return out;
    const auto bare = study.targets.from_manifest.empty()
                          ? sampleTargets(study.targets, study.distances, study.seed, {}, places)
                          : drawDistractors(targets, study.targets, study.distances, study.seed, {}, places);
    if (!bare) return tl::unexpected(bare.error());
    for (std::size_t i = 0; i < std::min(bare->size(), targets.size()); ++i)
        out[i] = (*bare)[i].target != targets[i].target             ? Redrawn::target
                 : (*bare)[i].distractors != targets[i].distractors ? Redrawn::distractors
                                                                    : Redrawn::nothing;
    return out;
}

Result<TargetSpace> fitTargetSpace(TargetSpace space, const std::vector<Vec3>& positions) {
    constexpr double farthest_m = 20.0;
    const auto problem = [&](std::string message, std::string hint = {}) {
        return fail(space.fit_manifest, std::move(message), std::move(hint));
    };
    if (positions.empty()) return problem("found no targets, expected at least one to fit the ranges to");
    bool first = true;
    for (const Vec3& position : positions) {
        const double radius_m = std::hypot(position.x, position.z);
        const double azimuth_deg = degreesFromRadians(std::atan2(position.x, position.z));
        const bool sensible = radius_m > 0.0 && radius_m <= farthest_m &&
                              position.y >= space.ball_diameter_m / 2 && position.y <= farthest_m;
        if (!sensible)  // not-a-number is none of these
            return problem(
                fmt::format("found a target at {} m, expected one off the avatar's axis, within {} "
                            "m of it, and at least {} m high, half a ball's diameter",
                            positionText(position), farthest_m, space.ball_diameter_m / 2),
                "Positions in a manifest are in metres");
        const auto widen = [&](Range& range, double value) {
            range =
                first ? Range{value, value} : Range{std::min(range.low, value), std::max(range.high, value)};
        };
        widen(space.height_m, position.y);
        widen(space.arc_deg, azimuth_deg);
        widen(space.radius_m, radius_m);
        first = false;
    }
    return space;
}

std::vector<SeenBalls> seenOf(const Study& study, const TargetItem& item, std::size_t band,
                              const std::vector<Viewpoint>& from, const StandingAvatar& avatar) {
    const double radius_m = study.targets.ball_diameter_m / 2;
    std::vector<Sphere> balls{{item.target, radius_m}};
    for (const Vec3& distractor : item.distractors.at(band)) balls.push_back({distractor, radius_m});
    std::vector<SeenBalls> out;
    for (const Viewpoint& viewpoint : from) out.push_back(seenFrom(viewpoint, avatar, balls));
    return out;
}

}  // namespace deixis::studies
