#include "audio/wav.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/text.h"

namespace thaum::audio {
namespace {

/// Most bytes of samples in a WAV file: its sizes are 32-bit numbers, and 100 bytes are left for the header.
constexpr std::uint64_t max_wav_bytes = std::numeric_limits<std::uint32_t>::max() - 100;

std::uint16_t bytes_of(WavFormat format) { return format == WavFormat::whole_16 ? 2 : 4; }

void put_name(ByteWriter& out, std::string_view name) {
    out.put_bytes(std::as_bytes(std::span(name.data(), name.size())));
}

float clipped_sample(float sample) { return std::isnan(sample) ? 0.0F : std::clamp(sample, -1.0F, 1.0F); }

}  // namespace

WavWriter::WavWriter(FileWriter file, std::filesystem::path path, WavFormat format, std::uint16_t channels)
    : file_(std::move(file)), path_(std::move(path)), format_(format), channels_(channels) {
    file_.write(header());
}

Expected<WavWriter> WavWriter::create(std::filesystem::path path, WavFormat format, std::uint16_t channels) {
    auto file = FileWriter::create(path);
    if (!file) return file.error();
    return WavWriter(std::move(*file), std::move(path), format, channels);
}

/// Makes the header: RIFF with the chunks "fmt ", "fact" (length in samples) and "data".
Bytes WavWriter::header() const {
    const std::uint16_t size = bytes_of(format_);
    const auto frame_size = static_cast<std::uint16_t>(size * channels_);
    const auto data_size = static_cast<std::uint32_t>(values_ * size);
    constexpr std::uint32_t fmt_size = 18, fact_size = 4, chunk_head = 8;
    constexpr std::uint32_t whole_numbers = 1, floating_point = 3;
    Bytes bytes;
    ByteWriter out(bytes);
    put_name(out, "RIFF");
    out.put(4 + chunk_head + fmt_size + chunk_head + fact_size + chunk_head + data_size);
    put_name(out, "WAVE");
    put_name(out, "fmt ");
    out.put(fmt_size);
    out.put(static_cast<std::uint16_t>(format_ == WavFormat::whole_16 ? whole_numbers : floating_point));
    out.put(channels_);
    out.put(sample_rate);
    out.put(static_cast<std::uint32_t>(sample_rate * frame_size));
    out.put(frame_size);
    out.put(static_cast<std::uint16_t>(8 * size));
    out.put(std::uint16_t{0});  // size of the chunk's extension: none
    put_name(out, "fact");
    out.put(fact_size);
    out.put(static_cast<std::uint32_t>(values_ / channels_));
    put_name(out, "data");
    out.put(data_size);
    return bytes;
}

void WavWriter::write(std::span<const float> samples) {
    const auto write_as = [&](auto convert) {
        std::array<decltype(convert(0.0F)), 1024> piece;
        for (auto remaining = samples; !remaining.empty();
             remaining = remaining.subspan(std::min(remaining.size(), piece.size()))) {
            const auto count = std::min(remaining.size(), piece.size());
            std::transform(remaining.begin(), remaining.begin() + static_cast<std::ptrdiff_t>(count),
                           piece.begin(), convert);
            file_.write(std::as_bytes(std::span(piece).first(count)));
        }
    };
    values_ += samples.size();
    // A WAV file cannot hold this many samples; `close` reports it.
    if (values_ * bytes_of(format_) > max_wav_bytes) return;
    if (format_ == WavFormat::float_32)
        write_as(clipped_sample);
    else
        write_as([](float sample) {
            return static_cast<std::int16_t>(std::lround(clipped_sample(sample) * 32767.0F));
        });
}

Expected<void> WavWriter::close() {
    if (values_ * bytes_of(format_) > max_wav_bytes)
        return fail(
            text(path_.string(), ": a WAV file holds 4 GB and no more; write 16 bits, or a shorter part"));
    file_.replace_start(header());
    return file_.close();
}

double WavWriter::seconds() const {
    return static_cast<double>(values_) / (channels_ * static_cast<double>(sample_rate));
}

}  // namespace thaum::audio
