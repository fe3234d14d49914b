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

namespace thaum::game::inline data {
struct Presentation;
}
namespace thaum::game::inline match {
class Simulation;
}
namespace thaum::game::inline senses {
struct HeardLine;
}

namespace thaum::game::inline scenario {

/// Layouts, captions and mixed sound of one run.
class PlaySenses {
public:
    /// Prepares the senses. `layouts`: names of files in assets/tactile/layouts, in addition to the figure of
    /// the body in the view. `mixed`: whether sounds are also mixed as loudspeakers would play them. The
    /// error names the faulty file, or says that there is no OpenAL.
    static Expected<std::unique_ptr<PlaySenses>> create(const std::filesystem::path& assets,
                                                        const Presentation& shown,
                                                        const std::vector<std::string>& layouts, bool mixed);
    ~PlaySenses();
    PlaySenses(const PlaySenses&) = delete;
    PlaySenses& operator=(const PlaySenses&) = delete;

    /// Updates sounds and effects; call this after each tick.
    void follow(const Simulation& match);

    const audio::SoundBank& bank() const;
    /// Returns the captions of all sounds that the player has heard, the oldest first.
    std::span<const HeardLine> lines(std::uint32_t player) const;
    /// Newest frame (strengths of all motors) of a layout, and counts of its effects, by the number of the
    /// layout.
    const tactile::TactileFrame& felt(std::uint32_t player, std::size_t layout) const;
    const tactile::MixerCounts& counts(std::uint32_t player, std::size_t layout) const;
    /// Number of a layout by name; std::nullopt: the script has not asked for it.
    std::optional<std::size_t> layout(std::string_view name) const;
    const tactile::Layout& layout(std::size_t number) const;
    /// The samples that loudspeakers would have played since the last call (left ear).
    std::vector<float> take_mixed();
    bool mixes() const;
    /// The samples of one sound alone, as loudspeakers would play it two metres ahead (left ear).
    std::vector<float> play_alone(std::uint32_t sound);
    /// Number of the known sound that these samples resemble most.
    std::size_t nearest(const std::vector<float>& samples);

private:
    struct Inside;
    explicit PlaySenses(std::unique_ptr<Inside> inside);

    std::unique_ptr<Inside> inside_;
};

}  // namespace thaum::game::inline scenario
