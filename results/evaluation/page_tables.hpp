// The tables of the evaluation's page, HTML; private to the evaluation.
#pragma once

#include <string>

#include "results/evaluation/evaluation.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

[[nodiscard]] std::string systemsHtml(const Evaluation& evaluation, Numbering& tables);
/// What the box plots of accuracy draw.
[[nodiscard]] std::string accuracyBoxesHtml(const Evaluation& evaluation, Numbering& tables);
/// Pairs of systems; empty of a single one.
[[nodiscard]] Section comparisonsSection(const Evaluation& evaluation, Numbering& tables);
/// Reward and speed each half second around the time of pointing.
[[nodiscard]] std::string profilesHtml(const Evaluation& evaluation, Numbering& tables);
[[nodiscard]] std::string correlationTable(const Evaluation& evaluation, Numbering& tables);
[[nodiscard]] std::string clustersHtml(const Evaluation& evaluation, Numbering& tables);

}  // namespace deixis::results
