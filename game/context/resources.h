// game/context/resources.h: the resources of a match, which its systems share in addition to components
// (ecs/resource.h). A system declares the resources that it reads or writes together with its components:
//
//     .reads = world.mask<Wizard, resource::Physics>(),
#pragma once
#include <array>
#include <string_view>

#include "ecs/resource.h"
#include "game/components/casting.h"
#include "game/components/wizard.h"
#include "game/context/event_journal.h"
#include "haptics/servo.h"
#include "physics/physics.h"

namespace thaum::game::inline context {

/// Strengths of the force on a hand in the last ticks (N): a ring buffer indexed by tick.
using ForceTrace = std::array<float, 2048>;

/// The last finished stroke of a player, the last key chord used instead of a stroke, and their results. A
/// key chord is a press of a wand's key while the button Trace is held.
struct EndedStroke {
    DrawnStroke stroke;
    Tick at{};    ///< tick of play at which the stroke ended; 0: no stroke yet
    bool read{};  ///< true: the stroke was recognised as a gesture
    /// Why the spell that was last cast in vain had nothing to act on (SpellRules::refusal)
    std::string_view refusal{};
    Tick outcome_at{};           ///< tick of play at which the effect in `outcome` ended; 0: never
    std::string_view outcome{};  ///< how the effect of a spell ended after its cast, as a text for the wizard
                                 ///< who cast it
    Tick chord_at{};             ///< tick of the last key chord (a wand's key while Trace is held); 0: never
    std::uint32_t chord_slot{};  ///< slot (number) of the wand key that the last key chord pressed; the spell
                                 ///< cast is the one with this slot
};

}  // namespace thaum::game::inline context

namespace thaum::game::resource {

/// Resource: bodies and contacts of Bullet.
struct Physics {
    using Value = physics::Physics;
    static constexpr std::string_view name = "physics";
};

/// Haptic models of this tick, one for each player: the descriptions from which servo steps compute the
/// forces. A tick rewrites only the parts that changed.
struct Models {
    using Value = std::array<haptics::HapticModel, players>;
    static constexpr std::string_view name = "haptic models";
};

/// All events of the last seconds, for display and for counting. Not part of the state; the journal starts
/// anew when a state is restored.
struct Journal {
    using Value = EventJournal;
    static constexpr std::string_view name = "event journal";
};

/// Force curves of the players' hands, for display. Not part of the state.
struct Forces {
    using Value = std::array<ForceTrace, players>;
    static constexpr std::string_view name = "force traces";
};

/// The last finished strokes of the players, for display. Not part of the state.
struct Strokes {
    using Value = std::array<EndedStroke, players>;
    static constexpr std::string_view name = "ended strokes";
};

}  // namespace thaum::game::resource

namespace thaum::game::inline context {}  // namespace thaum::game::inline context
