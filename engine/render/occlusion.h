// render/occlusion.h: the exact share of the sky that a block hides from a surface.
//
// A surface under an evenly bright sky receives light from each part of the sky by the cosine law. The share
// from a polygon is its form factor, which Lambert (Photometria, 1760) gave as a sum over its edges. A block
// counts as its polygons that face the surface, clipped at the surface's horizon. There are no rays and no
// noise: the floor beside an endless wall loses 1/2, in the corner of two such walls 3/4.
#pragma once
#include "core/maths.h"

namespace thaum::render {

/// A box with edges along the axes; low <= high (m).
struct Block {
    vec3 low{}, high{};
};

/// Share of the sky that the block hides from a point with a unit normal, 0 to 1. 0 for a point inside the
/// block.
double form_factor(const Block& block, vec3 point, vec3 normal);

/// Returns true if the ray from `point` along `way` meets the block. `way` need not be unit.
bool meets(const Block& block, vec3 point, vec3 way);

}  // namespace thaum::render
