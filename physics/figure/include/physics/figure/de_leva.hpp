// Masses and inertias of a person's segments: de Leva (1996), "Adjustments to Zatsiorsky-Seluyanov's segment
// inertia parameters", J. Biomechanics 29(9):1223-1230, table 4, the mean of its men (73.0 kg, 1.741 m) and
// women (61.9 kg, 1.735 m).
//
// Percent; centres of mass from the first end that is named, radii of gyration of the length between both
// ends, about the front-to-back, side-to-side and lengthwise axis. Women / men:
//
//   segment, ends                    mass          centre of mass  front-back   side-side    lengthwise
//   head: vertex, 7th cervical       6.68 / 6.94   48.41 / 50.02   27.1 / 30.3  29.5 / 31.5  26.1 / 26.1
//   upper trunk: C7, xiphoid        15.45 / 15.96  50.50 / 50.66   46.6 / 50.5  31.4 / 32.0  44.9 / 46.5
//   middle trunk: xiphoid, navel    14.65 / 16.33  45.12 / 45.02   43.3 / 48.2  35.4 / 38.3  41.5 / 46.8
//   lower trunk: navel, mid hips    12.47 / 11.17  49.20 / 61.15   43.3 / 61.5  40.2 / 55.1  44.4 / 58.7
//   upper arm: shoulder, elbow       2.55 / 2.71   57.54 / 57.72   27.8 / 28.5  26.0 / 26.9  14.8 / 15.8
//   forearm: elbow, wrist            1.38 / 1.62   45.59 / 45.74   26.1 / 27.6  25.7 / 26.5   9.4 / 12.1
//   hand: wrist, 3rd metacarpal      0.56 / 0.61   74.74 / 79.00   53.1 / 62.8  45.4 / 51.3  33.5 / 40.1
//   thigh: hip, knee                14.78 / 14.16  36.12 / 40.95   36.9 / 32.9  36.4 / 32.9  16.2 / 14.9
//   shank: knee, ankle               4.81 / 4.33   43.52 / 43.95   26.7 / 25.1  26.3 / 24.6   9.2 / 10.2
//   foot: heel, toe tip              1.29 / 1.37   40.14 / 44.15   29.9 / 25.7  27.9 / 24.5  13.9 / 12.4
#pragma once

#include <glm/mat3x3.hpp>

#include "core/pose.hpp"

namespace deixis::physics {

enum class BodyPart : unsigned char {
    head,
    upper_trunk,
    middle_trunk,
    lower_trunk,
    upper_arm,
    forearm,
    hand,
    thigh,
    shank,
    foot,
};

/// Shares, not percent.
struct PartParameters {
    double mass_share = 0.0;  ///< of the whole body's
    double centre_share = 0.0;
    Vec3 radii_of_gyration{0.0};  ///< about the front-to-back, side-to-side and lengthwise axis
};
[[nodiscard]] PartParameters partParameters(BodyPart part);

/// Lengths that a skeleton does not show, of stature (the same table): vertex to C7, wrist to third
/// metacarpal, heel to toe tip.
constexpr double head_length_share = 0.1400;
constexpr double hand_length_share = 0.0472;
constexpr double foot_length_share = 0.1399;
/// Of the line from C7 to the middle of the hips.
constexpr double upper_trunk_share = 0.3861;
constexpr double middle_trunk_share = 0.3456;

/// A person of that stature, as heavy for it as the mean of the table's men and women: 22.32 kg/m^2.
[[nodiscard]] double bodyMass(double stature_m);

/// What a rigid body needs: mass, its centre, and the inertia about it, in the axes in which the centre is
/// given.
struct MassProperties {
    double mass_kg = 0.0;
    Vec3 centre_m{0.0};
    glm::dmat3 inertia_kg_m2{0.0};
};

/// A part between its two ends; `front` is about the direction in which the body faces.
[[nodiscard]] MassProperties massOf(BodyPart part, double body_mass_kg, const Vec3& first_end,
                                    const Vec3& other_end, const Vec3& front);

/// Both as one rigid body, by the parallel axis theorem.
[[nodiscard]] MassProperties together(const MassProperties& a, const MassProperties& b);

}  // namespace deixis::physics
