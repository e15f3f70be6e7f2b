#pragma once

#include <utility>
#include <vector>

#include "prototype/baking.h"
#include "prototype/hall.h"

namespace prototype {

/// What the player has done so far.
struct Score {
    int points = 0, pieces = 0, breaks = 0;
    double broken_kg = 0;  ///< of things that were whole
};

/// A blow or a bang: what is heard, and seen as dust where something shatters.
struct Happening {
    Timbre timbre = Timbre::plaster;
    btVector3 position = btVector3(0, 0, 0);
    float impulse_n_s = 0, mass_kg = 0;
    bool shatters = false;
    render::Vec3 colour = render::Vec3::Ones();  ///< of what is inside
};

/// The rules: balls break things, pieces count, and after a while things stand in their places again.
class Game {
  public:
    static constexpr float step_s = 1.0f / 60;

    explicit Game(ReadyLevel ready);

    /// Moves on by a part of a second, in steps of a sixtieth; what is drawn lies between them.
    void advance(float seconds);
    void throwBall(const render::Ray& ray) { hall_.throwBall(ray); }
    /// Sets off a bomb before what the ray meets.
    void setOffBomb(const render::Ray& ray);

    const Level& level() const { return ready_.level; }
    Hall& hall() { return hall_; }
    const Score& score() const { return score_; }
    int steps() const { return steps_; }
    /// What has happened since the last call.
    std::vector<Happening> takeHappenings() { return std::exchange(happenings_, {}); }
    sherd::FractureWorld& fracture() { return fracture_; }
    /// How a thing or a piece of one is to be drawn.
    const render::Material& lookOf(const btRigidBody& body) const { return placeOf(body).prop->look; }

  private:
    /// The place of a thing; the thing and all its pieces have it as their user pointer.
    struct Place {
        const Prop* prop = nullptr;
        btRigidBody* whole = nullptr;          ///< none: it is in pieces
        btVector3 start = btVector3(0, 0, 0);  ///< of the centre of mass
        btVector3 lo = btVector3(0, 0, 0), hi = btVector3(0, 0, 0);
        int missing_since = -1;  ///< step; -1: it stands where it should
    };

    static Place& placeOf(const btRigidBody& body) { return *static_cast<Place*>(body.getUserPointer()); }
    void putThere(Place& place);
    bool makeRoom(Place& place);
    void takeEvents();
    void count(const sherd::BlowEvent& event, Place& place);
    void putBackWhatIsMissing();
    void removeOldPieces();

    ReadyLevel ready_;
    Hall hall_;
    sherd::FractureWorld fracture_{&hall_.world()};  ///< goes before the world
    std::vector<Place> places_;
    std::vector<Happening> happenings_;
    Score score_;
    int steps_ = 1;
};

}  // namespace prototype
