// render/occlusion.h: how much of the sky a block takes from a surface, exactly.
//
// A surface under an evenly bright sky receives from each part of it by the cosine law; the share that comes from a
// polygon is its form factor, which Lambert (Photometria, 1760) gave as a sum over its edges. A block is the polygons
// of it that face the surface, cut off at the surface's horizon. No rays, no noise: the floor beside an endless wall
// loses 1/2, in the corner of two such walls 3/4.
#pragma once
#include "core/maths.h"

namespace thaum::render {

/// Edges along the axes; low <= high, m.
struct Block {
    vec3 low{}, high{};
};

/// 0 to 1, for a point with that unit normal. A point within the block is not covered by it.
double form_factor(const Block& block, vec3 point, vec3 normal);

/// Does the ray from the point meet the block? `way` need not be unit.
bool meets(const Block& block, vec3 point, vec3 way);

}  // namespace thaum::render
