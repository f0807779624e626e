#include "tracking_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "results/database/tracking_blocks.hpp"

namespace deixis::results {

namespace {

int flags(const studies::TrackedPose& pose) {
    return (pose.position_valid ? 1 : 0) | (pose.orientation_valid ? 2 : 0) | (pose.tracked ? 4 : 0);
}

/// Appends a float32, least significant byte first on every machine.
void append(std::vector<unsigned char>& bytes, double number) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(number));
    for (int shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<unsigned char>((bits >> shift) & 0xFFU));
}

void append(std::vector<unsigned char>& bytes, const studies::HandJoint& joint) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const Vec3& position = joint.pose.stage_from_device.position;
    const Quat& turn = joint.pose.stage_from_device.orientation;
    for (const double number : {position.x, position.y, position.z})
        append(bytes, joint.pose.position_valid ? number : unknown);
    for (const double number : {turn.w, turn.x, turn.y, turn.z})
        append(bytes, joint.pose.orientation_valid ? number : unknown);
    append(bytes, joint.radius_m);
}

}  // namespace

TrackingWriter::TrackingWriter(SQLite::Database& database)
    : block_(database,
             "INSERT INTO tracking_blocks (session, trial_index, first_frame, frames, first_display_time_s, "
             "last_display_time_s, data) VALUES (?, ?, ?, ?, ?, ?, ?)"),
      joints_(database, "INSERT INTO hand_joints VALUES (?, ?, ?, ?, ?)"),
      trial_(database,
             "INSERT INTO trial_tracking VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
             "frames = frames + excluded.frames, "
             "dropped_frames = dropped_frames + excluded.dropped_frames, "
             "samples_missing = samples_missing + excluded.samples_missing, "
             "max_off_place_m = max(max_off_place_m, excluded.max_off_place_m), "
             "head_untracked_frames = head_untracked_frames + excluded.head_untracked_frames, "
             "last_display_time_s = excluded.last_display_time_s") {
    samples_.reserve(max_frames_in_block);
}

void TrackingWriter::insert(long long session, std::span<const TrackedFrame> frames) {
    while (!frames.empty()) {
        const int trial = frames.front().trial_index;
        const auto max = frames.first(std::min(frames.size(), max_frames_in_block));
        const auto end = std::find_if(max.begin(), max.end(),
                                      [&](const TrackedFrame& frame) { return frame.trial_index != trial; });
        const auto block = frames.first(static_cast<std::size_t>(end - max.begin()));
        insertBlock(session, block);
        frames = frames.subspan(block.size());
    }
}

void TrackingWriter::insertBlock(long long session, std::span<const TrackedFrame> frames) {
    samples_.clear();
    for (const TrackedFrame& frame : frames) samples_.push_back(frame.sample);
    const std::string data = packTracking(samples_);
    block_.tryReset();  // an earlier failure was thrown then
    block_.clearBindings();
    block_.bind(1, static_cast<std::int64_t>(session));
    if (frames.front().trial_index >= 0) block_.bind(2, frames.front().trial_index);
    block_.bind(3, static_cast<std::int64_t>(samples_.front().frame));
    block_.bind(4, static_cast<std::int64_t>(samples_.size()));
    block_.bind(5, samples_.front().display_time_s);
    block_.bind(6, samples_.back().display_time_s);
    block_.bindNoCopy(7, data.data(), static_cast<int>(data.size()));
    block_.exec();
    for (const TrackedFrame& frame : frames) insertJoints(session, frame.sample);
}

void TrackingWriter::insertJoints(long long session, const studies::TrackingSample& sample) {
    constexpr std::array<const char*, 2> hands{"left", "right"};
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        if (sample.joints[hand].empty()) continue;
        joint_bytes_.clear();
        joint_flags_.clear();
        for (const studies::HandJoint& joint : sample.joints[hand]) {
            append(joint_bytes_, joint);
            joint_flags_.push_back(static_cast<unsigned char>(flags(joint.pose)));
        }
        joints_.tryReset();
        joints_.bind(1, static_cast<std::int64_t>(session));
        joints_.bind(2, static_cast<std::int64_t>(sample.frame));
        joints_.bindNoCopy(3, hands[hand]);
        joints_.bindNoCopy(4, joint_bytes_.data(), static_cast<int>(joint_bytes_.size()));
        joints_.bindNoCopy(5, joint_flags_.data(), static_cast<int>(joint_flags_.size()));
        joints_.exec();
    }
}

void TrackingWriter::insert(long long session, const TrialTracking& trial) {
    trial_.tryReset();
    trial_.bind(1, static_cast<std::int64_t>(session));
    trial_.bind(2, trial.trial_index);
    trial_.bind(3, static_cast<std::int64_t>(trial.frames));
    trial_.bind(4, static_cast<std::int64_t>(trial.dropped_frames));
    trial_.bind(5, static_cast<std::int64_t>(trial.samples_missing));
    trial_.bind(6, trial.max_off_place_m);
    trial_.bind(7, static_cast<std::int64_t>(trial.head_untracked_frames));
    trial_.bind(8, trial.first_display_time_s);
    trial_.bind(9, trial.last_display_time_s);
    trial_.exec();
}

}  // namespace deixis::results
