// Benchmark of the mixer: time of a block of 8 ms, allocations, and error of the level against the exact law.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "audio/mixer.h"
#include "core/hash.h"
#include "core/text.h"
#include "tools/bench/allocations.h"
#include "tools/bench/areas.h"
#include "tools/bench/measure.h"

namespace thaum::bench {
namespace {

using audio::AudioFrame;
using audio::Mixer;

constexpr double block_us = 1e6 * audio::frame_samples / audio::sample_rate;
constexpr double hum_size = 0.25;
/// Indices of the two sounds in bench_sounds().
constexpr std::uint32_t hum = 0, knock = 1;

audio::SoundBank bench_sounds() {
    audio::SoundBank bank;
    bank.sounds.resize(2);
    auto& humming = bank.sounds[hum];
    humming.name = "hum";
    humming.loops = true;
    humming.near_m = 1;
    humming.samples.resize(audio::sample_rate);
    for (std::size_t i = 0; i < humming.samples.size(); ++i)
        humming.samples[i] = static_cast<float>(
            hum_size * det::sin(2 * pi * 200 * static_cast<double>(i) / audio::sample_rate));
    auto& knocking = bank.sounds[knock];
    knocking.name = "knock";
    knocking.samples.assign(humming.samples.begin(), humming.samples.begin() + audio::sample_rate / 4);
    return bank;
}

/// Frame of sound with `lasts` voices (playing sounds) that continue and `begins` voices that start. All
/// voices move. Some of the continuing voices are behind walls, and some are played slower.
AudioFrame busy_frame(std::uint32_t listeners, std::uint32_t lasts, std::uint32_t begins, int block) {
    AudioFrame frame;
    frame.listener_count = listeners;
    const double angle = 0.02 * block;
    for (std::uint32_t i = 0; i < listeners; ++i)
        frame.listeners[i].forward = {det::sin(angle), 0, -det::cos(angle)};
    const auto place = [&](std::uint32_t i) {
        return vec3{4 * det::cos(angle + 0.2 * i), 1, 4 * det::sin(angle + 0.2 * i)};
    };
    for (std::uint32_t key = 0; key < lasts; ++key) {
        audio::Voice voice{.sound = hum, .key = key, .position = place(key)};
        voice.gain = 0.1;
        voice.pitch = key % 2 == 0 ? 1 : 0.8;
        voice.muffled.fill(key % 4 == 0 ? 0.5 : 0);
        frame.lasts.add(voice);
    }
    for (std::uint32_t i = 0; i < begins; ++i)
        frame.begins.add({.sound = knock, .position = place(i + lasts), .gain = 0.1});
    return frame;
}

struct MixCase {
    const char* listeners_heard;  ///< how listeners share the speakers, as a word for the report
    std::uint32_t listeners{1};
    std::uint32_t lasts{}, begins{};  ///< number of lasting voices (playing sounds), and of those that begin
                                      ///< in each block
    bool headphones{};
};

/// Mixes blocks and appends a row with times, allocations and number of voices (playing sounds) heard.
void mix_row(const Options& options, Report& report, const MixCase& mixed) {
    auto mixer = Mixer::create(bench_sounds(), {.headphones = mixed.headphones});
    if (!mixer) {
        report.faults.push_back(text("audio: ", mixer.error().message));
        return;
    }
    std::array<float, audio::block_values> block{};
    int number = 0;
    const std::function<void()> mix = [&] {
        mixer->play(busy_frame(mixed.listeners, mixed.lasts, mixed.begins, number++), block);
        do_not_optimise(block);
    };
    for (int i = 0; i < 100; ++i) mix();
    std::vector<double> samples(options.quick ? 500 : 5000);
    std::uint64_t voices = 0;
    const auto before = allocation_count();
    const auto hash_until = number + 400;
    std::uint64_t hash = 0;
    for (auto& sample : samples) {
        sample = us_of(mix);
        voices += mixer->report().voices;
        if (number <= hash_until) hash = hash_bytes(std::as_bytes(std::span(block)), hash);
    }
    const auto allocated = allocation_count() - before;
    const auto count = static_cast<double>(samples.size());
    report.rows.push_back(
        {.area = "audio",
         .name = "mix",
         .setting = {{"listeners", std::int64_t{mixed.listeners}},
                     {"heard", std::string(mixed.listeners_heard)},
                     {"begins_per_block", std::int64_t{mixed.begins}}},
         .time_us = times(samples),
         .is_default = mixed.listeners == 2 && mixed.begins > 0,
         .metrics = {{"percent_of_a_core", 100 * median(samples) / block_us},
                     {"voices", static_cast<double>(voices) / count},
                     {"allocations", static_cast<double>(allocated)},
                     {"limited_blocks", static_cast<double>(mixer->report().limited_blocks)}},
         .hash = hex(hash)});
}

// ---- error of the level ----------------------------------------------------------------------------------

/// Gains of both channels for a sound at an angle from straight ahead (rad, positive to the right), as OpenAL
/// pans: the front half is spread by a factor of 1.5, a source of 0.25 m radius covers an angle, and
/// first-order ambisonics are decoded for two speakers.
std::array<double, 2> exact_pan(double angle, double distance_m) {
    const double ahead = std::abs(angle);
    const double azimuth = std::copysign(ahead >= pi / 2 ? ahead : std::min(1.5 * ahead, pi / 2), angle);
    const double spread = 2 * det::asin(0.25 / distance_m);
    const double width = 0.5 * (det::cos(spread / 2) + 1);
    const double scale = std::sqrt(1 + spread / (2 * pi));
    const double across = width * det::sin(azimuth), along = width * det::cos(azimuth);
    // Weight of the component from straight ahead in OpenAL's decoding for two speakers.
    constexpr double front = 0.0957;
    const auto gain = [&](double side) {
        return std::clamp(scale * (0.5 + 0.5 * side * across + front * along), 0.0, 1.0);
    };
    return {gain(-1), gain(1)};
}

/// Largest error of the level over distances and angles (dB), from the energy of both channels.
double worst_level_db(Mixer& mixer, std::span<const double> distances_m, std::size_t& places) {
    double worst = 0;
    for (const double distance : distances_m) {
        for (int step = -11; step <= 12; ++step) {
            const double angle = pi * step / 12;
            AudioFrame frame;
            frame.lasts.add(
                {.sound = hum, .position = {distance * det::sin(angle), 0, -distance * det::cos(angle)}});
            std::array<float, audio::block_values> block{};
            for (int i = 0; i < 4; ++i)
                // Four blocks let the gains reach their values and the limiter's delay pass.
                mixer.play(frame, block);
            double energy = 0;
            constexpr int blocks = 5;  // number of measured blocks; they hold eight periods of the sound
            for (int i = 0; i < blocks; ++i) {
                mixer.play(frame, block);
                for (const float s : block) energy += static_cast<double>(s) * s;
            }
            const auto pan = exact_pan(angle, distance);
            const double gain = hum_size * audio::distance_gain(distance, 1, audio::Sound{}.reach_m);
            const double exact =
                0.5 * gain * gain * (pan[0] * pan[0] + pan[1] * pan[1]) * blocks * audio::frame_samples;
            worst = std::max(worst, std::abs(10 * std::log10(energy / exact)));
            ++places;
        }
    }
    return worst;
}

void level_row(Report& report) {
    auto mixer = Mixer::create(bench_sounds(), {});
    if (!mixer) return;  // the failure was already reported by mix_row
    std::size_t places = 0;
    constexpr std::array distances_m{0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 35.0};
    const double start = now_us();
    const double worst = worst_level_db(*mixer, distances_m, places);
    const double time = (now_us() - start) / (9.0 * static_cast<double>(places));
    report.rows.push_back({.area = "audio",
                           .name = "level",
                           .setting = {{"heard", std::string("panned")}},
                           .time_us = Times{time, time, time},
                           .error = ErrorMeasure{"worst_db", worst},
                           .is_default = true,
                           .metrics = {{"places", static_cast<double>(places)}}});
}

}  // namespace

void audio(const Options& options, Report& report) {
    const std::array cases{
        MixCase{"nothing", 2, 0, 0}, MixCase{"panned", 1, 32, 2},     MixCase{"panned", 2, 32, 0},
        MixCase{"panned", 2, 32, 2}, MixCase{"hrtf", 1, 32, 2, true},
    };
    for (const auto& mixed : cases) mix_row(options, report, mixed);
    level_row(report);
}

}  // namespace thaum::bench
