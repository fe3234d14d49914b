// haptics/surface.h: touching surfaces with a point (Zilles and Salisbury 1995, "A constraint-based god-object method for
// haptic display"; friction after Ruspini, Kolarov, Khatib 1997).
//
//     patch of surfaces ----.
//     tip ------------------+--> touch() --> force on the hand = stiffness (proxy - tip) + damping
//     state (the proxy) <---'
//
// The proxy is where the tip would be if it could not enter anything. Each tick it starts where it was, is carried along by what it
// touched, is pushed out by what moved over it, and goes towards the tip as a swept point: straight until it meets a surface, then
// along that surface (a round one: surface_round.h), along the crease of two, into the corner of three. Nothing lags: it ends at
// the place nearest to the tip to rounding. Swept relative to each body's own motion, no speed takes it through anything in the
// patch. A proxy whose moves are used up stays held by what held it last: inside, the force never vanishes.
//
// Friction (Coulomb, in metres of penetration: with one stiffness forces are lengths). Where the pull along the touched surfaces
// is at most the sum of friction x penetration over them, the proxy sticks; beyond that, it slides in the direction of the pull
// until the dynamic friction holds it. It holds still with the static one.
//
// Force: stiffness is the mean of the touched ones, weighted by their part of the push, so the direction is that of proxy -
// tip whatever the mixture. With one stiffness and no friction the force is minus the gradient of stiffness/2 times the square of
// the distance: it creates no energy. To slide under load from one stiffness to another does, half the difference
// times depth squared. Damping acts along the push and only on the way in (paper 004): it never pulls.
//
// Textures are heights h above the surface, from 0 to their top, at the place of the proxy. The proxy walks on their top;
// what it is deep beneath that less what the texture lies below it is the depth that is felt:
//
//     impact   (paper 004, F_mag)   beneath the surface itself: depth + h, along the surface's normal n
//     vibration (paper 004, F_vec)  beneath h: depth + h, along the unit normal of the texture, n - grad h
//     bumps    (paper 002, 5)       beneath h: depth + h, times n - grad h: minus the gradient of the spring's energy
//
// where depth is the tip's beneath the surface, below zero above it. On one plane bumps are passive. On a curved surface
// the proxy does not move as far as the tip, and where walls meet their heights change each other's depth: there the force
// is no gradient, and a closed loop of the tip can gain energy (1.4 mJ in the crease of two planes, 6 mJ in a corner).
// Vibration differs from bumps by the length of its normal, sqrt(1 + |grad h|^2). Impact is an active source: it jumps by
// h where the surface is crossed, and to press in over a trough and slide to a crest gains energy.
//
// Device frame, m. Plain data, no allocation, no clock; memory is the SurfaceState alone.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/maths.h"

