#include "audio/detail/checked_frame.h"

#include <algorithm>
#include <cmath>

namespace thaum::audio::detail {
namespace {

constexpr double min_pitch = 0.25, max_pitch = 4;
constexpr double longest_reach_m = 1e5;

/// Clips a value, or replaces one that is not a number. Counts each value that had to be changed.
void clip(double& value, double least, double most, double otherwise, std::uint64_t& bad_values) {
    const double clipped = std::isnan(value) ? otherwise : std::clamp(value, least, most);
    if (clipped == value) return;
    value = clipped;
    ++bad_values;
}

}  // namespace

std::vector<SoundFacts> facts_of(const SoundBank& bank, std::uint64_t& bad_values) {
    std::vector<SoundFacts> facts;
    for (const auto& sound : bank.sounds) {
        SoundFacts fact{.group = sound.group,
                        .loops = sound.loops,
                        .near_m = sound.near_m,
                        .reach_m = sound.reach_m,
                        .samples = static_cast<std::uint32_t>(sound.samples.size())};
        clip(fact.reach_m, 0, longest_reach_m, Sound{}.reach_m, bad_values);
        clip(fact.near_m, 0, fact.reach_m, std::min(Sound{}.near_m, fact.reach_m), bad_values);
        if (static_cast<std::size_t>(sound.group) >= sound_groups) {
            fact.group = SoundGroup::effects;
            ++bad_values;
        }
        // A loop of one sample makes no sound and has no later sample to start at.
        if (sound.samples.size() < 2) fact.samples = 0;
        facts.push_back(fact);
    }
    return facts;
}

bool check_voice(Voice& voice, bool lasting, std::span<const SoundFacts> sounds, std::uint64_t& bad_values) {
    const bool playable = voice.sound < sounds.size() && sounds[voice.sound].samples > 0 &&
                          sounds[voice.sound].loops == lasting;
    const bool placed = voice.at_ear || !(std::isnan(voice.position.x + voice.position.y + voice.position.z));
    if (!playable || !placed) {
        ++bad_values;
        return false;
    }
    clip(voice.gain, 0, 1, 0, bad_values);
    clip(voice.pitch, min_pitch, max_pitch, 1, bad_values);
    for (auto& muffled : voice.muffled) clip(muffled, 0, 1, 0, bad_values);
    return true;
}

Listener checked_listener(const Listener& listener, const Listener& before, std::uint64_t& bad_values) {
    constexpr double min_length = 1e-6, max_length = 1e6;
    const auto usable = [](vec3 axis) {
        const double length = glm::length(axis);
        return length > min_length && length < max_length;  // false for NaN
    };
    if (!is_finite(listener.position) || !usable(listener.forward) || !usable(listener.up)) {
        ++bad_values;
        return before;
    }
    const vec3 forward = glm::normalize(listener.forward);
    const vec3 across = glm::cross(forward, glm::normalize(listener.up));
    const vec3 right = usable(across) ? glm::normalize(across) : perpendicular_to(forward);
    return {listener.position, forward, glm::cross(right, forward)};
}

MixSettings checked_settings(const MixSettings& settings, std::uint64_t& bad_values) {
    auto checked = settings;
    for (auto* fader : {&checked.master, &checked.effects, &checked.music, &checked.interface})
        clip(*fader, 0, 1, 0, bad_values);
    if (checked.ears != Ears::left_right) checked.ears = Ears::shared;
    return checked;
}

}  // namespace thaum::audio::detail
