// Compares the sound generator with exact formulas: frequency, decay, sweep, filters, notes, and the Fourier
// transform.
#include <cmath>

#include "audio/analysis.h"
#include "audio/detail/parts.h"
#include "core/maths.h"
#include "unit/audio_recipes.h"

namespace thaum::audio {
namespace {

constexpr double rate = sample_rate;

/// Amplitude and phase of a frequency around a time, through a Hann window.
std::complex<double> wave_at(const Sound& sound, double hz, double middle_s, double width_s) {
    const auto from = static_cast<std::size_t>((middle_s - width_s / 2) * rate);
    const auto count = static_cast<std::size_t>(width_s * rate);
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double window =
            1 - std::cos(2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
        const double time = static_cast<double>(from + i) / rate;
        sum += window * static_cast<double>(sound.samples[from + i]) * std::polar(1.0, -2 * pi * hz * time);
    }
    return sum * (2.0 / static_cast<double>(count));
}

/// Frequency near `hz`, from the change of phase within 10 ms around a time.
double frequency_at(const Sound& sound, double hz, double middle_s) {
    const double gap = 0.01;
    const auto before = wave_at(sound, hz, middle_s - gap / 2, 0.03),
               after = wave_at(sound, hz, middle_s + gap / 2, 0.03);
    return hz + std::arg(after / before) / (2 * pi * gap);
}

std::string tone(double hz, std::string_view keys) { return part("tone", text("hz = ", hz, "\n", keys)); }

TEST(AudioSynth, PartialHasItsFrequencyAndDecay) {
    for (const double hz : {200.0, 440.0, 3000.0, 12000.0}) {
        for (const double decay : {0.25, 1.0}) {
            const auto sound = made(head(0.5) + tone(hz, text("attack = 0.001\ndecay = ", decay)));
            EXPECT_NEAR(frequency_at(sound, hz, 0.1), hz, 0.01) << hz;
            const auto early = std::abs(wave_at(sound, hz, 0.05, 0.04)),
                       late = std::abs(wave_at(sound, hz, 0.2, 0.04));
            EXPECT_NEAR(std::log(early / late), std::log(1000.0) * 0.15 / decay, 2e-3)
                << hz << " Hz, " << decay << " s";
        }
    }
}

/// A decay is computed block by block. After 3,900 blocks it must still be exponential.
TEST(AudioSynth, ALongDecayStaysExponential) {
    const auto sound = made(head(1.5) + tone(1000, "decay = 1.5"));
    const double early = std::abs(wave_at(sound, 1000, 0.1, 0.04)),
                 late = std::abs(wave_at(sound, 1000, 1.4, 0.04));
    EXPECT_NEAR(std::log(early / late), std::log(1000.0) * 1.3 / 1.5, 1e-6);
}

TEST(AudioSynth, PartialsHaveTheirRatiosLevelsAndDecays) {
    const auto sound =
        made(head(0.5) + tone(500, "decay = 1\nratios = [1, 2.7]\nlevels = [1, 0.5]\ndecays = [1, 0.25]"));
    const auto first = [&](double s) { return std::abs(wave_at(sound, 500, s, 0.04)); };
    const auto second = [&](double s) { return std::abs(wave_at(sound, 1350, s, 0.04)); };
    EXPECT_NEAR(frequency_at(sound, 1350, 0.1), 1350, 0.01);
    EXPECT_NEAR(std::log(second(0.05) / second(0.2)), std::log(1000.0) * 0.15 / 0.25, 5e-3);
    // Both waves rise for 2 ms before they decay. Through a window of 40 ms, an exponential decay with rate r
    // has its value in the middle times sinh(x)/x / (1 + (x/pi)^2), where x = r * 20 ms.
    const auto seen = [](double r) {
        const double x = r * 0.02;
        return std::sinh(x) / x / (1 + x * x / (pi * pi));
    };
    const double slow = std::log(1000.0), fast = slow / 0.25;
    const double wanted = 0.5 * std::exp(-(fast - slow) * 0.048) * seen(fast) / seen(slow);
    EXPECT_NEAR(second(0.05) / first(0.05), wanted, 0.005 * wanted);
}

TEST(AudioSynth, SweepGlidesEvenlyInOctaves) {
    const auto sound = made(head(1) + tone(400, "decay = 4\nsweep_to = 1600\nsweep_s = 0.8"));
    for (const double time : {0.1, 0.2, 0.4, 0.6, 0.7}) {
        const double hz = 400 * std::pow(4, time / 0.8);
        EXPECT_NEAR(frequency_at(sound, hz, time), hz, 0.004 * hz) << time;
    }
    EXPECT_NEAR(frequency_at(sound, 1600, 0.9), 1600, 0.05);
}

TEST(AudioSynth, VibratoDeviatesBySemitones) {
    const auto sound = made(head(1) + tone(2000, "decay = 10\nvibrato_hz = 2\nvibrato = 3"));
    const double up = 2000 * std::pow(2, 3 / 12.0), down = 2000 * std::pow(2, -3 / 12.0);
    EXPECT_NEAR(frequency_at(sound, up, 0.125), up, 0.005 * up);
    EXPECT_NEAR(frequency_at(sound, down, 0.375), down, 0.005 * down);
}

TEST(AudioSynth, TremoloTakesItsShare) {
    const auto sound = made(head(1) + tone(2000, "decay = 16\ntremolo_hz = 2\ntremolo = 0.6"));
    const double high = std::abs(wave_at(sound, 2000, 0.5, 0.02)),
                 low = std::abs(wave_at(sound, 2000, 0.25, 0.02));
    EXPECT_NEAR(low / high, 0.4 * std::exp(std::log(1000.0) * 0.25 / 16), 0.01);
}

TEST(AudioSynth, NotesHaveTheFrequenciesOfTheirKeys) {
    const auto sound = made(head(1) + part("score",
                                           "decay = 0.3\nbeats_per_minute = 120\nnotes = ["
                                           "{ beat = 0, beats = 0.5, key = 69 }, "
                                           "{ beat = 1, beats = 0.5, key = 81 }]"));
    EXPECT_NEAR(frequency_at(sound, 440, 0.1), 440, 0.01);
    EXPECT_NEAR(frequency_at(sound, 880, 0.65), 880, 0.05);
    EXPECT_NEAR(hz_of_key(60), 261.6255653, 1e-6);
    // The second note begins after one beat of 0.5 s.
    EXPECT_LT(std::abs(wave_at(sound, 880, 0.45, 0.08)), 1e-3 * std::abs(wave_at(sound, 880, 0.6, 0.08)));
}

/// Power of a second of noise in the bands [0, low), [low, high) and above.
std::array<double, 3> powers(std::string_view keys, double low, double high) {
    const auto sound = made(head(1.5) + part("noise", keys));
    std::array<double, 3> sums{};
    constexpr std::size_t n = 1U << 15U;
    std::vector<std::complex<double>> values(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double window = 1 - std::cos(2 * pi * static_cast<double>(i) / n);
        values[i] = window * static_cast<double>(sound.samples[12'000 + i]);
    }
    fourier(values);
    for (std::size_t i = 1; i < n / 2; ++i) {
        const double hz = static_cast<double>(i) * rate / n;
        sums[hz < low ? 0 : hz < high ? 1 : 2] += std::norm(values[i]);
    }
    const double all = sums[0] + sums[1] + sums[2];
    return {sums[0] / all, sums[1] / all, sums[2] / all};
}

TEST(AudioSynth, NoiseIsLimitedToItsBand) {
    // Two filters of second order in series: a low-pass or high-pass falls by 24 dB per octave, a band-pass
    // by 12 dB.
    EXPECT_LT(powers("filter = \"low\"\nhz = 1000", 1000, 4000)[2], 3e-4);
    EXPECT_GT(powers("filter = \"low\"\nhz = 1000", 1500, 4000)[0], 0.97);
    EXPECT_LT(powers("filter = \"high\"\nhz = 4000", 1000, 4000)[0], 1e-5);
    EXPECT_LT(powers("filter = \"high\"\nhz = 4000", 3000, 4000)[0], 2e-3);
    const auto band = powers("filter = \"band\"\nhz = 2000\nsharpness = 4", 1000, 4000);
    EXPECT_LT(band[0], 5e-3);
    EXPECT_LT(band[2], 5e-3);
    EXPECT_GT(powers("filter = \"band\"\nhz = 2000\nsharpness = 4", 1750, 2250)[1], 0.8);
}

TEST(AudioSynth, NoiseIsAsStrongInEveryBand) {
    for (const auto filter : {NoiseFilter::low, NoiseFilter::band, NoiseFilter::high}) {
        for (const double hz : {500.0, 2000.0, 8000.0}) {
            Noise noise;
            noise.pitch = {hz, hz, 1, 0, 0};
            noise.filter = filter;
            noise.sharpness = filter == NoiseFilter::band ? 3 : 0.7;
            Canvas canvas(2, true);
            add_noise(canvas, noise, random_stream(1, 1));
            double sum = 0;
            for (const double sample : canvas.samples()) sum += sample * sample;
            const double rms = std::sqrt(sum / static_cast<double>(canvas.size()));
            EXPECT_NEAR(rms, 0.35, 0.07) << static_cast<int>(filter) << " " << hz;
        }
    }
}

TEST(AudioSynth, EvenGrainsComeAtTheirRate) {
    const auto sound =
        made(head(1) + part("grains", "rate = 20\neven = 1\nspread = 0\nlow_hz = 3000\nring = 0.01"));
    int grains = 0;
    double before = 0;
    for (std::size_t from = 0; from + 480 <= sound.samples.size(); from += 480) {
        double loudest = 0;
        for (std::size_t i = from; i < from + 480; ++i)
            loudest = std::max(loudest, std::abs(static_cast<double>(sound.samples[i])));
        if (loudest > 0.4 && before <= 0.4) ++grains;
        before = loudest;
    }
    EXPECT_EQ(grains, 20);
}

TEST(AudioSynth, SineTableIsExact) {
    double worst = 0;
    for (int i = 0; i <= 100'000; ++i) {
        const double cycles = i / 100'000.0;
        worst = std::max(worst, std::abs(sine_of_cycles(cycles) - std::sin(2 * pi * cycles)));
    }
    EXPECT_LT(worst, 4e-7);
}

TEST(AudioAnalysis, FourierTransformIsTheSum) {
    Random random = random_stream(5, 5);
    constexpr std::size_t n = 64;
    std::vector<std::complex<double>> values(n);
    for (auto& value : values) value = {random.uniform(-1, 1), random.uniform(-1, 1)};
    auto fast = values;
    fourier(fast);
    for (std::size_t k = 0; k < n; ++k) {
        std::complex<double> sum = 0;
        for (std::size_t i = 0; i < n; ++i)
            sum += values[i] * std::polar(1.0, -2 * pi * static_cast<double>(i * k) / n);
        EXPECT_LT(std::abs(sum - fast[k]), 1e-12);
    }
}

TEST(AudioAnalysis, LoudnessAndPowerOfASine) {
    std::vector<float> samples(24'000);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<float>(0.5 * std::sin(2 * pi * 1000 * static_cast<double>(i) / rate));
    EXPECT_NEAR(loudest_db(samples), 20 * std::log10(0.5 / std::sqrt(2.0)), 0.01);
    EXPECT_EQ(loudest_db(std::vector<float>(4800)), -200);
    EXPECT_NEAR(peak_of(samples), 0.5, 1e-6);
    const auto spectrogram = spectrogram_of(samples, 5, 30);
    for (std::size_t column = 1; column < 4; ++column) {
        double sum = 0;
        for (std::size_t row = 0; row < 30; ++row) sum += spectrogram.at(column, row);
        EXPECT_NEAR(sum, 0.125, 0.002);
        const auto row = static_cast<std::size_t>(30 * std::log(1000 / lowest_row_hz) /
                                                  std::log(highest_row_hz / lowest_row_hz));
        EXPECT_GT(spectrogram.at(column, row), 0.8 * sum);
    }
}

}  // namespace
}  // namespace thaum::audio
