// game/scene/orb_look.h: the look of the orb. Ribbons follow the flow inside the ball, and one ribbon more
// starts at the probe of each wizard who scries. From far away a painted ball replaces all of this.
//
//     simulation              any thread                         renderer
//     take_orb(match, orb)    show_orb(orb, eyes, look)          frame.changes
//                             add_orb(orb, ..., instances)
#pragma once
#include <array>
#include <span>
#include <vector>

#include "field/analytic.h"
#include "field/streamline.h"
#include "game/picture/station_picture.h"
#include "game/scene/changing_mesh.h"
#include "render/renderer.h"
#include "render/scene.h"

namespace thaum::game::inline scene {

/// Everything drawn for an orb. It can be moved but not copied, because `changes` points into it.
struct OrbLook {
    ChangingMesh flow{};                             ///< ribbons of the flow (m, frame of the orb)
    std::array<ChangingMesh, players> probe_flow{};  ///< ribbon that starts at each player's probe
    render::MeshId ball{};                           ///< painted ball, shown from far away
    render::MeshId glass{};                          ///< inside of the ball's far half
    render::MeshId bead{};                           ///< white ball of radius 1 m
    render::MeshId arrow{};                          ///< white cone from the origin 1 m along -z, radius 1 m

    std::uint64_t seed{};  ///< seed of the flow that the ribbons show
    field::VortexFlow vortices{};
    std::array<std::optional<vec3>, players>
        probe_seed{};                         ///< start of each probe's ribbon (m, frame of the orb)
    std::vector<field::StreamPoint> line;     ///< working memory for tracing flow lines
    std::vector<render::MeshChange> changes;  ///< meshes that have changed, for the renderer (Frame::changes)

    OrbLook() = default;
    OrbLook(OrbLook&&) = default;
    OrbLook& operator=(OrbLook&&) = default;
};

OrbLook make_orb_look(render::Renderer& renderer, double radius);

/// Whether an eye is near enough to see the flow rather than the painted ball.
bool sees_flow(const OrbPicture& orb, vec3 eye);

/// Refreshes the ribbons if the flow or a probe (the tip that a hand moves) has changed and at least one eye
/// is near enough. Returns the number of flow lines traced.
std::size_t show_orb(const OrbPicture& orb, std::span<const vec3> eyes, OrbLook& look);

/// Adds the flow with probes and forces, or the painted ball. `viewer` sees the hidden core (the axis of the
/// strongest vortex) if that player has found it.
void add_orb(const OrbLook& look, const OrbPicture& orb, std::uint32_t viewer, vec3 eye,
             std::vector<render::Instance>& out);
/// Adds the tip that a hand moves at the orb or in a crystal: a bead, and the force on the hand as an arrow,
/// coloured green to red by its strength.
void add_tip(const OrbLook& look, const TipPicture& tip, std::uint32_t player,
             std::vector<render::Instance>& out);
/// Adds only the arrow that shows the force on the hand.
void add_force(const OrbLook& look, const TipPicture& tip, std::vector<render::Instance>& out);

}  // namespace thaum::game::inline scene
