// A corpus in numbers, beside what was published about people.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "learning/corpus/corpus.hpp"

namespace deixis::learning {

struct MeanAndSd {
    int count = 0;
    double mean = 0.0;
    double sd = 0.0;  ///< over n
};

/// Where hands are at the apices of a class's strokes.
struct ApexPlaces {
    MeanAndSd height_m;   ///< of the moving hands' mean above the shoulders' (below: negative)
    MeanAndSd outward_m;  ///< of the farther moving hand from the body's middle, to its own side
};

struct CorpusStatistics {
    int takes = 0;
    double minutes = 0.0;
    int words = 0;
    int word_forms = 0;
    double accents_per_minute = 0.0;
    /// Of takes whose strokes are known; those of recordings are not.
    motion::StrokeStatistics strokes{};
    double both_hands = 0.0;      ///< share of strokes
    MeanAndSd stroke_s{};         ///< durations, begin to apex
    MeanAndSd before_accent_s{};  ///< a stroke begins before the accent's begin
    /// From the motion alone: how long a wrist that made a stroke stays slower than 0.3 m/s after its apex,
    /// where that is a frame at least.
    MeanAndSd hold_s{};
    std::array<ApexPlaces, motion::gesture_class_count> places{};
    // Of motions.
    double still = 0.0;          ///< share of frames in which both wrists are slower than 0.1 m/s
    double wrist_p99_m_s = 0.0;  ///< 99th percentile of speeds
    double wrist_most_m_s = 0.0;
};

[[nodiscard]] CorpusStatistics corpusStatistics(std::span<const CorpusTake* const> takes);
[[nodiscard]] CorpusStatistics corpusStatistics(const Corpus& corpus);

/// Columns of numbers beside the published ones.
struct StatisticsColumn {
    std::string name;
    CorpusStatistics statistics;
};
struct StatisticsRow {
    std::string what;
    std::string published;  ///< "-" where nothing was found
    std::string source;
    std::vector<std::string> found;  ///< one a column
};
[[nodiscard]] std::vector<StatisticsRow> statisticsTable(std::span<const StatisticsColumn> columns);
/// The table in columns of equal width, and as CSV.
[[nodiscard]] std::string statisticsText(std::span<const StatisticsColumn> columns);
[[nodiscard]] std::string statisticsCsv(std::span<const StatisticsColumn> columns);

}  // namespace deixis::learning
