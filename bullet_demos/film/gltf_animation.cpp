#include "film/gltf_animation.h"

namespace demo {

GltfMotion::GltfMotion(const Track& track) {
    Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
    for (const Key& key : track.keys) {
        Eigen::Quaterniond turn = Eigen::Quaterniond(key.placed.linear()).normalized();
        // Neighbours lie on the same side, so that what is between them is the shorter way.
        if (turn.dot(before) < 0) turn.coeffs() = -turn.coeffs();
        before = turn;
        times.push_back(static_cast<float>(key.time_s));
        for (int axis = 0; axis < 3; ++axis)
            places.push_back(static_cast<float>(key.placed.translation()[axis]));
        for (int i = 0; i < 4; ++i) turns.push_back(static_cast<float>(turn.coeffs()[i]));
    }
}

void GltfAnimation::addMotion(int node, const GltfMotion& motion) {
    if (motion.times.size() < 2) return;
    const int times = buffer_.addFloats(motion.times, 1);
    addChannel(node, "translation", times, buffer_.addFloats(motion.places, 3), "LINEAR");
    addChannel(node, "rotation", times, buffer_.addFloats(motion.turns, 4), "LINEAR");
}

void GltfAnimation::addPresence(int node, const Track& track) {
    std::vector<float> times, sizes;
    const auto add = [&](double time_s, float size) {
        times.push_back(static_cast<float>(time_s));
        sizes.insert(sizes.end(), 3, size);
    };
    const double gone_s = track.keys.back().time_s;
    if (track.is_replaced && gone_s <= track.born_s()) return;  // never there, and its node has size 0
    if (track.born_s() > 0) add(0, 0);
    add(track.born_s(), 1);
    if (track.is_replaced) add(gone_s, 0);
    if (times.size() < 2) return;
    addChannel(node, "scale", buffer_.addFloats(times, 1), buffer_.addFloats(sizes, 3), "STEP");
}

nlohmann::ordered_json GltfAnimation::json() const {
    return {{"name", "run"}, {"samplers", samplers_}, {"channels", channels_}};
}

void GltfAnimation::addChannel(int node, const char* path, int times, int values, const char* interpolation) {
    channels_.push_back({{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", times}, {"output", values}, {"interpolation", interpolation}});
}

}  // namespace demo
