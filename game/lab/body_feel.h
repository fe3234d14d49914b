// game/lab/body_feel.h: the feel of a body as a whole in the volume lab, F = A + R(v) + S(n) and walls
// (haptics/volume/volume_feel.h), as parts with numbers:
//
//     opacity  S R                  force along the gradient (N) and drag (N s/m) where the picture is opaque
//     attract  S R                  the same, but drawn towards opaque matter, to follow thin structures
//     shell    LOW HIGH S R         the same within a shell between two densities
//     wall     DENSITY S FRICTION   surface of one density, which a push above S (N) gets through
//     gravity  X Y Z                ambient force (N)
//     plane    X Y Z NX NY NZ S     guide plane through a place (m), with a normal and its largest force (N)
//
// Numbers at the end that are left out are 0. A voxel's material (field/materials.h) scales stiffness and drag: they
// are given for the first material of the table.
#pragma once
#include <span>
#include <string_view>

#include "core/error.h"
#include "field/materials.h"
#include "field/voxels.h"
#include "haptics/volume/volume_feel.h"

namespace thaum::game {

enum class FeelKind : std::uint32_t { opacity, attract, shell, wall, gravity, plane };

inline constexpr std::size_t most_feel_numbers = 7;

/// One part of a feel. The first `count` numbers are those of its kind.
struct FeelPart {
    FeelKind kind{};
    std::array<double, most_feel_numbers> numbers{};
    bool operator==(const FeelPart&) const = default;
};

/// Name of a kind of part, and the numbers that it has.
struct FeelForm {
    std::string_view name{};
    std::size_t least{}, count{};  ///< numbers that must be given, and all
    std::size_t most_parts{};      ///< how many parts of this kind act together
    std::array<std::string_view, most_feel_numbers> labels{};
};
std::span<const FeelForm> feel_forms();
const FeelForm& form_of(FeelKind kind);

/// Makes a part. The error says what is wrong with its name or its numbers.
Expected<FeelPart> feel_part(std::string_view name, std::span<const double> numbers);

/// Puts parts together. `opacity`: the picture's opacity by the density; `reach`: depth at which a wall is behind (m).
/// The fields of the result are still empty. The error says which parts do not fit together.
Expected<haptics::VolumeFeel> feel_of_parts(std::span<const FeelPart> parts,
                                            const field::TransferFunction& opacity, double reach);

/// Factors of each material, relative to the first one of the table.
haptics::MaterialTable feel_of_materials(const field::Materials& materials);

/// Material of the voxel nearest to a place of the parent's frame; the first material outside the body.
struct BodyMaterials {
    std::array<int, 3> count{};
    vec3 spacing{1};
    field::Placement placement{};
    std::span<const std::uint8_t> indices{};

    std::uint8_t material(vec3 place) const;
};

}  // namespace thaum::game
