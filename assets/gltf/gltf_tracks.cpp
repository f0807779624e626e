#include "gltf_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <set>

#include "core/order_statistics.hpp"

namespace deixis::assets::gltf {

namespace {

constexpr double latest_s = 1e6;  // eleven days

/// Where a time lies among the keys: at key `index` where `at_key`, else behind it, before the next.
struct Place {
    std::size_t index = 0;
    bool at_key = true;
};

Place placeOf(const std::vector<double>& times, double time, double snap) {
    if (time <= times.front() + snap) return {0, true};
    if (time >= times.back() - snap) return {times.size() - 1, true};
    const auto next =
        static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
    if (times[next] - time <= snap) return {next, true};
    return {next - 1, time - times[next - 1] <= snap};
}

/// The four numbers (the last unused for vectors) of row `row` of a track's values.
glm::dvec4 row(const Track& track, std::size_t index) {
    const std::size_t width = track.width();
    glm::dvec4 out(0.0);
    for (std::size_t c = 0; c < width; ++c) out[static_cast<int>(c)] = (*track.values)[index * width + c];
    return out;
}

glm::dvec4 keyValue(const Track& track, std::size_t key) {
    return row(track, track.interpolation == Interpolation::cubic_spline ? 3 * key + 1 : key);
}

/// Between two keys, u in (0, 1) of the way (appendix C: STEP, CUBICSPLINE; LINEAR of vectors).
glm::dvec4 between(const Track& track, std::size_t key, double u, double interval) {
    if (track.interpolation == Interpolation::step) return keyValue(track, key);
    if (track.interpolation == Interpolation::linear)
        return keyValue(track, key) * (1.0 - u) + keyValue(track, key + 1) * u;
    const double u2 = u * u;
    const double u3 = u2 * u;
    const glm::dvec4 out_tangent = row(track, 3 * key + 2) * interval;
    const glm::dvec4 in_tangent = row(track, 3 * (key + 1)) * interval;
    return (2.0 * u3 - 3.0 * u2 + 1.0) * keyValue(track, key) + (u3 - 2.0 * u2 + u) * out_tangent +
           (3.0 * u2 - 2.0 * u3) * keyValue(track, key + 1) + (u3 - u2) * in_tangent;
}

Quat unit(const glm::dvec4& xyzw) {
    return glm::normalize(Quat(xyzw.w, xyzw.x, xyzw.y, xyzw.z));
}

void checkTimes(const std::vector<double>& times, const std::string& where) {
    if (times.front() < 0.0) reject(where, fmt::format("begins at {} s, expected 0 or later", times.front()));
    if (times.back() > latest_s)
        reject(where, fmt::format("ends at {} s, expected {} s or earlier", times.back(), latest_s));
    for (std::size_t i = 1; i < times.size(); ++i)
        if (!(times[i] > times[i - 1]))
            reject(where, fmt::format("time {} is {} s and time {} is {} s, expected a later one", i - 1,
                                      times[i - 1], i, times[i]));
}

class TracksReader {
  public:
    TracksReader(const Document& document, Values& values, std::vector<std::string>& remarks)
        : doc_(document), values_(values), remarks_(remarks) {}

    Track read(const Animation& animation, const std::string& place, const Channel& channel) {
        const Sampler& sampler = animation.samplers[static_cast<std::size_t>(channel.sampler)];
        const std::string where = fmt::format("{}: {}/samplers/{}", doc_.file, place, channel.sampler);
        Track track;
        track.node = channel.node;
        track.path = channel.path;
        track.interpolation = sampler.interpolation;
        checkFormats(track, sampler, where);
        track.times = &values_.read(sampler.input, "times");
        if (checked_times_.insert(sampler.input).second) checkTimes(*track.times, where);
        const bool cubic = track.interpolation == Interpolation::cubic_spline;
        if (cubic && track.times->size() < 2)
            reject(where, "is a cubic spline of one key, expected 2 or more");
        const std::size_t expected = track.times->size() * (cubic ? 3 : 1);
        // Before the values are read: their number is thus bounded by that of the times.
        if (const std::size_t found = doc_.accessors[static_cast<std::size_t>(sampler.output)].count;
            found != expected)
            reject(where, fmt::format("has {} values for {} times, expected {}", found, track.times->size(),
                                      expected));
        track.values = &values_.read(sampler.output, "values");
        if (track.path == Path::rotation && checked_rotations_.insert(sampler.output).second)
            checkRotations(track, where);
        return track;
    }

