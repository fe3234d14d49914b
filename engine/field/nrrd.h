// field/nrrd.h: volumes in NRRD files (teem.sourceforge.net/nrrd/format.html), the usual format of scans in
// research.
//
// Read: three axes, or four with one axis of components; 8 and 16 bit integers, float and double, of either
// byte order; raw or gzip; samples in the same file or in one other file ("data file: NAME"). The samples
// come out with x fastest along the axes of the file's space. What a header says about space is kept so:
//
//     space directions along the axes of space   samples are put in order; their lengths are the spacing
//     directions turned against those axes       placement.turn
//     directions that are not at right angles    an error
//     space origin                               placement.origin is the middle of the samples (Volume::has_place)
//     only spacings                              the same, with the middle of the samples at the origin
//     units (space units, or units of the axes)  metres come out; without units, lengths are mm, as in medicine
//     axis mins and maxs without spacings        their difference over the samples, or over the gaps of nodes
//     no spacing at all                          1 mm
//     a space such as right-anterior-superior    turned to left-posterior-superior (Volume::is_of_patient)
//     a left-handed space                        mirrored, so that the frame is right-handed
//
// A file that is written says what was read: the same vectors, the same frame, and no origin if there was none. The
// key/value pair "thaum save:=NAME" tells which files belong to one body (Volume::save_name).
//
// Other fields, comments and key/value pairs are skipped. Samples that are not numbers stay so.
#pragma once
#include <filesystem>

#include "core/error.h"
#include "core/file_writer.h"
#include "field/volume.h"

namespace thaum::field {

/// Reads a volume of at most `limit` samples times components. The error is one line with the path and, for a
/// header, the line: nothing is allocated that the size of the file does not justify.
Expected<Volume> read_nrrd(const std::filesystem::path& path, std::size_t limit = most_samples);

enum class Packing : std::uint8_t { raw, gzip };

/// Writes a volume as one file, with its placement, name and units. The scale becomes part of the spacing.
/// Lengths are in mm if reading gives the same bits again, else in m. Integers are rounded and limited to the
/// range of their type. The error names the path.
Expected<void> write_nrrd(const std::filesystem::path& path, const Volume& volume,
                          Packing packing = Packing::gzip);

/// Writes all bytes to the disk under a temporary name; FileWriter::close then puts the file at its path. So files that
/// belong together are put there only after all of them could be written.
Expected<FileWriter> start_nrrd(const std::filesystem::path& path, const Volume& volume,
                                Packing packing = Packing::gzip);

}  // namespace thaum::field
