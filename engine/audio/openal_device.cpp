#include <optional>
#include <utility>

#include "audio/detail/block_stream.h"
#include "audio/sound_device.h"

namespace thaum::audio {
namespace {

// Numbers of the extension ALC_SOFT_output_mode, which headers older than OpenAL Soft 1.22 lack.
constexpr ALCenum output_mode = 0x19AC;
constexpr ALCint surround_7_1 = 0x1506;

class OpenAlDevice final : public SoundDevice {
public:
    OpenAlDevice() = default;
    OpenAlDevice(std::string name, std::size_t channels) : name_(std::move(name)), channels_(channels) {}
    ~OpenAlDevice() override { end(); }

    Expected<void> open() override {
        end();
        if (!al_.set_thread_context) {
            const auto found = detail::find_openal();
            if (!found) return found.error();
            al_ = *found;
        }
        device_ = alcOpenDevice(name_.empty() ? nullptr : name_.c_str());
        if (device_ == nullptr)
            return fail(name_.empty() ? "no sound device was found"
                                      : "there is no sound device of this name");
        // OpenAL's auxiliary sends are needed for reverberation only. Without them OpenAL needs less memory
        // for its voices.
        const ALCint attributes[] = {ALC_FREQUENCY, static_cast<ALCint>(sample_rate), ALC_MAX_AUXILIARY_SENDS,
                                     0, 0};
        context_ = alcCreateContext(device_, attributes);
        if (context_ == nullptr || !has_channels()) {
            const bool plays = context_ != nullptr;
            end();
            return fail(plays ? "the sound device does not have the eight channels of 7.1 sound"
                              : "the sound device does not play");
        }
        ALCint periods_per_second = 0;
        alcGetIntegerv(device_, ALC_REFRESH, 1, &periods_per_second);
        const detail::ContextScope scope(al_, context_);
        stream_.emplace(detail::blocks_to_queue(sample_rate / static_cast<double>(periods_per_second)),
                        channels_);
        return {};
    }

    std::size_t wanted() override {
        const detail::ContextScope scope(al_, context_);
        return stream_->wanted();
    }

    void write(std::span<const float> block) override {
        const detail::ContextScope scope(al_, context_);
        stream_->write(block);
    }

    bool is_connected() override {
        ALCint connected = ALC_TRUE;
        if (alcIsExtensionPresent(device_, "ALC_EXT_disconnect") != ALC_FALSE)
            alcGetIntegerv(device_, ALC_CONNECTED, 1, &connected);
        return connected == ALC_TRUE;
    }

    void close() override { end(); }

private:
    /// Whether the device has the channels that were asked for. If OpenAL cannot tell their number, the
    /// device is assumed to have them.
    bool has_channels() const {
        if (channels_ == 2 || alcIsExtensionPresent(device_, "ALC_SOFT_output_mode") == ALC_FALSE)
            return true;
        ALCint mode = 0;
        alcGetIntegerv(device_, output_mode, 1, &mode);
        return mode == surround_7_1;
    }

    void end() {
        if (stream_) {
            const detail::ContextScope scope(al_, context_);
            stream_->destroy();
        }
        stream_.reset();
        if (context_ != nullptr) alcDestroyContext(context_);
        if (device_ != nullptr) alcCloseDevice(device_);
        context_ = nullptr;
        device_ = nullptr;
    }

    const std::string name_{};
    const std::size_t channels_ = 2;
    detail::OpenAl al_{};
    ALCdevice* device_{};
    ALCcontext* context_{};
    std::optional<detail::BlockStream> stream_;
};

}  // namespace

std::unique_ptr<SoundDevice> openal_device() { return std::make_unique<OpenAlDevice>(); }

std::unique_ptr<SoundDevice> openal_channels(std::string name, std::size_t channels) {
    return std::make_unique<OpenAlDevice>(std::move(name), channels);
}

std::vector<std::string> sound_device_names() {
    prepare_openal();
    std::vector<std::string> names;
    // The list consists of names that each end in NUL; an empty name ends the list.
    const ALCchar* word = alcGetString(nullptr, ALC_ALL_DEVICES_SPECIFIER);
    for (; word != nullptr && *word != '\0'; word += names.back().size() + 1) names.emplace_back(word);
    return names;
}

}  // namespace thaum::audio
