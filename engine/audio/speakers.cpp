#include "audio/speakers.h"

#include <utility>

#include "core/text.h"

namespace thaum::audio {

Speakers::Speakers(Mixer mixer, std::unique_ptr<SoundDevice> device, double wait_s)
    : thread_(wait_s, std::move(mixer), std::move(device)) {}

bool Speakers::hear(const AudioFrame& frame) { return thread_.work().hear(frame); }
bool Speakers::hear(const Voice& voice) { return thread_.work().hear(voice); }
void Speakers::set(const MixSettings& settings) { thread_.work().set(settings); }
std::string Speakers::status() const {
    const auto& refused = thread_.refused();
    return refused.empty() ? thread_.work().status() : text("no sound: ", refused);
}
bool Speakers::plays() const { return thread_.work().plays(); }
PlaybackReport Speakers::report() const { return thread_.work().report(); }

}  // namespace thaum::audio
