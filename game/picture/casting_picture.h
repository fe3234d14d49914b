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

namespace thaum::game {

class Simulation;

/// Time for which a finished stroke fades (s).
inline constexpr double stroke_fade_seconds = 1.2;
/// Time for which the caption of a reading is shown (s).
inline constexpr double reading_seconds = 2.6;
/// Least time from one flash of a shield to the next one (s), so that there are at most 2.5 flashes a second.
inline constexpr double flash_apart_seconds = 0.4;

/// The stroke that a wizard draws, or has just finished.
struct StrokePicture {
    static constexpr std::size_t most_points = most_drawn_points;

    std::array<DrawnPoint, most_points> points{};
    std::uint32_t count{};
    double apart_s = 0.008;  ///< time between two points
    bool drawing{};          ///< Trace is held
    bool on_brew{};          ///< the ladle draws
    bool curve{};            ///< the hand draws a curve at the orb, which is no stroke of a spell
    bool read{};             ///< the finished stroke was a gesture
    double since_end_s{};    ///< time since the end of a finished stroke
    double force_now{};      ///< force at the newest point (N)
    double force_mean{};     ///< mean force along the stroke, which decides between gentle and harsh (N)
    bool chord{};  ///< a key chord has taken the stroke's place, and the forces are those of the chord
    /// The points on the brew (m, world); of a stroke of the ladle only.
    std::array<fvec3, most_points> places{};
};

/// What came of a stroke.
enum class StrokeOutcome : std::uint8_t {
    none,       ///< only read, on the brew
    cast,       ///< a spell was cast
    unread,     ///< the stroke means nothing, or its gesture has no spell
    unfocused,  ///< not enough focus
    fizzled     ///< the spell has nothing to act on
};

/// The last reading of a wizard's strokes.
struct ReadingPicture {
    double age_s{1e6};
    StrokeOutcome outcome{};
    std::uint32_t gesture{no_gesture}, nearest{no_gesture};  ///< numbers in CastingPicture::gestures
    double probability{}, force{}, turns{};                  ///< see LastReading
    std::optional<std::uint32_t> chord{};  ///< slot of the key chord; std::nullopt: a stroke was read
    Event event{};                         ///< the event of the outcome; unused for StrokeOutcome::none
    std::string refusal{};                 ///< why the spell has nothing to act on; empty: unknown
};

/// The hand of a wizard who casts without a button.
struct FreePicture {
    static constexpr std::size_t most_points = 64;
    /// Way of the hand in the last second, evenly chosen, the newest point last; the first `count` (m).
    std::array<fvec3, most_points> trail{};
    std::uint32_t count{};
    double miss_age_s{1e6};  ///< time since the hand last almost cast a spell
    NearMiss miss{};
};

struct CastingPicture {
    bool there{};  ///< the match has spells
    double focus{}, focus_cap{};
    double ward{};                   ///< harm that the shield still takes (HP); 0: no shield
    double ward_share{};             ///< that harm as a share of what the shield took at first, 0 to 1
    double since_flash_s{1e6};       ///< time since the shield began to flash because it took harm
    std::optional<vec3> recalled{};  ///< place of a thing that flies to the wizard (m)
    StrokePicture stroke;
    Slip slip{};             ///< why the last stroke was not read at all
    double slip_age_s{1e6};  ///< time since the end of that stroke
    ReadingPicture reading;
    std::string outcome{};      ///< how a spell has ended after its cast, in words; empty: nothing to tell
    double outcome_age_s{1e6};  ///< time since that end
    FreePicture free;
    std::shared_ptr<const GestureSet> gestures;  ///< the wizard's own gestures, or those of the match
    const SpellStats* first_spell{};             ///< the spell of the first chord; null without spells
    const CastingRules* rules{};                 ///< of the match's data; null without spells
};

/// Fills in what is to be seen of a wizard's strokes and spells.
void take_casting(const Simulation& match, ecs::Entity wizard, std::uint32_t player, CastingPicture& out);

/// Name of a gesture for the screen: "Circle"; empty for a number without a gesture.
std::string shown_gesture(const CastingPicture& casting, std::uint32_t gesture);

}  // namespace thaum::game
