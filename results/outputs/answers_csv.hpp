// The table of answers; private to the analysis' outputs.
#pragma once

#include <string>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// All rows, also of those left out, in the form that loadLongTable() reads again. Written straight away:
/// there may be millions.
[[nodiscard]] std::string answersCsv(const ResponseTable& table);

}  // namespace deixis::results
