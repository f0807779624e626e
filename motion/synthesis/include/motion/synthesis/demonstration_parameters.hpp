// Parameters of the synthetic demonstrations and of the systems made from the same parts.
// assets/data/demonstrations.toml has the values with their sources; the defaults here are the same
// values.
#pragma once

#include <array>
#include <cstdint>

namespace deixis::motion {

/// Drawn uniformly from [low, high).
struct Interval {
    double low = 0.0;
    double high = 0.0;
};

/// Drawn from a normal distribution.
struct Spread {
    double mean = 0.0;
    double sd = 0.0;
};

/// Where the demonstrated targets lie: on a half-cylinder before the avatar.
struct TargetDraw {
    Interval azimuth_deg{-85.0, 85.0};  ///< 0 straight ahead, positive to the avatar's left
    Interval radius_m{1.9, 2.2};        ///< horizontal distance from the avatar's vertical axis
    Interval height_m{0.0, 2.2};
    double crossing_deg = 10.0;  ///< so far from straight ahead either hand may point
};

/// The line that the pointer lays through fingertip and target, and its errors.
struct PointingLineParameters {
    double origin_k = 0.12;          ///< the line starts at (1-k) eye + k shoulder
    Spread extension{0.996, 0.002};  ///< shoulder to fingertip over the length of the straight arm
    /// Share of the index finger's angle to the target that wrist and knuckle mend, and their limits.
    double index_alignment = 0.15;
    double wrist_limit_deg = 10.0;
    double knuckle_limit_deg = 6.0;
    double actor_bias_sd_deg = 2.0;     ///< constant error of the one actor, per axis
    double trial_bias_sd_deg = 1.5;     ///< error of a trial, per axis
    Spread palm_inward_deg{20.0, 8.0};  ///< turn of the palm from facing down towards the body's middle
};

/// Soechting & Flanders (1989): an angle of an arm segment, degrees, as a + b R + c psi (elevations) or
/// a + b chi + c psi (yaws); R is the distance shoulder to fingertip in cm, psi the elevation and chi the
/// azimuth (outward positive) of the fingertip seen from the shoulder. The upper arm's elevation is counted
/// from hanging down, the forearm's from pointing up (with the authors' signs only this fits: psi up, forearm
/// up).
struct ArmPostureParameters {
    std::array<double, 3> upper_arm_elevation{-4.0, 1.10, 0.90};
    std::array<double, 3> forearm_elevation{39.4, 0.54, -1.06};
    std::array<double, 3> upper_arm_yaw{13.2, 0.86, 0.11};
    std::array<double, 3> forearm_yaw{-10.0, 1.08, -0.35};
    double swivel_sd_deg = 3.5;
};

/// What trunk, shoulder girdle, head and eyes take over.
struct BodyShareParameters {
    double torso_yaw_share = 0.22;  ///< of the target's azimuth
    double torso_yaw_sd_rad = 0.03;
    double torso_pitch_share = 0.06;  ///< of the target's elevation: forward for low targets
    double torso_roll_share = 0.02;   ///< of the azimuth: towards the target
    double head_yaw_share = 0.65;     ///< of the azimuth that the torso leaves
    double head_yaw_limit_rad = 0.75;
    double head_pitch_share = 0.6;  ///< of the target's elevation
    double eye_limit_deg = 25.0;
    double shoulder_raise_share = 0.10;  ///< of the arm's elevation from hanging
    double shoulder_forward_deg = 6.0;   ///< when reaching straight ahead
    double head_lead_s = 0.1;            ///< the head starts so long before the hand
    double gaze_lead_s = 0.2;            ///< and the eyes so long
    double gaze_shift_s = 0.25;          ///< duration of the shift of gaze
};

/// Seconds of each phase. `emphasis` is a style: it multiplies raise and hold (communicative intent lengthens
/// both, Peeters et al. 2015).
struct TimingParameters {
    Interval rest_s{0.2, 0.4};  ///< before and after
    Interval raise_s{0.65, 0.95};
    Interval hold_s{0.7, 1.3};
    Interval retract_s{0.7, 1.05};
    double warp = 0.9;  ///< exponent on time: below 1 the speed peaks earlier
    double emphasis = 1.0;
    Interval bulge{0.03, 0.08};  ///< sideways deviation of the fingertip's path over its length
    double min_reach = 0.72;     ///< fingertip never nearer to the shoulder on its way, over arm length
};

/// Noise of a living body.
struct NoiseParameters {
    double ou_decay = 0.8;        ///< Ornstein-Uhlenbeck, per 30 Hz frame
    double ou_step_rad = 0.015;   ///< its normal step's SD per frame
    double smoothing_hz = 2.0;    ///< low-pass between joint targets and joints
    double hold_share = 0.15;     ///< of the noise that is left while the hand is still
    double hold_drift_deg = 0.3;  ///< amplitude of the arm's slow drift during the hold
    Interval hold_drift_hz{0.3, 1.3};
    double sway_m = 0.003;  ///< amplitude of the hips' sway over planted feet
    Interval sway_hz{0.2, 0.4};
    double breathing_deg = 0.5;  ///< amplitude of the chest's pitch
    Interval breathing_hz{0.22, 0.30};
};

/// Where the system `direct` differs from a demonstration.
struct DirectParameters {
    double extension = 0.990;
    double index_alignment = 1.0;
    double noise_share = 0.25;  ///< of the demonstrations' noise
};

/// Where the system `stiff` differs.
struct StiffParameters {
    double extension = 0.995;
    double rest_s = 0.3;
    double raise_s = 0.7;
    double hold_s = 1.0;
    double retract_s = 0.7;
};

/// Where the system `drifting` differs.
struct DriftingParameters {
    Interval pull{0.35, 0.55};  ///< share of the way to the mean posture of the hand's demonstrations
    Interval hold_s{1.5, 2.5};
    double wander_deg = 5.0;  ///< amplitude of the slow wandering during the hold
    Interval wander_hz{0.25, 0.6};
    Interval hold_shift{0.10, 0.25};  ///< share of the way that the posture continues moving during the hold
    double jitter_rad = 0.003;        ///< SD of the unsmoothed shaking of each arm joint, per frame
    double noise_share = 1.5;
};

struct DemonstrationParameters {
    std::uint64_t library_seed = 1;
    int left_count = 25;
    int right_count = 27;
    TargetDraw targets;
    PointingLineParameters line;
    ArmPostureParameters arm;
    BodyShareParameters body;
    TimingParameters timing;
    NoiseParameters noise;
    DirectParameters direct;
    StiffParameters stiff;
    DriftingParameters drifting;
};

}  // namespace deixis::motion
