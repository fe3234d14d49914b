#include "audio/detail/oscillator.h"

#include <algorithm>
#include <cmath>

#include "core/maths.h"

namespace thaum::audio {
namespace {

const double falling_60_db = det::log(1e-3), octave = det::log(2), silent = det::log(1e-4);

SineTable make_sine_table() {
    SineTable table{};
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = det::sin(2 * pi * static_cast<double>(i) / sine_table_size);
    return table;
}

}  // namespace

double hz_of_key(double key) { return 440 * det::exp(octave * (key - 69) / 12); }

const SineTable& sine_table() {
    static const SineTable table = make_sine_table();
    return table;
}

double steady_gain_at(const Envelope& envelope, double time) {
    const double tremolo =
        envelope.tremolo == 0
            ? 1
            : 1 - envelope.tremolo *
                      (0.5 - 0.5 * sine_of_cycles(std::fmod(envelope.tremolo_hz * time + 0.25, 1.0)));
    const double level = envelope.level * tremolo;
    if (time >= envelope.attack) return level;
    const double share = time / envelope.attack;
    return level * share * share * (3 - 2 * share);
}

double fall_within(double time, double decay) {
    return decay == 0 ? 1 : det::exp(falling_60_db * time / decay);
}

double fall_at(const Envelope& envelope, double decay, double time) {
    const double falling = time - envelope.attack - envelope.hold;
    return falling <= 0 ? 1 : fall_within(falling, decay);
}

double length_of(const Envelope& envelope, double decay) {
    return envelope.attack + envelope.hold + decay * silent / falling_60_db;
}

double hz_at(const Pitch& pitch, double time) {
    double octaves = 0;
    if (pitch.sweep_to != pitch.hz)
        octaves = det::log(pitch.sweep_to / pitch.hz) / octave * std::min(1.0, time / pitch.sweep_s);
    if (pitch.vibrato != 0)
        octaves += pitch.vibrato / 12 * sine_of_cycles(std::fmod(pitch.vibrato_hz * time, 1.0));
    return octaves == 0 ? pitch.hz : pitch.hz * det::exp(octave * octaves);
}

Canvas::Canvas(double seconds, bool loops)
    : samples_(static_cast<std::size_t>(std::floor(seconds * sample_rate + 0.5))), loops_(loops) {}

double Canvas::seconds() const { return static_cast<double>(samples_.size()) / sample_rate; }

double fitted_rate(double hz, const Canvas& canvas) {
    if (!canvas.loops() || hz == 0) return hz;
    return std::max(1.0, std::floor(hz * canvas.seconds() + 0.5)) / canvas.seconds();
}

}  // namespace thaum::audio
