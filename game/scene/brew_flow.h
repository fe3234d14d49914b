// game/scene/brew_flow.h: the flow of a brew as arrows and streamlines.
#pragma once
#include "game/scene/brew_look.h"

namespace thaum::game::inline scene {

/// Traces a streamline from a place over `length` with equal steps of about `step` arc length, by the
/// classical Runge-Kutta method. The streamline ends early where the fluid is at rest. The first point is
/// `from` (m, fluid's frame).
void follow(const BrewPicture& picture, vec3 from, double length, double step, std::vector<vec3>& out);

void add_arrows(const BrewPicture& picture, const BrewPlace& place, const BrewMeshes& meshes,
                std::vector<render::Instance>& out);
/// Adds streamlines from fixed seeds, up to 1.6 m long. A line fades towards its tail, which shows the
/// direction of the flow.
void add_streamlines(const BrewPicture& picture, const BrewPlace& place, const BrewMeshes& meshes,
                     std::vector<render::Instance>& out);

}  // namespace thaum::game::inline scene
