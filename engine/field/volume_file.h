// field/volume_file.h: reads volumes from files of any supported format.
#pragma once
#include <filesystem>

#include "core/error.h"
#include "field/nrrd.h"
#include "field/volume.h"

namespace thaum::field {

/// Reads a volume. The extension of the file name, in upper or lower case, gives the format: .nrrd and .nhdr
/// (field/nrrd.h), .toml (read_raw). A volume without any finite sample is an error, and so is any other
/// format, which the error names.
Expected<Volume> read_volume(const std::filesystem::path& path, const ReadChoice& choice = {});

/// Reads plain samples described by a TOML file:
///
///     version = 1
///     file = "head.raw"               # beside the TOML file
///     sizes = [128, 128, 54]          # x is fastest in the file
///     type = "int16"                  # int8, uint8, int16 to uint64, float, double
///     endian = "little"               # or "big"; may be left out
///     spacing_mm = [1.9, 1.9, 3.0]
///     components = 1                  # or 3, side by side in the file; may be left out
///     name = "head"                   # may be left out, as units
///     units = "HU"
Expected<Volume> read_raw(const std::filesystem::path& path, std::size_t limit = max_samples);

}  // namespace thaum::field
