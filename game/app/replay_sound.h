// game/app/replay_sound.h: writes what players hear during a replayed match to a WAV file. Equal logs give
// equal files.
#pragma once
#include <filesystem>
#include <optional>

#include "audio/mixer.h"
#include "audio/wav.h"
#include "game/senses/sound/sound_scene.h"

namespace thaum::game::inline app {

class ReplaySound {
public:
    /// `ears`: the player who listens; std::nullopt: both, mixed. The error is one line.
    static Expected<ReplaySound> create(const std::filesystem::path& file, std::optional<std::uint32_t> ears,
                                        const MatchData& data, const std::filesystem::path& assets);

    /// Appends the sound of the last eight ticks, at every eighth tick.
    void follow(const Simulation& match);
    /// Lets the last sounds end, then completes the file.
    Expected<void> close();

private:
    ReplaySound(audio::WavWriter file, audio::Mixer mixer, SoundScene scene,
                std::optional<std::uint32_t> ears)
        : file_(std::move(file)), mixer_(std::move(mixer)), scene_(std::move(scene)), ears_(ears) {}

    audio::WavWriter file_;
    audio::Mixer mixer_;
    SoundScene scene_;
    std::optional<std::uint32_t> ears_;
    audio::AudioFrame frame_{};
    std::array<float, audio::block_values> block_{};
};

}  // namespace thaum::game::inline app
