#include "recorders.hpp"

namespace deixis::app {

void DirectRecorder::record(const studies::SessionEvent& event) {
    if (std::holds_alternative<studies::Response>(event)) ++answers_;
    store_.record(event, plan_, clips_by_trial_);
}

}  // namespace deixis::app
