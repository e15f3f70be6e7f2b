#pragma once

#include <sherd/sherd.h>

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/left_over.h"
#include "viewer/simulation.h"

namespace demo {

/// The stress that a blow's peak force makes in the struck body, particle by particle.
struct BlowStress {
    struct Particle {
        sherd::Vec3 position = sherd::Vec3::Zero();  ///< in the asset's coordinates
        double radius_m = 0;                         ///< of a ball of its volume
        double stress_pa = 0;                        ///< largest principal one
        int piece = -1;                              ///< of `pieces`; -1: none, the body is whole
    };
    std::vector<Particle> particles;
    std::vector<sherd::BreakableAsset> pieces;  ///< that the body broke into; or the body itself
    double strength_pa = 0;                     ///< mean tensile strength
    double largest_pa = 0;
    int blow = 0;  ///< SeenBlow::number
    std::string error;
};

/// Works out BlowStress beside the frames, with a StressModel of the struck asset. What an event tells is the
/// place, the direction and the peak force of the strike that was met first; the patch is taken as the
/// smallest of the settings.
class StressView {
  public:
    StressView() = default;
    ~StressView() { leaveToItself(std::move(future_)); }
    StressView(const StressView&) = delete;
    StressView& operator=(const StressView&) = delete;

    /// Begins with that blow unless it is known or being worked on. One without a force has no stress.
    void want(const SeenBlow& blow);
    /// The newest one that is done; none yet.
    const std::optional<BlowStress>& newest();
    bool working() const { return future_.valid(); }
    void wait();

  private:
    struct Known {
        sherd::BreakableAsset asset;
        sherd::StressModel model;
    };

    int wanted_ = -1;
    std::future<BlowStress> future_;
    std::optional<BlowStress> newest_;
    std::shared_ptr<std::optional<Known>> known_ = std::make_shared<std::optional<Known>>();
};

}  // namespace demo
