// field/voxel_volume.h: bodies of voxels from volumes, and back into volumes for files (field/volume.h).
//
// A volume holds one property. Density, colour and material are therefore three volumes, each with the count,
// spacing and placement of the body. Together they give back every bit of the body.
#pragma once
#include <optional>

#include "core/error.h"
#include "field/volume.h"
#include "field/voxels.h"

namespace thaum::field {

/// Densities of empty and of solid material.
struct DensityRange {
    float empty = 0, full = 1;
};

/// Makes a body whose densities are the samples of a scalar volume; it is white and of material 0. Without a
/// range, its least and greatest finite samples are the densities of empty and of solid material. The surface
/// is half-way between them. The error says what is wrong with the volume or the range.
Expected<Voxels> voxels_of(const Volume& volume, std::optional<DensityRange> range = std::nullopt);
/// Makes a body like the other voxels_of, but moves the samples out of the volume, which keeps all else. So a
/// large volume is not in memory twice. On an error the volume is as before.
Expected<Voxels> voxels_of(Volume&& volume, std::optional<DensityRange> range = std::nullopt);

/// Volume of the densities, stored as float32.
Volume density_volume(const Voxels& body);
/// Volume of the colours: three components of 8 bits.
Volume colour_volume(const Voxels& body);
/// Volume of the material indices, in 8 bits.
Volume material_volume(const Voxels& body);

/// Sets the colours of the voxels from a volume with as many samples along each axis. The samples must be
/// whole numbers from 0 to 255. On an error the body is as before.
Expected<void> set_colours(Voxels& body, const Volume& volume);
/// Sets the material indices of the voxels from a volume with as many samples along each axis. The samples
/// must be whole numbers from 0 to 255. On an error the body is as before.
Expected<void> set_materials(Voxels& body, const Volume& volume);

}  // namespace thaum::field
