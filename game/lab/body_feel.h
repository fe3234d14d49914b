// game/lab/body_feel.h: the feel of a body as a whole in the volume lab, as parts with numbers. The force on
// the hand is F = A + R(v) + S(n): A is ambient, R(v) a drag against the hand's velocity v, and S(n) acts
// along n, the direction of the density's gradient. Walls are added to it (haptics/volume/volume_feel.h):
//
//     opacity  S R                  force along the gradient (N) and drag (N s/m) where the picture is opaque
//     attract  S R                  the same, but drawn towards opaque matter, to follow thin structures
//     shell    LOW HIGH S R         the same within a shell between two densities
//     wall     DENSITY S FRICTION   surface of one density, through which a force above S (N) breaks
//     gravity  X Y Z                ambient force (N)
//     plane    X Y Z NX NY NZ S     guide plane through a place (m), with a normal and its largest force (N)
//
// Numbers at the end that are left out are 0. A voxel's material (field/materials.h) scales stiffness and
// drag: they are given for the first material of the table.
#pragma once
#include <span>
#include <string_view>

#include "core/error.h"
#include "field/materials.h"
#include "field/voxels.h"
#include "haptics/volume/volume_feel.h"

namespace thaum::game::inline lab {

enum class FeelKind : std::uint32_t { opacity, attract, shell, wall, gravity, plane };

inline constexpr std::size_t max_feel_numbers = 7;

/// One part of a body's feel (the force law by which it is felt), such as a wall. Only the first of its
/// `numbers` are in use: as many as parts of its kind have (FeelForm::count).
struct FeelPart {
    FeelKind kind{};
    std::array<double, max_feel_numbers> numbers{};
    bool operator==(const FeelPart&) const = default;
};

/// Form of one kind of part of a feel, such as walls: its name, and the count and the names of its numbers.
struct FeelForm {
    std::string_view name{};
    std::size_t least{}, count{};  ///< how many numbers must be given at least, and how many the part has
    std::size_t max_parts{};       ///< how many parts of this kind may act together
    std::array<std::string_view, max_feel_numbers> labels{};
};
std::span<const FeelForm> feel_forms();
const FeelForm& form_of(FeelKind kind);

/// Makes a part of a body's feel, such as a wall. The error says what is wrong with the name or the numbers.
Expected<FeelPart> feel_part(std::string_view name, std::span<const double> numbers);

/// Combines parts into one feel, the force law by which a body is felt. `opacity`: the picture's opacity as a
/// function of density; `reach`: depth at which the hand has broken through a wall (m). The fields of the
/// result are left empty. The error says which parts do not fit together.
Expected<haptics::VolumeFeel> feel_of_parts(std::span<const FeelPart> parts,
                                            const field::TransferFunction& opacity, double reach);

/// Haptic factors of each material, relative to the first material of the table.
haptics::MaterialTable feel_of_materials(const field::Materials& materials);

/// Looks up the material of a body at a position in the parent frame. It is the material of the nearest
/// voxel, and outside of the body the first material of the table.
struct BodyMaterials {
    std::array<int, 3> count{};
    vec3 spacing{1};
    field::Placement placement{};
    std::span<const std::uint8_t> indices{};

    std::uint8_t material(vec3 place) const;
};

}  // namespace thaum::game::inline lab
