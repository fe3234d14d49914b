// game/scenario/play_senses.h: what both players hear and feel during a run, for scripts that ask for it.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"

namespace thaum::audio {
struct SoundBank;
}
namespace thaum::tactile {
class Layout;
struct MixerCounts;
struct TactileFrame;
}  // namespace thaum::tactile

namespace thaum::game {

class Simulation;
struct HeardLine;
struct Presentation;

/// Layouts, words and mixed sound of one run.
class PlaySenses {
public:
    /// `layouts`: names of files in assets/tactile/layouts, beside the figure of the view. `mixed`: the sounds are
    /// mixed, too, as loudspeakers would play them. The error names the faulty file, or says that there is no OpenAL.
    static Expected<std::unique_ptr<PlaySenses>> create(const std::filesystem::path& assets,
                                                        const Presentation& shown,
                                                        const std::vector<std::string>& layouts, bool mixed);
    ~PlaySenses();
    PlaySenses(const PlaySenses&) = delete;
    PlaySenses& operator=(const PlaySenses&) = delete;

    /// Follows the match after each tick.
    void follow(const Simulation& match);

    const audio::SoundBank& bank() const;
    /// Returns the words for all that the player has heard, the oldest first.
    std::span<const HeardLine> lines(std::uint32_t player) const;
    /// Newest frame and counts of a layout, by its number.
    const tactile::TactileFrame& felt(std::uint32_t player, std::size_t layout) const;
    const tactile::MixerCounts& counts(std::uint32_t player, std::size_t layout) const;
    /// Number of a layout by name; std::nullopt: the script has not asked for it.
    std::optional<std::size_t> layout(std::string_view name) const;
    const tactile::Layout& layout(std::size_t number) const;
    /// What the loudspeakers have played since the last call (left ear).
    std::vector<float> take_mixed();
    bool mixes() const;
    /// One sound alone as the loudspeakers play it, two metres ahead (left ear).
    std::vector<float> play_alone(std::uint32_t sound);
    /// Number of the sound of the bank that these samples resemble most.
    std::size_t nearest(const std::vector<float>& samples);

private:
    struct Inside;
    explicit PlaySenses(std::unique_ptr<Inside> inside);

    std::unique_ptr<Inside> inside_;
};

}  // namespace thaum::game
