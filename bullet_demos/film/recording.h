#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "world/placed_scene.h"

namespace demo {

/// Where a body was at a moment.
struct Key {
    double time_s = 0;
    Eigen::Isometry3d placed;  ///< from its own coordinates to the world
};

/// A body, a fragment or a ball over a run.
struct Track {
    BodyState body;         ///< what it looks like; `placed` is where it was first
    std::vector<Key> keys;  ///< from its birth on, in order; at least one
    bool is_fragment = false;
    bool is_replaced = false;  ///< by its fragments, at the time of the last key

    double born_s() const { return keys.front().time_s; }
    bool isThereAt(double time_s) const;
    /// Between two keys it moves and turns evenly; after the last one it rests.
    Eigen::Isometry3d placedAt(double time_s) const;
};

/// Writes down where everything in a scene is, step by step. A break belongs to the step in which it happens:
/// fragments are born where the body was at its beginning, and the body is gone from then on.
class Recorder {
  public:
    explicit Recorder(const PlacedScene& scene) : scene_(scene) {}

    /// Takes over where all bodies are at `time_s`; `events` are those since the last call.
    void record(double time_s, const std::vector<sherd::BlowEvent>& events);
    const std::vector<Track>& tracks() const { return tracks_; }

  private:
    void add(const btRigidBody* body, const BodyState& state, double time_s);
    void extend(const btRigidBody* body, const BodyState& state, double time_s);

    const PlacedScene& scene_;
    std::vector<Track> tracks_;
    std::unordered_map<const btRigidBody*, std::size_t> present_;  ///< index into `tracks_`
    std::unordered_map<const btRigidBody*, Key> birth_keys_;       ///< of the fragments of this step
};

}  // namespace demo
