// Values of a few names, such as systems and measures; private to the library.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/name.hpp"

namespace deixis::results {

/// Names in the order in which they were first asked for. Looking one up is a walk over all: quicker than a
/// map for the few names that stand in each of a million answers, and not meant for many.
template <typename T>
class ByName {
  public:
    /// Made where it is new.
    T& operator[](Name name) {
        for (auto& [known, value] : entries_)
            if (known == name) return value;
        return entries_.emplace_back(name, T{}).second;
    }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    [[nodiscard]] auto begin() const { return entries_.begin(); }
    [[nodiscard]] auto end() const { return entries_.end(); }

  private:
    std::vector<std::pair<Name, T>> entries_{};
};

}  // namespace deixis::results
