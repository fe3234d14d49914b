// audio/wav.h: writes samples to a WAV file.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "audio/sound.h"
#include "core/error.h"
#include "core/file_writer.h"

namespace thaum::audio {

/// Number format of the samples in a file.
enum class WavFormat : std::uint8_t {
    whole_16,  ///< 16-bit integers, which every program reads
    float_32,  ///< the mixer's own 32-bit floats, bit for bit
};

/// A WAV file at 48 kHz. Unless `close` is called, no file is left (core/file_writer.h).
class WavWriter {
public:
    /// Starts a file. `channels`: 1, or 2 for stereo. The error names the path and says why the file cannot
    /// be created.
    static Expected<WavWriter> create(std::filesystem::path path, WavFormat format,
                                      std::uint16_t channels = 2);

    /// Appends samples, in stereo left and right in turn. Values outside -1 to 1 are clipped, NaN becomes 0.
    void write(std::span<const float> samples);
    /// Completes the header and the file. The error names the path and says why the file cannot be written,
    /// such as more than 4 GB of samples.
    Expected<void> close();
    /// Length of what was written (s).
    double seconds() const;

private:
    WavWriter(FileWriter file, std::filesystem::path path, WavFormat format, std::uint16_t channels);
    Bytes header() const;

    FileWriter file_;
    std::filesystem::path path_;
    WavFormat format_;
    std::uint16_t channels_;
    std::uint64_t values_{};  ///< number of samples written, over all channels
};

}  // namespace thaum::audio
