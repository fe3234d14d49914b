#include "audio/detail/listener_mix.h"

#include <algorithm>

namespace thaum::audio::detail {
namespace {

/// Least gain of a voice that is played by a source of OpenAL: -100 dB.
constexpr double min_gain = 1e-5;
/// A new voice must be louder by this factor to take the source of OpenAL from a voice that already plays, so
/// that two about equally loud voices do not take turns.
constexpr double keep_factor = 1.1;
/// Largest change in one block of 8 ms of the damping of high tones, as behind walls; a change from none to
/// all takes 0.4 s. When the gain of the filter changes, its output jumps for some samples by the same share
/// of the signal; a jump of 2 % cannot be heard as a click.
constexpr double max_muffle_change = 0.02;
/// Looping voices whose keys (the numbers that identify them) are neighbours start this many samples apart,
/// so that equal sounds do not add up wave by wave.
constexpr std::uint64_t samples_between_keys = 7919;

fvec3 place_of(const Voice& voice, const Listener& listener) {
    if (voice.at_ear) return {};
    const vec3 away = voice.position - listener.position;
    const vec3 right = glm::cross(listener.forward, listener.up);
    return {glm::dot(away, right), glm::dot(away, listener.up), -glm::dot(away, listener.forward)};
}

}  // namespace

ListenerMix::ListenerMix(std::unique_ptr<Loopback> device, std::span<const SoundFacts> sounds,
                         std::uint32_t index)
    : device_(std::move(device)), sounds_(sounds), index_(index) {}

void ListenerMix::block(const Listener& listener, BlockVoices voices,
                        const std::array<double, sound_groups>& faders, std::uint64_t clock,
                        MixReport& report, std::span<float> stereo) {
    const auto scope = device_->enter();
    free_ended();
    gather(listener, voices, faders, report);
    choose(report);
    device_->begin_changes();
    fade_the_rest();
    starting_count_ = 0;
    for (const auto& candidate : std::span(candidates_).first(candidate_count_)) {
        if (candidate.playing >= 0)
            change(playing_[static_cast<std::size_t>(candidate.playing)], candidate, listener);
        else
            start(candidate, listener, clock);
    }
    device_->end_changes();
    device_->start(std::span(starting_).first(starting_count_));
    report.begun += starting_count_;
    heard_ = static_cast<std::uint32_t>(candidate_count_);
    silent_blocks_ = playing_count_ == 0 ? silent_blocks_ + 1 : 0;
    device_->render(stereo);
}

void ListenerMix::silence() {
    const auto scope = device_->enter();
    for (const auto& playing : std::span(playing_).first(playing_count_)) device_->give_back(playing.source);
    playing_count_ = 0;
    heard_ = 0;
}

void ListenerMix::free_ended() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < playing_count_; ++i) {
        const auto& playing = playing_[i];
        if (playing.fading || (!playing.lasting && device_->has_ended(playing.source)))
            device_->give_back(playing.source);
        else
            playing_[kept++] = playing;
    }
    playing_count_ = kept;
}

double ListenerMix::gain_of(const Voice& voice, const Listener& listener,
                            const std::array<double, sound_groups>& faders) const {
    const auto& sound = sounds_[voice.sound];
    const double gain = voice.gain * faders[static_cast<std::size_t>(sound.group)];
    if (voice.at_ear) return gain;
    return gain * distance_gain(glm::length(voice.position - listener.position), sound.near_m, sound.reach_m);
}

std::int32_t ListenerMix::find_lasting(const Voice& voice) const {
    for (std::size_t i = 0; i < playing_count_; ++i) {
        const auto& playing = playing_[i];
        if (playing.lasting && playing.voice.key == voice.key && playing.voice.sound == voice.sound)
            return static_cast<std::int32_t>(i);
    }
    return -1;
}

void ListenerMix::add(const Candidate& candidate) {
    if (candidate.gain > min_gain) candidates_[candidate_count_++] = candidate;
}

