// game/lab/saved_body.h: a carved body in files. A NRRD file holds one property, so colours and materials stand beside
// the densities: head.nrrd, head.colour.nrrd, head.material.nrrd. The last two are written only if a tool has changed
// them, and read if they are there. All files of a body carry the name of the save, so that parts of two bodies, as a
// power cut between two files may leave them, are not taken for one.
#pragma once
#include <array>
#include <filesystem>

#include "game/lab/volume_lab.h"

namespace thaum::game {

/// Files of colours and materials that belong to a file of densities.
std::array<std::filesystem::path, 2> companions_of(const std::filesystem::path& file);

/// Saves the volume as it is now. All files are written before the first one is put at its place. The error names the
/// file that could not be written.
Expected<void> save_volume(const VolumeLab& lab, const std::filesystem::path& file);

/// Takes colours and materials that stand beside the file of the lab's volume; none are no error.
Expected<void> take_saved_properties(VolumeLab& lab, const std::filesystem::path& file);

}  // namespace thaum::game
