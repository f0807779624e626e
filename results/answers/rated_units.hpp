// Ratings of the same clips by several participants; private to the quality of the data.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "results/answers/data_quality.hpp"
#include "results/answers/response_table.hpp"

namespace deixis::results {

/// Of those who count. A unit is a system's clip for an item on one measure; confidence, which is about an
/// answer and not about a clip, makes none.
class RatedUnits {
  public:
    explicit RatedUnits(const ResponseTable& table);

    /// Of one participant's rows: ParticipantQuality::agreement.
    [[nodiscard]] std::optional<double> agreement(const std::vector<const ResponseRow*>& rows) const;
    [[nodiscard]] std::vector<Reliability> reliability(const ResponseTable& table) const;

  private:
    using Key = std::tuple<std::string, std::string, std::string>;  ///< measure, system, item
    struct Unit {
        std::string measure;
        std::vector<double> ratings{};
        std::vector<std::string> raters{};  ///< of each of them
        double sum = 0.0;
    };

    static Key keyOf(const ResponseRow& row) { return {row.measure, row.system, row.target_id}; }

    std::map<std::string, double> range_{};  ///< of the scale, by measure
    std::vector<Unit> units_{};              ///< in the order in which they first occur
    std::map<Key, std::size_t> index_{};
};

}  // namespace deixis::results
