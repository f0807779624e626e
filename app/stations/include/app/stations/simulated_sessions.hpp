// Sessions of simulated participants, several at a time, stored in the participants' order.
#pragma once

#include <vector>

#include "app/clips/study_setup.hpp"
#include "app/study/stimuli.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "results/store/store.hpp"
#include "studies/design/plan.hpp"
#include "studies/simulation/simulated_participant.hpp"

namespace deixis::app {

/// Runs every session that each plan still has, and keeps it in `store`, where the plans are stored already:
/// the first session of everybody in the order of `plans`, then the second, and so on. Virtual time; nothing
/// is drawn. Returns how many units were answered. Errors: a session that makes no progress, or of whom the
/// participant can make none.
[[nodiscard]] Result<int> simulateSessions(const StudySetup& setup,
                                           const std::vector<studies::StudyPlan>& plans,
                                           const assets::Avatar& avatar, const StimulusLibrary& stimuli,
                                           const studies::SimulatedParameters& parameters,
                                           results::Store& store);

}  // namespace deixis::app
