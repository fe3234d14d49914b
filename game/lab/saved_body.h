// game/lab/saved_body.h: a carved body in files. A NRRD file holds one property, so colours and materials stand beside
// the densities: head.nrrd, head.colour.nrrd, head.material.nrrd. The last two are written only if a tool has changed
// them, and read if they are there.
#pragma once
#include <filesystem>

#include "game/lab/volume_lab.h"

namespace thaum::game {

/// Saves the volume as it is now. The error names the file that could not be written.
Expected<void> save_volume(const VolumeLab& lab, const std::filesystem::path& file);

/// Takes colours and materials that stand beside the file of the lab's volume; none are no error.
Expected<void> take_saved_properties(VolumeLab& lab, const std::filesystem::path& file);

}  // namespace thaum::game
