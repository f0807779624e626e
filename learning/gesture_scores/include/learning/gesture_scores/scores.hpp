// How good speech gestures are in numbers: Yoon et al. (2021), section 5.3.
#pragma once

#include <Eigen/Core>

namespace deixis::learning {

/// What scores look at: parts of 30 frames, of which the frames 10 to 14 are poses (equation 8).
constexpr int scored_frames = 30;
constexpr int posed_first = 10;
constexpr int posed_frames = 5;

/// Of held-out windows: of each the 30 frames that a window adds, generated without a seed from before it.
/// Lower is better. A baseline without controls has the first alone.
struct GestureScores {
    /// Frechet gesture distance: that of the latents of an autoencoder, which was trained on the training
    /// motions, between held-out and generated motions. Comparable only where the autoencoder was trained on
    /// the same motions by the same seed.
    double fgd_no_controls = 0.0;
    double fgd_pose_controls = 0.0;   ///< as for `pcs`
    double fgd_style_controls = 0.0;  ///< as for `scs`
    /// Equation 8: mean absolute difference of directions' numbers where the frames 10 to 14 of the 30 are
    /// poses.
    double pcs = 0.0;
    /// Equation 9: mean absolute difference of normalised styles over the 30 frames where each frame has the
    /// style of the held-out window.
    double scs = 0.0;
    bool controls = true;

    /// What weights are chosen by: the geometric mean of PCS, SCS and the mean FGD; without controls the FGD.
    [[nodiscard]] double score() const;
};

/// Between normal distributions with the means and covariances (over n - 1) of two samples, a row for each:
/// the squared distance of the means plus tr(A + B - 2 (A B)^(1/2)) (Dowson & Landau 1982). At least 2 rows
/// each.
[[nodiscard]] double frechetDistance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace deixis::learning
