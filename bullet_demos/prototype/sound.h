#pragma once

#include <memory>

#include "prototype/game.h"
#include "render/camera.h"

namespace prototype {

/// Plays what happens, at its place. Silent where there is no sound device.
class Sound {
  public:
    Sound();
    ~Sound();
    Sound(const Sound&) = delete;
    Sound& operator=(const Sound&) = delete;

    void listenFrom(const render::OrbitCamera& camera);
    void play(const Happening& happening);
    bool silent() const { return !device_; }

  private:
    struct Device;
    std::unique_ptr<Device> device_;
};

}  // namespace prototype
