#pragma once

#include <cstddef>

namespace sherd {

// Wall-clock times in milliseconds. No time is counted in two fields, so they may be added up. Reports list
// them by `time_fields`; a new field is a line in its struct and a line there.

/// What the stages of one blow took; 0 where a stage was not needed.
struct StageTimes {
    double gate = 0;       ///< whether the energy of the blow can break the body at all
    double coarse = 0;     ///< a first look at a fragment's blow on a coarse grid, all of it
    double sample = 0;     ///< particles and cells of a body that is not sampled yet
    double assemble = 0;   ///< the stress problem of a body that is not prepared yet, and of each damage wave
    double factor = 0;     ///< its factor
    double loads = 0;      ///< from contacts to forces on the surface, and what the supports answer to them
    double solve = 0;      ///< the linear solve
    double stress = 0;     ///< the stress of its solution, free of traction where the surface is free
    double damage = 0;     ///< strengths of the particles, and which of them fail
    double cluster = 0;    ///< the fragment that each particle belongs to
    double surface = 0;    ///< cutting the fragments out of the surface
    double fragments = 0;  ///< their solids: mass, boxes, errors of conservation
    double bodies = 0;     ///< their rigid bodies and collision shapes
    double swap = 0;       ///< taking the broken body out of the world and putting the fragments in; what the
                           ///< app's callbacks do meanwhile is included
    double check = 0;      ///< the full solve of FractureSettings::check_with_full_solve

    double total() const;  ///< sum of all fields
    StageTimes& operator+=(const StageTimes& more);
    StageTimes& operator-=(const StageTimes& less);
};

/// What belongs to no single blow, over all steps.
struct StepTimes {
    double sync = 0;      ///< which bodies came and went; removals and events
    double release = 0;   ///< deleting broken bodies that nobody needs any more
    double snapshot = 0;  ///< a copy of all that the solve will change
    double overlaps = 0;  ///< contacts of fragments: where they are born, and so that they come to rest
    double ground = 0;    ///< keeping fragments on their side of meshes and height fields
    double sweep = 0;     ///< continuous collision among fragments
    double contacts = 0;  ///< gathering the contacts of breakable bodies, vertices that Bullet lacks included
    double restore = 0;   ///< finding the islands of broken bodies, and setting them back to before the solve
    double resolve = 0;   ///< contacts of the fragments, and solving their islands once more, by Bullet
    double waiting = 0;   ///< choosing the blows that wait (Budget), and waiting for other threads
    double foresight = 0;  ///< following what flies (Budget::foresight_s), on the thread that steps

    double total() const;  ///< sum of all fields
};

/// What a FractureWorld took since it was made, in steps, applyBlow and explode. Stages count when their blow
/// is decided, which may be steps after they were done: what one step took is the growth of `whole`.
struct WorldTimes {
    StageTimes blows;  ///< of all blows, those without an event included, on the thread that steps
    /// The same on other threads, without what was foreseen in vain; no part of `whole`.
    StageTimes workers;
    StepTimes steps;
    /// Everything, by a stopwatch of its own: `stages()`, and the little between the stages. What a step
    /// takes beyond the growth of this is Bullet's own part of it.
    double whole = 0;
    /// Bullet's own solve of the steps, a part of its part. With several FractureWorlds in one world, the
    /// work of those within is included.
    double bullet_solve = 0;

    double stages() const;  ///< sum of all fields of `blows` and `steps`
};

/// A field of a struct of times.
template <class Times>
struct TimeField {
    const char* name;
    double Times::*value;
};

/// The fields of a struct of times, `time_fields<StageTimes>`: an array of TimeField.
template <class Times>
inline constexpr std::nullptr_t time_fields = nullptr;

/// In the order of the pipeline.
template <>
inline constexpr TimeField<StageTimes> time_fields<StageTimes>[] = {
    {"gate", &StageTimes::gate},       {"coarse", &StageTimes::coarse},
    {"sample", &StageTimes::sample},   {"assemble", &StageTimes::assemble},
    {"factor", &StageTimes::factor},   {"loads", &StageTimes::loads},
    {"solve", &StageTimes::solve},     {"stress", &StageTimes::stress},
    {"damage", &StageTimes::damage},   {"cluster", &StageTimes::cluster},
    {"surface", &StageTimes::surface}, {"fragments", &StageTimes::fragments},
    {"bodies", &StageTimes::bodies},   {"swap", &StageTimes::swap},
    {"check", &StageTimes::check},
};

template <>
inline constexpr TimeField<StepTimes> time_fields<StepTimes>[] = {
    {"sync", &StepTimes::sync},           {"release", &StepTimes::release},
    {"snapshot", &StepTimes::snapshot},   {"overlaps", &StepTimes::overlaps},
    {"ground", &StepTimes::ground},       {"sweep", &StepTimes::sweep},
    {"contacts", &StepTimes::contacts},   {"restore", &StepTimes::restore},
    {"resolve", &StepTimes::resolve},     {"waiting", &StepTimes::waiting},
    {"foresight", &StepTimes::foresight},
};

/// Whether each field of a struct of times has its line.
template <class Times>
inline constexpr bool is_listed = sizeof(time_fields<Times>) ==
                                  sizeof(Times) / sizeof(double) * sizeof(TimeField<Times>);
static_assert(is_listed<StageTimes> && is_listed<StepTimes>, "a new time needs a line in time_fields");

inline double StageTimes::total() const {
    double sum = 0;
    for (const TimeField<StageTimes>& field : time_fields<StageTimes>) sum += this->*field.value;
    return sum;
}

inline double StepTimes::total() const {
    double sum = 0;
    for (const TimeField<StepTimes>& field : time_fields<StepTimes>) sum += this->*field.value;
    return sum;
}

inline StageTimes& StageTimes::operator+=(const StageTimes& more) {
    for (const TimeField<StageTimes>& field : time_fields<StageTimes>)
        this->*field.value += more.*field.value;
    return *this;
}

inline StageTimes& StageTimes::operator-=(const StageTimes& less) {
    for (const TimeField<StageTimes>& field : time_fields<StageTimes>)
        this->*field.value -= less.*field.value;
    return *this;
}

inline double WorldTimes::stages() const {
    return blows.total() + steps.total();
}

}  // namespace sherd
