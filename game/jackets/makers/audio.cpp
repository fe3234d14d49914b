#include "game/jackets/makers/audio.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "audio/channels.h"
#include "core/one_line.h"
#include "core/text.h"
#include "game/jackets/jacket.h"
#include "game/jackets/jacket_output.h"
#include "game/jackets/place_name.h"

namespace thaum::game::inline jackets {
namespace {

constexpr std::size_t max_words_shown = 60, max_of_name_shown = 100;
/// Largest number of sound blocks that one call writes. A device that wants ever more blocks would otherwise
/// keep a core busy.
constexpr std::size_t max_at_once = 4;
/// Number of calls in a row in which the device may take no block of sound before it is given up. The thread
/// that plays on jackets (TactilePlayer) calls about every 4 ms.
constexpr int max_idle_looks = 500;
constexpr Tick longest_life = 500;
/// When the output closes: number of blocks in which the waves fade out, and how often the device is asked to
/// take them.
constexpr int last_blocks = 3, max_last_looks = 15;
constexpr std::chrono::milliseconds between_last_looks{4};

class AudioJacket final : public JacketOutput {
public:
    AudioJacket(std::string name, std::size_t channels, std::unique_ptr<audio::SoundDevice> device)
        : name_(std::move(name)), device_(std::move(device)), tones_(channels) {}
    ~AudioJacket() override { AudioJacket::close(); }

    Expected<void> open() override;
    void write(const tactile::TactileFrame& frame, double now_s) override;
    void silence() override;
    bool is_connected() override;
    void close() override;
    std::string name() const override { return name_; }

private:
    std::size_t feed();

    const std::string name_;
    const std::unique_ptr<audio::SoundDevice> device_;
    audio::ChannelTones tones_;
    bool open_ = false;
    /// Blocks of sound until the last frame (amplitudes of all actuators) no longer holds
    std::size_t blocks_left_ = 0;
    int idle_looks_ = 0;  ///< calls of is_connected() in a row at which the device took no block of sound
};

Expected<void> AudioJacket::open() {
    close();
    if (auto opened = device_->open(); !opened) return opened;
    open_ = true;
    idle_looks_ = 0;
    tones_ = audio::ChannelTones(tones_.channels());
    return {};
}

void AudioJacket::write(const tactile::TactileFrame& frame, double) {
    const auto known = std::min<std::size_t>(frame.count, tactile::frame_capacity);
    for (std::size_t i = 0; i < tones_.channels(); ++i)
        tones_.set(i, i < known ? audio::ChannelTone{frame.amplitude[i], frame.carrier_hz[i]}
                                : audio::ChannelTone{});
    blocks_left_ = std::min(frame.time_to_live, longest_life) / audio::frame_ticks;
    feed();
}

void AudioJacket::silence() {
    tones_.silence();
    feed();
}

/// Writes the blocks that the device wants. Returns their number.
std::size_t AudioJacket::feed() {
    if (!open_) return 0;
    std::array<float, audio::max_channels * audio::frame_samples> block{};
    const auto values = std::span(block).first(tones_.channels() * audio::frame_samples);
    const auto wanted = std::min(device_->wanted(), max_at_once);
    for (std::size_t i = 0; i < wanted; ++i) {
        if (blocks_left_ == 0)
            tones_.silence();
        else
            --blocks_left_;
        tones_.mix(values);
        device_->write(values);
    }
    return wanted;
}

bool AudioJacket::is_connected() {
    if (!open_) return false;
    if (!device_->is_connected()) {
        fault_ = "the sound device is gone";
        return false;
    }
    idle_looks_ = feed() > 0 ? 0 : idle_looks_ + 1;
    if (idle_looks_ < max_idle_looks) return true;
    fault_ = "the sound device takes no sound";
    return false;
}

/// Lets the waves end before the device is closed.
void AudioJacket::close() {
    if (!open_) return;
    const bool fade = !tones_.is_silent() && device_->is_connected();
    blocks_left_ = 0;
    int written = 0;
    for (int i = 0; fade && i < max_last_looks && written < last_blocks; ++i) {
        written += static_cast<int>(feed());
        std::this_thread::sleep_for(between_last_looks);
    }
    device_->close();
    open_ = false;
}

Expected<std::string> read(std::string_view, std::string_view device) {
    if (fits_name(device)) return std::string(device);
    return fail("write a device's name after the colon, as `thaum doctor` prints it");
}

std::string audio_name(const Jacket& jacket) {
    const auto where = jacket.place.empty() ? std::string("the usual sound device")
                                            : text("'", printable(jacket.place, max_words_shown), "'");
    return text(jacket.layout().motors, " shakers on ", where);
}

std::unique_ptr<input::TactileOutput> make(const Jacket& jacket, std::uint32_t) {
    const auto channels = jacket.layout().motors;
    return audio_jacket(audio_name(jacket), channels, audio::openal_channels(jacket.place, channels));
}

std::vector<FoundJacket> find() {
    std::vector<FoundJacket> found;
    for (const auto& name : audio::sound_device_names())
        found.push_back({"shakers", text("could be on \"audio:", printable(name, max_of_name_shown), "\"")});
    return found;
}

// A setting without a device's name means the usual sound device.
const JacketRegistration registration({.name = "audio",
                                       .order = 4,
                                       .forms = {{"audio", {"speakers", 2}, ""},
                                                 {"audio8", {"shakers8", 8}, ""}},
                                       .shown = {"audio", "audio8", "audio:DEVICE"},
                                       .read = read,
                                       .make = make,
                                       .find = find});

}  // namespace

std::unique_ptr<input::TactileOutput> audio_jacket(std::string name, std::size_t channels,
                                                   std::unique_ptr<audio::SoundDevice> device) {
    return std::make_unique<AudioJacket>(std::move(name), channels, std::move(device));
}

}  // namespace thaum::game::inline jackets
