// Ratings of the same clips by several participants; private to the quality of the data.
#pragma once

#include <cstddef>
#include <functional>
#include <unordered_map>
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
    struct Key {
        Name measure, system, item;
        bool operator==(const Key&) const = default;
    };
    struct HashOfKey {
        std::size_t operator()(const Key& key) const {
            const std::hash<Name> hash;
            return (hash(key.measure) * 31 + hash(key.system)) * 31 + hash(key.item);
        }
    };
    struct Unit {
        Name measure;
        std::vector<double> ratings{};
        std::vector<Name> raters{};  ///< of each of them
        double sum = 0.0;
    };

    static Key keyOf(const ResponseRow& row) { return {row.measure, row.system, row.target_id}; }

    std::unordered_map<Name, double> range_{};  ///< of the scale, by measure
    std::vector<Unit> units_{};                 ///< in the order in which they first occur
    std::unordered_map<Key, std::size_t, HashOfKey> index_{};
};

}  // namespace deixis::results
