// The answers of a database as a flat table: what the analysis works on.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

struct ResponseRow {
    std::string participant;
    std::string stage;  ///< "naturalness" or "game"
    std::string system;
    std::string layout;
    std::string target_id;
    double rating = 0.0;   ///< naturalness
    bool correct = false;  ///< game
    double response_time_s = 0.0;
    bool synthetic = false;  ///< answered by a simulated participant
};

struct ResponseTable {
    std::string study_name;
    std::string study_title;
    std::string study_hash;
    double alpha = 0.01;
    std::vector<std::string> systems;  ///< in the study file's order
    std::vector<std::string> layouts;
    int rating_steps = 5;
    int planned_ratings = 0;  ///< trials planned, answered or not
    int planned_choices = 0;
    std::vector<ResponseRow> rows;  ///< ordered by participant, then trial; practice left out
};

/// Reads a database made by Store, read-only.
[[nodiscard]] Result<ResponseTable> loadResponses(const std::filesystem::path& database);

}  // namespace deixis::results
