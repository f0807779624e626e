// The views of a database: responses_flat, and for each kind of trial with its own values
// (kept_values.hpp) views that show them as columns, made from the kind's declaration.
#pragma once

#include <string>

#include "studies/study_file/kept_values.hpp"

namespace deixis::results {

/// SQL that makes all of them; they must not be there. Understood by SQLite and, but for how responses_flat
/// writes moments, by PostgreSQL.
[[nodiscard]] std::string createViews();
/// SQL that makes those of kinds that are missing, as after a kind was added. SQLite's.
[[nodiscard]] std::string createMissingViews();
/// SQL that takes all of them away, those that are there.
[[nodiscard]] std::string dropViews();
/// SQL of one declared value. `row` says which row of `table` (trial_values or response_values), called v,
/// belongs to the row at hand.
[[nodiscard]] std::string keptValueSql(const studies::KeptField& field, const char* table, const char* row);

}  // namespace deixis::results
