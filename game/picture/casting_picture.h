// game/picture/casting_picture.h: strokes, readings and spells of one wizard at one moment, as plain data.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>

#include "game/components/casting.h"
#include "game/components/free_hand.h"
#include "game/components/match.h"
#include "game/components/stroke_reading.h"
#include "game/data/casting_rules.h"
#include "game/data/gesture_set.h"
#include "game/data/reading.h"
#include "game/data/spell.h"

namespace thaum::game::inline match {
class Simulation;
}

namespace thaum::game::inline picture {

/// Time for which a finished stroke fades (s).
inline constexpr double stroke_fade_seconds = 1.2;
/// Time for which the caption with the result of a stroke is shown (s).
inline constexpr double reading_seconds = 2.6;
/// Minimum time between the starts of two flashes of a shield (s), which limits them to 2.5 flashes a second.
inline constexpr double flash_apart_seconds = 0.4;

/// The stroke that a wizard draws, or has just finished.
struct StrokePicture {
    static constexpr std::size_t max_points = max_drawn_points;

    std::array<DrawnPoint, max_points> points{};
    std::uint32_t count{};
    double apart_s = 0.008;  ///< time between two points of the stroke (s)
    bool drawing{};          ///< true: the player holds the button Trace
    bool on_brew{};          ///< true: the stroke is drawn on the brew, with the ladle that stirs it
    bool curve{};            ///< true: the hand draws a curve at the orb, which is no stroke of a spell
    bool read{};             ///< true: the finished stroke was recognised as a gesture
    double since_end_s{};    ///< time since the end of a finished stroke (s)
    double force_now{};      ///< force of the stroke at its newest point (N)
    double force_mean{};     ///< mean force along the stroke, which decides between gentle and harsh (N)
    /// true: a key chord (a wand's key while Trace is held) has replaced the stroke, and the forces are those
    /// of the chord (N)
    bool chord{};
    /// The points of the stroke on the surface of the brew, for a stroke of the ladle only (m, world).
    std::array<fvec3, max_points> places{};
};

/// What came of a stroke.
enum class StrokeOutcome : std::uint8_t {
    none,       ///< the stroke was recognised but casts no spell, such as a stroke on the brew
    cast,       ///< a spell was cast
    unread,     ///< the stroke is no gesture, or its gesture has no spell
    unfocused,  ///< the wizard had too little focus, the supply that spells cost
    fizzled     ///< the spell had nothing to act on
};

/// What the last stroke of a wizard was recognised as, and what came of it.
struct ReadingPicture {
    double age_s{1e6};
    StrokeOutcome outcome{};
    /// recognised gesture, and the one that the stroke resembles most; indices in CastingPicture::gestures
    std::uint32_t gesture{no_gesture}, nearest{no_gesture};
    /// Probability that the recognised gesture was meant, mean force of the stroke (N), and number of turns
    /// of a closed stroke.
    double probability{}, force{}, turns{};
    /// Number of the wand's key in the key chord (a wand's key while the button Trace is held) that replaced
    /// the stroke; std::nullopt: a stroke was read.
    std::optional<std::uint32_t> chord{};
    Event event{};          ///< event that reports what came of the stroke; unused for StrokeOutcome::none
    std::string refusal{};  ///< why the spell had nothing to act on; empty: unknown
};

/// The hand of a wizard who casts spells without a button.
struct FreePicture {
    static constexpr std::size_t max_points = 64;
    /// Path of the hand in the last second: points at even intervals, the newest last; only the first `count`
    /// are used (m).
    std::array<fvec3, max_points> trail{};
    std::uint32_t count{};
    double miss_age_s{1e6};  ///< time since the hand last almost cast a spell (s)
    NearMiss miss{};
};

struct CastingPicture {
    bool there{};  ///< true: the match has spells, so there is something to show
    double focus{}, focus_cap{};
    double ward{};              ///< harm that the shield can still absorb (HP); 0: no shield
    double ward_share{};        ///< remaining strength of the shield as a share of its initial value, 0 to 1
    double since_flash_s{1e6};  ///< time since the shield began to flash because it absorbed harm (s)
    std::optional<vec3> recalled{};  ///< position of the thing that flies to the wizard (m, world)
    StrokePicture stroke;
    Slip slip{};             ///< why the last stroke was not read, such as its size, if it was not read
    double slip_age_s{1e6};  ///< time since the end of the last stroke, read or not (s)
    ReadingPicture reading;
    /// How the effect of a spell has ended after its cast, in words; empty: nothing to show.
    std::string outcome{};
    double outcome_age_s{1e6};  ///< time since the effect of the spell has ended (s)
    FreePicture free;
    std::shared_ptr<const GestureSet> gestures;  ///< gestures of the wizard: the player's own, or those of
                                                 ///< the match
    const SpellStats* first_spell{};  ///< the spell with the lowest wand key; null if the match has no spells
    /// rules of strokes and spells in the match's data; null if the match has no spells
    const CastingRules* rules{};
};

/// Copies the visible state of a wizard's strokes and spells.
void take_casting(const Simulation& match, ecs::Entity wizard, std::uint32_t player, CastingPicture& out);

/// Display name of a gesture: "Circle"; empty for an unknown number.
std::string shown_gesture(const CastingPicture& casting, std::uint32_t gesture);

}  // namespace thaum::game::inline picture
