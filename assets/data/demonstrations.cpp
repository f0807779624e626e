#include "assets/data/demonstrations.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "core/files.hpp"

namespace deixis::assets {

namespace {

using motion::DemonstrationParameters;
using motion::Interval;
using motion::Spread;

struct Limits {
    double low, high;
};
constexpr Limits angle{-180.0, 180.0};
constexpr Limits not_negative{0.0, 1e6};
constexpr Limits share{0.0, 1.0};
constexpr Limits seconds{0.01, 60.0};
constexpr Limits hertz{0.0, 60.0};

/// Reads one [section], remembers which keys it knows, and notes the first problem.
class Section {
  public:
    Section(const toml::table& file, std::string_view name, const std::string& file_name,
            std::optional<Error>& problem)
        : name_(name), file_name_(file_name), problem_(problem) {
        table_ = name.empty() ? &file : file[name].as_table();
        if (table_ == nullptr) note(0, "", fmt::format("the section [{}] is missing", name));
    }

    void read(std::string_view key, double& out, Limits limits) {
        if (const auto* node = find(key)) read(key, *node, out, limits);
    }
    void read(std::string_view key, int& out, Limits limits) {
        double value = 0.0;
        if (const auto* node = find(key)) {
            if (!node->is_integer()) return note(lineOf(*node), key, "expected a whole number");
            read(key, *node, value, limits);
            out = static_cast<int>(value);
        }
    }
    void read(std::string_view key, std::uint64_t& out) {
        const auto* node = find(key);
        if (node == nullptr) return;
        const auto value = node->value_exact<std::int64_t>();
        if (!value || *value < 0) return note(lineOf(*node), key, "expected a whole number, 0 or more");
        out = static_cast<std::uint64_t>(*value);
    }
    void read(std::string_view key, Interval& out, Limits limits) {
        std::array<double, 2> values{};
        if (!read(key, values, limits)) return;
        if (values[0] > values[1])
            return note(lineOf(*table_->get(key)), key, "the first number is larger than the second");
        out = {values[0], values[1]};
    }
    void read(std::string_view key, Spread& out, Limits mean_limits) {
        std::array<double, 2> values{};
        if (!read(key, values, mean_limits)) return;
        if (values[1] < 0.0)
            return note(lineOf(*table_->get(key)), key, "the second number, the SD, is negative");
        out = {values[0], values[1]};
    }
    template <std::size_t count>
    bool read(std::string_view key, std::array<double, count>& out, Limits limits) {
        const auto* node = find(key);
        if (node == nullptr) return false;
        const auto* array = node->as_array();
        if (array == nullptr || array->size() != count) {
            note(lineOf(*node), key, fmt::format("expected a list of {} numbers", count));
            return false;
        }
        for (std::size_t i = 0; i < count; ++i) read(key, *array->get(i), out[i], limits);
        return !problem_;
    }

    /// To be called last: a key that was not asked for is a problem.
    void rejectOthers() {
        if (table_ == nullptr) return;
        for (const auto& [key, node] : *table_)
            if (known_.count(std::string(key.str())) == 0)
                note(key.source().begin.line, key.str(), "unknown key",
                     fmt::format("Known here: {}", fmt::join(known_, ", ")));
    }

    /// Names a key that is read elsewhere.
    void know(std::string_view key) { known_.emplace(key); }

  private:
    static std::uint32_t lineOf(const toml::node& node) { return node.source().begin.line; }

    const toml::node* find(std::string_view key) {
        know(key);
        if (table_ == nullptr) return nullptr;
        const toml::node* node = table_->get(key);
        if (node == nullptr && key == "min_reach") {  // its name in studies that were locked before
            know("least_reach");
            node = table_->get("least_reach");
        }
        if (node == nullptr) note(lineOf(*table_), key, "this key is missing");
        return node;
    }

    void read(std::string_view key, const toml::node& node, double& out, Limits limits) {
        const auto value = node.value<double>();
        if (!value || !(node.is_integer() || node.is_floating_point()) || !std::isfinite(*value))
            return note(lineOf(node), key, "expected a finite number");
        if (*value < limits.low || *value > limits.high)
            return note(lineOf(node), key,
                        fmt::format("found {}, expected {} to {}", *value, limits.low, limits.high));
        out = *value;
    }

    void note(std::uint32_t line, std::string_view key, std::string message, std::string hint = {}) {
        if (problem_) return;
        std::string where = file_name_;
        if (line > 0) where += fmt::format(":{}", line);
        const std::string dotted =
            name_.empty() || key.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
        if (!dotted.empty()) where += ": " + dotted;
        problem_ = Error{std::move(where), std::move(message), std::move(hint)};
    }

