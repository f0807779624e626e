// What was recorded in a participant's trials, for replay.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/store/store.hpp"
#include "studies/session/replay.hpp"

namespace deixis::results {

/// One answer, as it was given; a trial that was done again has several.
struct RecordedAnswer {
    studies::RecordedTrial trial{};
    ClipRecords clips{};  ///< of its stimuli
    long long session = 0;
    bool superseded = false;    ///< it was done again: the answer does not count
    std::string avatar_hash{};  ///< SHA-256 of the avatar that its session showed
    std::string outcome{};      ///< for people: "chose ball 2 of 3, correct, after 1.42 s"
};

struct Recording {
    std::string study_title;
    std::string study_source{};  ///< the study file's text; empty if it was not kept
    std::string participant;
    std::vector<RecordedAnswer> answers;  ///< of trials that show clips, in order of arrival
};

/// Reads all trials that show clips, with their plays, answers and tracked frames; changes nothing. Fails
/// if there is no such participant.
[[nodiscard]] Result<Recording> loadRecording(const std::filesystem::path& database,
                                              const std::string& participant);

}  // namespace deixis::results
