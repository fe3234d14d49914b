// haptics/level_contact.h: contact of a proxy with the surface on which a field has a given value.
//
//     proxy of the last tick, place it heads for --> find_contact --> up to three planes on the surface
//                                                                 --> holding_plane --> the plane that holds the proxy
//
// A proxy that was held by the tangent plane of the last tick lies next to the surface. One Newton step along the
// gradient finds the surface from there. The force of a plane at that place does not depend on how deep the tip is
// in samples, or on how the density rises behind the surface. If the proxy would land inside the solid on the far
// side of a groove or in a corner, a second and a third plane bound its way there.
//
// One plane holds the proxy. It goes through the place where the proxy lands, across the push. The tangent plane of the first
// wall alone would throw it from wall to wall. All three at once would hold up to three times the strength, since in a
// hollow they are nearly parallel.
//
// The surface is found if the proxy is within reach of it, or if it lies between the proxy and the place that the
// proxy heads for. So a flat field in front of the surface needs no gradient. A proxy that is deeper than the reach
// has got through, and is free.
#pragma once
#include <array>
#include <cstdint>

#include "field/field.h"

namespace thaum::haptics {

struct LevelSurface {
    field::ScalarField field{};
    double level{};
    bool solid_below{};  ///< the solid has smaller values than the level, not larger ones
    double reach{};      ///< depth at which a proxy has got through, and distance of the search, > 0 (m)
};

struct ContactPlane {
    vec3 place{};       ///< place on the surface (m)
    vec3 normal{};      ///< unit vector out of the solid
    double gradient{};  ///< length of the field's gradient there (1/m)
};

struct LevelContact {
    std::array<ContactPlane, 3>
        planes{};  ///< the first `count` are in use; the first one is nearest to the proxy
    std::uint32_t count{};
    /// Whether the proxy lies behind the surface, so that the first plane has to move it and not only to hold it.
    bool behind{};
    std::uint32_t reads{};  ///< number of times that the field was read
};

/// Finds the planes that hold a proxy which would move from `proxy` to `target` (m). No allocation. A field that is
/// not finite gives no contact.
LevelContact find_contact(const LevelSurface& surface, vec3 proxy, vec3 target) noexcept;

/// The nearest place to `target` that is behind none of the planes (m).
vec3 landing_of(const LevelContact& contact, vec3 target) noexcept;

/// The plane that holds a proxy on its way to `target`: through its landing place, and across the way from there to the
/// target. The first plane if the way is free. The contact must have a plane.
ContactPlane holding_plane(const LevelContact& contact, vec3 target) noexcept;

}  // namespace thaum::haptics
