// Systems that make pointing clips for a target: the interface, and the built-in ones. Each is documented
// in docs/systems.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/gesture_phases.hpp"
#include "motion/synthesis/demonstration_parameters.hpp"

namespace deixis::motion {

/// How a gesture is held, where a study asks for it; what is not set stays as the system does by itself.
struct HoldSettings {
    std::optional<double> hold_s{};  ///< from peak to hold
    /// About how far the fingertip wanders to each side of where it points, slowly, during the hold; metres.
    std::optional<double> unsteadiness_m{};
};

struct GenerationRequest {
    std::string target_id;
    Vec3 target{0.0};  ///< metres, in the avatar's frame
    std::uint64_t seed = 0;
    HoldSettings settings{};
};

/// A clip, and the phases as its generator planned them.
struct GeneratedClip : GesturePhases {
    Clip clip{};
};

/// A system: the same request gives the same clip, bit for bit. Several threads may call generate() at once.
class Generator {
  public:
    virtual ~Generator() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual GeneratedClip generate(const GenerationRequest& request) const = 0;
};

/// Names of the built-in systems: "demonstration-nn", "direct", "stiff", "drifting", "gp".
[[nodiscard]] const std::vector<std::string>& generatorNames();
/// Names of the learned systems, which are made from weights: "moglow", "amp-no-runtime", "amp-base",
/// "amp-pfnn-1", "amp-pfnn-3", "amp-pfnn-8", "flow".
[[nodiscard]] const std::vector<std::string>& learnedNames();
/// Both, and "gt-nn", the paper's name of demonstration-nn.
[[nodiscard]] const std::vector<std::string>& systemNames();

/// Makes a built-in system for an avatar. Fails on an unknown name, on that of a learned system, which is
/// made from its weights (motion/learned, physics/policy), or an avatar without the bones of both arms.
[[nodiscard]] Result<std::unique_ptr<Generator>> makeGenerator(std::string_view name, const Skeleton& avatar,
                                                               const DemonstrationParameters& parameters);

}  // namespace deixis::motion
