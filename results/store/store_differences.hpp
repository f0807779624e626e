// What differs between what a database holds and what is to be put there, in words.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>
#include <vector>

#include "studies/design/plan.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::results {

/// Between the study kept in the database and this one: name, stages, systems, layouts, distances, and the
/// first line of the file that is another. May be empty: other texts of a questionnaire file, say.
[[nodiscard]] std::vector<std::string> studyDifferences(SQLite::Database& database,
                                                        const studies::Study& study);

/// Between two plans: what they are for, and the first trials that are not the same.
[[nodiscard]] std::vector<std::string> planDifferences(const studies::StudyPlan& kept,
                                                       const studies::StudyPlan& given);

/// ": a; b; c", or nothing.
[[nodiscard]] std::string listed(const std::vector<std::string>& differences);

}  // namespace deixis::results
