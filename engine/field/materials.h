// field/materials.h: the materials that voxels refer to by an index (R. S. Avila, L. M. Sobierajski, A haptic
// interaction method for volume visualization, 1996, section 3).
//
//     version = 1
//     [[material]]
//     name = "skin"
//     stiffness = 250                N/m
//     viscosity = 1.5                N s/m
//     opacity = 0.3                  0: not drawn, but still felt; 1: hides everything behind it
//     colour = "#E0AC8C"             older files have [224, 172, 140]: red, green, blue, each from 0 to 255
//
// The table is fixed while a body is carved. An edit changes the index of a voxel and never a material,
// because changing a material would change the whole body at once.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/config.h"
#include "field/voxels.h"

namespace thaum::field {

/// A material of voxels, as a data file describes it.
struct Material {
    std::string name;
    double stiffness{};  ///< stiffness that a hand feels when it pushes into the material (N/m)
    double viscosity{};  ///< drag on a hand inside (N s/m)
    double opacity{};    ///< opacity from 0 to 1
    Rgb8 colour{};
};

/// At most 256 materials. The index of a material is its place in the file.
using Materials = std::vector<Material>;

inline constexpr std::int64_t materials_file_version = 1;

/// Reads a table of materials. The error names file, line and fault, such as two materials with the same
/// name.
Expected<Materials> read_materials(const Config& config);

/// Index of a material by its name, if there is one.
std::optional<std::uint8_t> material_index(const Materials& materials, std::string_view name);

/// Reads three whole numbers from 0 to 255.
Rgb8 read_colour(const ConfigTable& table, std::string_view key);

}  // namespace thaum::field
