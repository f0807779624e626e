// Style statistics and pose compliance of the SGToolkit (Yoon et al. 2021): equations 4 to 6, 8 and 9.
// Pure functions.
#pragma once

#include <vector>

#include "core/error.hpp"
#include "motion/gestures/motion_statistics.hpp"

namespace deixis::motion {

constexpr double style_frame_time_s = 1.0 / 15.0;  ///< the paper's motion runs at 15 frames per second
constexpr int style_window = 30;                   ///< frames, section 4.3

/// Style at one frame, before normalisation.
struct Style {
    double speed = 0.0;       ///< eq. 4: path of all joints together, metres a frame
    double space = 0.0;       ///< eq. 5: between the wrists, metres
    double handedness = 0.0;  ///< eq. 6: -1 right hand only, 0 both alike, 1 left hand only
};
/// Ten upper-body joints, the nearest humanoid bones to the paper's: hips, spine, neck, head, and both arms'
/// shoulder, elbow and wrist.
[[nodiscard]] const std::vector<Bone>& styleBones();

/// Style at every frame. The window is i - w/2 to i + w/2, both counted, its sum divided by w, as the
/// equations are printed; at the ends it is cut off and the divisor with it in proportion. Hands that do not
/// move at all have a handedness of 0. Fails without both hands or with fewer than 2 frames.
[[nodiscard]] Result<std::vector<Style>> gestureStyle(const JointTrajectories& motion,
                                                      int window = style_window);

/// The same of any joints: positions [joint][frame] in metres, of as many frames each, and which two are the
/// wrists.
[[nodiscard]] Result<std::vector<Style>> styleOfPositions(const std::vector<std::vector<Vec3>>& positions,
                                                          std::size_t left_wrist, std::size_t right_wrist,
                                                          int window = style_window);

/// Mean and standard deviation of each element over a corpus. `sd` is over n.
struct StyleNorm {
    Style mean;
    Style sd;
};
[[nodiscard]] StyleNorm styleNorm(const std::vector<std::vector<Style>>& corpus);
/// (style - mean) / sd, clamped to [-3, 3]; 0 if the corpus does not vary.
[[nodiscard]] Style normalisedStyle(const Style& style, const StyleNorm& norm);

/// The joints that pose compliance looks at: those of styleBones() without the hips, to which all coordinates
/// are relative. The paper's ten (appendix A.2) have nose and head top for the head, and no hips.
[[nodiscard]] const std::vector<Bone>& poseBones();

/// Pose compliance score, eq. 8: the mean absolute difference of the joints' coordinates (metres) over the
/// frames [first, last) for which poses were asked; the paper takes [10, 15) of 30. Fails if joints or
/// rates differ (by more than 1 %) or a motion is too short. The paper's figures (0.014 for its model) are of
/// unit vectors from joint to joint, as its program has them: not metres.
[[nodiscard]] Result<double> poseCompliance(const JointTrajectories& reference,
                                            const JointTrajectories& generated, int first = 10,
                                            int last = 15);

/// Style compliance score, eq. 9: the mean absolute difference of normalised styles over all frames and the
/// three elements. Fails if the lengths differ or there are no frames.
[[nodiscard]] Result<double> styleCompliance(const std::vector<Style>& reference,
                                             const std::vector<Style>& generated);

}  // namespace deixis::motion
