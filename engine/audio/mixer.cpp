#include "audio/mixer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "audio/detail/checked_frame.h"
#include "audio/detail/limiter.h"
#include "audio/detail/listener_mix.h"

namespace thaum::audio {
namespace {

constexpr double half_power = 0.70710678118654752;

}  // namespace

/// Gains from a listener's two channels to the two speakers.
struct SpeakerGains {
    float left_to_left{}, right_to_left{}, left_to_right{}, right_to_right{};
    bool operator==(const SpeakerGains&) const = default;
};

namespace {

SpeakerGains speaker_gains(std::uint32_t listener, std::uint32_t listeners, Ears ears) {
    constexpr float some = static_cast<float>(half_power);
    if (listener >= listeners) return {};
    if (listeners == 1) return {1, 0, 0, 1};
    if (ears == Ears::shared) return {some, 0, 0, some};
    return listener == 0 ? SpeakerGains{some, some, 0, 0} : SpeakerGains{0, 0, some, some};
}

/// Adds a listener's block to the sum. The gains move evenly from the old to the new ones.
void add_block(std::span<const float> heard, const SpeakerGains& from, const SpeakerGains& to,
               std::span<float> sum) {
    const float step = 1.0F / frame_samples;
    for (std::size_t i = 0; i < frame_samples; ++i) {
        const float t = static_cast<float>(i + 1) * step;
        const auto between = [t](float a, float b) { return a == b ? a : a + (b - a) * t; };
        const float left = heard[2 * i], right = heard[2 * i + 1];
        sum[2 * i] += between(from.left_to_left, to.left_to_left) * left +
                      between(from.right_to_left, to.right_to_left) * right;
        sum[2 * i + 1] += between(from.left_to_right, to.left_to_right) * left +
                          between(from.right_to_right, to.right_to_right) * right;
    }
}

}  // namespace

double distance_gain(double distance_m, double near_m, double reach_m) {
    if (!(distance_m < reach_m)) return 0;
    if (distance_m <= near_m) return 1;
    const double end = near_m / reach_m;
    return (near_m / distance_m - end) / (1 - end);
}

double fader_gain(double fader) {
    const double clipped = std::clamp(fader, 0.0, 1.0);
    return clipped * clipped;
}

struct Mixer::State {
    std::vector<detail::SoundFacts> sounds;
    std::array<std::optional<detail::ListenerMix>, max_listeners> mixes;
    std::array<SpeakerGains, max_listeners> gains{};
    detail::Limiter limiter;
    MixSettings settings;
    MixReport report;
    bool hrtf_fails = false;

    // Listeners and voices of the newest frame, with invalid values replaced.
    std::uint32_t listener_count = 1;
    std::array<Listener, max_listeners> listeners{};
    std::array<Voice, 32> lasts{};
    std::size_t last_count = 0;
    std::array<Voice, max_begins> begins{};
    std::size_t begin_count = 0;
    std::array<float, block_values> heard{};

    void begin(Voice voice) {
        if (!detail::check_voice(voice, false, sounds, report.bad_values)) return;
        if (begin_count == max_begins)
            ++report.left_out;
        else
            begins[begin_count++] = voice;
    }

