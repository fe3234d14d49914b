// haptics/surface/surface.h: contact of a point with surfaces (Zilles and Salisbury 1995, "A constraint-based
// god-object method for haptic display"; friction after Ruspini, Kolarov, Khatib 1997).
//
//     patch of surfaces ----.
//     tip ------------------+--> touch() --> force on the hand = stiffness (proxy - tip) + damping
//     state (the proxy) <---'
//
// The proxy is the position that the tip would have if it could not enter anything. Each tick it starts at
// its old position. The touched body carries it along, and bodies that moved over it push it out. Then it
// moves towards the tip as a swept point: straight until it meets a surface, then along that surface (a round
// one: detail/round.h), along the crease of two, into the corner of three. There is no lag: the proxy ends
// at the place nearest to the tip, to rounding. The sweep is relative to each body's own motion, so no speed
// takes the proxy through anything in the patch. If its moves are used up, the last walls go on holding it:
// the force never vanishes inside a body.
//
// Friction follows Coulomb. Forces are compared as lengths in metres, since with one stiffness they are in
// proportion. The proxy sticks while its distance to the tip along the touched surfaces is at most the sum of
// friction x depth over these surfaces. Beyond that it slides towards the tip until dynamic friction holds
// it. A resting proxy is held by static friction.
//
// Force: the stiffness is the mean of the touched surfaces, weighted by their share of the push. The
// direction is therefore that of proxy - tip for any mixture. With one stiffness and no friction, the force
// is minus the gradient of stiffness/2 times the squared distance, and creates no energy. Sliding under load
// from one stiffness to another creates energy: half their difference times depth squared. Damping acts along
// the push and only on the way in (paper 004), so it never pulls.
//
// Textures are heights h above the surface, from 0 to their top, at the place of the proxy. The proxy moves
// on the top. The depth that is felt is the depth below the top, less the distance between top and texture:
//
//     impact   (paper 004, F_mag)   beneath the surface itself: depth + h, along the surface's normal n
//     vibration (paper 004, F_vec)  beneath h: depth + h, along the unit normal of the texture, n - grad h
//     bumps    (paper 002, 5)       beneath h: depth + h, times n - grad h: minus the gradient of the
//                                   spring's energy
//
// Here depth is the tip's depth beneath the surface, negative above it. Bumps are passive on one plane. On a
// curved surface the proxy does not move as far as the tip, and in a crease the heights of the walls change
// each other's depth. There the force is no gradient, and a closed loop of the tip can gain energy (1.4 mJ in
// the crease of two planes, 6 mJ in a corner). Vibration differs from bumps by the length of its normal,
// sqrt(1 + |grad h|^2). Impact is an active source: its depth jumps by h at the surface. A hand that presses
// in over a trough and slides to a crest gains energy.
//
// Device frame, lengths in m. Plain data, no allocation, no clock. SurfaceState is the whole state.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"

