// game/context/resources.h: the resources of a match, which its systems share beside components (ecs/resource.h).
// A system declares those that it reads or writes together with its components:
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

namespace thaum::game {

/// Force magnitudes of the last ticks (N), ring buffer indexed by tick.
using ForceTrace = std::array<float, 2048>;

/// The last stroke that a player has finished, the last key chord in place of one, and what came of them.
struct EndedStroke {
    DrawnStroke stroke;
    Tick at{};                   ///< tick of play at which it ended; 0: there is none
    bool read{};                 ///< true: it was a gesture
    std::string_view refusal{};  ///< why the spell that fizzled last did nothing (SpellRules::refusal)
    Tick outcome_at{};           ///< tick of play of `outcome`; 0: never
    std::string_view outcome{};  ///< how a spell has ended after its cast, in words for its wizard
    Tick chord_at{};             ///< tick of play of the last key chord; 0: there was none
    std::uint32_t chord_slot{};  ///< its wand's key: slot of the spell
};

namespace resource {

/// Bodies and contacts.
struct Physics {
    using Value = physics::Physics;
    static constexpr std::string_view name = "physics";
};

/// Haptic models of this tick, one for each player. Parts that did not change are not written again.
struct Models {
    using Value = std::array<haptics::HapticModel, players>;
    static constexpr std::string_view name = "haptic models";
};

/// Every event of the last seconds. It is not part of the state; restoring a state restarts it.
struct Journal {
    using Value = EventJournal;
    static constexpr std::string_view name = "event journal";
};

/// Traces of the forces on the players' hands, for display. They are not part of the state.
struct Forces {
    using Value = std::array<ForceTrace, players>;
    static constexpr std::string_view name = "force traces";
};

/// The strokes that players finished last, for display. They are not part of the state.
struct Strokes {
    using Value = std::array<EndedStroke, players>;
    static constexpr std::string_view name = "ended strokes";
};

}  // namespace resource
}  // namespace thaum::game