    void take(const AudioFrame& frame);
    void mix(std::span<float> stereo);
    void mix_listener(std::uint32_t i, std::span<float> sum);
    bool wants_hrtf() const { return settings.headphones && listener_count == 1 && !hrtf_fails; }
    void switch_hrtf();
};

void Mixer::State::take(const AudioFrame& frame) {
    const auto count = std::clamp(frame.listener_count, 1U, static_cast<std::uint32_t>(max_listeners));
    if (count != frame.listener_count) ++report.bad_values;
    listener_count = count;
    for (std::uint32_t i = 0; i < count; ++i)
        listeners[i] = detail::checked_listener(frame.listeners[i], listeners[i], report.bad_values);
    const auto counted = [this](std::uint32_t listed, std::size_t capacity) {
        if (listed > capacity) ++report.bad_values;
        return std::min<std::size_t>(listed, capacity);
    };
    report.left_out += frame.lasts.left_out;
    report.left_out += frame.begins.left_out;
    last_count = 0;
    for (auto voice : std::span(frame.lasts.voices).first(counted(frame.lasts.count, lasts.size())))
        if (detail::check_voice(voice, true, sounds, report.bad_values)) lasts[last_count++] = voice;
    const auto& listed = frame.begins.voices;
    for (const auto& voice : std::span(listed).first(counted(frame.begins.count, listed.size())))
        begin(voice);
}

/// Switches between panning and HRTF while the first listener is faded out; the next block fades the listener
/// in again.
void Mixer::State::switch_hrtf() {
    const bool wanted = wants_hrtf();
    mixes[0]->set_hrtf(wanted);
    hrtf_fails = wanted && !mixes[0]->hrtf();
}

void Mixer::State::mix_listener(std::uint32_t i, std::span<float> sum) {
    auto& mix = *mixes[i];
    const bool present = i < listener_count;
    const bool switches = i == 0 && mix.hrtf() != wants_hrtf();
    const auto target = switches ? SpeakerGains{} : speaker_gains(i, listener_count, settings.ears);
    const auto from = std::exchange(gains[i], target);
    const detail::BlockVoices voices{std::span(lasts).first(present ? last_count : 0),
                                     std::span(begins).first(present ? begin_count : 0)};
    const bool nothing = voices.lasts.empty() && voices.begins.empty() && mix.is_silent();
    if (!nothing) {
        const double master = fader_gain(settings.master);
        const std::array<double, sound_groups> faders{master * fader_gain(settings.effects),
                                                      master * fader_gain(settings.music),
                                                      master * fader_gain(settings.interface)};
        mix.block(listeners[i], voices, faders, report.blocks * frame_samples, report, heard);
        add_block(heard, from, target, sum);
        report.voices += mix.voices();
    }
    if (switches) switch_hrtf();
}

void Mixer::State::mix(std::span<float> stereo) {
    std::fill(stereo.begin(), stereo.end(), 0.0F);
    report.voices = 0;
    for (std::uint32_t i = 0; i < max_listeners; ++i) mix_listener(i, stereo);
    begin_count = 0;
    if (limiter.process(stereo)) ++report.limited_blocks;
    ++report.blocks;
    report.hrtf = mixes[0]->hrtf();
}

Mixer::Mixer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mixer::Mixer(Mixer&& other) noexcept = default;
Mixer& Mixer::operator=(Mixer&& other) noexcept = default;
Mixer::~Mixer() = default;

Expected<Mixer> Mixer::create(const SoundBank& bank, const MixSettings& settings) {
    auto state = std::make_unique<State>();
    state->sounds = detail::facts_of(bank, state->report.bad_values);
    state->settings = detail::checked_settings(settings, state->report.bad_values);
    for (std::uint32_t i = 0; i < max_listeners; ++i) {
        auto device = detail::Loopback::open(bank, i == 0 && settings.headphones);
        if (!device) return device.error();
        state->mixes[i].emplace(std::move(*device), state->sounds, i);
    }
    state->hrtf_fails = settings.headphones && !state->mixes[0]->hrtf();
    state->gains[0] = speaker_gains(0, 1, settings.ears);
    return Mixer(std::move(state));
}

void Mixer::begin(const Voice& voice) { state_->begin(voice); }

void Mixer::play(const AudioFrame& frame, std::span<float> stereo) {
    state_->take(frame);
    state_->mix(stereo);
}

void Mixer::run_on(std::span<float> stereo) {
    ++state_->report.blocks_without_frame;
    state_->mix(stereo);
}

void Mixer::set(const MixSettings& settings) {
    state_->settings = detail::checked_settings(settings, state_->report.bad_values);
    if (!settings.headphones) state_->hrtf_fails = false;
}

void Mixer::silence() {
    for (auto& mix : state_->mixes) mix->silence();
    state_->last_count = state_->begin_count = 0;
    state_->limiter.clear();
}

const MixReport& Mixer::report() const { return state_->report; }

}  // namespace thaum::audio
