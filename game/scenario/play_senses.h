// game/scenario/play_senses.h: what both players hear and feel during a run, for scripts that ask for it.
#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audio/analysis.h"
#include "audio/mixer.h"
#include "game/senses/senses.h"

namespace thaum::game {

/// Layouts, words and mixed sound of one run.
class PlaySenses {
public:
    /// `layouts`: names of files in assets/tactile/layouts, beside the figure of the view. `mixed`: the sounds are
    /// mixed, too, as loudspeakers would play them. The error names the faulty file, or says that there is no OpenAL.
    static Expected<std::unique_ptr<PlaySenses>> create(const std::filesystem::path& assets,
                                                        const Presentation& shown,
                                                        const std::vector<std::string>& layouts, bool mixed);

    /// Follows the match after each tick.
    void follow(const Simulation& match);

    const Senses& senses() const { return *senses_; }
    /// Number of a layout by name; std::nullopt: the script has not asked for it.
    std::optional<std::size_t> layout(std::string_view name) const;
    const tactile::Layout& layout(std::size_t number) const;
    /// What the loudspeakers have played since the last call (left ear).
    std::vector<float> take_mixed() { return std::exchange(mixed_, {}); }
    bool mixes() const { return mixer_.has_value(); }
    /// One sound alone as the loudspeakers play it, two metres ahead (left ear).
    std::vector<float> play_alone(std::uint32_t sound);
    /// Number of the sound of the bank that these samples resemble most.
    std::size_t nearest(const std::vector<float>& samples);

private:
    std::unique_ptr<Senses> senses_;
    std::vector<std::string> names_{"abstract_4x5"};  ///< of the layouts, by number
    std::deque<tactile::Layout> layouts_;             ///< numbers 1 and up of `senses_`
    std::optional<audio::Mixer> mixer_;
    std::array<float, audio::block_values> block_{};
    std::vector<float> mixed_;
    std::vector<audio::Signature> known_;  ///< of each sound, once `nearest` was asked
};

}  // namespace thaum::game
