#include "figure.hpp"

#include "shapes.hpp"

namespace deixis::avatar_maker {

namespace {

using glm::vec3;

// Everything but the hair is the same on both sides, so the bodies are those of the left (+x).

// ---- clothes ----

double sweater(const Vec3& p) {
    static const Loft trunk(1, 0, 2, 0.25, 0.02,
                            {{0.872, 0, -0.004, 0.167, 0.112, 0.130},
                             {0.885, 0, -0.004, 0.171, 0.115, 0.134},
                             {0.905, 0, -0.004, 0.170, 0.115, 0.131},
                             {0.960, 0, -0.004, 0.163, 0.110, 0.117},
                             {1.030, 0, -0.004, 0.151, 0.105, 0.100},
                             {1.090, 0, -0.006, 0.147, 0.104, 0.096},
                             {1.160, 0, -0.008, 0.151, 0.110, 0.101},
                             {1.240, 0, -0.010, 0.158, 0.117, 0.109},
                             {1.310, 0, -0.012, 0.160, 0.113, 0.112},
                             {1.370, 0, -0.014, 0.142, 0.092, 0.104},
                             {1.410, 0, -0.018, 0.104, 0.064, 0.084},
                             {1.438, 0, -0.021, 0.068, 0.047, 0.064},
                             {1.460, 0, -0.022, 0.052, 0.040, 0.052}});
    static const Loft sleeve(0, 1, 2, 0.0, 0.008,
                             {{0.140, 1.383, -0.016, 0.047, 0.052, 0.052},
                              {0.190, 1.384, -0.016, 0.048, 0.053, 0.053},
                              {0.250, 1.386, -0.016, 0.047, 0.050, 0.050},
                              {0.330, 1.388, -0.015, 0.046, 0.047, 0.048},
                              {0.420, 1.389, -0.015, 0.045, 0.045, 0.046},
                              {0.470, 1.390, -0.015, 0.044, 0.043, 0.046},
                              {0.530, 1.390, -0.014, 0.045, 0.046, 0.045},
                              {0.600, 1.390, -0.014, 0.040, 0.042, 0.040},
                              {0.650, 1.390, -0.014, 0.036, 0.038, 0.037},
                              {0.672, 1.390, -0.014, 0.0345, 0.037, 0.036}});
    const double chest = ellipsoid(p, {0.072, 1.290, 0.046}, {0.078, 0.070, 0.054});
    const double shoulder_blade = ellipsoid(p, {0.080, 1.320, -0.080}, {0.062, 0.080, 0.040});
    const double deltoid = ellipsoid(p, {0.173, 1.381, -0.016}, {0.057, 0.048, 0.053});
    const double trapezius = roundCone(p, {0.028, 1.434, -0.036}, {0.150, 1.388, -0.020}, 0.032, 0.038);
    double d = trunk(p);
    d = blend(d, chest, 0.05);
    d = blend(d, shoulder_blade, 0.05);
    d = blend(d, trapezius, 0.05);
    const double arm = blend(sleeve(p), deltoid, 0.04);
    return blend(d, arm, 0.045);
}

/// Ribbed ends of the sweater: collar, cuffs, hem.
double trim(const Vec3& p) {
    static const Vec3 collar_axis = glm::normalize(Vec3(0, 0.955, 0.297));
    double collar = torus(p, {0, 1.4580, -0.0210}, collar_axis, 0.0575, 0.0100);
    collar = blend(collar, torus(p, {0, 1.4715, -0.0195}, collar_axis, 0.0550, 0.0090), 0.008);
    static const Loft cuff(0, 1, 2, 0.0, 0.008,
                           {{0.664, 1.390, -0.014, 0.0365, 0.0385, 0.0375},
                            {0.680, 1.390, -0.0145, 0.0355, 0.0375, 0.0365},
                            {0.704, 1.390, -0.015, 0.0325, 0.0355, 0.0345}});
    return std::min(collar, cuff(p));
}

double trousers(const Vec3& p) {
    static const Loft seat(1, 0, 2, 0.2, 0.03,
                           {{0.800, 0, -0.004, 0.150, 0.090, 0.100},
                            {0.860, 0, -0.004, 0.162, 0.102, 0.110},
                            {0.920, 0, -0.004, 0.158, 0.102, 0.106},
                            {0.980, 0, -0.004, 0.140, 0.095, 0.095}});
    static const Loft leg(1, 0, 2, 0.05, 0.012,
                          {{0.062, 0.101, -0.024, 0.050, 0.058, 0.052},
                           {0.090, 0.101, -0.025, 0.050, 0.055, 0.053},
                           {0.150, 0.100, -0.022, 0.049, 0.050, 0.053},
                           {0.240, 0.099, -0.014, 0.051, 0.050, 0.060},
                           {0.330, 0.098, -0.006, 0.055, 0.053, 0.066},
                           {0.400, 0.097, 0.000, 0.056, 0.056, 0.064},
                           {0.460, 0.096, 0.004, 0.056, 0.059, 0.058},
                           {0.510, 0.095, 0.006, 0.058, 0.062, 0.058},
                           {0.600, 0.094, 0.004, 0.067, 0.069, 0.069},
                           {0.700, 0.092, 0.002, 0.076, 0.079, 0.081},
                           {0.790, 0.089, 0.000, 0.081, 0.086, 0.092},
                           {0.870, 0.086, -0.002, 0.080, 0.088, 0.096},
                           {0.930, 0.082, -0.002, 0.072, 0.080, 0.085}});
    const double glutes = ellipsoid(p, {0.074, 0.860, -0.048}, {0.078, 0.072, 0.062});
    const double hips = blend(seat(p), glutes, 0.04);
    return blend(hips, leg(p), 0.03);
}

double shoes(const Vec3& p) {
    const double heel = ellipsoid(p, {0.100, 0.030, -0.042}, {0.038, 0.062, 0.048});
    const double collar = ellipsoid(p, {0.100, 0.070, -0.026}, {0.037, 0.036, 0.046});
    const double instep = roundCone(p, {0.101, 0.056, -0.008}, {0.107, 0.026, 0.100}, 0.038, 0.034);
    const double toes = ellipsoid(p, {0.109, 0.012, 0.112}, {0.046, 0.044, 0.064});
    const double waist = roundCone(p, {0.101, 0.014, -0.040}, {0.107, 0.014, 0.100}, 0.033, 0.040);
    double d = blend(blend(heel, waist, 0.02), instep, 0.03);
    d = blend(d, collar, 0.02);
    d = blend(d, toes, 0.04);
    return d;
}

// ---- hand ----

struct Finger {
    Vec3 knuckle, middle, last, tip;
    double radius;  // at the knuckle
    Vec3 wrist;     // where its metacarpal starts
};

double finger(const Vec3& p, const Finger& f) {
    const double r = f.radius;
    const Vec3 end = f.tip - glm::normalize(f.tip - f.last) * (0.76 * r);
    double d = roundCone(p, f.knuckle, f.middle, r * 1.02, r * 0.95);
    d = blend(d, roundCone(p, f.middle, f.last, r * 0.97, r * 0.87), 0.003);
    return blend(d, roundCone(p, f.last, end, r * 0.89, r * 0.76), 0.003);
}

double hand(const Vec3& p) {
    static const Finger fingers[] = {
        {{0.818, 1.388, 0.013},
         {0.862, 1.388, 0.016},
         {0.889, 1.388, 0.018},
         {0.912, 1.387, 0.020},
         0.0096,
         {0.745, 1.389, 0.001}},
        {{0.822, 1.390, -0.010},
         {0.870, 1.390, -0.010},
         {0.900, 1.390, -0.010},
         {0.924, 1.389, -0.010},
         0.0098,
         {0.745, 1.391, -0.010}},
        {{0.817, 1.388, -0.031},
         {0.861, 1.388, -0.034},
         {0.889, 1.388, -0.036},
         {0.912, 1.387, -0.038},
         0.0092,
         {0.745, 1.390, -0.021}},
        {{0.808, 1.384, -0.050},
         {0.842, 1.384, -0.055},
         {0.863, 1.384, -0.058},
         {0.883, 1.383, -0.061},
         0.0081,
         {0.745, 1.388, -0.029}},
    };
    static const Loft wrist(0, 1, 2, 0.0, 0.01,
                            {{0.660, 1.390, -0.015, 0.0240, 0.0285, 0.0280},
                             {0.700, 1.390, -0.015, 0.0220, 0.0275, 0.0270},
                             {0.730, 1.389, -0.015, 0.0205, 0.0275, 0.0270},
                             {0.760, 1.388, -0.014, 0.0180, 0.0290, 0.0280}});
    double palm = wrist(p);
    for (const Finger& f : fingers) {
        const Vec3 under(0, -0.003, 0);
        palm = blend(palm, roundCone(p, f.wrist + under, f.knuckle + under * 0.7, 0.0150, f.radius + 0.0022),
                     0.012);
    }
    palm = blend(palm, ellipsoid(p, {0.772, 1.378, 0.006}, {0.030, 0.013, 0.017}), 0.012);  // thenar
    palm = blend(palm, ellipsoid(p, {0.772, 1.378, -0.037}, {0.030, 0.012, 0.014}), 0.012);

    const Vec3 metacarpal(0.747, 1.378, 0.006), proximal(0.779, 1.368, 0.034), distal(0.805, 1.362, 0.054);
    const Vec3 tip(0.828, 1.357, 0.071);
    const Vec3 thumb_end = tip - glm::normalize(tip - distal) * 0.0085;
    double thumb = roundCone(p, metacarpal, proximal, 0.0150, 0.0118);
    thumb = blend(thumb, roundCone(p, proximal, distal, 0.0116, 0.0105), 0.004);
    thumb = blend(thumb, roundCone(p, distal, thumb_end, 0.0108, 0.0086), 0.004);

    // Each finger grows out of the palm, but neighbours never melt into one another.
    double d = blend(palm, thumb, 0.014);
    for (const Finger& f : fingers) d = std::min(d, blend(palm, finger(p, f), 0.007));
    return d;
}

// ---- head ----

const Vec3 eye(0.031, 1.622, 0.068);  // as the joint leftEye

double face(const Vec3& p, bool eyes_open) {
    double d = ellipsoid(p, {0, 1.650, -0.012}, {0.074, 0.090, 0.093});
    d = blend(d, leaningEllipsoid(p, {0, 1.596, 0.022}, {0.058, 0.080, 0.065}, 0.08), 0.03);
    d = blend(d, roundCone(p, {0.035, 1.568, 0.008}, {0.008, 1.538, 0.064}, 0.020, 0.0185), 0.028);
    d = blend(d, ellipsoid(p, {0.035, 1.594, 0.053}, {0.024, 0.021, 0.025}), 0.02);  // cheek
    d = blend(d, ellipsoid(p, {0.033, 1.572, 0.040}, {0.025, 0.028, 0.032}), 0.02);
    d = blend(d, ellipsoid(p, {0, 1.531, 0.073}, {0.016, 0.013, 0.013}), 0.018);                     // chin
    d = blend(d, roundCone(p, {0.010, 1.650, 0.074}, {0.046, 1.648, 0.058}, 0.0105, 0.0105), 0.02);  // brow
    d = blend(d, roundCone(p, {0.050, 1.643, 0.052}, {0.050, 1.606, 0.052}, 0.0110, 0.0120), 0.014);
    d = carve(d, ellipsoid(p, {0.030, 1.622, 0.099}, {0.022, 0.0155, 0.0175}), 0.016);  // eye socket
    d = blend(d, glm::length(p - eye) - (eyeball_radius_m + 0.0009), 0.005);            // lids
    if (!eyes_open) return d;
    // Their opening is a little larger than that of makeLids(), which draws the sharp border.
    const double dx = (p.x - eye.x) / 0.0159;
    const double dy = (p.y - eye.y - 0.06 * (p.x - eye.x)) / (p.y > eye.y ? 0.0103 : 0.0083);
    const double opening = (std::sqrt(dx * dx + dy * dy) - 1.0) * 0.010;
    return carve(d, std::max(opening, eye.z - p.z), 0.001);
}

double nose(const Vec3& p) {
    double d = roundCone(p, {0, 1.640, 0.075}, {0, 1.590, 0.097}, 0.0078, 0.0095);
    d = blend(d, ellipsoid(p, {0, 1.587, 0.099}, {0.0108, 0.0098, 0.0108}), 0.008);
    return blend(d, ellipsoid(p, {0.0100, 1.5855, 0.0890}, {0.0075, 0.0070, 0.0095}), 0.008);
}

/// The lips as a patch of the face: 1 in the middle of each lip, 0 at its border and at the mouth's line.
struct Mouth {
    double half_width = 0.0245;
    [[nodiscard]] double line(double t) const { return 1.5515 + 0.0030 * t * t; }
    [[nodiscard]] double upper(double t) const { return (1.0 - t * t) * 0.0052 + 0.0004; }
    [[nodiscard]] double lower(double t) const { return (1.0 - t * t) * 0.0072 + 0.0004; }
};

/// Height above the mouth's line as a fraction of the lip's thickness there: -1 at the lower border, 1 at the
/// upper; beyond them outside.
double lipHeight(const Vec3& p) {
    constexpr Mouth mouth;
    const double t = std::min(p.x / mouth.half_width, 1.0);
    const double dy = p.y - mouth.line(t);
    return dy > 0.0 ? dy / mouth.upper(t) : dy / mouth.lower(t);
}

double lipRelief(const Vec3& p) {
    if (p.z < 0.05 || std::abs(p.y - 1.552) > 0.03) return 0.0;
    const double t = std::min(p.x / Mouth{}.half_width, 1.0);
    const double h = lipHeight(p);
    const double bulge = smoothStep(1.35, 0.5, std::abs(h)) * smoothStep(0.0, 0.35, std::abs(h));
    return (1.0 - t * t) * 0.0026 * bulge;
}

double ear(const Vec3& p) {
    const Vec3 q(p.x + 0.12 * (p.z + 0.014), p.y, p.z);
    const double d = leaningEllipsoid(q, {0.0750, 1.610, -0.014}, {0.0078, 0.0275, 0.0165}, 0.18);
    return carve(d, ellipsoid(q, {0.0835, 1.612, -0.011}, {0.0060, 0.0165, 0.0095}), 0.005);
}

double headSkin(const Vec3& p, bool eyes_open) {
    double d = face(p, eyes_open);
    d = blend(d, nose(p), 0.010) - lipRelief(p);
    d = blend(d, ear(p), 0.006);
    const double neck = roundCone(p, {0, 1.420, -0.024}, {0, 1.560, -0.014}, 0.0520, 0.0480);
    return blend(d, neck, 0.025);
}

/// Locks combed back from the forehead: a wave around the head's length.
double hairGrooves(const Vec3& p) {
    const double x = p.x - 0.012;
    const double y = p.y - 1.655;
    const double around = x / (std::abs(x) + std::abs(y) + 1e-3);  // about as an angle
    const double turned = 7.0 * around + 9.0 * p.z;
    const double wave = std::abs(turned - 2.0 * std::floor(0.5 * turned + 0.5));  // 0 to 1 and back
    return 0.0022 * smoothStep(0.0, 1.0, wave) * smoothStep(1.665, 1.715, p.y) * smoothStep(-0.08, 0.0, p.z);
}

double hair(const Vec3& p, const Vec3& left) {
    double d = ellipsoid(left, {0, 1.670, -0.014}, {0.0785, 0.0790, 0.0990});
    d = blend(d, ellipsoid(left, {0, 1.630, -0.030}, {0.0730, 0.0750, 0.0800}), 0.03);
    const double forelock = roundCone(p, {0.034, 1.716, 0.040}, {-0.044, 1.706, 0.042}, 0.024, 0.024);
    d = blend(d, forelock, 0.02) + hairGrooves(p);
    const double open = ellipsoid(p, {-0.004, 1.594, 0.108}, {0.0660, 0.0900, 0.0980});
    d = carve(d, open, 0.008);
    const double below = 1.580 - left.y + 0.30 * (left.z + 0.07);
    d = common(d, below, 0.014);
    const double ear_room = ellipsoid(left, {0.082, 1.600, -0.008}, {0.024, 0.034, 0.024});
    return carve(d, ear_room, 0.014);
}

double brows(const Vec3& p) {
    const Vec3 inner(0.0165, 1.6550, 0.0864), arch(0.0320, 1.6578, 0.0805), outer(0.0495, 1.6520, 0.0665);
    return blend(roundCone(p, inner, arch, 0.0027, 0.0030), roundCone(p, arch, outer, 0.0030, 0.0012), 0.002);
}

struct Parts {
    double skin, hair, sweater, trim, trousers, shoes;
};

Parts parts(const Vec3& p, bool eyes_open = true) {
    const Vec3 left(std::abs(p.x), p.y, p.z);
    constexpr double far = 1.0;
    Parts d{far, far, far, far, far, far};
    // Only bodies near enough to matter; the bounds are wider than the blends.
    if (left.x < 0.2 && p.y > 1.38) d.skin = headSkin(left, eyes_open);
    if (left.x > 0.55) d.skin = std::min(d.skin, hand(left));
    if (left.x < 0.25 && p.y > 1.45) d.hair = std::min(hair(p, left), brows(left));
    if (p.y > 0.75) d.sweater = sweater(left);
    if (p.y > 1.2) d.trim = trim(left);
    if (left.x < 0.4 && p.y < 1.1) d.trousers = trousers(left);
    if (p.y < 0.3) d.shoes = common(shoes(left), -p.y, 0.006);
    return d;
}

}  // namespace

double materialDistance(const Vec3& p, Material material) {
    const Parts d = parts(p, false);
    switch (material) {
        case Material::skin:
        case Material::lips:
        case Material::mouth:
            return d.skin;
        case Material::hair:
            return d.hair;
        case Material::sweater:
            return d.sweater;
        case Material::trim:
            return d.trim;
        case Material::trousers:
            return d.trousers;
        case Material::shoes:
        case Material::soles:
            return d.shoes;
    }
    return d.skin;
}

double figureDistance(const Vec3& p) {
    const Parts d = parts(p);
    double all = blend(d.skin, d.hair, 0.004);
    all = blend(all, blend(d.sweater, d.trim, 0.004), 0.003);
    all = blend(all, d.trousers, 0.003);
    return blend(all, d.shoes, 0.003);
}

Material figureMaterial(const Vec3& p) {
    const Parts d = parts(p);
    const std::array<std::pair<double, Material>, 6> all{{{d.skin, Material::skin},
                                                          {d.hair, Material::hair},
                                                          {d.sweater, Material::sweater},
                                                          {d.trim, Material::trim},
                                                          {d.trousers, Material::trousers},
                                                          {d.shoes, Material::shoes}}};
    auto nearest = all[0];
    for (const auto& entry : all)
        if (entry.first < nearest.first) nearest = entry;
    if (nearest.second == Material::skin) {
        const Vec3 left(std::abs(p.x), p.y, p.z);
        const Mouth mouth;
        if (left.x < mouth.half_width && p.z > 0.05 && std::abs(lipHeight(left)) < 1.0) {
            const double t = left.x / mouth.half_width;
            return std::abs(p.y - mouth.line(t)) < 0.0008 + 0.0003 * t ? Material::mouth : Material::lips;
        }
    }
    if (nearest.second == Material::shoes && p.y < 0.018) return Material::soles;
    return nearest.second;
}

vec3 materialColour(Material material) {
    switch (material) {
        case Material::skin:
            return {0.546F, 0.275F, 0.156F};
        case Material::lips:
            return {0.420F, 0.150F, 0.100F};
        case Material::mouth:
            return {0.110F, 0.030F, 0.022F};
        case Material::hair:
            return {0.040F, 0.023F, 0.015F};
        case Material::sweater:
            return {0.034F, 0.216F, 0.223F};
        case Material::trim:
            return {0.023F, 0.150F, 0.160F};
        case Material::trousers:
            return {0.036F, 0.043F, 0.068F};
        case Material::shoes:
            return {0.300F, 0.270F, 0.235F};
        case Material::soles:
            return {0.730F, 0.710F, 0.670F};
    }
    return vec3(1.0F);
}

}  // namespace deixis::avatar_maker
