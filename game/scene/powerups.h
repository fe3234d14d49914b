// game/scene/powerups.h: the power-ups in the arena. Each kind has its own outline, always turned to the
// viewer: a bottle, a heart, a star with four points. The shapes do not move. The ring on the ground below
// remains after a pick-up and fills until the power-up returns.
#pragma once
#include <array>
#include <vector>

#include "game/picture/picture.h"
#include "render/renderer.h"

namespace thaum::game::inline scene {

/// A mesh centred at the origin with its front along +z (m).
render::MeshData power_up_mesh(PowerUpKind kind);

struct PowerUpMeshes {
    struct Kind {
        render::MeshId shape{}, ring{}, disc{};
    };
    std::array<Kind, power_up_names.size()> kinds{};
};

/// Uploads the meshes. The renderer's OpenGL context must be current.
PowerUpMeshes make_power_up_meshes(render::Renderer& renderer);

void add_power_ups(const PowerUpMeshes& meshes, const Picture& picture, vec3 eye,
                   std::vector<render::Instance>& out);

}  // namespace thaum::game::inline scene
