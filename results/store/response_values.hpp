// What the kind of a response keeps of it beside answers, read back; private to the store.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <vector>

#include "studies/study_file/kept_values.hpp"

namespace deixis::results {

[[nodiscard]] std::vector<studies::KeptValue> readResponseValues(SQLite::Database& database,
                                                                 std::int64_t response);

}  // namespace deixis::results
