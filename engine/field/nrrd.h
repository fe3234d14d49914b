// field/nrrd.h: volumes in NRRD files (teem.sourceforge.net/nrrd/format.html), the usual format of scans in
// research.
//
// The reader accepts three axes of space, in any order, at most one axis of components (3, or colours) and
// one of time. Samples may be integers of 8 to 64 bits, float or double, in either byte order, in the
// encodings raw, gzip and ascii. They may be in the same file, in another one, or in several (LIST, or a
// pattern such as "slice%03d.raw 1 40 1"), after skipped lines and bytes. From a file with time, one moment
// is read, and from colours, the luminance. The reader refuses other kinds of axes (list, matrices,
// quaternions), two axes of space or four, spaces with time, the encodings hex and bzip2, and block types. An
// error of one line names each of these. The samples come out with x fastest along the axes of the file's
// space. The reader keeps the header's values about space as follows:
//
//     space directions along the axes of space   samples are put in order; their lengths are the spacing
//     directions turned against those axes       placement.turn
//     directions that are not at right angles    an error
//     space origin                               placement.origin is the middle of the samples
//                                                (Volume::has_place)
//     only spacings                              the same; without an origin, the middle of the samples
//                                                is at 0
//     "nan" or "none"                            not given
//     units (space units, or units of the axes)  lengths become m; without units, or with units that are none
//                                                of length, such as "pixel", lengths are mm, as in medicine
//     axis mins and maxs without spacings        their difference over the samples, or over the gaps of
//                                                nodes; their place is left out
//     no spacing at all                          1 mm
//     a space such as right-anterior-superior    turned to left-posterior-superior (Volume::is_of_patient)
//     a left-handed space                        mirrored, so that the frame is right-handed
//
// A file that is written repeats what was read: the same vectors, the same frame, and no origin if there was
// none. The key/value pair "thaum save:=NAME" tells which files belong to one body (Volume::save_name).
//
// Without kinds, an axis of 3 or 4 bytes holds colours, and an axis of 3 other numbers a vector. If a
// detached file is not where the header says, detail/sample_file.h describes where it is looked for. Samples
// that lose most of their differences when they are rounded to float are refused (Rounding, field/volume.h).
// So are bytes of another encoding, and floats in the other byte order.
//
// Samples are read, unpacked and converted in pieces, so reading needs hardly more memory than the samples of
// the volume take as floats. Only a file of text is in memory as a whole.
//
// Comments and key/value pairs are skipped. Volume::notes lists everything else that was left out or changed.
// Samples that are not numbers (NaN) remain so.
#pragma once
#include <filesystem>

#include "core/error.h"
#include "core/file_writer.h"
#include "field/volume.h"

namespace thaum::field {

/// Choices for reading an NRRD file.
struct ReadChoice {
    /// Largest number of samples times components that is accepted, over all moments of time.
    std::size_t limit = max_samples;
    int frame = 0;                    ///< moment of time to read, from 0 on
    bool colours_as_vectors = false;  ///< true: keep colours as vectors; false: keep their luminance
};

/// Reads a volume. The error is one line with the path and, for a fault of the header, the line. A header
/// that claims more samples than the file can hold allocates no memory.
Expected<Volume> read_nrrd(const std::filesystem::path& path, const ReadChoice& choice = {});

/// How samples are stored: as they are, or packed by gzip.
enum class Packing : std::uint8_t { raw, gzip };

/// Writes a volume as one file, with its placement, name and units. The scale becomes part of the spacing.
/// Lengths are in mm if reading gives the same bits again, else in m. Integers are rounded and limited to the
/// range of their type. The error names the path.
Expected<void> write_nrrd(const std::filesystem::path& path, const Volume& volume,
                          Packing packing = Packing::gzip);

/// Writes all bytes to the disk under a temporary name; FileWriter::close then puts the file at its path. So
/// files that belong together replace the old ones only after all of them could be written.
Expected<FileWriter> start_nrrd(const std::filesystem::path& path, const Volume& volume,
                                Packing packing = Packing::gzip);

}  // namespace thaum::field
