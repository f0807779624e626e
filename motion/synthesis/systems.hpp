// The built-in systems, one file each; generator.cpp knows them by name.
#pragma once

#include <memory>

#include "motion/synthesis/generator.hpp"
#include "pointing_body.hpp"

namespace deixis::motion {

[[nodiscard]] std::unique_ptr<Generator> makeDemonstrationNn(const PointingBody& body,
                                                             const DemonstrationParameters& parameters);
/// The same under the paper's name.
[[nodiscard]] std::unique_ptr<Generator> makeGtNn(const PointingBody& body,
                                                  const DemonstrationParameters& parameters);
[[nodiscard]] std::unique_ptr<Generator> makeDirect(const PointingBody& body,
                                                    const DemonstrationParameters& parameters);
[[nodiscard]] std::unique_ptr<Generator> makeStiff(const PointingBody& body,
                                                   const DemonstrationParameters& parameters);
[[nodiscard]] std::unique_ptr<Generator> makeDrifting(const PointingBody& body,
                                                      const DemonstrationParameters& parameters);
[[nodiscard]] std::unique_ptr<Generator> makeGp(const PointingBody& body,
                                                const DemonstrationParameters& parameters);

}  // namespace deixis::motion
