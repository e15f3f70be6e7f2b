#include "viewer/stress_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/inside.h"

namespace demo {
namespace {

using sherd::Vec3;

Vec3 toAsset(const btTransform& placed, const Vec3& point) {
    const btVector3 local =
        placed.inverse() * btVector3(btScalar(point.x()), btScalar(point.y()), btScalar(point.z()));
    return Vec3(local.x(), local.y(), local.z());
}

sherd::SurfaceLoad loadOf(const sherd::BlowEvent& event, const sherd::StressModel& model) {
    const sherd::ContactSettings& contact = event.asset.settings().fracture.contact;
    const Vec3 at = toAsset(event.asset_transform, event.position);
    const Vec3 towards = toAsset(event.asset_transform, event.position + event.normal) - at;
    sherd::SurfaceLoad load;
    load.region = sherd::SphereRegion{at, 1.5 * contact.smallest_patch * model.report().wall_thickness_m};
    load.force_n = event.peak_force_n * towards;
    return load;
}

/// Which piece each particle went to.
void assignPieces(BlowStress& stress) {
    for (std::size_t piece = 0; piece < stress.pieces.size(); ++piece) {
        const InsideTest inside(stress.pieces[piece].surface());
        for (BlowStress::Particle& particle : stress.particles)
            if (particle.piece < 0 && inside.contains(particle.position)) particle.piece = int(piece);
    }
}

BlowStress workOut(const SeenBlow& blow, const sherd::StressModel& model) {
    BlowStress stress;
    stress.blow = blow.number;
    stress.strength_pa = blow.event.asset.material().tensile_strength_pa;
    std::optional<sherd::StressField> field;
    if (blow.event.peak_force_n > 0) {
        auto solved = model.solve({loadOf(blow.event, model)});
        if (solved)
            field = std::move(solved).value();
        else
            stress.error = solved.error();
    }
    const std::vector<Vec3> positions = model.particlePositions();
    const std::vector<double> volumes = model.particleVolumes();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        BlowStress::Particle particle{positions[i], std::cbrt(volumes[i] * 0.2387), 0, -1};
        if (field) particle.stress_pa = sherd::largestPrincipal(field->particles[i]);
        stress.largest_pa = std::max(stress.largest_pa, particle.stress_pa);
        stress.particles.push_back(particle);
    }
    stress.pieces = blow.pieces;
    if (stress.pieces.empty()) stress.pieces = {blow.event.asset};
    assignPieces(stress);
    return stress;
}

}  // namespace

void StressView::want(const SeenBlow& blow) {
    if (wanted_ == blow.number || working()) return;
    wanted_ = blow.number;
    future_ = std::async(std::launch::async, [blow, known = known_] {
        const sherd::BreakableAsset& asset = blow.event.asset;
        // One model is kept: each takes up to 200 MB.
        if (!*known || &(*known)->asset.surface() != &asset.surface()) {
            auto model = sherd::StressModel::make(asset.surface(), asset.material(), asset.settings(),
                                                  asset.supports());
            if (!model) {
                BlowStress failed;
                failed.blow = blow.number;
                failed.error = model.error();
                return failed;
            }
            known->emplace(Known{asset, std::move(model).value()});
        }
        return workOut(blow, (*known)->model);
    });
}

const std::optional<BlowStress>& StressView::newest() {
    if (working() && isReady(future_)) newest_ = future_.get();
    return newest_;
}

void StressView::wait() {
    if (working()) newest_ = future_.get();
}

}  // namespace demo
