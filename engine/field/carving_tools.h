// field/carving_tools.h: tools that change voxels, as data files describe them (R. S. Avila, L. M.
// Sobierajski, A haptic interaction method for volume visualization, 1996, section 6, table 2).
//
//     version = 1
//     name = "squirt"
//     [[operation]]                  1 to 3; no property may be changed by two operations of one tool
//     method = "filter"              filter | constant
//     extent = "gaussian"            sphere | box | gaussian | plate | stamp
//     radius = 3                     voxels; or radius_m = 0.01 (m)
//     properties = "density"         some of: density colour material
//     filter = "construct"           melt | construct | mix; only with method = "filter"
//     rate = 6                       1/s; only with method = "filter"
//     density = 1                    0 is empty, 1 is solid; for density, except with melt
//     colour = "#FF0000"             for colour; older files have [255, 0, 0]
//     material = "wax"               for material; a name of the table of materials
//     only = "surface"               optional: voxels beside the surface; not together with density
//
// A filter moves a property d towards its constant D: d' = a D + (1 - a) d. Melting has D = 0. For a time t,
// a = 1 - exp(-rate w t), where w is the weight of the extent at the voxel. So two edits of t / 2 give the
// same as one of t. A constant sets the property to D; applying it again changes nothing.
//
// Extents and their keys:
//
//     sphere     radius            weight 1, falling to 0 over two voxels at the rim
//     box        half = [x, y, z]  half edges along the tool's axes, with the same rim
//     gaussian   radius            the bell exp(-4.5 (r / radius)^2) minus its value at the rim, so 0 there
//     plate      half = [x, y, z]  a box whose z axis follows the motion, for cuts; x is half the thickness
//     stamp      radius, cells = [x, y, z], shape: a small body of cells; its longest half edge is the radius
//
// `half` is in voxels, `half_m` in m. The shape of a stamp has a character for each cell: . or 0 is nothing,
// # is solid, 1 to 9 are tenths. x runs fastest, then y, then z. Spaces and line ends do not count.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/config.h"
#include "field/materials.h"
#include "field/voxels.h"

namespace thaum::field {

/// Whether an operation sets a property to its constant, or moves it towards the constant.
enum class Method : std::uint8_t { constant, filter };
/// Shape within which an operation acts.
enum class ExtentShape : std::uint8_t { sphere, box, gaussian, plate, stamp };

/// A small body of cells with weights from 0 to 1, x fastest. The cells fill the box that has the half edges
/// Extent::half.
struct Stamp {
    std::array<int, 3> cells{};
    std::vector<float> weight{};
};

/// Region of voxels that an operation reaches, with a weight for each voxel: how strongly the operation acts
/// there.
struct Extent {
    ExtentShape shape{};
    /// Half edges along the tool's axes; for a sphere or a Gaussian, the radius along all three (voxels or
    /// m).
    vec3 half{};
    bool in_metres = false;  ///< true: `half` is in m; false: in voxels
    Stamp stamp{};           ///< weights of the cells, 0 to 1; empty unless the shape is `stamp`
};

/// Set of properties of a voxel, such as those that an operation changes.
struct Properties {
    bool density = false, colour = false, material = false;

    bool operator==(const Properties&) const = default;
};

/// One change that a tool makes to one property of voxels.
struct Operation {
    Method method{};
    Extent extent{};
    Properties changes{};
    /// Rate at which the method `filter` moves a property towards its constant where the tool's weight is 1
    /// (1/s).
    double rate = 0;
    double density = 0;  ///< density that is set or approached, from 0 (empty) to 1 (solid)
    Rgb8 colour{};
    std::uint8_t material = 0;
    bool surface_only = false;  ///< true: change only voxels beside the body's surface
};

/// A tool: a name and the operations that it applies, in this order.
struct Tool {
    std::string name;
    std::vector<Operation> operations{};
};

inline constexpr std::int64_t tool_file_version = 1;
inline constexpr std::size_t max_operations = 3;  // one each for density, colour and material
inline constexpr std::size_t max_tool_bytes = std::size_t{1} << 20U;

/// Reads a tool. The error names file, line and fault. If two operations change one property, it names both.
Expected<Tool> read_tool(const Config& config, const Materials& materials);
/// Reads the file of a tool. The error is that of `read_tool`, or says that the file cannot be read.
Expected<Tool> load_tool(const std::filesystem::path& path, const Materials& materials);

/// Makes a stamp of the shape that a body has in the box: weight 0 for empty voxels, 1 for solid ones.
Stamp stamp_of(const VoxelView& body, const VoxelBox& box);

}  // namespace thaum::field
