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
    int pauses = 0;          ///< the trial was interrupted this often and its clip shown again
};

/// The sessions of one kind of station.
struct StationUse {
    std::string kind;
    std::string details;
    bool synthetic = false;
    int sessions = 0;
};

struct ResponseTable {
    std::string study_name;
    std::string study_title;
    std::string study_hash;
    double alpha = 0.01;
    std::vector<std::string> systems;  ///< in the study file's order
    std::vector<std::string> layouts;  ///< of the game, likewise
    int rating_steps = 5;
    int planned_ratings = 0;  ///< trials planned, answered or not
    int planned_choices = 0;
    int planned_participants = 0;
    int balls = 0;         ///< shown in a trial of the game; 0 where there is none
    std::string database;  ///< file name without its folder
    std::vector<StationUse> stations;
    std::vector<std::string> program_versions;  ///< that recorded the sessions, in order of their text
    std::vector<std::string> avatar_hashes;     ///< likewise
    std::vector<ResponseRow> rows;              ///< ordered by participant, then trial; practice left out
};

/// Reads a database made by Store; changes nothing in it or beside it. Errors: no such file, not one of ours,
/// a newer version, no study in it yet, no answers in it yet.
[[nodiscard]] Result<ResponseTable> loadResponses(const std::filesystem::path& database);

}  // namespace deixis::results
