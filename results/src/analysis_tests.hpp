// Participants' means under conditions, and the tests that compare them; private to the analysis.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "results/analysis.hpp"

namespace deixis::results {

/// The scores of one participant under one condition.
using Scores = std::vector<double>;

/// Condition -> participant -> scores. std::map keeps the participants in order.
using Cells = std::map<std::string, std::map<std::string, Scores>>;

/// Scores as the decimals they were given as: means that are equal on paper are equal.
[[nodiscard]] Rational exactMeanOf(const Scores& scores);

/// 0 of no values.
[[nodiscard]] double meanOf(const std::vector<Rational>& values);

/// Fills in the differences' test, their mean and their normality: participants' means under comparison.a
/// minus those under comparison.b, of the participants who have both.
void testDifferences(Comparison& comparison, const Cells& cells, double level);

/// Fills in all that depends on the family, which consists of these tests.
void adjustFamily(const std::vector<AdjustedTest*>& family, const std::string& name, double alpha);

/// Of the participants who have scores under each of the systems.
[[nodiscard]] OmnibusResult omnibusTest(const Cells& cells, const std::string& measure,
                                        const std::vector<std::string>& systems);

}  // namespace deixis::results
