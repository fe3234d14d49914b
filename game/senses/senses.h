// game/senses/senses.h: what both players hear and feel of a match, computed without loudspeakers and motors,
// for pictures of replays, scenarios and benchmarks. The match is never changed.
#pragma once
#include <filesystem>
#include <memory>

#include "audio/synth.h"
#include "game/senses/felt_words.h"
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/tactile_scene.h"

namespace thaum::game::inline senses {

/// Sounds, effects on the body, and the layout (places of the motors) of the body figure in the view.
struct SenseData {
    audio::SoundBank bank;
    tactile::EffectBank effects;
    tactile::Layout figure;

    /// Loads the data. The error names a folder that cannot be read, or a fault in the figure's layout. A
    /// sound or effect with a fault is only left out.
    static Expected<std::shared_ptr<const SenseData>> load(const std::filesystem::path& assets,
                                                           audio::WithSamples samples);
};

class Senses {
public:
    static std::unique_ptr<Senses> create(std::shared_ptr<const SenseData> data, const Presentation& shown);
    Senses(std::shared_ptr<const SenseData> data, MatchSounds sounds, MatchEffects effects);
    Senses(const Senses&) = delete;
    Senses& operator=(const Senses&) = delete;

    /// Adds a layout (places of the motors of a jacket or pad) for both players, and returns its number.
    /// Number 0 is the body's figure in the view. Keeps a reference to the layout.
    std::size_t add(const tactile::Layout& layout);
    /// Computes what is heard and felt. Call this after each tick; only every eighth tick is used.
    void follow(const Simulation& match);

    const SenseData& data() const { return *data_; }
    const MatchEffects& effects() const { return effects_; }
    const MatchSounds& sounds() const { return sounds_; }
    /// Sounds of the newest frame, as both players hear them.
    const audio::AudioFrame& heard() const { return frame_; }
    std::span<const HeardLine> lines(std::uint32_t player) const { return lines_.at(player).lines(); }
    const tactile::TactileFrame& felt(std::uint32_t player, std::size_t layout) const {
        return scenes_.at(player)->frame(layout);
    }
    const tactile::MixerCounts& counts(std::uint32_t player, std::size_t layout) const {
        return scenes_.at(player)->counts(layout);
    }
    /// Time since any cell of the body figure in the player's view was last active (s).
    double since_felt_s(std::uint32_t player) const;

private:
    std::shared_ptr<const SenseData> data_;
    MatchSounds sounds_;
    MatchEffects effects_;
    ToldBySounds told_;
    SoundScene sound_;
    audio::AudioFrame frame_{};
    std::array<std::unique_ptr<TactileScene>, players> scenes_{};
    std::array<HandWords, players> hands_{};
    std::array<HeardLines, players> lines_{};
    /// tick (Simulation::now) at which any cell of the body's figure was last active; 0: never
    std::array<Tick, players> felt_at_{};
    Tick now_{};
};

}  // namespace thaum::game::inline senses
