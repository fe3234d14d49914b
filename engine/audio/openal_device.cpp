#include <optional>

#include "audio/detail/block_stream.h"
#include "audio/sound_device.h"

namespace thaum::audio {
namespace {

class OpenAlDevice final : public SoundDevice {
public:
    ~OpenAlDevice() override { end(); }

    Expected<void> open() override {
        end();
        if (!al_.set_thread_context) {
            const auto found = detail::find_openal();
            if (!found) return tl::unexpected(found.error());
            al_ = *found;
        }
        device_ = alcOpenDevice(nullptr);
        if (device_ == nullptr) return fail("no sound device was found");
        const ALCint attributes[] = {ALC_FREQUENCY, static_cast<ALCint>(sample_rate), 0};
        context_ = alcCreateContext(device_, attributes);
        if (context_ == nullptr) {
            end();
            return fail("the sound device does not play");
        }
        ALCint periods_per_second = 0;
        alcGetIntegerv(device_, ALC_REFRESH, 1, &periods_per_second);
        const detail::ContextScope scope(al_, context_);
        stream_.emplace(detail::blocks_to_queue(sample_rate / static_cast<double>(periods_per_second)));
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

    detail::OpenAl al_{};
    ALCdevice* device_{};
    ALCcontext* context_{};
    std::optional<detail::BlockStream> stream_;
};

}  // namespace

std::unique_ptr<SoundDevice> openal_device() { return std::make_unique<OpenAlDevice>(); }

}  // namespace thaum::audio
