#include "film/recording.h"

#include <algorithm>
#include <iterator>

namespace demo {
namespace {

bool areSame(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
    return a.matrix() == b.matrix();
}

Eigen::Isometry3d between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double part) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(from.linear()).slerp(part, Eigen::Quaterniond(to.linear()));
    Eigen::Isometry3d placed = Eigen::Isometry3d::Identity();
    placed.linear() = turn.normalized().toRotationMatrix();
    placed.translation() = (1 - part) * from.translation() + part * to.translation();
    return placed;
}

}  // namespace

bool Track::isThereAt(double time_s) const {
    return time_s >= born_s() && !(is_replaced && time_s >= keys.back().time_s);
}

Eigen::Isometry3d Track::placedAt(double time_s) const {
    const auto next = std::upper_bound(keys.begin(), keys.end(), time_s,
                                       [](double time, const Key& key) { return time < key.time_s; });
    if (next == keys.begin()) return keys.front().placed;
    const Key& before = *std::prev(next);
    if (next == keys.end()) return before.placed;
    return between(before.placed, next->placed, (time_s - before.time_s) / (next->time_s - before.time_s));
}

void Recorder::record(double time_s, const std::vector<sherd::BlowEvent>& events) {
    birth_keys_.clear();
    for (const sherd::BlowEvent& event : events) {
        if (event.outcome != sherd::Outcome::broke) continue;
        // Fragments have the coordinates of the body that they come from.
        Key birth;
        if (const auto parent = present_.find(event.body); parent != present_.end()) {
            Track& track = tracks_[parent->second];
            track.is_replaced = true;
            birth = track.keys.back();
            present_.erase(parent);
        } else if (const auto born = birth_keys_.find(event.body); born != birth_keys_.end()) {
            birth = born->second;  // in this step, too
        } else {
            continue;
        }
        for (const btRigidBody* fragment : event.fragments) birth_keys_[fragment] = birth;
    }
    const std::vector<BodyState> states = scene_.states();
    std::size_t next = 0;
    for (const btRigidBody* body : scene_.fracture().bodies()) extend(body, states[next++], time_s);
    for (const PlacedBall& ball : scene_.balls()) extend(ball.body, states[next++], time_s);
}

void Recorder::add(const btRigidBody* body, const BodyState& state, double time_s) {
    present_[body] = tracks_.size();
    Track track{state, {}};
    if (const auto birth = birth_keys_.find(body); birth != birth_keys_.end()) {
        track.is_fragment = true;
        track.body.placed = birth->second.placed;
        track.keys.push_back(birth->second);
    }
    track.keys.push_back({time_s, state.placed});
    tracks_.push_back(std::move(track));
}

void Recorder::extend(const btRigidBody* body, const BodyState& state, double time_s) {
    const auto known = present_.find(body);
    if (known == present_.end()) return add(body, state, time_s);
    std::vector<Key>& keys = tracks_[known->second].keys;
    // What rests needs two keys only: the first and the last.
    if (keys.size() > 1 && areSame(keys[keys.size() - 2].placed, keys.back().placed) &&
        areSame(keys.back().placed, state.placed)) {
        keys.back().time_s = time_s;
    } else {
        keys.push_back({time_s, state.placed});
    }
}

}  // namespace demo
