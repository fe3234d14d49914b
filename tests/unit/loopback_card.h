// A loopback device of OpenAL that serves as a sound card with any rate and two or eight channels.
#pragma once
#include <gtest/gtest.h>

#include <vector>

#include "audio/detail/openal.h"

namespace thaum::audio::rig {

class Card {
public:
    explicit Card(int rate, std::size_t channels = 2) : channels_(channels) {
        al_ = detail::find_openal().value();
        device_ = al_.open_loopback(nullptr);
        const ALCint speakers = channels == 2 ? ALC_STEREO_SOFT : ALC_7POINT1_SOFT;
        const ALCint attributes[] = {
            ALC_FREQUENCY, rate, ALC_FORMAT_CHANNELS_SOFT, speakers, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT, 0};
        context_ = alcCreateContext(device_, attributes);
        EXPECT_NE(context_, nullptr);
    }
    ~Card() {
        alcDestroyContext(context_);
        alcCloseDevice(device_);
    }
    Card(const Card&) = delete;
    Card& operator=(const Card&) = delete;

    detail::ContextScope enter() { return {al_, context_}; }
    void render(std::vector<float>& heard, std::size_t frames) {
        heard.resize(heard.size() + channels_ * frames);
        al_.render(device_, heard.data() + heard.size() - channels_ * frames, static_cast<ALCsizei>(frames));
    }

private:
    std::size_t channels_;
    detail::OpenAl al_{};
    ALCdevice* device_{};
    ALCcontext* context_{};
};

}  // namespace thaum::audio::rig
