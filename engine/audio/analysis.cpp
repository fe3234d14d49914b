#include "audio/analysis.h"

#include <algorithm>
#include <cmath>

#include "audio/sound.h"
#include "core/assert.h"
#include "core/maths.h"
#include "core/sin_cos.h"

namespace thaum::audio {
namespace {

constexpr std::size_t window_samples = 2048;
/// In a signature (the numbers by which two sounds are compared), a band of frequencies counts as silent if
/// it is this far below the loudest band (dB).
constexpr double signature_floor_db = 24;
/// The audible part of a sound is its shortest beginning that holds this share of its energy.
constexpr double audible_share = 0.97;
/// The last number of a signature (the numbers by which two sounds are compared) stands for the length of the
/// sound. It grows by this amount when the length doubles (dB).
constexpr double octave_of_length_db = 12;

double decibels(double power) { return power <= 1e-20 ? -200 : 10 / det::log(10) * det::log(power); }

const std::vector<double>& hann_window() {
    static const std::vector<double> window = [] {
        std::vector<double> made(window_samples);
        for (std::size_t i = 0; i < window_samples; ++i)
            made[i] = 0.5 - 0.5 * det::cos(2 * pi * (static_cast<double>(i) + 0.5) / window_samples);
        return made;
    }();
    return window;
}

/// Power of each line (frequency) of the spectrum of the samples around the index `middle`.
std::vector<double> lines_around(std::span<const float> samples, std::ptrdiff_t middle) {
    std::vector<std::complex<double>> values(window_samples);
    const auto& window = hann_window();
    for (std::size_t i = 0; i < window_samples; ++i) {
        const auto at =
            middle + static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(window_samples / 2);
        if (at >= 0 && at < static_cast<std::ptrdiff_t>(samples.size()))
            values[i] = window[i] * static_cast<double>(samples[static_cast<std::size_t>(at)]);
    }
    fourier(values);
    std::vector<double> lines(window_samples / 2);
    constexpr double scale =
        2.0 / (0.375 * window_samples * window_samples);  // 0.375 is the mean square of the Hann window
    for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = std::norm(values[i]) * scale;
    return lines;
}

/// Power of the lines between two frequencies. A line that lies partly between them counts in part.
double power_between(const std::vector<double>& lines, double low_hz, double high_hz) {
    constexpr double line_hz = static_cast<double>(sample_rate) / window_samples;
    const double low = low_hz / line_hz, high = high_hz / line_hz;
    double sum = 0;
    for (auto i = static_cast<std::size_t>(std::lround(low)); i < lines.size(); ++i) {
        const double from = std::max(low, static_cast<double>(i) - 0.5);
        const double to = std::min(high, static_cast<double>(i) + 0.5);
        if (to <= from) break;
        sum += lines[i] * (to - from);
    }
    return sum;
}

}  // namespace

void fourier(std::span<std::complex<double>> values) {
    const std::size_t n = values.size();
    THAUM_ASSERT(n > 0 && (n & (n - 1)) == 0, "the number of values must be a power of two");
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
        j ^= bit;
        if (i < j) std::swap(values[i], values[j]);
    }
    for (std::size_t half = 1; half < n; half *= 2) {
        for (std::size_t k = 0; k < half; ++k) {
            const auto [sine, cosine] =
                det::sin_cos(-pi * static_cast<double>(k) / static_cast<double>(half));
            for (std::size_t i = k; i < n; i += 2 * half) {
                const auto a = values[i], b = values[i + half];
                const std::complex<double> turned(b.real() * cosine - b.imag() * sine,
                                                  b.real() * sine + b.imag() * cosine);
                values[i] = a + turned;
                values[i + half] = a - turned;
            }
        }
    }
}

double peak_of(std::span<const float> samples) {
    double peak = 0;
    for (const float sample : samples) peak = std::max(peak, std::abs(static_cast<double>(sample)));
    return peak;
}

double loudest_db(std::span<const float> samples) {
    const std::size_t window = sample_rate / 20, step = sample_rate / 200;
    double loudest = 0;
    for (std::size_t from = 0; from == 0 || from + window <= samples.size(); from += step) {
        double sum = 0;
        for (std::size_t i = from; i < std::min(from + window, samples.size()); ++i)
            sum += static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
        loudest = std::max(loudest, sum / static_cast<double>(window));
    }
    return decibels(loudest);
}

Spectrogram spectrogram_of(std::span<const float> samples, std::size_t columns, std::size_t rows) {
    Spectrogram result{columns, rows, std::vector<double>(columns * rows)};
    const double octaves = det::log(highest_row_hz / lowest_row_hz);
    std::vector<double> ends(rows + 1);
    for (std::size_t row = 0; row <= rows; ++row)
        ends[row] = lowest_row_hz * det::exp(octaves * static_cast<double>(row) / static_cast<double>(rows));
    for (std::size_t column = 0; column < columns; ++column) {
        const double share = (static_cast<double>(column) + 0.5) / static_cast<double>(columns);
        const auto middle = static_cast<std::ptrdiff_t>(share * static_cast<double>(samples.size()));
        const auto lines = lines_around(samples, middle);
        for (std::size_t row = 0; row < rows; ++row)
            result.power[column * rows + row] = power_between(lines, ends[row], ends[row + 1]);
    }
    return result;
}

namespace {

/// The shortest beginning of a sound that holds `audible_share` of its energy.
std::span<const float> audible_part(std::span<const float> samples) {
    double whole = 0, sum = 0;
    for (const float sample : samples) whole += static_cast<double>(sample) * static_cast<double>(sample);
    std::size_t count = 0;
    for (; count < samples.size() && sum < audible_share * whole; ++count)
        sum += static_cast<double>(samples[count]) * static_cast<double>(samples[count]);
    return samples.first(count);
}

}  // namespace

Signature signature_of(std::span<const float> samples) {
    const auto audible = audible_part(samples);
    constexpr std::size_t moments = 4;  // columns (moments) of the spectrogram in each quarter of the sound
    const auto spectrogram = spectrogram_of(audible, signature_quarters * moments, signature_bands);
    Signature signature{};
    double loudest = -200;
    for (std::size_t quarter = 0; quarter < signature_quarters; ++quarter) {
        for (std::size_t band = 0; band < signature_bands; ++band) {
            double sum = 0;
            for (std::size_t i = 0; i < moments; ++i) sum += spectrogram.at(quarter * moments + i, band);
            auto& cell = signature[quarter * signature_bands + band];
            cell = decibels(sum);
            loudest = std::max(loudest, cell);
        }
    }
    for (auto& cell : signature) cell = std::max(0.0, cell - loudest + signature_floor_db);
    const double seconds = std::max(0.01, static_cast<double>(audible.size()) / sample_rate);
    signature.back() = octave_of_length_db * det::log(seconds) / det::log(2);
    return signature;
}

double distance(const Signature& a, const Signature& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace thaum::audio
