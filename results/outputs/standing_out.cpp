#include "results/outputs/standing_out.hpp"

#include "studies/study_file/leave_out_rule.hpp"

namespace deixis::results {

bool standsOut(const ParticipantQuality& one) {
    constexpr int least = studies::LeaveOutRule::least_answers;
    return one.failed_check.value_or(false) ||
           (one.same_of >= least && one.same_share >= mostly_one_rating) ||
           (one.p_side && *one.p_side <= side_p) ||
           (one.times >= least && one.fast + one.slow > many_odd_times * one.times) ||
           (one.agreement && *one.agreement < 0.0);
}

}  // namespace deixis::results
