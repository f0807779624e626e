#include "motion/unit_gestures/gesture_variation.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

Vec3 placeOf(const ChannelValues& hand) {
    return {hand[0], hand[1], hand[2]};
}

Vec3 middleOf(const UnitGesture& gesture, std::size_t channel) {
    Vec3 sum(0.0);
    double count = 0.0;
    for (const UnitKey& key : gesture.keys)
        if (key.channels[channel]) {
            sum += placeOf(*key.channels[channel]);
            count += 1.0;
        }
    return count > 0.0 ? sum / count : sum;
}

}  // namespace

UnitGesture varied(const UnitGesture& gesture, double size, const Vec3& move) {
    constexpr double nearest = 0.37, farthest = 0.985;
    UnitGesture out = gesture;
    for (std::size_t c = 0; c < channel_count; ++c) {
        const bool hand = isHand(static_cast<Channel>(c));
        const Vec3 middle = hand ? middleOf(gesture, c) : Vec3(0.0);
        for (UnitKey& key : out.keys) {
            if (!key.channels[c]) continue;
            ChannelValues& values = *key.channels[c];
            if (!hand) {
                for (double& angle : values) angle *= size;
                continue;
            }
            Vec3 place = middle + size * (placeOf(values) - middle) + move;
            const double reach = glm::length(place);
            if (reach > 0.0) place *= std::clamp(reach, nearest, farthest) / reach;
            values = {place.x, place.y, place.z, values[3]};
        }
    }
    return out;
}

UnitGesture smallNod(double depth_deg) {
    constexpr double down_s = 0.22, back_s = 0.5;
    UnitGesture gesture;
    gesture.id = "small_nod";
    gesture.name = "Small nod";
    gesture.gesture_class = GestureClass::beat;
    gesture.meaning = "A stress by the head";
    gesture.keys.resize(3);
    gesture.keys[1] = {down_s, GesturePhase::stroke, false, {}};
    gesture.keys[1].channels[indexOf(Channel::head)] = ChannelValues{0.0, depth_deg, 0.0, 0.0};
    gesture.keys[2] = {back_s, GesturePhase::retraction, false, {}};
    return gesture;
}

}  // namespace deixis::motion