namespace thaum::haptics {

/// Shape of a surface, with the meaning of its parameters.
enum class SurfaceKind : std::uint32_t {
    plane,     ///< a: a point on it, b: unit normal; everything behind it is solid
    triangle,  ///< a, b, c: corners, counter-clockwise seen from the side that can be touched
    sheet,     ///< a, b, c: corners of a triangle that can be touched from both sides
    sphere,    ///< a: centre, b.x: radius
    /// a: centre, b.x: radius, b.y: half the length of the straight part along the body's y axis.
    capsule,
    box,       ///< a: centre, b: half extents along the body's axes
    cylinder,  ///< like the capsule, with flat ends
};

/// One surface of a body at its present position.
struct Surface {
    SurfaceKind kind{};
    std::uint32_t body{};  ///< index in SurfacePatch::bodies
    std::uint32_t part{};  ///< index among the surfaces of its body; the same from tick to tick
    std::uint32_t spare{};
    vec3 a{}, b{}, c{};  ///< parameters of the shape, see SurfaceKind (m, device frame)
};
static_assert(sizeof(Surface) == 4 * sizeof(std::uint32_t) + 3 * sizeof(vec3), "no padding");

/// Kind of a texture. As wide as a double, so that a Texture has no padding.
enum class TextureKind : std::uint64_t {
    none,
    impact,     ///< a sinusoidal grating, felt along the surface's normal
    vibration,  ///< a sinusoidal grating, felt along the normal of its own slopes
    bumps,      ///< a map of heights
};

/// Heights above a surface, fixed to its body. They depend on the place in two directions of the body, u and
/// v, so on a curved surface they look as if cut from a solid block.
///
///     grating   h = amplitude (1 + sin(2 pi u / wavelength)), u = axes[0] . (place - origin)
///     bumps     h = 2 amplitude times the patch's map at (u, v) / wavelength, which repeats; v by axes[1]
struct Texture {
    TextureKind kind{};
    double amplitude{};   ///< half the greatest height, >= 0 (m)
    double wavelength{};  ///< length of a period, > 0 (m)
    vec3 origin{};        ///< place of the body where u and v are zero (m, body frame)
    /// Directions in which u and v grow (unit, body frame).
    std::array<vec3, 2> axes{vec3{1, 0, 0}, vec3{0, 0, 1}};
};
static_assert(sizeof(Texture) == sizeof(TextureKind) + 2 * sizeof(double) + 3 * sizeof(vec3), "no padding");

inline constexpr std::size_t bump_cells = 16;

/// Heights 0 to 1 at the nodes of a square of one wavelength; neighbours in memory differ in u. A quadratic
/// B-spline between the nodes has a continuous slope and never rises above them.
using BumpMap = std::array<float, bump_cells * bump_cells>;

/// Contact properties of a surface.
struct SurfaceMaterial {
    double stiffness{300};      ///< contact stiffness, > 0 (N/m)
    double damping{};           ///< contact damping, >= 0 (N s/m)
    double static_friction{};   ///< coefficient of static friction, >= dynamic_friction
    double dynamic_friction{};  ///< coefficient of dynamic friction, >= 0
    Texture texture{};
};
static_assert(sizeof(SurfaceMaterial) == 4 * sizeof(double) + sizeof(Texture), "no padding");

/// A rigid body to which surfaces belong.
struct SurfaceBody {
    vec3 position{};               ///< point of the body that has `velocity` (m)
    quat orientation{1, 0, 0, 0};  ///< rotation from body frame to device frame (unit)
    vec3 velocity{};               ///< velocity over the last tick (m/s)
    vec3 spin{};                   ///< angular velocity about `position` (rad/s)
    SurfaceMaterial material{};
    std::uint32_t key{};  ///< identity of the body, the same from tick to tick
    std::uint32_t spare{};
};
static_assert(sizeof(SurfaceBody) ==
                  3 * sizeof(vec3) + sizeof(quat) + sizeof(SurfaceMaterial) + 2 * sizeof(std::uint32_t),
              "no padding");

inline constexpr std::size_t surface_capacity = 32;
inline constexpr std::size_t surface_body_capacity = 8;

/// Surfaces near the tip. The first `count` surfaces and `body_count` bodies are in use. A surface of any
/// other body is ignored.
struct SurfacePatch {
    std::array<Surface, surface_capacity> surfaces{};
    std::array<SurfaceBody, surface_body_capacity> bodies{};
    std::uint32_t count{};
    std::uint32_t body_count{};
    BumpMap bumps{};  ///< heights for all bodies with the texture `bumps`
    /// The patch contains all surfaces within `reach` of `centre`. The proxy stays within that sphere until a
    /// new patch shows what lies beyond. Surfaces that the proxy has not met give no force.
    vec3 centre{};           ///< centre of the sphere in which all surfaces are known (m)
    double reach{HUGE_VAL};  ///< radius of the sphere in which all surfaces are known (m)
};
static_assert(sizeof(SurfacePatch) ==
                  surface_capacity * sizeof(Surface) + surface_body_capacity * sizeof(SurfaceBody) +
                      2 * sizeof(std::uint32_t) + sizeof(BumpMap) + sizeof(vec3) + sizeof(double),
              "no padding");

/// A touched surface, identified by its body's key and its part.
struct SurfaceContact {
    std::uint32_t key{};
    std::uint32_t part{};
    vec3 force{};  ///< part of the force on the hand; the body gets the opposite (N)
};

/// State of a contact, kept from tick to tick; no padding.
struct SurfaceState {
    vec3 proxy{};  ///< position of the proxy (m); valid if `begun`
    /// Touched surfaces, the first `contacts`, the most loaded first.
    std::array<SurfaceContact, 3> touched{};
    std::uint32_t contacts{};
    std::uint32_t sliding{};  ///< 1: the proxy slid in the last tick, against friction
    std::uint32_t begun{};    ///< 0: there is no proxy yet; it starts at the tip
    std::uint32_t limited{};  ///< 1: the end of the space whose surfaces are known held the proxy
};
static_assert(sizeof(SurfaceState) == 4 * sizeof(vec3) + 10 * sizeof(std::uint32_t));

/// Place and motion of the tip that touches the surfaces.
struct SurfaceTip {
    vec3 position{};  ///< position of the tip (m)
    vec3 velocity{};  ///< velocity of the tip (m/s), for damping only
};

/// Result of one tick of contact.
struct ContactResult {
    vec3 force{};  ///< force on the hand, always finite (N)
    vec3 proxy{};  ///< position of the proxy (m); at the tip if nothing is touched
    /// Displacement of the proxy from the tip by the surfaces' normal push, without friction (m).
    vec3 push{};
    std::uint32_t contacts{};  ///< number of touched surfaces, 0 to 3
};

/// Advances the contact by one tick of `dt` seconds. If the tip is not finite, the force is zero and the
/// proxy restarts at the tip. The proxy stays `surface_gap` in front of a surface, so forces are exact up to
/// the stiffness times `surface_gap`.
ContactResult touch(const SurfacePatch& patch, SurfaceState& state, const SurfaceTip& tip,
                    double dt) noexcept;

/// Gap that the proxy keeps from surfaces (m). With it, rounding never decides on which side the proxy is.
inline constexpr double surface_gap = 2e-10;

/// The patch after its bodies have moved on for `seconds` (s).
SurfacePatch moved_on(SurfacePatch patch, double seconds);

/// Height and slope of a texture at a place (body frame). The slope lies in the plane or line of the axes.
struct Relief {
    double height{};  ///< height above the surface (m)
    vec3 slope{};     ///< gradient of the height
};
/// Height and slope of a texture at a place on the surface (m).
Relief relief_at(const Texture& texture, const BumpMap& bumps, vec3 place) noexcept;

}  // namespace thaum::haptics
