// Tracking samples on their way into the tables tracking_blocks, hand_joints and trial_tracking.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <span>
#include <vector>

#include "results/store/store.hpp"

namespace deixis::results {

/// Statements prepared once; the database must outlive them. Call inside a transaction.
class TrackingWriter {
  public:
    explicit TrackingWriter(SQLite::Database& database);
    /// Packs frames into blocks: one for each run of frames of one trial, and no longer than a block may be.
    void insert(long long session, std::span<const TrackedFrame> frames);
    void insert(long long session, const TrialTracking& trial);

  private:
    void insertBlock(long long session, std::span<const TrackedFrame> frames);
    void insertJoints(long long session, const studies::TrackingSample& sample);

    SQLite::Statement block_;
    SQLite::Statement joints_;
    SQLite::Statement trial_;
    std::vector<studies::TrackingSample> samples_;
    std::vector<unsigned char> joint_bytes_;
    std::vector<unsigned char> joint_flags_;
};

}  // namespace deixis::results