void ListenerMix::gather(const Listener& listener, BlockVoices voices,
                         const std::array<double, sound_groups>& faders, MixReport& report) {
    candidate_count_ = 0;
    for (std::size_t i = 0; i < playing_count_; ++i) {
        auto& playing = playing_[i];
        playing.chosen = false;
        if (!playing.lasting)
            add({&playing.voice, static_cast<std::int32_t>(i), false,
                 gain_of(playing.voice, listener, faders)});
    }
    const auto heard = [this](const Voice& voice) { return (voice.heard_by >> index_ & 1U) != 0; };
    for (std::size_t i = 0; i < voices.lasts.size(); ++i) {
        const auto& voice = voices.lasts[i];
        const bool repeated =
            std::any_of(voices.lasts.begin(), voices.lasts.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Voice& other) { return heard(other) && other.key == voice.key; });
        if (!heard(voice)) continue;
        if (repeated)
            ++report.bad_values;
        else
            add({&voice, find_lasting(voice), true, gain_of(voice, listener, faders)});
    }
    for (const auto& voice : voices.begins)
        if (heard(voice)) add({&voice, -1, false, gain_of(voice, listener, faders)});
}

/// Keeps the loudest of the voices that want a source of OpenAL. Their order does not depend on the algorithm
/// of std::sort.
void ListenerMix::choose(MixReport& report) {
    if (candidate_count_ <= max_heard) return;
    const auto all = std::span(candidates_).first(candidate_count_);
    const auto rank = [](const Candidate& c) { return c.gain * (c.playing >= 0 ? keep_factor : 1); };
    // Of voices with equal gains the earlier ones come first. Voices lie in several lists, so each gets an
    // index here.
    std::array<std::uint16_t, max_candidates> order{};
    for (std::size_t i = 0; i < all.size(); ++i) order[i] = static_cast<std::uint16_t>(i);
    const auto used = std::span(order).first(all.size());
    std::sort(used.begin(), used.end(), [&](std::uint16_t a, std::uint16_t b) {
        return rank(all[a]) != rank(all[b]) ? rank(all[a]) > rank(all[b]) : a < b;
    });
    std::sort(used.begin(), used.begin() + max_heard);
    for (const auto cut : used.subspan(max_heard)) report.stolen += all[cut].playing >= 0 ? 1 : 0;
    report.left_out += all.size() - max_heard;
    for (std::size_t i = 0; i < max_heard; ++i) candidates_[i] = all[used[i]];
    candidate_count_ = max_heard;
}

/// Fades out the playing voices that get no source in this block.
void ListenerMix::fade_the_rest() {
    for (const auto& candidate : std::span(candidates_).first(candidate_count_))
        if (candidate.playing >= 0) playing_[static_cast<std::size_t>(candidate.playing)].chosen = true;
    for (auto& playing : std::span(playing_).first(playing_count_)) {
        if (playing.chosen) continue;
        playing.fading = true;
        device_->set_gain(playing.source, 0);
    }
}

void ListenerMix::change(Playing& playing, const Candidate& candidate, const Listener& listener) {
    if (candidate.voice != &playing.voice) playing.voice = *candidate.voice;
    const auto& voice = playing.voice;
    if (candidate.gain != playing.gain) device_->set_gain(playing.source, candidate.gain);
    playing.gain = candidate.gain;
    if (voice.pitch != playing.pitch) device_->set_pitch(playing.source, voice.pitch);
    playing.pitch = voice.pitch;
    const auto place = place_of(voice, listener);
    if (place != playing.place) device_->set_place(playing.source, place);
    playing.place = place;
    const double muffled = playing.muffled + std::clamp(voice.muffled[index_] - playing.muffled,
                                                        -max_muffle_change, max_muffle_change);
    if (muffled != playing.muffled) device_->set_muffled(playing.source, muffled);
    playing.muffled = muffled;
}

void ListenerMix::start(const Candidate& candidate, const Listener& listener, std::uint64_t clock) {
    const auto& voice = *candidate.voice;
    const auto& sound = sounds_[voice.sound];
    const auto source = device_->take(voice.sound);
    auto& playing = playing_[playing_count_++];
    playing = {.voice = voice,
               .source = source,
               .lasting = candidate.lasting,
               .chosen = true,
               .gain = candidate.gain,
               .pitch = voice.pitch,
               .muffled = voice.muffled[index_],
               .place = place_of(voice, listener)};
    device_->set_gain(source, playing.gain);
    device_->set_pitch(source, playing.pitch);
    device_->set_place(source, playing.place);
    device_->set_muffled(source, playing.muffled);
    if (candidate.lasting) {
        // Loops of music follow the mixer's clock, so that layers which come and go stay in step.
        const bool in_step = sound.group == SoundGroup::music;
        const auto sample = clock + 1 + (in_step ? 0 : samples_between_keys * voice.key);
        device_->set_start(source, std::max(1U, static_cast<std::uint32_t>(sample % sound.samples)));
    }
    starting_[starting_count_++] = source;
}

}  // namespace thaum::audio::detail