    std::string name_;
    const std::string& file_name_;
    std::optional<Error>& problem_;
    const toml::table* table_ = nullptr;
    std::set<std::string> known_;
};

void readLibrary(Section& s, DemonstrationParameters& p) {
    s.read("seed", p.library_seed);
    s.read("left_count", p.left_count, {1, 10000});
    s.read("right_count", p.right_count, {1, 10000});
}

void readTargets(Section& s, motion::TargetDraw& t) {
    s.read("azimuth_deg", t.azimuth_deg, angle);
    s.read("radius_m", t.radius_m, {0.8, 100.0});
    s.read("height_m", t.height_m, {-10.0, 100.0});
    s.read("crossing_deg", t.crossing_deg, {0.0, 180.0});
}

void readLine(Section& s, motion::PointingLineParameters& l) {
    s.read("origin_k", l.origin_k, share);
    s.read("extension", l.extension, share);
    s.read("index_alignment", l.index_alignment, share);
    s.read("wrist_limit_deg", l.wrist_limit_deg, {0.0, 90.0});
    s.read("knuckle_limit_deg", l.knuckle_limit_deg, {0.0, 90.0});
    s.read("actor_bias_sd_deg", l.actor_bias_sd_deg, {0.0, 45.0});
    s.read("trial_bias_sd_deg", l.trial_bias_sd_deg, {0.0, 45.0});
    s.read("palm_inward_deg", l.palm_inward_deg, angle);
}

void readArm(Section& s, motion::ArmPostureParameters& a) {
    s.read("upper_arm_elevation", a.upper_arm_elevation, angle);
    s.read("forearm_elevation", a.forearm_elevation, angle);
    s.read("upper_arm_yaw", a.upper_arm_yaw, angle);
    s.read("forearm_yaw", a.forearm_yaw, angle);
    s.read("swivel_sd_deg", a.swivel_sd_deg, {0.0, 45.0});
}

void readBody(Section& s, motion::BodyShareParameters& b) {
    s.read("torso_yaw_share", b.torso_yaw_share, share);
    s.read("torso_yaw_sd_rad", b.torso_yaw_sd_rad, share);
    s.read("torso_pitch_share", b.torso_pitch_share, share);
    s.read("torso_roll_share", b.torso_roll_share, share);
    s.read("head_yaw_share", b.head_yaw_share, share);
    s.read("head_yaw_limit_rad", b.head_yaw_limit_rad, {0.0, 1.4});
    s.read("head_pitch_share", b.head_pitch_share, share);
    s.read("eye_limit_deg", b.eye_limit_deg, {0.0, 60.0});
    s.read("shoulder_raise_share", b.shoulder_raise_share, share);
    s.read("shoulder_forward_deg", b.shoulder_forward_deg, {0.0, 45.0});
    s.read("head_lead_s", b.head_lead_s, {0.0, 2.0});
    s.read("gaze_lead_s", b.gaze_lead_s, {0.0, 2.0});
    s.read("gaze_shift_s", b.gaze_shift_s, seconds);
}

void readTiming(Section& s, motion::TimingParameters& t) {
    s.read("rest_s", t.rest_s, seconds);
    s.read("raise_s", t.raise_s, seconds);
    s.read("hold_s", t.hold_s, seconds);
    s.read("retract_s", t.retract_s, seconds);
    s.read("warp", t.warp, {0.2, 5.0});
    s.read("emphasis", t.emphasis, {0.1, 10.0});
    s.read("bulge", t.bulge, share);
    s.read("min_reach", t.min_reach, share);
}

void readNoise(Section& s, motion::NoiseParameters& n) {
    s.read("ou_decay", n.ou_decay, {0.0, 0.999});
    s.read("ou_step_rad", n.ou_step_rad, share);
    s.read("smoothing_hz", n.smoothing_hz, {0.1, 15.0});
    s.read("hold_share", n.hold_share, share);
    s.read("hold_drift_deg", n.hold_drift_deg, {0.0, 45.0});
    s.read("hold_drift_hz", n.hold_drift_hz, hertz);
    s.read("sway_m", n.sway_m, {0.0, 0.1});
    s.read("sway_hz", n.sway_hz, hertz);
    s.read("breathing_deg", n.breathing_deg, {0.0, 10.0});
    s.read("breathing_hz", n.breathing_hz, hertz);
}

void readDirect(Section& s, motion::DirectParameters& d) {
    s.read("extension", d.extension, share);
    s.read("index_alignment", d.index_alignment, share);
    s.read("noise_share", d.noise_share, not_negative);
}

void readStiff(Section& s, motion::StiffParameters& d) {
    s.read("extension", d.extension, share);
    s.read("rest_s", d.rest_s, seconds);
    s.read("raise_s", d.raise_s, seconds);
    s.read("hold_s", d.hold_s, seconds);
    s.read("retract_s", d.retract_s, seconds);
}

void readDrifting(Section& s, motion::DriftingParameters& d) {
    s.read("pull", d.pull, share);
    s.read("hold_s", d.hold_s, seconds);
    s.read("hold_shift", d.hold_shift, share);
    s.read("wander_deg", d.wander_deg, {0.0, 45.0});
    s.read("wander_hz", d.wander_hz, hertz);
    s.read("jitter_rad", d.jitter_rad, share);
    s.read("noise_share", d.noise_share, not_negative);
}

}  // namespace

Result<DemonstrationParameters> parseDemonstrationParameters(std::string_view text, const std::string& name) {
    toml::table file;
    try {
        file = toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}:{}", name, error.source().begin.line),
                    fmt::format("this is not valid TOML: {}", error.description()));
    }
    DemonstrationParameters out;
    std::optional<Error> problem;
    Section whole(file, "", name, problem);
    const auto section = [&](std::string_view key, auto&& reader, auto& part) {
        whole.know(key);
        Section s(file, key, name, problem);
        reader(s, part);
        s.rejectOthers();
    };
    section("library", readLibrary, out);
    section("targets", readTargets, out.targets);
    section("line", readLine, out.line);
    section("arm", readArm, out.arm);
    section("body", readBody, out.body);
    section("timing", readTiming, out.timing);
    section("noise", readNoise, out.noise);
    section("direct", readDirect, out.direct);
    section("stiff", readStiff, out.stiff);
    section("drifting", readDrifting, out.drifting);
    whole.rejectOthers();
    if (problem) return tl::unexpected(*problem);
    return out;
}

Result<DemonstrationParameters> loadDemonstrationParameters(const std::filesystem::path& path) {
    const auto text = readFile(path);
    if (!text) return tl::unexpected(text.error());
    return parseDemonstrationParameters(*text, path.string());
}

}  // namespace deixis::assets
