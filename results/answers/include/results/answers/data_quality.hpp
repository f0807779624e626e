// How carefully participants answered, and how far they agree: what a reader checks before the results.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace deixis::results {

struct ResponseTable;

/// Of one participant's answers; none of a kind: 0, or no value.
struct ParticipantQuality {
    std::string participant;
    bool left_out = false;  ///< excluded or dropped out; judged like the others
    int ratings = 0;        ///< on all measures
    /// In which the rating given most often has the largest share, of those that the rule can judge if any,
    std::string same_measure{};
    double same_rating = 0.0;        ///< that rating,
    double same_share = 0.0;         ///< its share,
    int same_of = 0;                 ///< and of how many
    int longest_run = 0;             ///< equal ratings of one measure in a row
    int decided = 0;                 ///< pairs in which a side was preferred
    int left = 0;                    ///< of them the left one
    std::optional<double> p_side{};  ///< exact binomial test of left against 1/2, two-sided
    int times = 0;                   ///< response times, one for each trial
    std::optional<double> median_s{};
    int fast = 0;  ///< beyond 3 MAD below the median of all participants' logarithms of times in the measure
    int slow = 0;  ///< likewise above (Leys et al. 2013)
    /// Pearson's correlation of the ratings with the means of the others' ratings of the same clips.
    std::optional<double> agreement{};
    std::optional<bool> failed_check{};  ///< none of whom is left out
};

/// How far those who count agree in rating the same clips (a system's for an item). Each clip's ratings are
/// one unit; those rated by one participant alone have no part in it.
struct Reliability {
    std::string measure;
    int raters = 0;
    int units = 0;
    int ratings = 0;
    std::optional<double> alpha{};  ///< Krippendorff (2011), interval scale; 1: all agree, 0: as by chance
    std::optional<double> icc_single{};  ///< Shrout & Fleiss (1979), ICC(1,1); units of unequal size as in
    std::optional<double> icc_mean{};    ///< one-way analysis of variance; ICC(1,k), of the mean of k ratings
    double k = 0.0;                      ///< ratings of a unit, the analysis' mean of unequal numbers
};

struct DataQuality {
    std::vector<ParticipantQuality> participants{};  ///< by name
    std::vector<Reliability> reliability{};          ///< of ratings, in the order of the measures
};

[[nodiscard]] DataQuality dataQuality(const ResponseTable& table);

/// Of ResponseTable::leave_out: who of those that count is to be left out, and why.
[[nodiscard]] std::map<std::string, std::string> leftOutByRule(const ResponseTable& table);

/// Ratings by unit, of two ratings or more. None of fewer than two units, and where all ratings are equal.
[[nodiscard]] std::optional<double> krippendorffAlpha(const std::vector<std::vector<double>>& units);

struct IntraclassCorrelation {
    double single = 0.0;  ///< ICC(1,1)
    double mean = 0.0;    ///< ICC(1,k)
    double k = 0.0;
};
/// Likewise.
[[nodiscard]] std::optional<IntraclassCorrelation> intraclassCorrelation(
    const std::vector<std::vector<double>>& units);

}  // namespace deixis::results
