// audio/analysis.h: measures of sounds: loudness, spectrogram, and a signature to tell sounds apart.
#pragma once
#include <array>
#include <complex>
#include <span>
#include <vector>

namespace thaum::audio {

/// Fourier transform in place. The number of values must be a power of two.
void fourier(std::span<std::complex<double>> values);

/// Largest absolute value of the samples.
double peak_of(std::span<const float> samples);

/// Level of the loudest 50 ms (dB; 0 is a root mean square of 1); -200 for silence.
double loudest_db(std::span<const float> samples);

/// Power over time and frequency. The rows are bands of equal width in octaves, the lowest first.
struct Spectrogram {
    std::size_t columns{}, rows{};
    /// Column by column. The powers of a column add up to about the mean square of the samples at that time.
    std::vector<double> power;

    /// Power in one column (time) and row (band of frequencies).
    double at(std::size_t column, std::size_t row) const { return power[column * rows + row]; }
};

/// Lowest and highest frequency of a spectrogram (Hz): the outer ends of its rows.
inline constexpr double lowest_row_hz = 40, highest_row_hz = 16'000;

/// Power of a sound at `columns` times and `rows` frequencies, from lowest_row_hz to
/// highest_row_hz in equal steps of pitch.
Spectrogram spectrogram_of(std::span<const float> samples, std::size_t columns, std::size_t rows);

/// Numbers of bands and of quarters in a signature. A signature describes the shape of a sound in time and
/// frequency, without its loudness. For each quarter of the audible part it holds the level of each band
/// above a floor, which is 24 dB below the loudest band (dB, at least 0). Its last number is 12 times the
/// binary logarithm of the length of the audible part in s, so that twice the length counts as 12 dB.
inline constexpr std::size_t signature_bands = 24, signature_quarters = 4;
/// Signature of a sound: the levels by quarter and band (dB), then the number for the length.
using Signature = std::array<double, signature_bands * signature_quarters + 1>;

/// Signature of a sound at 48 kHz: numbers that describe its shape in time and frequency, without its
/// loudness.
Signature signature_of(std::span<const float> samples);

/// Distance of two sounds by their signatures: root mean square of the differences between the numbers (dB).
double distance(const Signature& a, const Signature& b);

}  // namespace thaum::audio
