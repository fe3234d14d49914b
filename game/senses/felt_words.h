// game/senses/felt_words.h: what the hand and the body feel in words, beside the words of the sounds
// (game/senses/sound/heard.h): "weight pulls down", "brew pushes left", "bolt strikes from behind". What a sound tells by
// itself is not told twice.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "game/senses/sound/heard.h"
#include "game/senses/sound/sound_names.h"
#include "game/senses/tactile/felt_source.h"
#include "game/senses/tactile/tactile_scene.h"

namespace thaum::game {

/// Words for a force on the hand.
struct ForceWords {
    std::string_view
        words;  ///< name of the force; empty: the steady force of the wand in hand, which names it
    std::string_view verb;  ///< what it does to the hand
};
/// By ForceSource.
inline constexpr std::array<ForceWords, force_sources> force_words{{{"wand", "kicks"},
                                                                    {"spring", "pulls"},
                                                                    {"", "pulls"},
                                                                    {"wall", "pushes"},
                                                                    {"brew", "pushes"},
                                                                    {"bowl", "pushes"},
                                                                    {"surface of the brew", "pushes"},
                                                                    {"flow", "pushes"},
                                                                    {"crystal", "pushes"}}};

/// Side to which a force pushes (device frame: +x right, +y up, -z ahead).
HeardFrom side_of_force(vec3 newtons);

/// Tells the forces on the hand of one player.
class HandWords {
public:
    /// Adds the forces of this frame.
    void take(const Simulation& match, std::uint32_t player, HeardLines& lines);

private:
    /// A force that is told.
    struct Told {
        bool on{};
        HeardFrom side{};
        Tick side_since{};
    };
    std::array<Told, force_sources> told_{};
};

/// What the sounds of a match tell by themselves. A sound without words tells nothing.
struct ToldBySounds {
    std::vector<bool> events{};  ///< by EventKind
    bool heart{}, stir{}, steps{};

    bool tells(EventKind kind) const {
        const auto number = static_cast<std::size_t>(kind);
        return number < events.size() && events[number];
    }
};
ToldBySounds told_by_sounds(const MatchSounds& sounds, const audio::SoundBank& bank);

/// Adds what the body feels in this frame, but for what sounds tell, and for the kick of the wand, which HandWords
/// tells.
void add_body_words(const TactileScene& scene, const MatchEffects& effects, const tactile::EffectBank& bank,
                    const ToldBySounds& sounds, HeardLines& lines);

}  // namespace thaum::game
