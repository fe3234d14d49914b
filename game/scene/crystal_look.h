// game/scene/crystal_look.h: the look of a crystal. Its voxels are drawn as an opaque surface. The key's
// shape is a faint shell around what is still to be built. Matter outside of the key's shape, which must be
// removed, is amber. From far away a coarse mesh replaces surface and shell.
//
//     simulation                      any thread                    renderer
//     take_crystals(match, crystals)  show_crystal(...)             view.scans, with look.body and look.key,
//                                                                   or an instance of look.mesh
//
// Only bricks (blocks of voxels) that have changed are sent, and only if a view sees the crystal.
#pragma once
#include <vector>

#include "game/picture/station_picture.h"
#include "game/scene/changing_mesh.h"
#include "render/renderer.h"
#include "render/scan.h"

namespace thaum::game::inline scene {

/// Everything drawn for a crystal. It can be moved but not copied, because the scans point into it.
struct CrystalLook {
    render::Scan body{}, key{};
    ChangingMesh mesh{};

    bool made{};                                   ///< true: the scans (voxels to be drawn) show a crystal
    std::uint64_t seed{};                          ///< seed of the shown crystal
    std::shared_ptr<const CrystalVoxels> shown{};  ///< the voxels that are shown
    std::shared_ptr<const CrystalVoxels> rough{};  ///< voxels of the crystal before anyone touched it
    std::vector<float> wanted{};                   ///< densities of the key's shape
    std::vector<field::Rgb8> paint{};              ///< colour of each voxel
    /// version of each brick (block of voxels), which rises with each change
    std::vector<std::uint32_t> bricks{};
    render::ScanTable table{};  ///< colour and opacity of the key's shape

    CrystalLook() = default;
    CrystalLook(CrystalLook&&) = default;
    CrystalLook& operator=(CrystalLook&&) = default;
};

/// Creates the look of a crystal, with scans (voxels to be drawn) that are still empty.
CrystalLook make_crystal_look(render::Renderer& renderer);

/// Whether an eye is near enough to see the voxels and the key rather than the mesh.
bool sees_voxels(const CrystalPicture& crystal, vec3 eye);

/// Refreshes the scans and the mesh if the crystal has changed. Returns the number of changed bricks.
std::size_t show_crystal(const CrystalPicture& crystal, CrystalLook& look);

/// Adds the coarse mesh of a crystal.
void add_crystal(const CrystalPicture& crystal, const CrystalLook& look, std::vector<render::Instance>& out);

}  // namespace thaum::game::inline scene
