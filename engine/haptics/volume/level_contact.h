// haptics/volume/level_contact.h: contact of a proxy with the surface on which a field has a given value.
//
//     proxy of the last tick, place it heads for --> find_contact --> up to three planes on the surface
//         --> holding_plane --> the plane that holds the proxy
//
// A proxy that was held by the tangent plane of the last tick lies next to the surface. One Newton step along
// the gradient finds the surface from there. The force of a plane at the surface does not depend on how deep
// the tip is in samples, or on how the density rises behind the surface. If the proxy would land inside the
// solid on the far side of a groove or in a corner, a second and a third plane bound its way there.
//
// Only one plane holds the proxy. It goes through the place where the proxy lands, at right angles to the
// push from the tip to that place. The first of the planes alone would throw the proxy from one wall of a
// groove to the other. All three at once would hold up to three times the strength, since in a hollow they
// are nearly parallel.
//
// The surface is found if the proxy is within reach of it, or if it lies between the proxy and the place that
// the proxy heads for. So a flat field in front of the surface needs no gradient. A proxy that is deeper than
// the reach has got through, and is free.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "field/field.h"

namespace thaum::haptics {

/// An isosurface of a field.
struct LevelSurface {
    field::ScalarField field{};
    double level{};
    bool solid_below{};  ///< the solid has smaller values than the level, not larger ones
    double reach{};  ///< depth at which a proxy has got through, and largest distance of the search, > 0 (m)
    /// Largest motion along its normal, in a tick, of the plane that stands for a sampled surface (m). It
    /// limits how fast the plane follows the steps that samples make in the surface, under a tip that slides.
    double slew{HUGE_VAL};
    vec3 motion{};  ///< motion of the tip in a tick (m)
};

/// One plane of an isosurface near the tip.
struct ContactPlane {
    vec3 place{};       ///< place on the surface (m)
    vec3 normal{};      ///< unit vector out of the solid
    double gradient{};  ///< length of the field's gradient there (1/m)
};

/// Planes through which the hand feels an isosurface in this tick.
struct LevelContact {
    std::array<ContactPlane, 3>
        planes{};  ///< the first `count` planes are in use; the first plane is nearest to the proxy
    std::uint32_t count{};
    /// The proxy lies behind the surface, so the first plane has to move the proxy and not only to hold it.
    bool behind{};
    bool late{};  ///< true: a plane is not yet where the surface asks for it, because of LevelSurface::slew
    double depth{};         ///< depth of the place that the proxy heads for, in a body of samples (m)
    std::uint32_t reads{};  ///< number of times that the field was read
};

/// Largest change of the force in a tick because a plane follows the small steps that samples make in a
/// surface (N): LevelSurface::slew times the spring's stiffness.
inline constexpr double max_step = 0.012;

/// Finds the planes that hold a proxy which would move from `proxy` to `target` (m). No allocation. A field
/// that is not finite gives no contact.
LevelContact find_contact(const LevelSurface& surface, vec3 proxy, vec3 target) noexcept;

/// The contact of a proxy that a spring of this stiffness (N/m) pulls. Planes move by at most
/// LevelSurface::slew in a tick, so that the force changes by at most max_step. This limit does not apply if
/// the tip presses with nearly the strength of the plane: the proxy then breaks through, and a limited plane
/// would follow it into the solid, tick by tick. `strength_of` gives the strength of a contact (N).
template <class StrengthOf>
LevelContact find_contact(LevelSurface surface, vec3 proxy, vec3 target, double stiffness,
                          StrengthOf strength_of) {
    constexpr double gives_way = 0.9;
    surface.slew = max_step / stiffness;
    const LevelContact contact = find_contact(surface, proxy, target);
    if (!contact.late || contact.count == 0) return contact;
    if (stiffness * contact.depth < gives_way * strength_of(contact)) return contact;
    surface.slew = HUGE_VAL;
    return find_contact(surface, proxy, target);
}

/// Place where a proxy on its way to `target` lands: the nearest one to `target` that is behind none of the
/// planes (m).
vec3 landing_of(const LevelContact& contact, vec3 target) noexcept;

/// The plane that holds a proxy on its way to `target`: it goes through the landing place, at right angles to
/// the way from there to the target. The first plane if the way is free. The contact must have a plane.
ContactPlane holding_plane(const LevelContact& contact, vec3 target) noexcept;

/// Force (N) with which a proxy presses a plane, at most `strength`. `pull` is the force of the proxy's
/// spring on the hand (N). The result is 0 while the tip is in front of the plane: `pull` is a tick old and
/// may still point out of the plane then, but the plane holds nothing.
double pressing_force(const ContactPlane& plane, vec3 next_tip, vec3 pull, double strength) noexcept;

}  // namespace thaum::haptics
