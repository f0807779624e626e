// Tracking samples as rows: the tables tracking, hand_joints and trial_tracking.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include "results/store.hpp"

namespace deixis::results {

/// Statements prepared once; the database must outlive them. Call inside a transaction.
class TrackingRows {
  public:
    explicit TrackingRows(SQLite::Database& database);
    void insert(long long session, const TrackedFrame& frame);
    void insert(long long session, const TrialTracking& trial);

  private:
    SQLite::Statement frame_;
    SQLite::Statement joints_;
    SQLite::Statement trial_;
    std::vector<unsigned char> joint_bytes_;
    std::vector<unsigned char> joint_flags_;
};

}  // namespace deixis::results