  private:
    void checkFormats(const Track& track, const Sampler& sampler, const std::string& where) {
        const Accessor& input = doc_.accessors[static_cast<std::size_t>(sampler.input)];
        const Accessor& output = doc_.accessors[static_cast<std::size_t>(sampler.output)];
        if (input.type != "SCALAR" || input.component_type != 5126)
            reject(where, fmt::format("has times of type {} and component type {}, expected SCALAR and 5126",
                                      input.type, input.component_type));
        const bool turns = track.path == Path::rotation;
        const bool float_or_fraction =
            output.component_type == 5126 || (turns && output.normalised && output.component_type != 5125);
        if (output.type != (turns ? "VEC4" : "VEC3") || !float_or_fraction)
            reject(where,
                   fmt::format("has values of type {} and component type {}{}, expected {}", output.type,
                               output.component_type, output.normalised ? " (normalised)" : "",
                               turns ? "VEC4 of 5126, or normalised" : "VEC3 of 5126"));
        if (!input.has_bounds && told_bounds_.insert(sampler.input).second)
            remarks_.push_back(
                fmt::format("/accessors/{} has no min and max (violates the specification)", sampler.input));
        for (const Accessor* accessor : {&input, &output})
            if (accessor->view >= 0 && doc_.views[static_cast<std::size_t>(accessor->view)].stride != 0 &&
                !told_stride_) {
                told_stride_ = true;
                remarks_.emplace_back("animation data have a stride (violates the specification)");
            }
    }

    void checkRotations(const Track& track, const std::string& where) {
        double worst = 0.0;
        for (std::size_t key = 0; key < track.times->size(); ++key) {
            const double length = glm::length(keyValue(track, key));
            if (!(length > 1e-3))
                reject(where, fmt::format("the rotation of key {} is a quaternion of length {}, expected 1",
                                          key, length));
            worst = std::max(worst, std::abs(length - 1.0));
        }
        if (worst > 0.02)
            remarks_.push_back(
                fmt::format("rotations of node {} are off unit length by up to {:.2g}; they are normalised",
                            track.node, worst));
    }

    const Document& doc_;
    Values& values_;
    std::vector<std::string>& remarks_;
    std::set<int> checked_times_, checked_rotations_, told_bounds_;
    bool told_stride_ = false;
};

/// All key times, increasing; those of two tracks that differ by rounding alone become one.
std::vector<double> allTimes(const std::vector<Track>& tracks) {
    std::set<const std::vector<double>*> inputs;
    std::vector<double> all;
    for (const Track& track : tracks)
        if (inputs.insert(track.times).second)
            all.insert(all.end(), track.times->begin(), track.times->end());
    std::sort(all.begin(), all.end());
    std::vector<double> times;
    for (const double time : all)
        if (times.empty() || time - times.back() > 1e-5 + 3e-7 * time) times.push_back(time);
    return times;
}

/// Steps of equal length through all times; step 0 where there are none.
struct Steps {
    double step = 0.0;
    std::size_t count = 0;  // from the first time to the last
    double residual = 0.0;  // largest distance of a time from its place
};

/// How well times stand on a grid of `step`, which is refined so that the last one does exactly.
Steps fit(const std::vector<double>& times, double step) {
    Steps out;
    std::vector<double> places{0.0};
    double place = 0.0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double moved = std::round((times[i] - times[i - 1]) / step);
        if (moved < 1.0) return {};
        place += moved;
        places.push_back(place);
        step = (times[i] - times.front()) / place;
    }
    out.step = step;
    out.count = static_cast<std::size_t>(place);
    for (std::size_t i = 0; i < times.size(); ++i)
        out.residual = std::max(out.residual, std::abs(times[i] - times.front() - places[i] * step));
    if (out.residual > std::min(0.1 * step, 1.5e-3)) return {};
    return out;
}

/// A whole number of frames per second where the times allow it as well.
void roundRate(Steps& steps, double last_time) {
    const double whole = std::round(1.0 / steps.step);
    if (whole < 1.0) return;
    const double shift = std::abs(1.0 / whole - steps.step) * static_cast<double>(steps.count);
    if (shift <= steps.residual + 3e-7 * last_time) steps.step = 1.0 / whole;
}

}  // namespace

