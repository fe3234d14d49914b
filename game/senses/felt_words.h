// game/senses/felt_words.h: describes in words what hand and body feel, in addition to the captions of sounds
// (game/senses/sound/heard.h): "weight pulls down", "brew pushes left", "bolt strikes from behind". An event
// with a sound caption is not described a second time.
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "game/senses/sound/heard.h"
#include "game/senses/sound/sound_names.h"
#include "game/senses/tactile/felt_source.h"
#include "game/senses/tactile/tactile_scene.h"

namespace thaum::game::inline senses {

/// Words for a force on the hand.
struct ForceWords {
    std::string_view
        /// name of the force; empty: the steady force of the wand in hand, whose data file has the name
        words;
    std::string_view verb;  ///< verb for what the force does to the hand
};
/// Name and verb for each source of force, in the order of ForceSource.
inline constexpr std::array<ForceWords, force_sources> force_words{{{"wand", "kicks"},
                                                                    {"spring", "pulls"},
                                                                    {"", "pulls"},
                                                                    {"wall", "pushes"},
                                                                    {"brew", "pushes"},
                                                                    {"bowl", "pushes"},
                                                                    {"surface of the brew", "pushes"},
                                                                    {"flow", "pushes"},
                                                                    {"crystal", "pushes"}}};

/// Side towards which a force pushes (device frame: +x right, +y up, -z ahead).
HeardFrom side_of_force(vec3 newtons);

/// Describes the forces on the hand of one player in words.
class HandWords {
public:
    /// Adds lines of words about the forces on the player's hand in this frame.
    void take(const Simulation& match, std::uint32_t player, HeardLines& lines);

private:
    /// A force on the hand that is being described in words.
    struct Told {
        bool on{};
        HeardFrom side{};
        Tick side_since{};
    };
    std::array<Told, force_sources> told_{};
};

/// Events and effects that the captions of sounds already describe. A sound without a caption describes
/// nothing.
struct ToldBySounds {
    std::vector<bool> events{};  ///< whether sounds describe an event, indexed by EventKind
    bool heart{}, stir{}, steps{};

    bool tells(EventKind kind) const {
        const auto number = static_cast<std::size_t>(kind);
        return number < events.size() && events[number];
    }
};
ToldBySounds told_by_sounds(const MatchSounds& sounds, const audio::SoundBank& bank);

/// Adds lines about what the body feels in this frame, except what captions of sounds describe, and except
/// the kick of the wand, which HandWords describes.
void add_body_words(const TactileScene& scene, const MatchEffects& effects, const tactile::EffectBank& bank,
                    const ToldBySounds& sounds, HeardLines& lines);

}  // namespace thaum::game::inline senses
