// game/match/hand/bare_probe.h: the wand's tip as a probe: walls, props (loose things) and the bowl's rim
// push the hand that holds the wand.
//
// The origin of the device frame is at the tip of a wand whose hand is at rest. The frame turns with the
// wizard's view. A metre of the hand is wand_m_per_m metres in the world. When the wizard turns or walks, the
// world moves in the device frame. The servo, which computes the force, subtracts that frame motion
// (haptics::FrameMotion), so walking and turning neither kick nor press the hand. The hand feels only its own
// motion and the motion of props.
// Props are pushed with the opposite force: one newton on a prop is n_per_n newtons at the hand.
#pragma once
#include "game/components/hand_state.h"
#include "game/context/match_context.h"

namespace thaum::game::inline match {

/// Fills in those parts of the haptic model that concern the wand's tip. They are the surfaces near it (the
/// patch) with their number, the motion of the device frame, and the free point at which the proxy starts
/// after a jump. Stores the device frame in HandState. The patch is empty if no surface is within reach.
/// Reads resource::Physics.
void fill_probe_model(const MatchContext& context, ecs::Entity wizard, HandState& hand_state,
                      haptics::HapticModel& model);

/// Adds the system that pushes touched things with the opposite of the hand's contact force, in world units,
/// every tick before bodies move. The push is not reduced when the safety stage reduces the hand's force.
void add_probe_system(MatchContext& context, ecs::Schedule& schedule);

}  // namespace thaum::game::inline match
