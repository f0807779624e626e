// The order in which a table of answers holds its rows; private to the library.
#pragma once

#include <vector>

#include "results/answers/response_table.hpp"

namespace deixis::results {

/// By participant, then by trial; rows that are alike in both keep their order.
void sortByParticipantAndTrial(std::vector<ResponseRow>& rows);

}  // namespace deixis::results
