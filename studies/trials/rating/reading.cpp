#include "study_reading.hpp"

namespace deixis::studies {

extern const KindReader rating_reader{readTrials};

}  // namespace deixis::studies