namespace thaum::haptics {

enum class SurfaceKind : std::uint32_t {
    plane,     ///< a: a point on it, b: unit normal; all behind it is solid
    triangle,  ///< a, b, c: counter-clockwise seen from the side that can be touched
    sheet,     ///< a, b, c: a triangle that can be touched from both sides
    sphere,    ///< a: centre, b.x: radius
    capsule,  ///< a: centre, b.x: radius, b.y: half the length of its straight part, which lies along the body's y axis
    box,       ///< a: centre, b: half extents along the body's axes
    cylinder,  ///< as the capsule, with flat ends
};

/// One surface of a body, where it is now.
struct Surface {
    SurfaceKind kind{};
    std::uint32_t body{};  ///< index in SurfacePatch::bodies
    std::uint32_t part{};  ///< which of its body's surfaces; the same from tick to tick
    std::uint32_t spare{};
    vec3 a{}, b{}, c{};  ///< m, device frame
};
static_assert(sizeof(Surface) == 4 * sizeof(std::uint32_t) + 3 * sizeof(vec3), "no padding");

/// As wide as a double, so that a Texture has no padding.
enum class TextureKind : std::uint64_t {
    none,
    impact,     ///< a sinusoidal grating
    vibration,  ///< the same
    bumps,      ///< a height map
};

/// Heights above a surface, fixed to its body; on a curved one as if cut from a block.
///
///     grating   h = amplitude (1 + sin(2 pi u / wavelength)), u = axes[0] . (place - origin)
///     bumps     h = 2 amplitude times the patch's map at (u, v) / wavelength, which repeats; v by axes[1]
struct Texture {
    TextureKind kind{};
    double amplitude{};                                      ///< m, >= 0; the top is twice that
    double wavelength{};                                     ///< m, > 0
    vec3 origin{};                                           ///< m, body frame
    std::array<vec3, 2> axes{vec3{1, 0, 0}, vec3{0, 0, 1}};  ///< unit, body frame
};
static_assert(sizeof(Texture) == sizeof(TextureKind) + 2 * sizeof(double) + 3 * sizeof(vec3), "no padding");

inline constexpr std::size_t bump_cells = 16;

/// Heights 0 to 1 at the nodes of one wavelength's square, u the fast index. Between them a
/// quadratic B-spline: never higher than the nodes, and of continuous slope.
using BumpMap = std::array<float, bump_cells * bump_cells>;

/// How a surface feels.
struct SurfaceMaterial {
    double stiffness{300};      ///< N/m, > 0
    double damping{};           ///< N s/m, >= 0
    double static_friction{};   ///< >= dynamic_friction
    double dynamic_friction{};  ///< >= 0
    Texture texture{};
};
static_assert(sizeof(SurfaceMaterial) == 4 * sizeof(double) + sizeof(Texture), "no padding");

/// What surfaces belong to: it moves as one.
struct SurfaceBody {
    vec3 position{};               ///< m, of the point that has `velocity`
    quat orientation{1, 0, 0, 0};  ///< unit
    vec3 velocity{};               ///< m/s, over the last tick
    vec3 spin{};                   ///< rad/s, about position
    SurfaceMaterial material{};
    std::uint32_t key{};  ///< the same from tick to tick
    std::uint32_t spare{};
};
static_assert(sizeof(SurfaceBody) ==
                  3 * sizeof(vec3) + sizeof(quat) + sizeof(SurfaceMaterial) + 2 * sizeof(std::uint32_t),
              "no padding");

inline constexpr std::size_t surface_capacity = 32;
inline constexpr std::size_t surface_body_capacity = 8;

/// The surfaces near the tip. In use are the first `count` and `body_count`; what names a body beyond is not felt.
struct SurfacePatch {
    std::array<Surface, surface_capacity> surfaces{};
    std::array<SurfaceBody, surface_body_capacity> bodies{};
    std::uint32_t count{};
    std::uint32_t body_count{};
    BumpMap bumps{};  ///< of all bodies whose texture is bumps
    /// All surfaces within `reach` of `centre` are in the patch. The proxy stays there until a new patch tells what is beyond;
    /// what it has not met is not felt.
    vec3 centre{};           ///< m
    double reach{HUGE_VAL};  ///< m
};
static_assert(sizeof(SurfacePatch) ==
                  surface_capacity * sizeof(Surface) + surface_body_capacity * sizeof(SurfaceBody) +
                      2 * sizeof(std::uint32_t) + sizeof(BumpMap) + sizeof(vec3) + sizeof(double),
              "no padding");

/// A surface that was touched, known again by its body's key and part.
struct SurfaceContact {
    std::uint32_t key{};
    std::uint32_t part{};
    vec3 force{};  ///< N, its share of the force on the hand; the body has the opposite
};

/// All that a tick leaves behind; no padding.
struct SurfaceState {
    vec3 proxy{};                             ///< m; holds where begun
    std::array<SurfaceContact, 3> touched{};  ///< the first `contacts`, the most loaded first
    std::uint32_t contacts{};
    std::uint32_t sliding{};  ///< 1: it slid in the last tick, against friction
    std::uint32_t begun{};    ///< 0: the proxy starts at the tip
    std::uint32_t limited{};  ///< 1: it was held at the end of the patch's reach
};
static_assert(sizeof(SurfaceState) == 4 * sizeof(vec3) + 10 * sizeof(std::uint32_t));

/// The probe, as measured.
struct SurfaceTip {
    vec3 position{};  ///< m
    vec3 velocity{};  ///< m/s; damping alone uses it
};

struct Touched {
    vec3 force{};  ///< N, on the hand; finite
    vec3 proxy{};  ///< m; the tip where nothing is touched
    vec3 push{};   ///< m, by which the surfaces hold the proxy from the tip; without what friction adds
    std::uint32_t contacts{};  ///< 0 to 3
};

/// One tick of dt seconds. Where the tip is not finite nothing is felt and the proxy begins anew. The proxy stays
/// `surface_gap` before a surface: forces are right to stiffness times that.
Touched touch(const SurfacePatch& patch, SurfaceState& state, const SurfaceTip& tip, double dt) noexcept;

inline constexpr double surface_gap = 2e-10;  ///< m

/// The patch when its bodies have gone on for so long, s.
SurfacePatch moved_on(SurfacePatch patch, double seconds);

/// Of a texture at a place, all in the body's frame. The slope lies in the axes' plane or line.
struct Relief {
    double height{};  ///< m
    vec3 slope{};     ///< gradient of the height
};
Relief relief_at(const Texture& texture, const BumpMap& bumps, vec3 place) noexcept;

}  // namespace thaum::haptics
