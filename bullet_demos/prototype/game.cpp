#include "prototype/game.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "viewer/conversions.h"

namespace prototype {
namespace {

constexpr int steps_between_tidying = 15, steps_until_put_back = 8 * 60;
constexpr std::size_t most_pieces = 160;  ///< that lie about
constexpr float small_piece_kg = 0.15f;

sherd::Budget gameBudget() {
    sherd::Budget budget;
    budget.milliseconds_per_step = 2;
    budget.solves_per_step = 1;
    budget.shortest_wait_s = 0.1;
    budget.fragments_per_step = 60;
    budget.fragments_alive = 400;
    return budget;
}

/// A piece has the step of its birth as its user index, a whole thing 0.
bool isPiece(const btRigidBody& body) {
    return body.getUserIndex() > 0;
}

/// What lies in a box, or touches it.
struct Inside : btBroadphaseAabbCallback {
    std::vector<btRigidBody*> bodies;
    bool process(const btBroadphaseProxy* proxy) override {
        auto* body = btRigidBody::upcast(static_cast<btCollisionObject*>(proxy->m_clientObject));
        if (body) bodies.push_back(body);
        return true;
    }
};

}  // namespace

Game::Game(ReadyLevel ready) : ready_(std::move(ready)), hall_(ready_.level) {
    if (!fracture_.setBudget(gameBudget())) std::abort();  // the figures above are possible
    fracture_.onFragment([this](sherd::FragmentBirth& birth) {
        birth.body.setUserIndex(steps_);
        birth.body.setSleepingThresholds(0.15f, 1.0f);  // rubble comes to rest soon
    });
    places_.resize(ready_.level.props.size());
    gDeactivationTime = 0.5f;  // s; Bullet's own is 2
    for (std::size_t i = 0; i < places_.size(); ++i) {
        places_[i].prop = &ready_.level.props[i];
        putThere(places_[i]);
    }
}

void Game::advance(float seconds) {
    constexpr int most_steps = 4;  // after a long frame the world goes on from where it was
    const int done = hall_.world().stepSimulation(seconds, most_steps, step_s);
    takeEvents();
    for (int i = 0; i < std::min(done, most_steps); ++i)
        if (++steps_ % steps_between_tidying == 0) {
            hall_.removeOldBalls();
            putBackWhatIsMissing();
            removeOldPieces();
        }
}

void Game::putThere(Place& place) {
    sherd::BodyOptions options(place.prop->home);
    options.user_pointer = &place;
    options.user_index = 0;
    // The asset was prepared, so it is not refused.
    place.whole = fracture_.add(ready_.assets[place.prop->kind], options).value();
    place.whole->setFriction(0.9f);
    place.whole->setRestitution(0.1f);
    place.whole->setDamping(0.05f, 0.15f);
    // What nobody touches costs nothing.
    if (!place.whole->isStaticObject()) place.whole->setActivationState(ISLAND_SLEEPING);
    place.start = place.whole->getCenterOfMassPosition();
    place.whole->getAabb(place.lo, place.hi);
    place.missing_since = -1;
}

void Game::setOffBomb(const render::Ray& ray) {
    constexpr float bang_kg = 15;  // it sounds, and is seen, as what weighs that much
    sherd::Explosion bomb;
    bomb.centre = hall_.aimOf(ray) - 0.25f * demo::toBullet(ray.direction);
    bomb.impulse_n_s = 2000;
    bomb.reach_m = 2;
    if (!sherd::explode(fracture_, bomb)) return;
    happenings_.push_back({Timbre::plaster, bomb.centre, float(bomb.impulse_n_s), bang_kg, true,
                           render::Vec3(1.0f, 0.85f, 0.6f)});
}

void Game::takeEvents() {
    for (const sherd::BlowEvent& event : fracture_.takeEvents()) {
        Place& place = placeOf(*event.body);
        const bool broke = event.outcome == sherd::Outcome::broke;
        if (broke) count(event, place);
        // Of half a sine. The impulse of Bullet's contacts also has what they push apart.
        const double pulse_n_s = 0.64 * event.peak_force_n * event.contact_time_s;
        happenings_.push_back(
            {ready_.level.kinds[place.prop->kind].timbre,
             btVector3(float(event.position.x()), float(event.position.y()), float(event.position.z())),
             float(pulse_n_s), float(event.asset.mass()), broke, place.prop->look.inside});
    }
}

void Game::count(const sherd::BlowEvent& event, Place& place) {
    const int pieces = int(event.fragments.size());
    score_.pieces += pieces;
    score_.points += pieces * ready_.level.kinds[place.prop->kind].points;
    if (event.body != place.whole) return;
    ++score_.breaks;
    score_.broken_kg += event.asset.mass();
    place.whole = nullptr;
    place.missing_since = steps_;
}

void Game::putBackWhatIsMissing() {
    constexpr float away_m = 0.06f;
    for (Place& place : places_) {
        if (place.whole) {
            const bool away = (place.whole->getCenterOfMassPosition() - place.start).length() > away_m;
            if (!away)
                place.missing_since = -1;
            else if (place.missing_since < 0)
                place.missing_since = steps_;
        }
        if (place.missing_since < 0 || steps_ - place.missing_since < steps_until_put_back) continue;
        if (!makeRoom(place)) continue;
        if (place.whole) fracture_.remove(place.whole);
        putThere(place);
    }
}

/// Takes pieces and balls out of the place; false: another whole thing lies there.
bool Game::makeRoom(Place& place) {
    Inside inside;
    hall_.world().getBroadphase()->aabbTest(place.lo, place.hi, inside);
    for (const btRigidBody* body : inside.bodies)
        for (const Place& other : places_)
            if (&other != &place && other.whole == body && other.missing_since >= 0) return false;
    for (btRigidBody* body : inside.bodies) {
        body->activate();
        if (isPiece(*body) && fracture_.asset(body)) fracture_.remove(body);
        hall_.removeBall(body);
    }
    // What its supports hold still would stay in its place for ever.
    for (btRigidBody* body : fracture_.bodies())
        if (isPiece(*body) && body->isStaticObject() && &placeOf(*body) == &place) fracture_.remove(body);
    return true;
}

void Game::removeOldPieces() {
    std::vector<btRigidBody*> pieces;
    for (btRigidBody* body : fracture_.bodies())
        if (isPiece(*body) && !body->isStaticObject()) pieces.push_back(body);
    if (pieces.size() <= most_pieces) return;
    // Large pieces stay ten seconds longer than small ones.
    const auto age = [](const btRigidBody* body) {
        return body->getUserIndex() + (body->getMass() > small_piece_kg ? 10 * 60 : 0);
    };
    const auto last = pieces.end() - std::ptrdiff_t(most_pieces);
    std::nth_element(pieces.begin(), last, pieces.end(),
                     [&](const btRigidBody* a, const btRigidBody* b) { return age(a) < age(b); });
    std::for_each(pieces.begin(), last, [this](btRigidBody* piece) { fracture_.remove(piece); });
}

}  // namespace prototype
