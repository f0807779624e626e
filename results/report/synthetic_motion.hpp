// What a report says of systems whose motion is synthetic, and of those that are not compared; private to the
// report.
#pragma once

#include <string>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// Which systems are synthetic, and how, in sentences (HTML); empty: of none is it known.
[[nodiscard]] std::string syntheticMotionText(const ResponseTable& table);

/// Of a system in a list: its name, and in parentheses what its motion is, if that is known (HTML).
[[nodiscard]] std::string systemWithMotion(const ResponseTable& table, const std::string& system);

/// The systems that are not compared: their means, and why. Empty where there are none.
[[nodiscard]] Section notComparedSection(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
