// game/stations/orb/orb.h: the scrying orb: its flow, the hidden core (the axis of the flow's first vortex),
// and the frame of the hand that scries.
//
//     hand, device frame --(metres_per_metre, turned to the orb)--> probe, world --> flow about its middle
//
// The flow is evaluated from its formula, so it has no samples and costs nothing while nobody scries.
#pragma once
#include "field/analytic.h"
#include "game/components/orb.h"
#include "game/context/match_context.h"
#include "game/context/surfaces.h"

namespace thaum::game::inline stations {

/// The orb's flow around its middle, with the axes of the world.
field::VortexFlow flow_of(const Orb& orb);

/// The hidden core: that part of the axis of the flow's first vortex which lies in the orb (m, world).
struct HiddenCore {
    vec3 middle{};  ///< point of the axis nearest to the orb's middle (m, world)
    vec3 axis{};    ///< direction of the core (unit, world)
    double half{};  ///< half of the core's length (m)
};
HiddenCore core_of(const Orb& orb);
/// The part of the first vortex's axis that lies in a ball of the given radius around `middle`, which is the
/// origin of the flow (m).
HiddenCore core_within(const field::VortexFlow& flow, vec3 middle, double radius);

/// Distance of a position from the hidden core (m, world).
double distance_from(const HiddenCore& core, vec3 place);

/// Whether a hand can find the hidden core (the first vortex's axis) of a flow that fills a box of this
/// extent (m). From every side the device must reach a long part of the core, but not with the hand at rest.
/// The curl of the core must exceed that of every other vortex, and those must hardly displace the point
/// around which the flow turns.
bool can_be_found(const field::VortexFlow& flow, double extent);

/// Creates the orb of a new match, and gives each wizard the strength curves with which the rules let haptic
/// modes begin. `seed` determines the flow. Does nothing if the match has no orb.
void spawn_orb(MatchContext& context, std::uint64_t seed);

/// The data of an orb that the next round takes over.
struct OrbMemory {
    std::uint64_t seed{};
    std::array<WornModes, players> modes{};
};
/// Data of the present orb for the next round; std::nullopt if there is no orb.
std::optional<OrbMemory> orb_memory(const ecs::World& world);
/// Creates the orb of the next round, with another flow. Wizards keep their active haptic modes and the
/// strength curves of these.
void spawn_next_orb(MatchContext& context, const OrbMemory& memory);

/// Pose of the device frame of a hand that scries (world). `yaw`: direction in which the wizard faces the orb
/// (rad).
HandFrame probe_frame(const OrbRules& rules, const Orb& orb, double yaw);

}  // namespace thaum::game::inline stations
