// field/carving.h: applies a tool to a body of voxels (R. S. Avila, L. M. Sobierajski, A haptic interaction
// method for volume visualization, 1996, section 6).
//
// An edit reads and writes only the voxels that the tool reaches, so its time does not depend on the size of
// the body. Voxels are changed brick by brick (8 x 8 x 8 voxels). The result depends on nothing but the body,
// the tool and the dab (one application of the tool).
//
// Density that is not finite, as in some scans, counts as empty. A filter moves a density gradually towards a
// constant. Once they differ by less than a millionth of the range from empty to solid, the density is set to
// the constant: otherwise a melted voxel would never become empty, and its density would end as a denormal
// number, which takes many times as long to compute with.
//
// Colours have 8 bits, so a weak filter would change nothing after rounding. The fraction is therefore
// rounded up or down at random, with the right mean. According to the paper, this rounding limits its rate of
// edits.
#pragma once
#include "field/carving_tools.h"
#include "field/voxels.h"

namespace thaum::field {

/// One application of a tool, in the body's frame.
struct Dab {
    vec3 place{};      ///< place of the tool (m)
    vec3 motion{};     ///< motion of the tool since its last application (m)
    mat3 turn{1.0};    ///< rotation from the tool's frame to the body's, for the shapes box, plate and stamp
    double seconds{};  ///< time since the last application, for which a gradual change acts (s)
    /// Random seed for the rounding of colours. It differs for each application of the tool, as the number of
    /// the tick does.
    std::uint64_t seed{};
};

/// Changes that one application of a tool made.
struct Edit {
    VoxelBox changed{};      ///< smallest box of the changed voxels
    std::size_t voxels = 0;  ///< number of changed voxels
    std::size_t bricks = 0;  ///< number of bricks (8 x 8 x 8 voxels) with a changed voxel
    double removed = 0;      ///< integral of the density taken away (density m^3)
    double added = 0;        ///< integral of the density brought in (density m^3)
};

/// Largest number of places at which one dab (application of a tool) acts along the tool's motion.
inline constexpr int max_places = 32;

/// Voxels that the tool may change. A motion longer than half of the tool's smallest half edge is divided
/// into steps of at most that length, but into no more than `max_places`, so that a quick stroke leaves no
/// gaps.
VoxelBox reach(const VoxelView& body, const Tool& tool, const Dab& dab);

/// Applies the tool once. Each brick (8 x 8 x 8 voxels) that changes gets a new version number, for readers
/// that keep copies. No allocation. A dab outside the body, or with a number that is not finite, changes
/// nothing.
Edit edit(const VoxelView& body, const Tool& tool, const Dab& dab);

}  // namespace thaum::field
