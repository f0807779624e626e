// The evaluation as tables: for CSV, JSON and the page; private to the evaluation.
#pragma once

#include "rays.hpp"
#include "results/evaluation/evaluation.hpp"
#include "results/tables/table.hpp"

namespace deixis::results {

[[nodiscard]] Table clipsTable(const Evaluation& evaluation);
[[nodiscard]] Table systemsTable(const Evaluation& evaluation);
[[nodiscard]] Table comparisonsTable(const Evaluation& evaluation);
[[nodiscard]] Table profilesTable(const Evaluation& evaluation);
[[nodiscard]] Table targetsTable(const Evaluation& evaluation);
[[nodiscard]] Table clustersTable(const Evaluation& evaluation);
[[nodiscard]] Table raysTable(const Evaluation& evaluation);

}  // namespace deixis::results
