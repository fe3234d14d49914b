// haptics/volume/volume_feel.h: the feel of a volume (Avila and Sobierajski 1996, "A haptic interaction
// method for volume visualization", section 4).
//
//     F = A + R(v) + S(n)
//
//     A   ambient: gravity and guide planes, felt everywhere
//     R   against the motion, C v: C grows with the opacity, or with the density within a shell, by material
//     S   along the gradient: grows with the opacity, or with the density within a shell
//     walls: surfaces of one density that stop the proxy up to a strength (haptics/volume/level_contact.h)
//
// The opacity is the picture's: a transfer function of the density times one of the gradient's
// length. So the hand feels what the eye sees. Walls and shells read densities alone. So a skin that
// a tool made invisible is still felt.
//
// S is a function of the density at the tip. A plane placed so that the spring between tip and proxy
// stretches by exactly S / stiffness gives that force, to rounding, while the tip rests. While it moves,
// the force follows with the spring's stiffness for one tick. Foreseeing the tip's motion would double
// the noise of the device's quantum.
//
// S of a shell in a density that rises evenly is the gradient of a potential. Any other S may create energy
// in a closed loop of the hand. As a plane it counts as a passive source, so the passivity controller takes
// most of that energy out: of 64 hostile volumes, the worst gave 27 mJ in 20 s. R goes to
// HapticModel::viscosity.
//
// All functions are plain and do not allocate. Device frame, lengths in m.
#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "field/field.h"
#include "field/transfer.h"
#include "haptics/modes.h"

namespace thaum::haptics {

/// Material index at a place, such as the index of the nearest voxel.
struct MaterialField {
    const void* what{};
    std::uint8_t (*read)(const void* what, vec3 place){};

    std::uint8_t operator()(vec3 place) const {
        return read == nullptr ? std::uint8_t{0} : read(what, place);
    }
};

/// Makes a material field from any object with a member function
/// `material(place)`. The object must outlive it.
template <class Source>
MaterialField material_field_of(const Source& source) {
    return {&source, [](const void* what, vec3 place) -> std::uint8_t {
                return static_cast<const Source*>(what)->material(place);
            }};
}

/// Feel of the voxels with one material index, as factors of the forces that their densities give.
struct MaterialFeel {
    double stiffness{1};  ///< factor of the force S along the gradient and of the strength of walls, >= 0
    double viscosity{1};  ///< factor of the drag R, >= 0
};
/// Factors of the feel of each material, by its index.
using MaterialTable = std::array<MaterialFeel, 256>;

/// A plane that guides the hand, such as the plane of a cut.
struct GuidePlane {
    vec3 place{};          ///< a point on the plane (m)
    vec3 normal{0, 1, 0};  ///< unit vector
    double strength{};     ///< largest force towards the plane, from both sides, at most max_pull (N)
};

/// Haptic volume rendering: forces in proportion to the opacity a = density(value) gradient(gradient's
/// length), by two transfer functions.
struct OpacityFeel {
    field::TransferFunction density{};   ///< share of the opacity by the density, 0 to 1
    field::TransferFunction gradient{};  ///< share of the opacity by the gradient's length (per m), 0 to 1
    double stiffness{};  ///< force S along the gradient where the opacity a is 1: S = stiffness a (N)
    /// Drag added where a is 1, R = (retarding a + retarding_always) v at the speed v (N s/m).
    double retarding{};
    double retarding_always{};  ///< drag that does not depend on the opacity (N s/m)
    /// Inverted mapping: S pulls towards larger densities and is stiffness (1 - a), so that the tip follows a
    /// thin structure instead of slipping off.
    bool attracts{};
};

/// A penetrable shell between two densities, viscous inside: S rises from 0 at `low` to `stiffness` at
/// `high`, and is 0 beyond. R = (retarding (d - low) / (high - low) + retarding_always) v within.
struct DensityShell {
    double low{}, high{};       ///< densities at which the shell begins and ends, low < high
    double stiffness{};         ///< largest force, which the shell reaches at the density `high` (N)
    double retarding{};         ///< drag added at the density `high` (N s/m)
    double retarding_always{};  ///< drag at all densities from `low` to `high` (N s/m)
};

/// The surface of one density, behind which larger densities are solid. It stops the proxy until the hand
/// pushes harder than `strength` times the factor MaterialFeel::stiffness; then the proxy passes through.
struct DensityWall {
    double density{};
    /// Push at which the wall lets the hand through, in a material whose stiffness factor is 1 (N).
    double strength{};
    double friction{};  ///< coefficient of friction, >= 0
    double reach{};     ///< depth at which the proxy has got through the wall, about the size of a voxel (m)
};

inline constexpr std::size_t max_guides = 3;
inline constexpr std::size_t max_walls_felt = 2;

/// Settings of the feel of a volume.
struct VolumeFeel {
    field::ScalarField density{};
    MaterialField material{};                     ///< material index at a place; empty: index 0 everywhere
    const MaterialTable* materials{};             ///< feel of the materials; null: all factors are 1
    vec3 gravity{};                               ///< ambient force on the hand (N)
    std::array<GuidePlane, max_guides> guides{};  ///< guide planes; the first `guide_count` are in use
    std::uint32_t guide_count{};
    std::array<DensityWall, max_walls_felt> walls{};  ///< walls; the first `wall_count` are in use
    std::uint32_t wall_count{};
    OpacityFeel opacity{};
    DensityShell shell{};
    /// Factor of the forces by opacity and shell, to fade them where a volume ends; walls end by themselves.
    double share{1};
};

/// Effects of a volume on the hand besides primitives (forces on the proxy), and its properties at the tip.
struct VolumeFelt {
    double viscosity{};  ///< coefficient C of the drag R = C v, for HapticModel::viscosity (N s/m)
    double opacity{};    ///< opacity at the tip, 0 to 1
    double stiff{};      ///< force S along the gradient at the tip, negative towards larger densities (N)
    std::uint32_t touched{};   ///< bit i: wall i has planes near the proxy
    std::uint32_t material{};  ///< material index at the tip
};

/// Number of primitives that a volume adds: it depends only on the numbers of guide planes and walls, because
/// the servo takes a change of the number for a jump.
std::size_t primitives_of(const VolumeFeel& feel) noexcept;

/// Adds the primitives (elementary forces) of a volume to the set, and returns the rest of its feel. Adds
/// none if there is no room for all.
VolumeFelt add_volume_feel(const VolumeFeel& feel, const ModeInput& input, PrimitiveSet& set) noexcept;

}  // namespace thaum::haptics
