// The region that a block hides from an eye. No OpenGL.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "render/scene.h"

namespace thaum::render::detail {

/// The region hidden by one block: its shadow if the eye were a lamp. The region is convex, so an object with
/// all its corners inside is hidden. Planes face inwards. After a transformation they need not be normalised.
struct Hidden {
    std::array<fvec4, 9> planes{};  ///< planes that bound the region: at most three faces and six edges
    std::size_t count{};
};

/// Appends the region that each block hides. Skips blocks that contain the eye and blocks that are not
/// finite.
void add_hidden(std::span<const Block> blocks, vec3 eye, std::vector<Hidden>& out);

/// Transforms a region from the world to the frame that `to_world` maps to the world.
Hidden moved(const Hidden& hidden, const fmat4& to_world);

/// Returns true if one of the regions contains the whole box.
bool is_hidden(std::span<const Hidden> hidden, fvec3 centre, fvec3 half);

}  // namespace thaum::render::detail
