#include "audio/detail/parts.h"

#include <algorithm>
#include <cmath>

#include "core/maths.h"

namespace thaum::audio {
namespace {

constexpr double sample_s = 1.0 / sample_rate;
constexpr double noise_rms = 0.35;     // root mean square of a noise with level 1
constexpr double highest_hz = 20'000;  // limit that keeps vibrato below half the sample rate

/// Place of a part, a layer of a sound, on the time axis of the sound (samples).
struct Span {
    std::size_t start{}, count{};
    bool lasting{};  ///< true: the part lasts as long as the whole loop
};

/// Place of a part on the time axis of its sound; `decay` is the longest decay of the part's sine waves (s).
Span span_of(const Canvas& canvas, const Envelope& envelope, double decay) {
    if (decay == 0 && canvas.loops()) return {0, canvas.size(), true};
    const auto start = static_cast<std::size_t>(envelope.start * sample_rate);
    const auto remaining = canvas.size() - std::min(start, canvas.size());
    if (decay == 0) return {start, remaining, false};
    const auto whole = static_cast<std::size_t>(length_of(envelope, decay) * sample_rate);
    return {start, canvas.loops() ? whole : std::min(whole, remaining), false};
}

/// The envelope or pitch, with tremolo and vibrato rates that fit a whole number of periods into a part that
/// lasts as long as its loop.
Envelope fitted(Envelope envelope, const Canvas& canvas, const Span& span) {
    if (!span.lasting) return envelope;
    envelope.attack = 0;
    envelope.tremolo_hz = fitted_rate(envelope.tremolo_hz, canvas);
    return envelope;
}

Pitch fitted(Pitch pitch, const Canvas& canvas, const Span& span) {
    if (span.lasting) pitch.vibrato_hz = fitted_rate(pitch.vibrato_hz, canvas);
    return pitch;
}

/// Frequency of a part, a layer of a sound, in each block of samples (Hz).
std::vector<double> frequencies_of(const Pitch& pitch, std::size_t count) {
    std::vector<double> result;
    for (std::size_t i = 0; i < count; i += control_samples) {
        const double middle = static_cast<double>(i) + control_samples / 2.0;
        result.push_back(std::min(hz_at(pitch, middle * sample_s), highest_hz));
    }
    return result;
}

/// The samples of a part, a layer of a sound, between two computations of its gain.
struct Block {
    std::size_t first{}, count{};
    double gain{}, step{};  ///< gain of the first sample, and its change from sample to sample
    double hz{};

