// game/lab/saved_body.h: a carved body in files. A NRRD file holds one property, so colours and materials
// have files of their own beside that of the densities: head.nrrd, head.colour.nrrd, head.material.nrrd. The
// files of colours and materials are written only if a tool has changed them or such a file already exists,
// and read if they exist. All files of a body contain the same identifier, so that files of different bodies,
// which a power cut during saving may leave, are not combined.
#pragma once
#include <array>
#include <filesystem>

#include "game/lab/volume_lab.h"

namespace thaum::game::inline lab {

/// Paths of the files of colours and of materials that belong to a file of densities.
std::array<std::filesystem::path, 2> companions_of(const std::filesystem::path& file);

/// Saves the volume in its present state. All files are written under temporary names before the first one is
/// renamed. The error names the file that could not be written.
Expected<void> save_volume(const VolumeLab& lab, const std::filesystem::path& file);

/// Loads the colours and materials from the files beside that of the lab's volume. Missing files are no
/// error.
Expected<void> take_saved_properties(VolumeLab& lab, const std::filesystem::path& file);

}  // namespace thaum::game::inline lab