Vec3 Track::vector(double time_s, double snap_s) const {
    const Place place = placeOf(*times, time_s, snap_s);
    if (place.at_key) return Vec3(keyValue(*this, place.index));
    const double interval = (*times)[place.index + 1] - (*times)[place.index];
    return Vec3(between(*this, place.index, (time_s - (*times)[place.index]) / interval, interval));
}

Quat Track::rotation(double time_s, double snap_s) const {
    const Place place = placeOf(*times, time_s, snap_s);
    const Quat before = unit(keyValue(*this, place.index));
    if (place.at_key) return before;
    const double interval = (*times)[place.index + 1] - (*times)[place.index];
    const double u = (time_s - (*times)[place.index]) / interval;
    if (interpolation == Interpolation::linear)  // glm::slerp takes the shorter arc
        return glm::normalize(glm::slerp(before, unit(keyValue(*this, place.index + 1)), u));
    const glm::dvec4 value = between(*this, place.index, u, interval);
    return glm::length(value) > 1e-9 ? unit(value) : before;
}

std::vector<Track> readTracks(const Document& document, int animation, const std::vector<int>& left_out,
                              Values& values, std::vector<std::string>& remarks) {
    const Animation& from = document.animations[static_cast<std::size_t>(animation)];
    TracksReader reader(document, values, remarks);
    std::vector<Track> tracks;
    for (const Channel& channel : from.channels)
        if (std::find(left_out.begin(), left_out.end(), channel.node) == left_out.end())
            tracks.push_back(reader.read(from, fmt::format("/animations/{}", animation), channel));
    return tracks;
}

FrameGrid frameGrid(const std::vector<Track>& tracks, double fps) {
    FrameGrid grid;
    const std::vector<double> times = allTimes(tracks);
    if (times.empty()) {
        grid.words = "30 fps (no keys)";
        return grid;
    }
    grid.start_s = times.front();
    const double rounding = 1e-6 + 3e-7 * times.back();
    const double span = times.back() - times.front();
    const auto resampleAt = [&](double rate) {
        grid.frame_time_s = 1.0 / rate;
        grid.snap_s = std::min(rounding, 0.25 / rate);
        const double frames = std::floor(span * rate + 1e-6) + 1.0;
        grid.frames = static_cast<std::size_t>(std::min(frames, 1e12));
    };
    if (fps > 0.0) {
        resampleAt(fps);
        grid.words = fmt::format("{:.7g} fps (given)", fps);
        return grid;
    }
    if (times.size() == 1) {
        grid.words = "30 fps (assumed: a single key)";
        return grid;
    }
    std::vector<double> gaps;
    for (std::size_t i = 1; i < times.size(); ++i) gaps.push_back(times[i] - times[i - 1]);
    const double min = *std::min_element(gaps.begin(), gaps.end());
    Steps steps = fit(times, min);
    if (steps.step > 0.0 && steps.step >= 1.0 / 480.0) {
        roundRate(steps, times.back());
        std::size_t parts = 1;
        if (steps.step > 0.1) {  // poses keyed by hand: the frames between them count too
            for (const double rate : {30.0, 24.0, 25.0}) {
                const double frames = steps.step * rate;
                if (std::abs(frames - std::round(frames)) < 1e-4 * frames && parts == 1)
                    parts = static_cast<std::size_t>(std::round(frames));
            }
            if (parts == 1) parts = static_cast<std::size_t>(std::ceil(30.0 * steps.step));
        }
        grid.frame_time_s = steps.step / static_cast<double>(parts);
        grid.frames = steps.count * parts + 1;
        grid.snap_s = std::min(steps.residual + rounding, 0.25 * grid.frame_time_s);
        grid.words = parts == 1 ? fmt::format("{:.7g} fps (the keys' rate)", 1.0 / grid.frame_time_s)
                                : fmt::format("{:.7g} fps (keys are {:.4g} s apart)", 1.0 / grid.frame_time_s,
                                              steps.step);
        return grid;
    }
    const double usual = upperMedian(gaps);
    resampleAt(usual > 1.0 / 40.0 ? 30.0 : usual > 1.0 / 80.0 ? 60.0 : 120.0);
    grid.uneven = true;
    grid.words = fmt::format("{:.7g} fps (keys at uneven times)", 1.0 / grid.frame_time_s);
    return grid;
}

}  // namespace deixis::assets::gltf