    double gain_of(std::size_t sample) const { return gain + step * static_cast<double>(sample); }
};

/// Calls `use(block)` for each block of a part.
template <class Use>
void each_block(const Envelope& envelope, double decay, std::span<const double> frequencies,
                std::size_t count, Use use) {
    const double fall_of_block = fall_within(static_cast<double>(control_samples) / sample_rate, decay);
    double fall = fall_at(envelope, decay, 0), gain = steady_gain_at(envelope, 0) * fall;
    for (std::size_t i = 0; i < count; i += control_samples) {
        const auto length = std::min(control_samples, count - i);
        const double time = static_cast<double>(i + length) * sample_s;
        // Once a decay has begun, its factor shrinks by the same share in every whole block. A multiplication
        // is cheaper than an exponential.
        fall = fall < 1 && length == control_samples ? fall * fall_of_block : fall_at(envelope, decay, time);
        const double next = steady_gain_at(envelope, time) * fall;
        use(Block{i, length, gain, (next - gain) / static_cast<double>(length),
                  frequencies[i / control_samples]});
        gain = next;
    }
}

/// Factor on a partial's frequency that gives it a whole number of periods in a part that lasts as long as
/// its loop.
double period_fit(std::span<const double> frequencies, std::size_t count, double ratio) {
    double periods = 0;
    for (std::size_t i = 0; i < count; i += control_samples)
        periods += frequencies[i / control_samples] * ratio * sample_s *
                   static_cast<double>(std::min(i + control_samples, count) - i);
    return std::max(1.0, std::floor(periods + 0.5)) / periods;
}

void add_partial(Canvas& canvas, const Envelope& envelope, std::span<const double> frequencies,
                 const Partial& partial) {
    const double decay = envelope.decay * partial.decay;
    const Span span = span_of(canvas, envelope, decay);
    const double fit = span.lasting ? period_fit(frequencies, span.count, partial.ratio) : 1;
    const double cycles_per_hz = partial.ratio * fit * sample_s;
    const SineTable& sine = sine_table();
    double cycles = 0;
    each_block(envelope, decay, frequencies, span.count, [&](const Block& block) {
        std::array<double, control_samples> samples;
        const double turn = block.hz * cycles_per_hz;
        for (std::size_t i = 0; i < block.count; ++i) {
            samples[i] = sine_of_cycles(sine, cycles) * block.gain_of(i) * partial.level;
            cycles += turn;
            if (cycles >= 1) cycles -= std::floor(cycles);
        }
        canvas.add(span.start + block.first, std::span(samples).first(block.count));
    });
}

/// Two state-variable filters in a row, in the form of A. Simper: "Linear
/// trapezoidal state variable filter" (2013).
class NoiseShaper {
public:
    NoiseShaper(NoiseFilter filter, double sharpness) : filter_(filter), damping_(1 / sharpness) {}

    void tune(double hz) {
        if (hz == hz_) return;
        hz_ = hz;
        const double g = det::tan(pi * hz * sample_s);
        a1_ = 1 / (1 + g * (g + damping_));
        a2_ = g * a1_;
        a3_ = g * a2_;
        // Noise evenly spread from -1 to 1 has a mean square of 1/3.
        scale_ = noise_rms * std::sqrt(3 * sample_rate / 2.0 / bandwidth());
    }

    double operator()(double in) { return scale_ * second_.step(*this, first_.step(*this, in)); }

private:
    struct Stage {
        double one = 0, two = 0;
        double step(const NoiseShaper& shaper, double in) {
            const double difference = in - two;
            const double band = shaper.a1_ * one + shaper.a2_ * difference;
            const double low = two + shaper.a2_ * one + shaper.a3_ * difference;
            one = 2 * band - one;
            two = 2 * low - two;
            if (shaper.filter_ == NoiseFilter::low) return low;
            const double through = shaper.damping_ * band;
            return shaper.filter_ == NoiseFilter::band ? through : in - through - low;
        }
    };

    /// Width of the passed band, roughly (Hz).
    double bandwidth() const {
        switch (filter_) {
            case NoiseFilter::low: return hz_;
            case NoiseFilter::band: return hz_ * damping_ * (pi / 4);
            default: return sample_rate / 2.0 - hz_;
        }
    }

