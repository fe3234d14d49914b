// game/hud/powerups.h: what lies in the court to be picked up. Each kind has a shape of its own, told by its outline alone
// and turned to whoever looks: a bottle, a heart, a star with four points. They stand still; below each a ring on the ground
// stays when it has been taken, and fills up until it is back.
#pragma once
#include <array>
#include <vector>

#include "game/hud/picture.h"
#include "render/renderer.h"

namespace thaum::game {

/// Centred, in m; its front looks along +z.
render::MeshData power_up_mesh(PowerUpKind kind);

struct PowerUpMeshes {
    struct Kind {
        render::MeshId shape{}, ring{}, disc{};
    };
    std::array<Kind, power_up_names.size()> kinds{};
};

/// The renderer's context must be current.
PowerUpMeshes make_power_up_meshes(render::Renderer& renderer);

void add_power_ups(const PowerUpMeshes& meshes, const Picture& picture, vec3 eye,
                   std::vector<render::Instance>& out);

}  // namespace thaum::game
