// Tests of WAV files: what other programs read from them, and that no incomplete file is left.
#include "audio/wav.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

#include "core/bytes.h"
#include "core/file.h"
#include "unit/message_of.h"

namespace thaum::audio {
namespace {

namespace fs = std::filesystem;

class Wav : public ::testing::Test {
protected:
    fs::path file() const { return folder_.path() / "heard.wav"; }
    bool folder_is_empty() const { return fs::is_empty(folder_.path()); }

    Bytes written(WavFormat format, const std::vector<float>& stereo, std::uint16_t channels = 2) const {
        auto writer = WavWriter::create(file(), format, channels);
        EXPECT_TRUE(writer);
        if (!writer) return {};
        // Writes the samples in pieces of odd lengths.
        for (std::size_t at = 0; at < stereo.size(); at += 770)
            writer->write(std::span(stereo).subspan(at, std::min<std::size_t>(770, stereo.size() - at)));
        EXPECT_EQ(writer->seconds(), static_cast<double>(stereo.size()) / (48'000 * channels));
        const auto closed = writer->close();
        EXPECT_TRUE(closed) << (closed ? "" : closed.error().message);
        return *read_file(file(), 1U << 20U);
    }

private:
    TemporaryFolder folder_;
};

/// The header of a WAV file, in the layout of the format's description.
struct Header {
    std::string riff, wave, fmt, fact, data;
    std::uint32_t file_size, fmt_size, rate, bytes_per_second, fact_size, frames, data_size;
    std::uint16_t tag, channels, frame_size, bits, extra;
};

std::string name_in(ByteReader& in) {
    const auto bytes = in.get_bytes(4);
    return {reinterpret_cast<const char*>(bytes.data()), 4};
}

Header read_header(ByteReader& in) {
    Header h{};
    h.riff = name_in(in), h.file_size = in.get<std::uint32_t>(), h.wave = name_in(in);
    h.fmt = name_in(in), h.fmt_size = in.get<std::uint32_t>();
    h.tag = in.get<std::uint16_t>(), h.channels = in.get<std::uint16_t>();
    h.rate = in.get<std::uint32_t>(), h.bytes_per_second = in.get<std::uint32_t>();
    h.frame_size = in.get<std::uint16_t>(), h.bits = in.get<std::uint16_t>(),
    h.extra = in.get<std::uint16_t>();
    h.fact = name_in(in), h.fact_size = in.get<std::uint32_t>(), h.frames = in.get<std::uint32_t>();
    h.data = name_in(in), h.data_size = in.get<std::uint32_t>();
    return h;
}

std::vector<float> ramp(std::size_t count) {
    std::vector<float> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = static_cast<float>(std::sin(0.01 * static_cast<double>(i)));
    return values;
}

TEST_F(Wav, NumbersOf32BitsAreTheMixersOwn) {
    const auto samples = ramp(5000);
    const auto bytes = written(WavFormat::float_32, samples);
    ByteReader in(bytes);
    const auto h = read_header(in);
    EXPECT_EQ(h.riff + h.wave + h.fmt + h.fact + h.data, "RIFFWAVEfmt factdata");
    EXPECT_EQ(h.file_size, bytes.size() - 8);
    EXPECT_EQ(h.data_size, 5000U * 4);
    EXPECT_EQ(h.frames, 2500U);
    EXPECT_EQ(h.tag, 3);
    EXPECT_EQ(h.bits, 32);
    EXPECT_EQ(h.frame_size, 8);
    EXPECT_EQ(h.bytes_per_second, 48'000U * 8);
    for (const float sample : samples) ASSERT_EQ(in.get<float>(), sample);
    EXPECT_EQ(in.left(), 0U);
}

TEST_F(Wav, OneChannelHasFramesOfOneSample) {
    const auto samples = ramp(5000);
    const auto bytes = written(WavFormat::float_32, samples, 1);
    ByteReader in(bytes);
    const auto h = read_header(in);
    EXPECT_EQ(h.channels, 1);
    EXPECT_EQ(h.frames, 5000U);
    EXPECT_EQ(h.frame_size, 4);
    EXPECT_EQ(h.bytes_per_second, 48'000U * 4);
    EXPECT_EQ(h.data_size, 5000U * 4);
    for (const float sample : samples) ASSERT_EQ(in.get<float>(), sample);
    EXPECT_EQ(in.left(), 0U);
}

TEST_F(Wav, WholeNumbersOf16BitsAreRoundedAndClipped) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const auto bytes = written(WavFormat::whole_16, {0, 1, -1, 0.5F, 3, -1e30F, nan, 1e-6F});
    ByteReader in(bytes);
    const auto h = read_header(in);
    EXPECT_EQ(h.fmt_size, 18U);
    EXPECT_EQ(h.fact_size, 4U);
    EXPECT_EQ(h.extra, 0);
    EXPECT_EQ(h.tag, 1);
    EXPECT_EQ(h.channels, 2);
    EXPECT_EQ(h.rate, 48'000U);
    EXPECT_EQ(h.bits, 16);
    EXPECT_EQ(h.bytes_per_second, 48'000U * 4);
    EXPECT_EQ(h.data_size, 16U);
    EXPECT_EQ(h.file_size, bytes.size() - 8);
    for (const int wanted : {0, 32767, -32767, 16384, 32767, -32767, 0, 0})
        EXPECT_EQ(in.get<std::int16_t>(), wanted);
    EXPECT_TRUE(in.ok());
}

TEST_F(Wav, AFileThatIsNotClosedLeavesNothing) {
    {
        auto writer = WavWriter::create(file(), WavFormat::float_32).value();
        writer.write(ramp(100'000));
    }
    EXPECT_TRUE(folder_is_empty());
}

TEST_F(Wav, AFolderThatDoesNotExistIsAnErrorOfOneLine) {
    const auto message = message_of(WavWriter::create(file() / "no" / "heard.wav", WavFormat::whole_16));
    EXPECT_NE(message.find("heard.wav"), std::string::npos);
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

}  // namespace
}  // namespace thaum::audio
