// audio/channels.h: sine waves on the channels of a sound device, for speakers and
// shakers that are worn on the body.
//
//     ChannelTones tones(8);
//     tones.set(3, {.amplitude = 0.5, .hz = 80});
//     tones.mix(block);       // 384 samples for each channel, a value for each channel in turn
//
// An amplitude moves to its new value along a straight line over the next block (8 ms), and the phase of a
// wave goes on when its frequency changes. So nothing clicks.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "audio/frame.h"

namespace thaum::audio {

inline constexpr std::size_t max_channels = 8;
/// Speakers of 7.1 sound, in the order of OpenAL's samples.
inline constexpr std::array<std::string_view, max_channels> surround_channels{
    "front left", "front right", "front centre", "bass",
    "back left",  "back right",  "side left",    "side right"};

/// One sine wave.
struct ChannelTone {
    double amplitude{};  ///< amplitude of the wave, 0 to 1
    double hz{};         ///< frequency (Hz)
};

/// One sine wave for each channel of a device.
class ChannelTones {
public:
    static constexpr double lowest_hz = 5, highest_hz = 1000;

    /// Makes silent waves for 1 to max_channels channels.
    explicit ChannelTones(std::size_t channels) : channels_(channels) {}

    /// Changes the wave of a channel within the next block. The amplitude is clipped to 0 to 1; NaN counts as
    /// 0. The frequency is clipped to lowest_hz to highest_hz; one that is not above 0, or NaN, changes
    /// nothing.
    void set(std::size_t channel, const ChannelTone& tone);
    /// Fades all waves out within the next block.
    void silence();
    /// Makes the next block: channels() * frame_samples values within -1 to 1.
    void mix(std::span<float> block);

    /// Number of channels, each of which has one wave.
    std::size_t channels() const { return channels_; }
    /// Whether the next block is silent from its first sample on, unless a wave is set.
    bool is_silent() const;

private:
    struct Wave {
        double amplitude{};  ///< amplitude of the wave at the end of the last block
        double wanted{};     ///< amplitude of the wave at the end of the next block
        double hz{100};
        double phase{};  ///< phase of the wave as a share of its period, 0 to 1
    };

    std::size_t channels_;
    std::array<Wave, max_channels> waves_{};
};

}  // namespace thaum::audio
