#include "prototype/sound.h"

#include <AL/al.h>
#include <AL/alc.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "prototype/clinks.h"

namespace prototype {

struct Sound::Device {
    Device(ALCdevice* its_device, ALCcontext* its_context) : device(its_device), context(its_context) {
        alcMakeContextCurrent(context);
        alGenBuffers(ALsizei(buffers.size()), buffers.data());
        alGenSources(ALsizei(sources.size()), sources.data());
        for (std::size_t i = 0; i < buffers.size(); ++i) {
            const Timbre timbre = Timbre(i / 2);
            const Samples samples = i % 2 == 0 ? knock(timbre) : shatter(timbre);
            alBufferData(buffers[i], AL_FORMAT_MONO16, samples.data(), ALsizei(2 * samples.size()),
                         sound_rate_hz);
        }
    }
    ~Device() {
        alDeleteSources(ALsizei(sources.size()), sources.data());
        alDeleteBuffers(ALsizei(buffers.size()), buffers.data());
        alcMakeContextCurrent(nullptr);
        alcDestroyContext(context);
        alcCloseDevice(device);
    }

    ALCdevice* device;
    ALCcontext* context;
    std::array<ALuint, 6> buffers{};  ///< of each timbre a knock and a break
    std::array<ALuint, 24> sources{};
    std::size_t next = 0;  ///< the source that has played longest
};

Sound::Sound() {
    ALCdevice* device = alcOpenDevice(nullptr);
    if (!device) return;
    if (ALCcontext* context = alcCreateContext(device, nullptr))
        device_ = std::make_unique<Device>(device, context);
    else
        alcCloseDevice(device);
}

Sound::~Sound() = default;

void Sound::listenFrom(const render::OrbitCamera& camera) {
    if (silent()) return;
    const render::Vec3 eye = camera.eye(), towards = camera.forward();
    const std::array<float, 6> turn = {towards.x(), towards.y(), towards.z(), 0, 0, 1};
    alListener3f(AL_POSITION, eye.x(), eye.y(), eye.z());
    alListenerfv(AL_ORIENTATION, turn.data());
}

void Sound::play(const Happening& happening) {
    constexpr float loud_impulse_n_s = 8, usual_kg = 0.5f;
    const float loudness = std::min(1.0f, std::sqrt(happening.impulse_n_s / loud_impulse_n_s));
    if (silent() || (!happening.shatters && loudness < 0.05f)) return;
    const ALuint source = device_->sources[device_->next++ % device_->sources.size()];
    const std::size_t buffer = 2 * std::size_t(happening.timbre) + (happening.shatters ? 1 : 0);
    // Small things sound higher.
    const float pitch =
        std::clamp(std::pow(usual_kg / std::max(happening.mass_kg, 1e-4f), 0.15f), 0.7f, 1.8f);
    alSourceStop(source);
    alSourcei(source, AL_BUFFER, ALint(device_->buffers[buffer]));
    alSource3f(source, AL_POSITION, happening.position.x(), happening.position.y(), happening.position.z());
    alSourcef(source, AL_REFERENCE_DISTANCE, 3);
    alSourcef(source, AL_PITCH, pitch);
    alSourcef(source, AL_GAIN, happening.shatters ? std::max(loudness, 0.25f) : 0.3f * loudness);
    alSourcePlay(source);
}

}  // namespace prototype
