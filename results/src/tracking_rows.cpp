#include "tracking_rows.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace deixis::results {

namespace {

// session, frame, trial_index, display_time_s, begun_s, submitted_s, dropped_frames, rendered, off_place_m,
// then validity and seven numbers for each of six poses.
constexpr int frame_columns = 9 + 6 * 8;

std::string insertFrameSql() {
    std::string sql = "INSERT INTO tracking VALUES (?";
    for (int column = 1; column < frame_columns; ++column) sql += ", ?";
    return sql + ")";
}

int flags(const studies::TrackedPose& pose) {
    return (pose.position_valid ? 1 : 0) | (pose.orientation_valid ? 2 : 0) | (pose.tracked ? 4 : 0);
}

/// Binds validity and pose from column `first` on; what is not valid stays NULL.
void bindTracked(SQLite::Statement& row, int first, const studies::TrackedPose& pose) {
    row.bind(first, flags(pose));
    if (pose.position_valid) {
        const Vec3& position = pose.stage_from_device.position;
        row.bind(first + 1, position.x);
        row.bind(first + 2, position.y);
        row.bind(first + 3, position.z);
    }
    if (pose.orientation_valid) {
        const Quat& turn = pose.stage_from_device.orientation;
        row.bind(first + 4, turn.w);
        row.bind(first + 5, turn.x);
        row.bind(first + 6, turn.y);
        row.bind(first + 7, turn.z);
    }
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

TrackingRows::TrackingRows(SQLite::Database& database)
    : frame_(database, insertFrameSql()),
      joints_(database, "INSERT INTO hand_joints VALUES (?, ?, ?, ?, ?)"),
      trial_(database,
             "INSERT INTO trial_tracking VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
             "frames = frames + excluded.frames, "
             "dropped_frames = dropped_frames + excluded.dropped_frames, "
             "samples_missing = samples_missing + excluded.samples_missing, "
             "max_off_place_m = max(max_off_place_m, excluded.max_off_place_m), "
             "head_untracked_frames = head_untracked_frames + excluded.head_untracked_frames, "
             "last_display_time_s = excluded.last_display_time_s") {}

void TrackingRows::insert(long long session, const TrackedFrame& frame) {
    const studies::TrackingSample& sample = frame.sample;
    const auto session_id = static_cast<std::int64_t>(session);
    const auto number = static_cast<std::int64_t>(sample.frame);
    frame_.tryReset();  // an earlier failure was thrown then
    frame_.clearBindings();
    frame_.bind(1, session_id);
    frame_.bind(2, number);
    if (frame.trial_index >= 0) frame_.bind(3, frame.trial_index);
    frame_.bind(4, sample.display_time_s);
    frame_.bind(5, sample.begun_s);
    frame_.bind(6, sample.submitted_s);
    frame_.bind(7, sample.dropped_frames);
    frame_.bind(8, sample.rendered ? 1 : 0);
    frame_.bind(9, sample.off_place_m);
    int column = 10;
    for (const auto* pose :
         {&sample.head, &sample.aim[0], &sample.aim[1], &sample.grip[0], &sample.grip[1]}) {
        bindTracked(frame_, column, *pose);
        column += 8;
    }
    if (sample.gaze) bindTracked(frame_, column, *sample.gaze);
    frame_.exec();

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
        joints_.bind(1, session_id);
        joints_.bind(2, number);
        joints_.bindNoCopy(3, hands[hand]);
        joints_.bindNoCopy(4, joint_bytes_.data(), static_cast<int>(joint_bytes_.size()));
        joints_.bindNoCopy(5, joint_flags_.data(), static_cast<int>(joint_flags_.size()));
        joints_.exec();
    }
}

void TrackingRows::insert(long long session, const TrialTracking& trial) {
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
