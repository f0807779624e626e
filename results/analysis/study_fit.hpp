// What several studies must have in common to be analysed together; private to their joining.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "results/analysis/several_studies.hpp"

namespace deixis::results {

using NameSet = std::set<std::string>;

/// "a, b", or "none".
[[nodiscard]] std::string listed(const NameSet& names);
/// Null where it is not measured.
[[nodiscard]] const Measure* measureIn(const ResponseTable& table, const std::string& name);

/// Each table is one study. Every measure that is answered in the one is answered in the others, in the same
/// way and on the same scale, and at one level of significance.
[[nodiscard]] Result<void> checkTogether(const std::vector<ResponseTable>& tables, const JoinChoice& choice);

/// Leaves out all other measures.
void keepMeasures(const NameSet& kept, ResponseTable& table);

/// Systems are compared by their names. Those that not all studies have are left out; fails where none is
/// left.
[[nodiscard]] Result<void> keepSharedSystems(std::vector<ResponseTable>& tables);

}  // namespace deixis::results