    NoiseFilter filter_;
    double damping_, hz_ = 0, a1_ = 0, a2_ = 0, a3_ = 0, scale_ = 0;
    Stage first_, second_;
};

/// Adds one grain, a short decaying sine wave, to the samples of a sound.
void add_grain(Canvas& canvas, const Grains& grains, std::size_t start, double level, double hz) {
    const auto count = static_cast<std::size_t>(grains.ring * (4.0 / 3) * sample_rate);
    const double fall = det::exp(det::log(1e-3) / (grains.ring * sample_rate));
    const double rise = det::exp(det::log(2) * grains.glide / 12 / (grains.ring * sample_rate));
    double cycles = 0, turn = hz * sample_s;
    for (std::size_t i = 0; i < count && (canvas.loops() || start + i < canvas.size()); ++i) {
        canvas.add(start + i, sine_of_cycles(cycles) * level);
        cycles += turn;
        if (cycles >= 1) cycles -= 1;
        level *= fall;
        turn = std::min(turn * rise, highest_hz * sample_s);
    }
}

/// Time from the start of one grain (a short decaying sine wave) to that of the next (s).
double interval(const Grains& grains, double rate, Random& random) {
    const double spread = -det::log(1 - random.uniform());
    return (grains.even + (1 - grains.even) * spread) / rate;
}

}  // namespace

void add_tone(Canvas& canvas, const Tone& tone) {
    const Span span = span_of(canvas, tone.envelope, tone.envelope.decay);
    const Envelope envelope = fitted(tone.envelope, canvas, span);
    const auto frequencies = frequencies_of(fitted(tone.pitch, canvas, span), span.count);
    for (const auto& partial : tone.partials) add_partial(canvas, envelope, frequencies, partial);
}

void add_noise(Canvas& canvas, const Noise& noise, Random random) {
    const Span span = span_of(canvas, noise.envelope, noise.envelope.decay);
    const Envelope envelope = fitted(noise.envelope, canvas, span);
    const auto frequencies = frequencies_of(fitted(noise.pitch, canvas, span), span.count);
    NoiseShaper shaper(noise.filter, noise.sharpness);
    if (span.lasting) {
        // The same noise runs through the filter twice, so that the filter begins the second run in the state
        // in which that run ends, and the loop has no seam.
        Random before = random;
        for (std::size_t i = 0; i < span.count; ++i) {
            shaper.tune(frequencies[i / control_samples]);
            shaper(before.uniform(-1, 1));
        }
    }
    each_block(envelope, envelope.decay, frequencies, span.count, [&](const Block& block) {
        shaper.tune(block.hz);
        for (std::size_t i = 0; i < block.count; ++i)
            canvas.add(span.start + block.first + i, shaper(random.uniform(-1, 1)) * block.gain_of(i));
    });
}

void add_grains(Canvas& canvas, const Grains& grains, Random random) {
    const Span span = span_of(canvas, grains.envelope, grains.envelope.decay);
    const Envelope envelope = fitted(grains.envelope, canvas, span);
    const double seconds = static_cast<double>(span.count) * sample_s;
    const double widest = det::log(grains.high_hz / grains.low_hz);
    // In a part that lasts as long as its loop, the first grain (a short sine wave) starts at a random time.
    // In any other part it starts as the part becomes audible.
    double time = span.lasting ? random.uniform() / grains.rate : std::min(envelope.attack, 1 / grains.rate);
    while (time < seconds) {
        const double hz = grains.low_hz * det::exp(widest * random.uniform());
        const double strength = (1 - grains.spread * random.uniform()) * (random.below(2) == 0 ? -1 : 1);
        const auto at = span.start + static_cast<std::size_t>(time * sample_rate);
        add_grain(canvas, grains, at, strength * gain_at(envelope, envelope.decay, time), hz);
        const double rate = grains.rate + (grains.rate_to - grains.rate) * (time / seconds);
        time += std::max(interval(grains, rate, random), sample_s);
    }
}

void add_score(Canvas& canvas, const Score& score) {
    const double beat_s = 60 / score.beats_per_minute;
    // Vibrato restarts with each note, so all notes share one curve: the frequencies of a note of 1 Hz.
    std::vector<double> course, frequencies;
    for (const auto& note : score.notes) {
        Envelope envelope = score.envelope;
        envelope.start += note.beat * beat_s;
        envelope.hold = std::max(0.0, note.beats * beat_s - envelope.attack);
        envelope.level *= note.level;
        const auto count = span_of(canvas, envelope, envelope.decay).count;
        if (count > course.size() * control_samples)
            course = frequencies_of({1, 1, 1, score.vibrato_hz, score.vibrato}, count);
        const double hz = hz_of_key(note.key);
        frequencies.clear();
        for (const double factor : course) frequencies.push_back(std::min(hz * factor, highest_hz));
        for (const auto& partial : score.partials) add_partial(canvas, envelope, frequencies, partial);
    }
}

}  // namespace thaum::audio
