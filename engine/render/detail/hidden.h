// What a block hides from an eye. Pure: no OpenGL.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "render/scene.h"

namespace thaum::render::detail {

/// The places from which every way to the eye leads through one block: its shadow, were the eye a lamp. It is convex, so what
/// has all its corners in it is hidden. Planes look inwards; in a frame that is moved they need not be unit.
struct Hidden {
    std::array<fvec4, 9> planes{};  ///< at most three faces and six edges
    std::size_t count{};
};

/// Appends what each block hides; none that the eye is in, nor one that is not finite.
void add_hidden(std::span<const Block> blocks, vec3 eye, std::vector<Hidden>& out);

/// The same in the frame from which `to_world` leads.
Hidden moved(const Hidden& hidden, const fmat4& to_world);

/// Whether one of them holds the whole box.
bool is_hidden(std::span<const Hidden> hidden, fvec3 centre, fvec3 half);

}  // namespace thaum::render::detail
