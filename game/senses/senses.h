// game/senses/senses.h: what both players hear and feel of a match, without loudspeakers and motors: for pictures of
// replays, scenarios and benches. It never changes the match.
#pragma once
#include <filesystem>
#include <memory>

#include "audio/synth.h"
#include "game/senses/felt_words.h"
#include "game/senses/sound/sound_scene.h"
#include "game/senses/tactile/tactile_scene.h"

namespace thaum::game {

/// Sounds, effects, and the layout of the figure in the view.
struct SenseData {
    audio::SoundBank bank;
    tactile::EffectBank effects;
    tactile::Layout figure;

    /// The error names a folder that cannot be read, or a faulty figure. A faulty sound or effect is only left out.
    static Expected<std::shared_ptr<const SenseData>> load(const std::filesystem::path& assets,
                                                           audio::WithSamples samples);
};

class Senses {
public:
    static std::unique_ptr<Senses> create(std::shared_ptr<const SenseData> data, const Presentation& shown);
    Senses(std::shared_ptr<const SenseData> data, MatchSounds sounds, MatchEffects effects);
    Senses(const Senses&) = delete;
    Senses& operator=(const Senses&) = delete;

    /// Adds a layout for both players, and returns its number. Number 0 is the figure. Keeps the reference.
    std::size_t add(const tactile::Layout& layout);
    /// Follows the match after each tick; it looks at every eighth one.
    void follow(const Simulation& match);

    const SenseData& data() const { return *data_; }
    const MatchEffects& effects() const { return effects_; }
    const MatchSounds& sounds() const { return sounds_; }
    /// What both players hear in the newest frame.
    const audio::AudioFrame& heard() const { return frame_; }
    std::span<const HeardLine> lines(std::uint32_t player) const { return lines_.at(player).lines(); }
    const tactile::TactileFrame& felt(std::uint32_t player, std::size_t layout) const {
        return scenes_.at(player)->frame(layout);
    }
    const tactile::MixerCounts& counts(std::uint32_t player, std::size_t layout) const {
        return scenes_.at(player)->counts(layout);
    }
    /// Time since a cell of the player's figure was last on (s).
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
    std::array<Tick, players> felt_at_{};  ///< Simulation::now when a cell was last on; 0: never
    Tick now_{};
};

}  // namespace thaum::game
